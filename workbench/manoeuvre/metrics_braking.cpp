// Braking to standstill: mean fully developed deceleration by UN Regulation 13, annex 4; deviation on split friction
// by ISO 14512.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kUpper = 0.8, kLower = 0.1;  ///< of the initial speed: range of the mean deceleration
constexpr double kStandstill = 0.25;  ///< m/s: below it the remaining distance follows from the mean deceleration

/// Speed along the path and distance travelled, per point.
struct Way {
  Values t = {}, speed = {}, length = {};  ///< from the start of braking on
  std::size_t first = 0;
};

Way way_of(const VehicleSeries& s, double begin) {
  Way way{.first = first_point(s, begin)};
  double length = 0;
  for (std::size_t i = way.first; i < s.t.size(); ++i) {
    if (i > way.first) length += std::hypot(s.x[i] - s.x[i - 1], s.y[i] - s.y[i - 1]);
    way.t.push_back(s.t[i]);
    way.speed.push_back(std::hypot(s.speed[i], s.lateral_speed[i]));
    way.length.push_back(length);
  }
  return way;
}

/// Time and distance of the first fall of the speed to a value; NaN if there is none.
struct Fall {
  double time = 0, length = 0;
};

Fall fall_to(const Way& way, double speed) {
  Values fallen;
  for (const double value : way.speed) fallen.push_back(-value);
  const double time = time_of_rise(way.t, fallen, -speed, 0);
  const auto i = static_cast<std::size_t>(std::upper_bound(way.t.begin(), way.t.end(), time) - way.t.begin());
  if (std::isnan(time) || i == 0) return {std::nan(""), std::nan("")};
  if (i == way.t.size()) return {time, way.length.back()};
  const double step = way.t[i] - way.t[i - 1], share = (time - way.t[i - 1]) / step;
  // Between two points the deceleration is constant.
  const double bend = (way.speed[i] - way.speed[i - 1]) * step / 2 * share * (share - 1);
  return {time, way.length[i - 1] + share * (way.length[i] - way.length[i - 1]) + bend};
}

void add_decelerations(VehicleMetrics& metrics, const Way& way) {
  const double begin = way.speed.front();
  const Fall upper = fall_to(way, kUpper * begin), lower = fall_to(way, kLower * begin);
  if (std::isnan(lower.time)) {
    metrics.notes.push_back(
        fmt::format("mean_fully_developed_deceleration, stopping_distance: the speed falls from {:.4g} to {:.4g} m/s, "
                    "not to {:.4g}",
                    begin, *std::min_element(way.speed.begin(), way.speed.end()), kLower * begin));
    return;
  }
  const double developed = (kUpper * kUpper - kLower * kLower) * begin * begin / (2 * (lower.length - upper.length));
  add(metrics, "mean_fully_developed_deceleration", developed, "m/s^2",
      "from 80 to 10 % of the speed, over the way (UN Regulation 13, annex 4)");
  const double slow = std::min(kStandstill, kLower * begin);
  const Fall end = fall_to(way, slow);
  if (std::isnan(end.time)) {
    metrics.notes.push_back(fmt::format(
        "stopping_distance: the vehicle does not stop, its speed is {:.4g} m/s at the end", way.speed.back()));
    return;
  }
  const double distance = end.length + slow * slow / (2 * developed);
  add(metrics, "stopping_distance", distance, "m", "distance from the start of braking to standstill");
  add(metrics, "stopping_time", end.time + slow / developed - way.t.front(), "s",
      "from the start of braking to standstill");
  add(metrics, "mean_deceleration", begin * begin / (2 * distance), "m/s^2", "that gives the stopping distance");
}

void add_deviations(VehicleMetrics& metrics, const VehicleSeries& s, std::size_t first) {
  const double c = std::cos(s.heading[first]), k = std::sin(s.heading[first]);
  Values across, turn;
  for (std::size_t i = first; i < s.t.size(); ++i) {
    across.push_back(-k * (s.x[i] - s.x[first]) + c * (s.y[i] - s.y[first]));
    turn.push_back(s.heading[i] - s.heading[first]);
  }
  add(metrics, "largest_lateral_deviation", largest(across), "m", "of the reference point from its initial line");
  add(metrics, "lateral_deviation", across.back(), "m", "at the end, to the left");
  add(metrics, "heading_change", turn.back(), "rad", "at the end, to the left");
  add(metrics, "largest_yaw_rate", largest(s.yaw_rate, {first, s.t.size()}), "rad/s", "either side, while braking");
}

}  // namespace

VehicleMetrics braking_metrics(const VehicleSeries& s, const Braking& braking) {
  std::string fault = fault_of(s, {{"x", &s.x},
                                   {"y", &s.y},
                                   {"heading", &s.heading},
                                   {"speed", &s.speed},
                                   {"lateral speed", &s.lateral_speed},
                                   {"yaw rate", &s.yaw_rate}});
  Way way;
  if (fault.empty()) {
    way = way_of(s, braking.begin);
    if (way.t.size() < 3) {
      fault = fmt::format("the series ends at {:.4g} s, braking begins at {:.4g} s", s.t.back(), braking.begin);
    } else if (!(way.speed.front() > 2 * kStandstill)) {
      fault = fmt::format("the speed is {:.3g} m/s when braking begins", way.speed.front());
    }
  }
  if (!fault.empty()) return refused("braking", fault);
  VehicleMetrics metrics;
  add(metrics, "initial_speed", way.speed.front(), "m/s", "when braking begins");
  add_decelerations(metrics, way);
  add_deviations(metrics, s, way.first);
  metrics.diagrams.push_back(
      {"Speed while braking", {"way", "m"}, {"speed", "m/s"}, {{"speed", way.length, way.speed}}});
  return metrics;
}

}  // namespace mbgen
