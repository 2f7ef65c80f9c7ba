#include "workbench/operating/steady_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/solver/bristle.hpp"
#include "mbgen/solver/newton.hpp"

namespace mbgen {
namespace {

constexpr double kWeighed = 1e-8;    // of the model's weight: smaller forces are rounding errors
constexpr double kSettled = 1e-5;    // 1/s: the same for rates of auxiliary states, relative to their magnitudes
constexpr double kFree = 1e-4;       // smallest component in a direction without effect
constexpr double kNamedPart = 1e-2;  // of the largest component of a direction

/// N, or N m at a lever of 1 m.
double least_force(const Model& model) {
  const auto add = [](double sum, const Body& body) { return sum + body.mass.value; };
  const double mass = std::accumulate(model.bodies.begin(), model.bodies.end(), 0.0, add);
  const double g = std::hypot(model.gravity[0].value, model.gravity[1].value, model.gravity[2].value);
  return kWeighed * mass * (g > 0 ? g : 1);
}

/// See free_directions. parts: components by choices.
std::string direction_text(const std::vector<SteadyChoice>& choices, const Eigen::VectorXd& parts) {
  const auto rates = std::count_if(choices.begin(), choices.end(), [](const SteadyChoice& c) { return c.is_rate; });
  Eigen::Index first = 0;
  const double largest = parts.cwiseAbs().maxCoeff(&first);
  if (rates > 0 && parts.head(rates).cwiseAbs().maxCoeff() > kFree * kFree * largest)
    parts.head(rates).cwiseAbs().maxCoeff(&first);
  const double rate = std::abs(parts[first]);
  std::vector<std::string> list;
  for (Eigen::Index k = 0; k < parts.size(); ++k) {
    const double least = kNamedPart * (k < rates ? rate : largest);
    if (std::abs(parts[k]) >= least)
      list.push_back(fmt::format("{} {:+.3g}", choices[static_cast<std::size_t>(k)].name, parts[k] / parts[first]));
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

}  // namespace

Eigen::VectorXd column_sizes(const Eigen::MatrixXd& matrix) {
  return matrix.colwise().norm().transpose().cwiseMax(1e-12);
}

bool is_weighed_out(const Compilation& compilation, const GenericSolver& solver, const OperatingPoint& point,
                    const Eigen::VectorXd& left) {
  const GenericState state{point.z, point.zd, point.x, point.t};
  std::vector<double> tau(state.z.size(), 0.0);
  GenericDerivative free, pushed;
  if (!left.allFinite() || !solver.accelerations(state, tau, free).ok()) return false;
  Eigen::Index row = 0;
  for (const int i : free_coordinates(compilation.topology, compilation.analysis)) {
    const auto at = static_cast<std::size_t>(i);
    tau[at] = least_force(compilation.model);
    if (!solver.accelerations(state, tau, pushed).ok()) return false;
    tau[at] = 0;
    if (std::abs(left[row++]) > std::max(kSteady, std::abs(pushed.zdd[at] - free.zdd[at]))) return false;
  }
  return row == left.size() || left.tail(left.size() - row).cwiseAbs().maxCoeff() < kSettled;
}

ScaledSystem::ScaledSystem(const Eigen::MatrixXd& matrix, bool scales_rows) : size_(column_sizes(matrix)) {
  const Eigen::MatrixXd columns = matrix * size_.cwiseInverse().asDiagonal();
  weight_ = Eigen::VectorXd::Ones(matrix.rows());
  if (scales_rows) weight_ = column_sizes(columns.transpose()).cwiseInverse();
  matrix_ = weight_.asDiagonal() * columns;
}

Eigen::VectorXd ScaledSystem::correction(const Eigen::VectorXd& wanted) const {
  return least_squares(matrix_, weight_.cwiseProduct(wanted), kIndifferentShare);
}

void require_holding(const Model& model, const OperatingPoint& point, const std::vector<BristleEnd>& bristles) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < bristles.size(); ++i) {
    const BristleEnd& bristle = bristles[i];
    const double bent = std::abs(point.x[static_cast<std::size_t>(first_bristle(model)) + i]);
    if (bristle.slides() || bent <= bristle.holds * (1 + kRounding)) continue;
    throw UserError(
        fmt::format("{}: no steady motion found: friction \"{}\" would have to hold {:.4g} times what it "
                    "can\n  hint: let the coordinate move at the start, or hold it with --hold\n",
                    model.file, bristle.name, bent / std::max(bristle.holds, kLeastBristle)));
  }
}

std::string changes_along(const Compilation& compilation, const LinearSystem& system, const OperatingPoint& point,
                          double turning, const int (&across)[2]) {
  constexpr double kChanges = 1e-5;  // 1/s^2: change of accelerations over the fastest rate
  const std::vector<int> independent = free_coordinates(compilation.topology, compilation.analysis);
  const Eigen::Index positions = position_count(system);
  const auto rate_of = [&](int coordinate) { return point.zd[static_cast<std::size_t>(coordinate)]; };
  const auto& [first, second] = across;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(independent.size()));
  double fastest = 0;
  for (Eigen::Index j = 0; j < system.A.cols(); ++j) {
    const LinearState& state = system.states[static_cast<std::size_t>(j)];
    const bool is_velocity = state.kind == LinearState::Kind::velocity;
    double rate = 0;
    if (state.kind == LinearState::Kind::position) rate = rate_of(state.index);
    fastest = std::max(fastest, std::abs(rate));
    if (is_velocity && state.index == first) rate = -turning * rate_of(second);
    if (is_velocity && state.index == second) rate = turning * rate_of(first);
    change += rate * system.A.col(j).segment(positions, change.size());
  }
  // The centripetal accelerations turn with the motion.
  for (Eigen::Index row = 0; row < change.size(); ++row) {
    const int coordinate = independent[static_cast<std::size_t>(row)];
    if (coordinate == first || coordinate == second) change[row] += turning * turning * rate_of(coordinate);
  }
  Eigen::Index place = 0;
  if (change.size() == 0 || !(change.cwiseAbs().maxCoeff(&place) > kChanges * fastest)) return "";
  const TreeBody& body =
      compilation.topology.bodies[static_cast<std::size_t>(independent[static_cast<std::size_t>(place)])];
  return fmt::format("the acceleration of {} changes by {:.3g} {}/s^2 a second", body.coordinate,
                     std::abs(change[place]), unit_of(body.kind));
}

