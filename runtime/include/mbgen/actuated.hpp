#pragma once
// All coordinates of a mechanism from its actuators: positions and rates from a near pose, accelerations, the Jacobian,
// and forces from actuators to coordinates and back. `System` is described in blocks.hpp and
// solver/actuated_motion.hpp. Of more actuators than directions motions are those of least weighted squares, forces
// those of least weighted norm.

#include "mbgen/independent.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/actuated_motion.hpp"

namespace mbgen {

namespace solver_detail {

/// Arguments, and everything at a position. Fails: not_a_number, loop_singular, actuators_singular.
template <class System>
Status look_at(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
               const typename System::State& state, ActuatedMotion<System>& motion) noexcept {
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  const Status status = motion.look(parameters, inputs, state);
  return status.ok() ? motion.actuators_status() : status;
}

/// Lets coordinates that an actuator moves alone be where it has them.
template <class System>
void set_own_coordinates(const typename System::ActuatorTerms& seen, const RealOf<System>* position,
                         typename System::State& state) noexcept {
  using Real = RealOf<System>;
  for (int i = 0; i < System::kActuators; ++i) {
    const Real* const direction = seen.direction + i * System::kCoordinates;
    int own = -1, moved = 0;
    for (int c = 0; c < System::kCoordinates; ++c)
      if (direction[c] != Real(0)) own = c, ++moved;
    if (moved == 1) state.z[own] += (position[i] - seen.position[i]) / direction[own];
  }
}

/// Newton's step: closes the loops, brings driven coordinates to their motions and the actuators to `position`.
template <class System>
void step_to(ActuatedMotion<System>& motion, const RealOf<System>* position, RealOf<System>* dz) noexcept {
  RealOf<System> along[System::kActuators];
  for (int i = 0; i < System::kActuators; ++i) along[i] = position[i] - motion.seen.position[i];
  motion.each_block(dz, [](const auto& solution, RealOf<System>* x) { solution.closing(x); });
  motion.add_along(along, dz);
}

/// Positions and velocities of driven coordinates beside a state, zero of the others.
template <class System>
void driven_motion(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   const typename System::State& state, RealOf<System>* dz, RealOf<System>* zd) noexcept {
  for (int i = 0; i < System::kCoordinates; ++i) dz[i] = zd[i] = RealOf<System>(0);
  if constexpr (System::kHasClosure) {
    if constexpr (System::kDrives > 0) {
      typename System::Closure closure;
      System::closure(parameters, inputs, state, closure);
      for (const int c : System::kDriveCoordinate) dz[c] = closure.dz[c], zd[c] = closure.zd[c];
    }
  }
  static_cast<void>(parameters), static_cast<void>(inputs), static_cast<void>(state);
}

/// Whether loops stay open, with the block of the worst equation.
template <class System>
Status open_loops([[maybe_unused]] const ActuatedMotion<System>& motion) noexcept {
  if constexpr (System::kBlocks > 0) {
    for (int e = 0; e < System::kEquations; ++e)
      if (!(magnitude(motion.loops.terms.Phi[e]) <= kRedundantTolerance<RealOf<System>>))
        return {Code::loop_not_closed, block_of<System>(e)};
  }
  return {};
}

/// z += dz, shortened when a coordinate would jump.
template <class System>
void take_step(const RealOf<System>* dz, typename System::State& state) noexcept {
  using Real = RealOf<System>;
  const Real factor = shortening(largest(dz, System::kCoordinates), kLargestNewtonStep<Real>);
  for (int c = 0; c < System::kCoordinates; ++c) state.z[c] += factor * dz[c];
}

/// Newton's iteration to the positions of the actuators; then motion is at them. Fails: loop_singular, loop_not_closed.
template <class System>
Status move_actuators(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const RealOf<System>* position, typename System::State& trial, ActuatedMotion<System>& motion,
                      RealOf<System>* zd) noexcept {
  using Real = RealOf<System>;
  constexpr Real tolerance = closure_tolerance<System>();
  Real dz[System::kCoordinates], previous = std::numeric_limits<Real>::infinity();
  int derivatives = kDerivativeSteps;
  for (int left = kNewtonIterations + 1; left > 0; --left) {
    const Status status = motion.look(parameters, inputs, trial);
    if (!status.ok()) return status;
    driven_motion<System>(parameters, inputs, trial, dz, zd);
    step_to<System>(motion, position, dz);
    const Real size = largest(dz, System::kCoordinates);
    if (!is_finite(size)) break;
    const bool gains = size > Real(0) && size < Real(0.5) * previous && left > 1;
    const bool is_there = size <= tolerance || (!gains && size <= kRoundingFloor<Real>);
    if (is_there && (derivatives-- == 0 || keeps_derivatives(dz, trial.z, System::kCoordinates)))
      return open_loops<System>(motion);
    previous = size;
    take_step<System>(dz, trial);
  }
  const Status open = open_loops<System>(motion);
  return open.ok() ? Status{Code::loop_not_closed, System::kBlocks > 0 ? 0 : -1} : open;
}

}  // namespace solver_detail

/// Closes the loops with the motors at these positions and speeds, from the state as a near pose.
/// Fails: not_a_number, loop_singular, actuators_singular; loop_not_closed also when another coordinate would jump; the
/// state is then unchanged.
template <class System>
Status complete_joints(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const RealOf<System>* position, const RealOf<System>* speed,
                       typename System::State& state) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  if (!is_finite(sum(position, System::kActuators) + sum(speed, System::kActuators))) return {Code::not_a_number, -1};
  ActuatedMotion<System> motion;
  typename System::State start, trial;
  copy_state<System>(state, start);
  System::actuators(parameters, inputs, state, motion.seen);
  set_own_coordinates<System>(motion.seen, position, start);
  copy_state<System>(start, trial);
  RealOf<System> zd[System::kCoordinates];
  const Status moved = move_actuators<System>(parameters, inputs, position, trial, motion, zd);
  if (!moved.ok()) return moved;
  const Status singular = motion.actuators_status();
  if (!singular.ok()) return singular;
  if constexpr (System::kBlocks > 0) {
    const int block = moved_far<System>(start, trial);
    if (block >= 0) return {Code::loop_not_closed, block};
  }
  motion.each_block(zd, [](const auto& solution, RealOf<System>* x) { solution.moving(x); });
  motion.add_along(speed, zd);
  copy(zd, trial.zd, System::kCoordinates);
  const int bad = first_not_finite(trial.zd, System::kCoordinates);
  if (bad >= 0) return {Code::not_a_number, bad};
  copy_state<System>(trial, state);
  return {};
}

