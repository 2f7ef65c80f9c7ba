#pragma once
// Inverse dynamics of a generated solver: its program at a consistent state, and what its monitors say. `System` is
// described in blocks.hpp; of one with actuators it offers kActuators, kActuatedDirections, the type ActuatorForces and the program
// inverse_dynamics.

#include "mbgen/blocks.hpp"
#include "mbgen/number.hpp"

namespace mbgen {

/// Smallest pivot of an actuator, over its median in the analysed configurations, with which forces are given: below it
/// they are fifty times what they usually are, and lose two digits.
template <class Real>
inline constexpr Real kLeastActuation = Real(0.02);

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

}  // namespace solver_detail

/// Forces of the actuators at a consistent state for the accelerations of the independent coordinates.
/// Fails: not_a_number, loop_singular where the independent coordinates do not determine the others,
/// actuators_singular; the forces are then unchanged.
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
  if (!status.ok()) return status;
  copy(values.force, forces.force, System::kActuators);
  copy(values.zdd, forces.zdd, System::kCoordinates);
  return {};
}

}  // namespace mbgen
