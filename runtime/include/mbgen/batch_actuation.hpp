#pragma once
// Inverse dynamics of several instances in lanes, see lanes/batch.hpp and actuation.hpp.

#include "mbgen/actuation.hpp"
#include "mbgen/lanes/batch.hpp"

namespace mbgen {

/// Forces of the actuators, as solve_inverse_dynamics. Result: the good lanes.
template <class System>
typename System::Mask actuate_lanes(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                    const typename System::State& state, const typename System::JointForces* forces,
                                    const typename System::Derivative& derivative,
                                    typename System::ActuatorForces& result) noexcept {
  using namespace batch_detail;
  typename System::Mask good = arguments_are_finite<System>(parameters, inputs, state, forces);
  typename System::InverseDynamics values;
  run_groups(System::inverse_dynamics, values, parameters, inputs, state, *forces, derivative);
  good &= pivots_reach<System>(values.pivot, kPivotThreshold<double>);
  for (int k = 0; k < System::kActuatedDirections; ++k) good &= values.actuation[k] >= kLeastActuation<double>;
  for (int i = 0; i < System::kActuators; ++i) result.force[i] = values.force[i];
  for (int i = 0; i < System::kCoordinates; ++i) result.zdd[i] = values.zdd[i];
  return good & is_finite(sum(values.zdd, System::kCoordinates) + sum(values.force, System::kActuators));
}

}  // namespace mbgen
