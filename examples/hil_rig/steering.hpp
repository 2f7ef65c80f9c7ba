#pragma once
// The actuator at the pitman arm. A network brings angles that jump; a driven coordinate needs an angle with the rate
// and the acceleration that belong to it (docs/use/driven.md).

#include <algorithm>

namespace hil_rig {

/// A servo without overshoot, with limits.
struct Servo {
  double bandwidth = 50;             ///< rad/s, both poles
  double largest_rate = 1.5;         ///< rad/s
  double largest_acceleration = 40;  ///< rad/s^2
};

/// Acceleration, rad/s^2, constant during the next step of h seconds, of a servo at an angle (rad) that moves with a
/// rate (rad/s) and is asked for `wanted` (rad).
constexpr double servo_acceleration(const Servo& servo, double wanted, double angle, double rate, double h) {
  const double w = servo.bandwidth;
  const double aimed = std::clamp(w / 2 * (wanted - angle), -servo.largest_rate, servo.largest_rate);
  // The rate after the step never passes the one aimed at.
  const double strength = std::min(2 * w, 1 / h);
  return std::clamp(strength * (aimed - rate), -servo.largest_acceleration, servo.largest_acceleration);
}

}  // namespace hil_rig
