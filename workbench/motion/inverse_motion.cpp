#include "workbench/motion/inverse_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/choice_at.hpp"

namespace mbgen {
namespace {

/// Accelerations that others determine less than by this share are open.
constexpr double kOpen = 1e-9;

/// Independent accelerations that meet the given ones: all accelerations are linear in them. is_open: whether these
/// leave others open.
Status complete(const Engine& engine, const LoadedState& at, const std::vector<double>& given,
                const std::vector<int>& free, GenericDerivative& derivative, bool& is_open) {
  Status status;
  const auto all_with = [&](int moved) {
    GenericDerivative trial = derivative;
    trial.zdd.assign(given.size(), 0.0);
    if (moved >= 0) trial.zdd[static_cast<std::size_t>(moved)] = 1;
    std::vector<double> force;
    if (status.ok()) status = engine.inverse_dynamics(at, trial, force);
    return trial.zdd;
  };
  const std::vector<double> start = all_with(-1);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!std::isnan(given[i])) rows.push_back(i);
  Eigen::MatrixXd matrix(rows.size(), free.size());
  Eigen::VectorXd right(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) right[static_cast<Eigen::Index>(r)] = given[rows[r]] - start[rows[r]];
  for (std::size_t q = 0; q < free.size(); ++q) {
    const std::vector<double> moved = all_with(free[q]);
    for (std::size_t r = 0; r < rows.size(); ++r)
      matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(q)) = moved[rows[r]] - start[rows[r]];
  }
  if (!status.ok()) return status;
  is_open = rows.size() < free.size() || leading_columns(matrix, kOpen).size() < free.size();
  if (is_open) return {};
  const Eigen::VectorXd independent = overdetermined_solution(matrix, right);
  derivative.zdd.assign(given.size(), 0.0);
  for (std::size_t q = 0; q < free.size(); ++q)
    derivative.zdd[static_cast<std::size_t>(free[q])] = independent[static_cast<Eigen::Index>(q)];
  return {};
}

bool are_given(const std::vector<double>& given, const std::vector<int>& coordinates) {
  return std::ranges::none_of(coordinates, [&](int i) { return std::isnan(given[static_cast<std::size_t>(i)]); });
}

/// The forces by the independent coordinates of a compilation.
InverseMotion forces_by(const Engine& engine, const Compilation& compilation, const LoadedState& at,
                        const std::vector<double>& given) {
  const std::vector<int> free = free_coordinates(compilation.topology, compilation.analysis);
  InverseMotion motion;
  motion.derivative = {given, std::vector<double>(at.state.x.size(), 0.0)};
  for (double& value : motion.derivative.zdd) value = std::isnan(value) ? 0 : value;
  bool is_open = false;
  if (!are_given(given, free)) motion.status = complete(engine, at, given, free, motion.derivative, is_open);
  if (is_open)
    for (const int i : free) motion.open.push_back(compilation.topology.bodies[static_cast<std::size_t>(i)].coordinate);
  if (motion.ok()) motion.status = engine.inverse_dynamics(at, motion.derivative, motion.force);
  return motion;
}

}  // namespace

InverseMotion actuator_forces(const Engine& engine, const Compilation& compilation, const std::vector<double>& inputs,
                              const LoadedState& at, const std::vector<double>& given) {
  InverseMotion motion = forces_by(engine, compilation, at, given);
  if (motion.status.code != Code::loop_singular) return motion;
  Compilation here{compilation.model, compilation.topology};
  std::optional<Analysis> chosen = chosen_at(compilation.model, compilation.topology, compilation.analysis, at.state.z);
  if (!chosen || !has_inverse_dynamics(here.model, here.topology, *chosen)) return motion;
  here.analysis = *std::move(chosen);
  const Engine anew = make_generic_engine(here, {});
  anew.set_inputs(inputs);
  return forces_by(anew, here, at, given);
}

std::string describe(const Compilation& compilation, const InverseMotion& motion) {
  return motion.open.empty() ? describe(compilation, motion.status) : "the given accelerations leave others open";
}

std::string hint_of(const InverseMotion& motion) {
  if (motion.open.empty()) return "";
  return fmt::format("give those of as many coordinates as determine the motion, for example {}",
                     fmt::join(motion.open, ", "));
}

Status close_around(const GenericSolver& poses, const Compilation& compilation, const std::vector<double>& given,
                    GenericState& state) {
  std::vector<int> kept = free_coordinates(compilation.topology, compilation.analysis);
  if (!are_given(given, kept)) {
    kept.clear();
    for (std::size_t i = 0; i < given.size(); ++i)
      if (!std::isnan(given[i])) kept.push_back(static_cast<int>(i));
  }
  const auto targets = [&](const std::vector<double>& values) {
    std::vector<CoordinateTarget> list;
    for (const int i : kept) list.push_back({i, values[static_cast<std::size_t>(i)], 1, true});
    return list;
  };
  const std::vector<CoordinateTarget> positions = targets(state.z), rates = targets(state.zd);
  GenericState closed = state;
  Status status = poses.project(closed);
  std::ranges::fill(closed.zd, 0.0);
  if (status.ok()) status = poses.assemble(closed, positions);
  if (status.ok()) status = poses.assemble_velocities(closed, rates);
  if (status.ok()) state = closed;
  return status;
}

std::vector<double> beyond_limits(const Model& model, const std::vector<double>& force) {
  std::vector<double> beyond(force.size(), 0.0);
  for (std::size_t i = 0; i < force.size(); ++i)
    if (const std::optional<double>& limit = model.actuators[i].limit; limit && !(std::abs(force[i]) <= *limit))
      beyond[i] = std::abs(force[i]) - *limit;
  return beyond;
}

}  // namespace mbgen
