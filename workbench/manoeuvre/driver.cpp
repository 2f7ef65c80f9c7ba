#include "workbench/manoeuvre/driver.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen {

double PlaneMotion::course() const {
  constexpr double kStands = 0.1;  // m/s, below which the velocity has no direction
  return std::abs(forward) < kStands ? heading : heading + std::atan2(left, forward);
}

double PlaneMotion::speed() const { return std::hypot(forward, left); }

CoursePlace find_place(const Path& path, const PlaneMotion& motion, double last_way) {
  const double way = path.nearest(motion.x, motion.y, last_way);
  const PathPoint point = path.at(way);
  return {way, (motion.y - point.y) * std::cos(point.heading) - (motion.x - point.x) * std::sin(point.heading)};
}

double steering_target(const Path& path, const CoursePlace& place, const PlaneMotion& motion,
                       const DriverSettings& driver, double wheelbase) {
  constexpr double kShortest = 3;  // m
  const double speed = std::max(0.0, motion.forward), ahead = std::max(kShortest, speed * driver.preview);
  const PathPoint here = path.at(place.way), soon = path.at(place.way + speed * driver.anticipation);
  const double deviation = -place.offset + ahead * std::sin(here.heading - motion.course());
  const double curvature = soon.curvature + driver.gain * 2 * deviation / (ahead * ahead);
  return wheelbase * curvature + driver.understeer * speed * speed * curvature;
}

double hand_acceleration(const Rates& now, double wanted, double lag, double period, const HandLimits& limits) {
  // The period is a part of the lag: a constant acceleration over it follows without ringing.
  const double frequency = std::min(2 / lag, 0.5 / period);
  const double target = std::clamp(wanted, -limits.angle, limits.angle);
  const double free = frequency * frequency * (target - now.value) - 2 * frequency * now.rate;
  return (std::clamp(now.rate + free * period, -limits.rate, limits.rate) - now.rate) / period;
}

double SpeedController::acceleration(const SpeedSettings& settings, double wanted, double actual, double period,
                                     double least, double most) {
  const double error = wanted - actual, proportional = settings.gain * error;
  const double next = integral_ + settings.gain * error * period / settings.integral_time;
  const double sum = proportional + next;
  if ((sum <= most || error < 0) && (sum >= least || error > 0)) integral_ = next;
  return std::clamp(proportional + integral_, least, most);
}

}  // namespace mbgen
