// Steady motions as text and as linear systems; stationary auxiliary states.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "compiler/algebra/dense.hpp"
#include "compiler/linearisation/bristles.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/solver/newton.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/operating/steady_checks.hpp"
#include "workbench/operating/steady_motion.hpp"

namespace mbgen {

using StateKind = LinearState::Kind;

std::string free_directions_note(const Compilation& compilation, const SteadyMotion& steady) {
  if (steady.free_directions.empty()) return "";
  return fmt::format(
      "{}: note: too few rates are held for one steady motion; the one near the start is given, and one "
      "may go from it along\n  {}\n  hint: hold one more rate with --hold, or solve for one input less\n",
      compilation.model.file, fmt::join(steady.free_directions, "\n  "));
}

std::string corners_note(const Compilation& compilation, const SteadyMotion& steady) {
  constexpr double kStill = 1e-9, kAside = 1e-9, kCorner = 1e-4;  // rad/s or m/s, likewise; of the largest derivative
  constexpr double kSmooth = 1e-6;  // 1/s or 1/s^2: changes of derivatives that smooth laws have over these sides
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(steady.point.inputs);
  std::vector<Eigen::MatrixXd> sides;
  for (const double side : {-kAside, kAside}) {
    OperatingPoint point = steady.point;
    for (const int i : free_coordinates(compilation.topology, compilation.analysis)) {
      double& rate = point.zd[static_cast<std::size_t>(i)];
      if (std::abs(rate) < kStill) rate += side;
    }
    GenericState state{point.z, point.zd, point.x, point.t};
    if (!solver.project(state).ok()) return "";
    point.z = state.z;
    point.zd = state.zd;
    const Result<LinearSystem> system = linearise(compilation, point);
    if (!system || system->A.size() == 0) return "";
    sides.push_back(system->A);
  }
  const Eigen::Index velocities = sides[0].rows() / 2;  // rows of rates of velocities and states
  const Eigen::MatrixXd apart = (sides[1] - sides[0]).bottomRows(velocities);
  const Eigen::VectorXd largest = sides[0].bottomRows(velocities).cwiseAbs().rowwise().maxCoeff();
  const Eigen::VectorXd allowed = (kCorner * largest).cwiseMax(kSmooth);
  const bool is_at_corner = (apart.cwiseAbs().rowwise().maxCoeff().array() > allowed.array()).any();
  if (!is_at_corner) return "";
  return fmt::format(
      "{}: note: parts at rest are at corners of their force laws, as dampers of two slopes: modes and gains "
      "take the side that rounding has\n  hint: give these laws one slope about rest\n",
      compilation.model.file);
}

std::string instant_note(const Compilation& compilation, const SteadyMotion& steady) {
  if (steady.changes.empty()) return "";
  return fmt::format(
      "{}: note: the motion is steady at this position alone: {}, so that no coordinate goes on at its rate\n"
      "  hint: modes and gains are those at this instant; simulate the motion, or choose another coordinate to move\n",
      compilation.model.file, steady.changes);
}

std::string steady_text(const Compilation& compilation, const SteadyMotion& steady, const SteadyRequest& request) {
  constexpr double kStill = 1e-9;  // rad/s or m/s: rounding
  std::string text = fmt::format("steady motion, accelerations at most {:.1e}:\n", steady.largest);
  for (const int i : free_coordinates(compilation.topology, compilation.analysis)) {
    const TreeBody& body = compilation.topology.bodies[i];
    if (std::abs(steady.point.zd[i]) < kStill) continue;
    text += fmt::format("  {:<32}{:>16.9g} {}/s\n", "zd." + body.coordinate, steady.point.zd[i], unit_of(body.kind));
  }
  for (std::size_t i = 0; i < compilation.model.inputs.size(); ++i) {
    const Input& input = compilation.model.inputs[i];
    if (std::find(request.solve.begin(), request.solve.end(), input.name) == request.solve.end()) continue;
    text += fmt::format("  {:<32}{:>16.9g} {}\n", input.name, steady.point.inputs[i], input.unit);
  }
  return text + "\n";
}

void set_steady_states(const Compilation& compilation, OperatingPoint& point) {
  set_steady_bristles(compilation.model, compilation.topology, point);
  const std::vector<AuxiliaryState> states = auxiliary_states(compilation.model);
  const auto count = static_cast<Eigen::Index>(point.x.size()) - held_state_count(compilation.model);
  Eigen::VectorXd size(count);
  for (Eigen::Index i = 0; i < count; ++i) size[i] = magnitude_of(states[static_cast<std::size_t>(i)]);
  for (int step = 0; step < kNewtonIterations && count > 0; ++step) {
    const LinearSystem system = expect(linearise(compilation, point));
    const Eigen::VectorXd left = system.drift.tail(count).cwiseQuotient(size);
    if (left.cwiseAbs().maxCoeff() < kSteady) return;
    const Eigen::MatrixXd matrix =
        size.cwiseInverse().asDiagonal() * system.A.bottomRightCorner(count, count) * size.asDiagonal();
    const Eigen::VectorXd by = least_squares(matrix, left, kIndifferentShare);
    for (Eigen::Index i = 0; i < count; ++i) point.x[static_cast<std::size_t>(i)] -= size[i] * by[i];
  }
}

LinearSystem turning_with(const SteadyMotion& motion, LinearSystem system) {
  if (motion.across[0] < 0) return system;
  const auto row_of = [&](StateKind kind, int coordinate) -> Eigen::Index {
    const auto is_it = [&](const LinearState& state) { return state.kind == kind && state.index == coordinate; };
    return std::find_if(system.states.begin(), system.states.end(), is_it) - system.states.begin();
  };
  for (const StateKind kind : {StateKind::position, StateKind::velocity}) {
    const Eigen::Index first = row_of(kind, motion.across[0]), second = row_of(kind, motion.across[1]);
    system.A(first, second) += motion.turning;
    system.A(second, first) -= motion.turning;
  }
  return system;
}

void mark_places(const SteadyMotion& motion, std::vector<Mode>& list) {
  constexpr double kSame = 1e-6;  // rad/s
  if (motion.across[0] < 0) return;
  for (Mode& mode : list) {
    const double off = std::abs(mode.eigenvalue - std::complex<double>(0, std::abs(motion.turning)));
    if (off > kSame) continue;
    mode.is_neutral = true;
    mode.is_unstable = false;
  }
  std::stable_partition(list.begin(), list.end(), [](const Mode& mode) { return !mode.is_neutral; });
}

}  // namespace mbgen
