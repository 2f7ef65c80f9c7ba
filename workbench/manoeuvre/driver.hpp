#pragma once
// A driver who steers along a course, and a controller of speed. Both act at instants.

#include "workbench/manoeuvre/manoeuvre.hpp"
#include "workbench/manoeuvre/path.hpp"
#include "workbench/manoeuvre/signal.hpp"

namespace mbgen {

/// How a vehicle moves on the plane.
struct PlaneMotion {
  double x = 0, y = 0, heading = 0;  ///< m, m, rad
  double forward = 0, left = 0;      ///< m/s, along and across the heading
  double lateral_acceleration = 0;   ///< m/s^2
  /// rad, direction of the velocity
  double course() const;
  /// m/s, over the ground
  double speed() const;
};

/// Where the driver is on the course.
struct CoursePlace {
  double way = 0;     ///< m
  double offset = 0;  ///< m, of the vehicle to the left of the course
};

/// The place for a motion, near the last one.
CoursePlace find_place(const Path& path, const PlaneMotion& motion, double last_way);

/// The mean angle of the road wheels, rad, for which the vehicle would follow the course. The curvature is the course's
/// curvature at the vehicle's position after lag seconds, plus a correction: the deviation e of the course at the
/// preview distance L from the straight line along the velocity, minus the bend of the course itself, gives 2 gain e /
/// L^2 (single-point preview: M. Kondo, A. Ajimine, SAE 680104; C. C. MacAdam, Vehicle System Dynamics 40 (2003)).
/// Wheels turn by wheelbase times curvature, and by `understeer` times the lateral acceleration.
double steering_wish(const Path& path, const CoursePlace& place, const PlaneMotion& motion,
                     const DriverSettings& driver, double wheelbase);

/// The angle's second derivative over the next `period` seconds, constant: a critically damped follower of the wish
/// with limits, all in the units of the angle.
struct HandLimits {
  double angle = 0, rate = 0;
};
double hand_acceleration(const Rates& now, double wish, double lag, double period, const HandLimits& limits);

/// Gain and integral with limits; the integral stands still where a limit holds.
class SpeedController {
 public:
  /// Acceleration wanted, m/s^2, from least to most.
  double acceleration(const SpeedSettings& settings, double wanted, double actual, double period, double least,
                      double most);

 private:
  double integral_ = 0;  ///< m/s^2
};

}  // namespace mbgen
