#include "plant.hpp"

namespace hil_rig {

namespace {

mbgen::Status evaluate(Plant& plant) noexcept {
  constexpr double kNoForces[coach_rig::kCoordinates] = {};
  coach_rig::Derivative derivative;
  const mbgen::Status status =
      coach_rig::accelerations_in_motion(plant.parameters, plant.inputs, plant.state, kStep, derivative);
  if (!status.ok()) return status;
  return coach_rig::outputs(plant.parameters, plant.inputs, plant.state, kNoForces, derivative, plant.outputs);
}

}  // namespace

mbgen::Status start(Plant& plant) noexcept {
  plant = {};
  plant.state = coach_rig::initial_state();
  const mbgen::Status status = coach_rig::assemble(plant.parameters, plant.inputs, plant.state);
  return status.ok() ? evaluate(plant) : status;
}

mbgen::Status step(Plant& plant, const Command& command) noexcept {
  Plant next = plant;
  next.inputs.steering_acceleration =
      servo_acceleration(next.servo, command.steering, next.inputs.steering, next.inputs.steering_rate, kStep);
  next.inputs.drive_torque = command.drive_torque;
  mbgen::Status status = coach_rig::step_rk4(next.parameters, next.inputs, next.state, kStep);
  if (!status.ok()) return status;
  next.inputs = coach_rig::advance_inputs(next.inputs, kStep);
  status = evaluate(next);
  if (status.ok()) plant = next;
  return status;
}

Motion motion_of(const Plant& plant) noexcept {
  using coach_rig::Coordinate;
  const coach_rig::Outputs& out = plant.outputs;
  const double* z = plant.state.z;
  return {plant.state.t,
          z[Coordinate::chassis_tx],
          z[Coordinate::chassis_ty],
          z[Coordinate::chassis_rz],
          out.roll,
          out.forward_speed,
          out.yaw_rate,
          out.lateral_acceleration,
          plant.inputs.steering,
          out.steering_torque,
          {out.load_front_left, out.load_front_right, out.load_rear_left, out.load_rear_right}};
}

Values values_of(const coach_rig::Parameters& parameters) noexcept {
  return {parameters.air_pressure_front, parameters.air_pressure_rear, parameters.bar_front, parameters.bar_rear,
          parameters.drag_area};
}

coach_rig::Parameters parameters_of(const Values& values) noexcept {
  using coach_rig::Parameter;
  return {values[Parameter::air_pressure_front], values[Parameter::air_pressure_rear], values[Parameter::bar_front],
          values[Parameter::bar_rear], values[Parameter::drag_area]};
}

bool set_parameter(coach_rig::Parameters& parameters, std::uint32_t number, double value) noexcept {
  const Values own = values_of({});
  if (number >= own.size() || !(value >= 0.1 * own[number] && value <= 10 * own[number])) return false;
  Values values = values_of(parameters);
  values[number] = value;
  parameters = parameters_of(values);
  return true;
}

}  // namespace hil_rig
