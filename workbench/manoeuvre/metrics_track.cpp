// Drive along a course: the accelerations used.

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {

using namespace manoeuvre;

VehicleMetrics track_metrics(const VehicleSeries& s) {
  const std::string fault = fault_of(s, {{"speed", &s.speed},
                                         {"lateral acceleration", &s.lateral_acceleration},
                                         {"longitudinal acceleration", &s.longitudinal_acceleration}});
  if (!fault.empty()) return refused("track", fault);
  VehicleMetrics metrics;
  double way = 0;
  for (std::size_t i = 1; i < s.t.size(); ++i) way += (s.t[i] - s.t[i - 1]) * (s.speed[i] + s.speed[i - 1]) / 2;
  add(metrics, "mean_speed", way / (s.t.back() - s.t.front()), "m/s", "over time");
  add(metrics, "largest_speed", largest(s.speed), "m/s", "");
  add(metrics, "largest_lateral_acceleration", largest(s.lateral_acceleration), "m/s^2", "in magnitude");
  add(metrics, "largest_acceleration", *std::ranges::max_element(s.longitudinal_acceleration), "m/s^2", "forward");
  add(metrics, "largest_deceleration", -*std::ranges::min_element(s.longitudinal_acceleration), "m/s^2", "braking");
  metrics.diagrams.push_back({"Accelerations",
                              {"lateral acceleration", "m/s^2"},
                              {"longitudinal acceleration", "m/s^2"},
                              {{"driven", s.lateral_acceleration, s.longitudinal_acceleration}}});
  return metrics;
}

}  // namespace mbgen
