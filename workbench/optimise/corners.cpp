#include "workbench/optimise/corners.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen::optimise {
namespace {

constexpr double kLongestStep = 1e-2, kShorter = 0.1;  // of scaled variables
/// Part of the expected fall that makes a step.
constexpr double kFalls = 0.1;

/// A point of the descent and the gradients seen around it.
struct Bundle {
  Eigen::VectorXd at;
  ProgrammePoint point;
  std::vector<Eigen::VectorXd> beside;
};

/// Constraints that a step can reach count as active.
ProgrammePoint reached(ProgrammePoint point, double step) {
  for (Eigen::Index k = 0; k < point.inequalities.size(); ++k)
    point.near[k] += step * point.of_inequalities.row(k).norm();
  return point;
}

bool keeps_constraints(const ProgrammePoint& from, const ProgrammePoint& to) {
  for (Eigen::Index k = 0; k < to.inequalities.size(); ++k)
    if (to.inequalities[k] > std::max(from.inequalities[k], to.near[k])) return false;
  for (Eigen::Index e = 0; e < to.equalities.size(); ++e)
    if (std::abs(to.equalities[e]) > std::max(std::abs(from.equalities[e]), kActivePart)) return false;
  return true;
}

}  // namespace

std::optional<CornerEnd> corner_near(const Programme& programme, const Eigen::VectorXd& variables, double size,
                                     int most, double shortest) {
  Bundle bundle{variables, {}, {}};
  if (!programme.evaluate(variables, true, bundle.point)) return {};
  Optimality optimality;
  for (double step = kLongestStep; step > 0.5 * shortest; step *= kShorter) {
    bundle.beside.clear();
    const std::size_t most_beside = 2 * static_cast<std::size_t>(variables.size()) + 2;
    for (;;) {
      optimality =
          optimality_at(reached(bundle.point, step), bundle.at, programme.lower, programme.upper, size, bundle.beside);
      if (optimality.rest <= kSmallRest) break;
      if (bundle.beside.size() > most_beside || --most < 0 || (programme.goes_on && !programme.goes_on())) break;
      const double length = optimality.rest_direction.norm();
      const Eigen::VectorXd to =
          (bundle.at + (step / length) * optimality.rest_direction).cwiseMax(programme.lower).cwiseMin(programme.upper);
      ProgrammePoint there;
      if (!programme.evaluate(to, true, there)) break;
      const bool is_lower = there.goal < bundle.point.goal - kFalls * step * length;
      if (is_lower && keeps_constraints(bundle.point, there)) {
        bundle = {to, std::move(there), {}};
      } else {
        bundle.beside.push_back(there.gradient);
      }
    }
  }
  if (optimality.rest > kSmallRest || bundle.beside.empty()) return {};
  return CornerEnd{bundle.at, optimality};
}

std::optional<Optimality> multipliers_around(const Programme& programme, const Eigen::VectorXd& variables,
                                             double size) {
  constexpr double kStep = 3e-3, kRest = 1e-2;  // of scaled variables; of the size, as gradients change over the step
  ProgrammePoint point;
  if (!programme.evaluate(variables, true, point)) return {};
  point = reached(std::move(point), kStep);
  const auto optimality = [&](const std::vector<Eigen::VectorXd>& beside) {
    return optimality_at(point, variables, programme.lower, programme.upper, size, beside);
  };
  std::vector<Eigen::VectorXd> beside;
  Optimality found = optimality({});
  for (Eigen::Index k = 0; k < 2 * variables.size() + 2; ++k) {
    if (!beside.empty() && found.rest <= kRest) return found;
    const Eigen::VectorXd to = variables + kStep * found.rest_direction.normalized();
    ProgrammePoint there;
    if (!programme.evaluate(to.cwiseMax(programme.lower).cwiseMin(programme.upper), true, there)) return {};
    // The point's own gradient is of differences across the corner.
    if (k == 0)
      point.gradient = there.gradient;
    else
      beside.push_back(there.gradient);
    found = optimality(beside);
  }
  return {};
}

}  // namespace mbgen::optimise