/// Positions and speeds of the motors at a state. Fails: not_a_number.
template <class System>
Status actuator_positions(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& state, RealOf<System>* position,
                          RealOf<System>* speed) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  typename System::ActuatorTerms seen;
  System::actuators(parameters, inputs, state, seen);
  for (int i = 0; i < System::kActuators; ++i) {
    position[i] = seen.position[i];
    speed[i] = RealOf<System>(0);
    for (int c = 0; c < System::kCoordinates; ++c)
      speed[i] += seen.direction[i * System::kCoordinates + c] * state.zd[c];
  }
  return {};
}

/// All accelerations from those of the motors, at a consistent state. Fails: not_a_number, loop_singular,
/// actuators_singular.
template <class System>
Status complete_accelerations(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                              const typename System::State& state, const RealOf<System>* acceleration,
                              RealOf<System>* zdd) noexcept {
  using namespace solver_detail;
  using Real = RealOf<System>;
  ActuatedMotion<System> motion;
  const Status status = look_at<System>(parameters, inputs, state, motion);
  if (!status.ok()) return status;
  Real all[System::kCoordinates] = {}, along[System::kActuators];
  if constexpr (System::kBlocks > 0) {
    if constexpr (System::kDrives > 0)
      for (const int c : System::kDriveCoordinate) all[c] = motion.loops.terms.driven_acceleration[c];
  }
  motion.each_block(all, [](const auto& solution, Real* x) { solution.accelerating(x); });
  for (int i = 0; i < System::kActuators; ++i) along[i] = acceleration[i] - motion.seen.drift[i];
  motion.add_along(along, all);
  const int bad = first_not_finite(all, System::kCoordinates);
  if (bad >= 0) return {Code::not_a_number, bad};
  copy(all, zdd, System::kCoordinates);
  return {};
}