std::vector<std::string> free_directions(const Eigen::MatrixXd& derivatives, const std::vector<SteadyChoice>& choices) {
  if (choices.empty()) return {};
  const Eigen::VectorXd size = column_sizes(derivatives);
  const auto [values, vectors] = right_singular_vectors(derivatives * size.cwiseInverse().asDiagonal());
  const auto is_felt = [least = kIndifferentShare * values[0]](double value) { return value > least; };
  const auto rank = std::count_if(values.begin(), values.end(), is_felt);
  if (rank == derivatives.cols()) return {};
  Eigen::MatrixXd of_choices(static_cast<Eigen::Index>(choices.size()), derivatives.cols() - rank);
  Eigen::VectorXd units(of_choices.rows());
  for (Eigen::Index k = 0; k < units.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(choices[static_cast<std::size_t>(k)].column);
    of_choices.row(k) = vectors.row(column).tail(of_choices.cols());
    units[k] = size[column];
  }
  const auto [shares, directions] = left_singular_vectors(of_choices);
  std::vector<std::string> texts;
  for (Eigen::Index d = 0; d < shares.size() && shares[d] > kFree; ++d)
    texts.push_back(direction_text(choices, directions.col(d).cwiseQuotient(units)));
  return texts;
}

}  // namespace mbgen
