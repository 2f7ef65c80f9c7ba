#include "workbench/optimise/optimality.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler/algebra/dense.hpp"

namespace mbgen::optimise {
namespace {

constexpr double kPivots = 1e-12;

/// A column of the combination: the gradient of a bound or constraint, and the place of its multiplier.
struct ActiveColumn {
  Eigen::VectorXd gradient;
  double* multiplier = nullptr;
  double sign = 1;  ///< of the multiplier as told
  bool is_free = false;
};

/// -1 at the lower bound, 1 at the upper, 0 between them.
int near_side(double value, double lower, double upper, double near) {
  return value <= lower + near ? -1 : value >= upper - near ? 1 : 0;
}

std::vector<ActiveColumn> active_columns(const ProgrammePoint& point, const Eigen::VectorXd& variables,
                                         const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                         Optimality& result) {
  std::vector<ActiveColumn> columns;
  for (Eigen::Index e = 0; e < point.equalities.size(); ++e)
    columns.push_back({point.of_equalities.row(e).transpose(), &result.equalities[e], 1, true});
  for (Eigen::Index k = 0; k < point.inequalities.size(); ++k)
    if (point.inequalities[k] > -point.near[k])
      columns.push_back({point.of_inequalities.row(k).transpose(), &result.inequalities[k]});
  for (Eigen::Index v = 0; v < variables.size(); ++v) {
    const double size = std::min(upper[v] - lower[v], std::max(1.0, std::abs(variables[v])));
    const int side = near_side(variables[v], lower[v], upper[v], kActivePart * size);
    result.at_bound[static_cast<std::size_t>(v)] = side;
    if (side == 0) continue;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(variables.size());
    gradient[v] = side;
    columns.push_back({std::move(gradient), &result.bounds[v], static_cast<double>(side)});
  }
  return columns;
}

/// The multipliers of the columns that take part, zero of the others.
Eigen::VectorXd combination(const std::vector<ActiveColumn>& columns, const std::vector<bool>& takes_part,
                            const Eigen::VectorXd& wanted) {
  const auto count = std::count(takes_part.begin(), takes_part.end(), true);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
  if (count == 0) return result;
  Eigen::MatrixXd matrix(wanted.size(), count);
  for (std::size_t c = 0, k = 0; c < columns.size(); ++c)
    if (takes_part[c]) matrix.col(static_cast<Eigen::Index>(k++)) = columns[c].gradient;
  const Eigen::VectorXd found = least_squares(matrix, wanted, kPivots);
  for (std::size_t c = 0, k = 0; c < columns.size(); ++c)
    if (takes_part[c]) result[static_cast<Eigen::Index>(c)] = found[static_cast<Eigen::Index>(k++)];
  return result;
}

Eigen::VectorXd rest_of(const std::vector<ActiveColumn>& columns, const Eigen::VectorXd& multipliers,
                        Eigen::VectorXd wanted) {
  for (std::size_t c = 0; c < columns.size(); ++c)
    wanted -= multipliers[static_cast<Eigen::Index>(c)] * columns[c].gradient;
  return wanted;
}

/// Steps from `at` towards `to` up to the first multiplier that would change its sign, which leaves.
bool step_to(const std::vector<ActiveColumn>& columns, const Eigen::VectorXd& to, Eigen::VectorXd& at,
             std::vector<bool>& takes_part) {
  double part = 1;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto k = static_cast<Eigen::Index>(c);
    if (takes_part[c] && !columns[c].is_free && to[k] <= 0) part = std::min(part, at[k] / (at[k] - to[k]));
  }
  at += part * (to - at);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (takes_part[c] && !columns[c].is_free && at[static_cast<Eigen::Index>(c)] <= 0 && part < 1) {
      takes_part[c] = false;
      at[static_cast<Eigen::Index>(c)] = 0;
    }
  return part == 1;
}

/// Multipliers with signs, and the smallest rest of `wanted`.
Eigen::VectorXd signed_combination(const std::vector<ActiveColumn>& columns, const Eigen::VectorXd& wanted) {
  std::vector<bool> takes_part;
  for (const ActiveColumn& column : columns) takes_part.push_back(column.is_free);
  Eigen::VectorXd at = combination(columns, takes_part, wanted);
  const double small = 1e-12 * (1 + wanted.cwiseAbs().maxCoeff());
  for (std::size_t round = 0; round < 3 * columns.size(); ++round) {
    const Eigen::VectorXd rest = rest_of(columns, at, wanted);
    std::size_t best = columns.size();
    double most = small;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double gain = columns[c].gradient.dot(rest);
      if (takes_part[c] || gain <= most) continue;
      most = gain;
      best = c;
    }
    if (best == columns.size()) break;
    takes_part[best] = true;
    while (!step_to(columns, combination(columns, takes_part, wanted), at, takes_part)) {
    }
  }
  return at;
}

/// Adds a row by which weights of gradients add up to one, and the gradients as columns with signs.
void add_gradients(const std::vector<Eigen::VectorXd>& gradients, std::vector<double>& weights,
                   std::vector<ActiveColumn>& columns, Eigen::VectorXd& wanted) {
  const Eigen::Index size = wanted.size();
  double lever = 0;
  for (const Eigen::VectorXd& gradient : gradients) lever = std::max(lever, 100 * gradient.cwiseAbs().maxCoeff());
  const auto longer = [&](const Eigen::VectorXd& column, double last) {
    Eigen::VectorXd result(size + 1);
    result << column, last;
    return result;
  };
  for (ActiveColumn& column : columns) column.gradient = longer(column.gradient, 0);
  weights.assign(gradients.size(), 0);
  for (std::size_t g = 0; g < gradients.size(); ++g) columns.push_back({longer(gradients[g], lever), &weights[g]});
  wanted = longer(Eigen::VectorXd::Zero(size), lever);
}

}  // namespace

Optimality optimality_at(const ProgrammePoint& point, const Eigen::VectorXd& variables, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper, double size, const std::vector<Eigen::VectorXd>& beside) {
  Optimality result;
  result.inequalities.setZero(point.inequalities.size());
  result.equalities.setZero(point.equalities.size());
  result.bounds.setZero(variables.size());
  result.at_bound.assign(static_cast<std::size_t>(variables.size()), 0);
  std::vector<ActiveColumn> columns = active_columns(point, variables, lower, upper, result);
  Eigen::VectorXd wanted = -point.gradient;
  std::vector<double> weights;
  if (!beside.empty()) {
    std::vector<Eigen::VectorXd> gradients = beside;
    gradients.push_back(point.gradient);
    add_gradients(gradients, weights, columns, wanted);
  }
  const Eigen::VectorXd multipliers = signed_combination(columns, wanted);
  for (std::size_t c = 0; c < columns.size(); ++c)
    *columns[c].multiplier = columns[c].sign * multipliers[static_cast<Eigen::Index>(c)];
  Eigen::VectorXd rest = rest_of(columns, multipliers, wanted).head(variables.size());
  if (!beside.empty()) {
    const double share = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (Eigen::VectorXd* list : {&rest, &result.inequalities, &result.equalities, &result.bounds}) *list /= share;
  }
  result.rest = rest.cwiseAbs().maxCoeff() / size;
  constexpr double kNone = 1e-6;  // of the size: a goal that is reached, as a target
  const double own = std::max(std::abs(point.goal), point.gradient.cwiseAbs().maxCoeff());
  result.own_rest = own > kNone * size ? result.rest * size / own : result.rest;
  result.rest_direction = rest;
  return result;
}

}  // namespace mbgen::optimise
