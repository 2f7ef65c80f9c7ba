#pragma once
// Driver model that steers along a course, and speed controller. Both act at instants.

#include "workbench/manoeuvre/manoeuvre.hpp"
#include "workbench/manoeuvre/path.hpp"
#include "workbench/manoeuvre/signal.hpp"

namespace mbgen {

/// Motion of a vehicle in the plane.
struct PlaneMotion {
  double x = 0, y = 0, heading = 0;  ///< m, m, rad
  double forward = 0, left = 0;      ///< m/s, along and across the heading
  double lateral_acceleration = 0;   ///< m/s^2
  /// rad, direction of the velocity
  double course() const;
  /// m/s, over the ground
  double speed() const;
};

/// Position of the driver along the course.
struct CoursePlace {
  double way = 0;     ///< m
  double offset = 0;  ///< m, of the vehicle to the left of the course
};

/// Position along the path, by a search near the last one.
CoursePlace find_place(const Path& path, const PlaneMotion& motion, double last_way);

/// Mean angle of the road wheels, rad, for which the vehicle would follow the course. The curvature is the course's
/// curvature at the vehicle's position after lag seconds, plus a correction of 2 gain e / L^2. Here e is the deviation
/// of the course at the preview distance L from the straight line along the velocity, minus the bend of the course
/// itself (single-point preview: M. Kondo, A. Ajimine, SAE 680104; C. C. MacAdam, Vehicle System Dynamics 40 (2003)).
/// The angle is wheelbase times curvature, plus `understeer` times the lateral acceleration.
double steering_target(const Path& path, const CoursePlace& place, const PlaneMotion& motion,
                       const DriverSettings& driver, double wheelbase);

/// Second derivative of the angle over the next `period` seconds, constant: critically damped tracking of the wanted
/// angle, with limits in the units of the angle.
struct HandLimits {
  double angle = 0, rate = 0;
};
double hand_acceleration(const Rates& now, double wanted, double lag, double period, const HandLimits& limits);

/// PI controller with limits; the integral is frozen at a limit (anti-windup).
class SpeedController {
 public:
  /// Wanted acceleration, m/s^2, from least to most.
  double acceleration(const SpeedSettings& settings, double wanted, double actual, double period, double least,
                      double most);

 private:
  double integral_ = 0;  ///< m/s^2
};

}  // namespace mbgen
