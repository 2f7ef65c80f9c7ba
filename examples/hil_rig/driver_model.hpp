#pragma once
// A driver: steers towards a point on the path ahead, and keeps the speed. Pure functions.

#include <algorithm>
#include <cmath>

#include "packet.hpp"

namespace hil_rig {

/// Task and constants of the driver.
struct Driver {
  double lane_change = 3.5;    ///< m to the left, and back again
  double out_at = 30;          ///< m along the road, where the way out begins
  double back_at = 110;        ///< m, where the way back begins
  double length = 50;          ///< m, of each of both
  double speed = 20;           ///< m/s
  double preview = 1.0;        ///< s, looks so far ahead
  double curvature = 0.087;    ///< 1/m of the coach's path over rad of the pitman arm, at 20 m/s
  double largest_angle = 0.3;  ///< rad, at the pitman arm
  double torque_at_speed = 640, torque_gain = 8000, largest_torque = 12000;  ///< N m, N m s/m, N m
};

/// Where the path is at x (m along the road): m to the left of the start, a double lane change.
inline double path(const Driver& driver, double x) {
  const auto change = [&](double from) {
    const double s = std::clamp((x - from) / driver.length, 0.0, 1.0);
    return s * s * s * (10 - 15 * s + 6 * s * s);
  };
  return driver.lane_change * (change(driver.out_at) - change(driver.back_at));
}

/// The driver's command for a motion of the coach: the circle through the coach and the point ahead, tangent to the
/// heading, gives the curvature; the speed is kept proportionally.
inline Command drive(const Driver& driver, const Motion& motion) {
  const double ahead = driver.preview * std::max(motion.forward_speed, 5.0);
  const double dx = ahead * std::cos(motion.yaw);
  const double dy = path(driver, motion.x + dx) - motion.y;
  const double sideways = dy * std::cos(motion.yaw) - dx * std::sin(motion.yaw);
  const double curvature = 2 * sideways / (ahead * ahead);
  const double torque = driver.torque_at_speed + driver.torque_gain * (driver.speed - motion.forward_speed);
  return {std::clamp(curvature / driver.curvature, -driver.largest_angle, driver.largest_angle),
          std::clamp(torque, -driver.largest_torque, driver.largest_torque)};
}

}  // namespace hil_rig
