#pragma once
// Faults of a manoeuvre's motion: the vehicle leaves its course, turns across it, or slides.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"
#include "workbench/manoeuvre/driver.hpp"

namespace mbgen {

constexpr double kCircleLeft = 0.5;  ///< m, ISO 4138: the path is within 0.5 m of the circle
constexpr double kLaneLeft = 1.75;   ///< m, half a lane

/// Time of the first occurrence of each fault, s.
struct CourseWatch {
  std::optional<double> leaves, turns, slides;

  /// Adds a point. place: on the course, none without a course. most: lateral offset of leaving it, m. heading: of the
  /// course, rad.
  void add(double t, const PlaneMotion& motion, const std::optional<CoursePlace>& place, double most, double heading);

  /// Warnings, a line each.
  std::vector<std::string> warnings(double most) const;
};

/// Mean heading of the foremost wheels minus the rearmost ones', rad to the left; none for a vehicle of one axle.
std::optional<double> steer_angle(const Compilation& compilation, const GenericState& state,
                                  const std::vector<double>& inputs);

/// Angle of the foremost wheels minus the angle of the rearmost, over the angle at the steering input, at a start;
/// positive to the left. None if the input moves no wheels: it is not an angle, or a force steers the wheels.
std::optional<double> steering_slope(const Compilation& compilation, const GenericState& start,
                                     const std::vector<double>& inputs);

}  // namespace mbgen
