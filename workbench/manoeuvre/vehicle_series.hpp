#pragma once
// Time series of a vehicle's motion for metrics, and a metric's value.

#include <string>
#include <vector>

namespace mbgen {

/// The motion of a vehicle at equal steps of time, SI units; every vector has one value per point of `t`.
struct VehicleSeries {
  std::vector<double> t, x, y, heading;      ///< s, m, m, rad, of the reference point, world frame
  std::vector<double> speed, lateral_speed;  ///< m/s, along and across the heading, horizontal
  /// m/s^2, horizontal, in axes turned by the heading
  std::vector<double> longitudinal_acceleration, lateral_acceleration;
  std::vector<double> vertical_acceleration;  ///< m/s^2, upwards, without gravity; for ride
  std::vector<double> yaw_rate, roll, pitch;  ///< rad/s, rad, rad
  std::vector<double> steer;                  ///< rad, at the steering input
  std::vector<std::vector<double>> loads;     ///< N, per tyre, in the order of `wheels`
  struct Wheel {
    std::string tyre;
    int axle = 0;
    bool is_left = false;
  };
  std::vector<Wheel> wheels;
  /// Motion of the last towed unit's reference point, as above; empty: no towed unit.
  struct Towed {
    std::vector<double> x, y, heading, lateral_acceleration, yaw_rate;
  };
  Towed towed;
};

/// A number that a standard defines.
struct VehicleMetric {
  std::string name;
  double value = 0;
  std::string unit;     ///< SI; "1" where there is none
  std::string meaning;  ///< for people: definition, with the standard's number
};

}  // namespace mbgen
