// Start from standstill: times to speeds, and the distance that the vehicle rolls back.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr int kSpeeds[] = {20, 50, 80, 100};  // km/h
constexpr double kDrives = 0.1;               // m/s

/// The first time from `from` on at which the speed is reached, by linear interpolation; NaN: never, or it is reached
/// already.
double time_of(const VehicleSeries& s, double speed, double from) {
  const std::size_t first = first_point(s, from);
  if (first >= s.t.size() || s.speed[first] >= speed) return std::nan("");
  return time_of_rise(s.t, s.speed, speed, first);
}

/// Way along the heading of the start, m, at each point.
Values ways_of(const VehicleSeries& s) {
  const double c = std::cos(s.heading.front()), d = std::sin(s.heading.front());
  Values ways;
  for (std::size_t i = 0; i < s.t.size(); ++i) ways.push_back(c * (s.x[i] - s.x.front()) + d * (s.y[i] - s.y.front()));
  return ways;
}

}  // namespace

VehicleMetrics start_metrics(const VehicleSeries& s, const StandingStart& start) {
  const std::string fault = fault_of(s, {{"x", &s.x},
                                         {"y", &s.y},
                                         {"heading", &s.heading},
                                         {"speed", &s.speed},
                                         {"longitudinal acceleration", &s.longitudinal_acceleration}});
  if (!fault.empty()) return refused("standing start", fault);
  VehicleMetrics metrics;
  const Values ways = ways_of(s);
  add(metrics, "rollback", std::max(0.0, -*std::ranges::min_element(ways)), "m",
      "largest way backwards from the start");
  if (const double moves = time_of(s, kDrives, start.at); std::isfinite(moves))
    add(metrics, "time_to_move", moves - start.at, "s", fmt::format("until the vehicle drives at {:g} m/s", kDrives));
  else
    metrics.notes.push_back(s.speed[std::min(first_point(s, start.at), s.t.size() - 1)] >= kDrives
                                ? "time_to_move: the vehicle moves already when the drive takes over"
                                : "time_to_move: the vehicle does not move forward");
  for (const int speed : kSpeeds) {
    const double time = time_of(s, speed / 3.6, start.at);
    if (std::isfinite(time))
      add(metrics, fmt::format("time_to_{}", speed), time - start.at, "s",
          fmt::format("from the start of the drive to {} km/h", speed));
  }
  add(metrics, "distance", ways.back(), "m", "at the end");
  add(metrics, "speed", s.speed.back(), "m/s", "at the end");
  add(metrics, "largest_longitudinal_acceleration", largest(s.longitudinal_acceleration), "m/s^2", "in magnitude");
  metrics.diagrams.push_back({"Standing start", {"time", "s"}, {"speed", "m/s"}, {{"speed", s.t, s.speed}}});
  return metrics;
}

}  // namespace mbgen