/// Rates of all coordinates for a unit speed of each motor, row by row: coordinates x actuators. Motions are left out.
/// Fails: not_a_number, loop_singular, actuators_singular; the rates are then unchanged.
template <class System>
Status actuator_jacobian(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                         const typename System::State& state, RealOf<System>* jacobian) noexcept {
  using namespace solver_detail;
  using Real = RealOf<System>;
  constexpr int n = System::kCoordinates, count = System::kActuators;
  ActuatedMotion<System> motion;
  const Status status = look_at<System>(parameters, inputs, state, motion);
  if (!status.ok()) return status;
  for (int i = 0; i < count; ++i) {
    Real unit[count] = {}, rates[n] = {};
    unit[i] = Real(1);
    motion.add_along(unit, rates);
    for (int c = 0; c < n; ++c) jacobian[c * count + i] = rates[c];
  }
  return {};
}

/// Forces of the motors with the same virtual work as generalised forces tau on the coordinates: the static map.
/// Fails: not_a_number, loop_singular, actuators_singular; the forces are then unchanged.
template <class System>
Status forces_at_actuators(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, const RealOf<System>* tau,
                           RealOf<System>* force) noexcept {
  using namespace solver_detail;
  constexpr int count = System::kActuators;
  ActuatedMotion<System> motion;
  const Status status = look_at<System>(parameters, inputs, state, motion);
  if (!status.ok()) return status;
  RealOf<System> found[count];
  motion.forces_for(tau, found);
  if (!is_finite(sum(found, count))) return {Code::not_a_number, first_not_finite(tau, System::kCoordinates)};
  copy(found, force, count);
  return {};
}

namespace solver_detail {

/// Generalised forces on all coordinates by forces of the motors.
template <class System>
void forces_of_actuators(const typename System::ActuatorTerms& seen, const RealOf<System>* force,
                         RealOf<System>* tau) noexcept {
  for (int c = 0; c < System::kCoordinates; ++c) {
    tau[c] = RealOf<System>(0);
    for (int i = 0; i < System::kActuators; ++i) tau[c] += seen.direction[i * System::kCoordinates + c] * force[i];
  }
}

/// Takes generalised forces on dependent coordinates over to the independent ones of the frozen partition.
/// Fails: loop_singular where these do not determine a block.
template <class System>
Status take_to_independent(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, RealOf<System>* tau) noexcept {
  using Real = RealOf<System>;
  FactorsOfFrozen<System> frozen;
  frozen.look(parameters, inputs, state);
  LoopFactorsOf<Real> loop;
  Real local[System::kBlockCoordinates], lambda[System::kEquations];
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    if (const Status status = frozen.factorise(b, loop); !status.ok()) return status;
    const int* const coordinate = System::kBlockCoordinate + block.first_coordinate;
    for (int c = 0; c < block.coordinates; ++c) local[c] = tau[coordinate[c]];
    solve_transposed(loop, local, lambda, frozen.factors.work);
    for (int c = 0; c < block.coordinates; ++c) tau[coordinate[c]] = local[c];
  }
  for (int c = 0; c < System::kCoordinates; ++c)
    if (frozen.independent[c] == 0) tau[c] = Real(0);  // of driven ones
  return {};
}

}  // namespace solver_detail

/// Generalised forces on the independent coordinates with the same virtual work as forces of the motors, zero on the
/// others. Fails: not_a_number, loop_singular where these coordinates do not determine the others; tau is then
/// unchanged.
template <class System>
Status forces_at_independent(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                             const typename System::State& state, const RealOf<System>* force,
                             RealOf<System>* tau) noexcept {
  using namespace solver_detail;
  constexpr int n = System::kCoordinates;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  typename System::ActuatorTerms seen;
  System::actuators(parameters, inputs, state, seen);
  RealOf<System> found[n];
  forces_of_actuators<System>(seen, force, found);
  if constexpr (System::kBlocks > 0) {
    const Status status = take_to_independent<System>(parameters, inputs, state, found);
    if (!status.ok()) return status;
  }
  if (!is_finite(sum(found, n))) return {Code::not_a_number, -1};
  copy(found, tau, n);
  return {};
}

}  // namespace mbgen
