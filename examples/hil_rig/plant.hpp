#pragma once
// The coach on the rig: the emitted solver of models/coach_rig.json, one step a cycle. Nothing here allocates or
// blocks.

#include <array>

#include "coach_rig.hpp"
#include "packet.hpp"
#include "steering.hpp"

namespace hil_rig {

constexpr double kStep = 1e-3;  ///< s, of the model and of the clock

/// The coach at a time, and what it was told.
struct Plant {
  coach_rig::Tuned parameters;
  coach_rig::Inputs inputs;
  coach_rig::State state{};
  coach_rig::Outputs outputs{};
  Servo servo;
};

/// The coach in static equilibrium at 20 m/s. Fails as coach_rig::assemble.
mbgen::Status start(Plant& plant) noexcept;

/// One step with a command, then the outputs. A plant that fails stays as it was.
/// Fails as coach_rig::step_rk4 and coach_rig::accelerations_in_motion.
mbgen::Status step(Plant& plant, const Command& command) noexcept;

Motion motion_of(const Plant& plant) noexcept;

using Values = std::array<double, coach_rig::kParameters>;

/// Tunable parameters by their numbers, and back.
Values values_of(const coach_rig::Parameters& parameters) noexcept;
coach_rig::Parameters parameters_of(const Values& values) noexcept;

/// Sets parameter `number`. Result: whether there is such a parameter and `value` is between a tenth and ten times the
/// model's own.
bool set_parameter(coach_rig::Parameters& parameters, std::uint32_t number, double value) noexcept;

}  // namespace hil_rig
