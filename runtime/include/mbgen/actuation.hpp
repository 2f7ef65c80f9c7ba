#pragma once
// Inverse dynamics of a generated solver: its program at a consistent state, and what its monitors say. `System` is
// described in blocks.hpp; of one with actuators it offers kActuators, kActuatedDirections, the type ActuatorForces and
// the program inverse_dynamics; where other pivots can be chosen at run time also the program required_forces.

#include "mbgen/blocks.hpp"
#include "mbgen/independent.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/actuated_motion.hpp"

namespace mbgen {

/// Share of the largest of given accelerations by which those of a loop block may differ from the loops' and still be
/// those of a motion.
template <class Real>
inline constexpr Real kConsistentAccelerations = Real(1e-8);
template <>
inline constexpr float kConsistentAccelerations<float> = 1e-3f;

namespace solver_detail {

/// Status of given accelerations and of the forces that a program found for them.
template <class System, class Values>
Status actuation_status(const Values& values, const typename System::Derivative& derivative) noexcept {
  if constexpr (System::kBlocks > 0) {
    const Status frozen = frozen_status<System>(values.pivot);
    if (!frozen.ok()) return frozen;
  }
  for (int k = 0; k < System::kActuatedDirections; ++k)
    if (!(values.actuation[k] >= kLeastActuation<RealOf<System>>)) return {Code::actuators_singular, k};
  const bool all_finite = is_finite(sum(values.zdd, System::kCoordinates) + sum(values.force, System::kActuators));
  if (all_finite) return {};
  const int coordinate = first_not_finite(derivative.zdd, System::kCoordinates);
  return {Code::not_a_number, coordinate >= 0 ? coordinate : first_not_finite(values.zdd, System::kCoordinates)};
}

/// Whether other pivots can be chosen where the frozen ones are bad.
template <class System, class = void>
inline constexpr bool kPivotsActuators = false;
template <class System>
inline constexpr bool kPivotsActuators<System, std::void_t<decltype(&System::required_forces)>> = true;

/// Whether accelerations of the coordinates of block b are those of `closed`.
template <class System>
bool are_alike(int b, const RealOf<System>* given, const RealOf<System>* closed) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  const int* const coordinate = System::kBlockCoordinate + block.first_coordinate;
  Real size(0), error(0);
  for (int c = 0; c < block.coordinates; ++c) {
    const Real value = given[coordinate[c]], difference = magnitude(closed[c] - value);
    size = magnitude(value) > size ? magnitude(value) : size;
    size = magnitude(closed[c]) > size ? magnitude(closed[c]) : size;
    error = difference > error || is_nan(difference) ? difference : error;
  }
  return error <= kConsistentAccelerations<Real> * size;
}

/// All accelerations from given ones: of a block whose given accelerations are a motion these, of others by the
/// independent coordinates of the frozen partition. Fails: loop_singular where neither determines a block.
template <class System>
Status complete_given(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, ActuatedMotion<System>& motion,
                      RealOf<System>* zdd) noexcept {
  using Real = RealOf<System>;
  FactorsOfFrozen<System> frozen;
  frozen.look(parameters, inputs, state);
  LoopFactorsOf<Real> loop;
  Real local[System::kBlockCoordinates];
  for (int i = 0; i < System::kCoordinates; ++i)
    if (System::kDriven[i] != 0) zdd[i] = frozen.terms.driven_acceleration[i];
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    const int* const coordinate = System::kBlockCoordinate + block.first_coordinate;
    const auto start = [&] {
      for (int c = 0; c < block.coordinates; ++c) local[c] = zdd[coordinate[c]];
    };
    start();
    motion.loops.solution(b).accelerating(local);
    if (!are_alike<System>(b, zdd, local)) {
      if (const Status status = frozen.factorise(b, loop); !status.ok()) return status;
      start();
      ByFactors<System>{b, loop, frozen.terms, frozen.factors.work, nullptr}.accelerating(local);
    }
    for (int c = 0; c < block.coordinates; ++c) zdd[coordinate[c]] = local[c];
  }
  return {};
}

/// Inverse dynamics by pivots of loops and actuators that are chosen here and now.
template <class System>
Status pivoted_inverse_dynamics(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                                const typename System::State& state, const RealOf<System>* tau,
                                const typename System::Derivative& derivative,
                                typename System::ActuatorForces& forces) noexcept {
  ActuatedMotion<System> motion;
  Status status = motion.look(parameters, inputs, state);
  if (!status.ok()) return status;
  typename System::Derivative all{};
  copy(derivative.zdd, all.zdd, System::kCoordinates);
  if constexpr (System::kBlocks > 0) {
    status = complete_given<System>(parameters, inputs, state, motion, all.zdd);
    if (!status.ok()) return status;
  }
  status = motion.actuators_status();
  if (!status.ok()) return status;
  typename System::RequiredForces needed;
  System::required_forces(parameters, inputs, state, tau, all, needed);
  RealOf<System> force[System::kActuators];
  motion.forces_for(needed.required, force);
  if (!is_finite(sum(all.zdd, System::kCoordinates) + sum(force, System::kActuators)))
    return {Code::not_a_number, first_not_finite(derivative.zdd, System::kCoordinates)};
  copy(force, forces.force, System::kActuators);
  copy(all.zdd, forces.zdd, System::kCoordinates);
  return {};
}

}  // namespace solver_detail

/// Forces of the actuators at a consistent state for the accelerations of the independent coordinates.
/// Where the independent coordinates hardly determine the others, all accelerations are read if they are those of a
/// motion. Fails: not_a_number, loop_singular where neither determines the motion, actuators_singular; the forces are
/// then unchanged.
template <class System>
Status solve_inverse_dynamics(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                              const typename System::State& state, const RealOf<System>* tau,
                              const typename System::Derivative& derivative,
                              typename System::ActuatorForces& forces) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, tau);
  if (!arguments.ok()) return arguments;
  typename System::InverseDynamics values;
  System::inverse_dynamics(parameters, inputs, state, tau, derivative, values);
  const Status status = actuation_status<System>(values, derivative);
  if constexpr (kPivotsActuators<System>) {
    const bool may_choose = status.code == Code::loop_singular ||
                            (status.code == Code::actuators_singular && System::kActuators > System::kFreeDirections);
    if (may_choose) return pivoted_inverse_dynamics<System>(parameters, inputs, state, tau, derivative, forces);
  }
  if (!status.ok()) return status;
  copy(values.force, forces.force, System::kActuators);
  copy(values.zdd, forces.zdd, System::kCoordinates);
  return {};
}

}  // namespace mbgen
