#pragma once
// When a vehicle stops to do what its manoeuvre means: off its course, across it, or sliding.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"
#include "workbench/manoeuvre/driver.hpp"

namespace mbgen {

constexpr double kCircleLeft = 0.5;  ///< m, ISO 4138: the path is within 0.5 m of the circle
constexpr double kLaneLeft = 1.75;   ///< m, half a lane

/// Times at which it first happens, s.
struct CourseWatch {
  std::optional<double> leaves, turns, slides;

  /// A point. place: on the course, none where there is none. most: m beside it, farther off it is left. heading: rad,
  /// of the course there.
  void add(double t, const PlaneMotion& motion, const std::optional<CoursePlace>& place, double most, double heading);

  /// Warnings, a line each.
  std::vector<std::string> warnings(double most) const;
};

/// Angle of the wheels of the foremost tyres minus the angle of the rearmost, rad to the left, for one at the steering
/// input; at a start. None if the input moves no wheels: it is then no angle, or a force turns them.
std::optional<double> steering_slope(const Compilation& compilation, const GenericState& start,
                                     const std::vector<double>& inputs);

}  // namespace mbgen
