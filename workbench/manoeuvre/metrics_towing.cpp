// Motion of the last towed unit relative to the first unit, ISO 14791.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kLeastTurn = 0.1;     ///< m/s^2: below it the radius of a path is ill-conditioned
constexpr double kLinearUpTo = 3;      ///< m/s^2, upper end of the fitted line
constexpr double kLeastSwing = 0.02;   ///< of the largest: smaller extremes are noise
constexpr double kRestOfSteer = 1e-6;  ///< of the largest angle
constexpr double kLeastMotion = 1e-9;  ///< m/s^2 or rad/s, below it a unit is at rest

/// A point of the vehicle's plane.
struct At {
  double x = 0, y = 0;
};
At ahead(double x, double y, double heading, double along) {
  return {x + along * std::cos(heading), y + along * std::sin(heading)};
}

/// Offset of the rearmost axle's middle to the left of the foremost axle's path, at each point; NaN before the start of
/// that path.
Values offtracking(const VehicleSeries& s, const Towing& towing) {
  std::vector<At> path;
  for (std::size_t i = 0; i < s.t.size(); ++i) path.push_back(ahead(s.x[i], s.y[i], s.heading[i], towing.front));
  Values aside(s.t.size(), std::nan(""));
  std::size_t k = 0;
  for (std::size_t i = 1; i < s.t.size(); ++i) {
    const At rear = ahead(s.towed.x[i], s.towed.y[i], s.towed.heading[i], -towing.towed_rear);
    const auto along = [&](std::size_t from) {  // over the square of the piece
      return (rear.x - path[from].x) * (path[from + 1].x - path[from].x) +
             (rear.y - path[from].y) * (path[from + 1].y - path[from].y);
    };
    while (k + 1 < i && along(k + 1) >= 0) ++k;
    const double dx = path[k + 1].x - path[k].x, dy = path[k + 1].y - path[k].y, length = std::hypot(dx, dy);
    if (length == 0 || along(k) < 0) continue;
    aside[i] = (dx * (rear.y - path[k].y) - dy * (rear.x - path[k].x)) / length;
  }
  return aside;
}

/// Adds the offtracking of a circle from an instant on: to its inside, over lateral acceleration.
void add_circle(VehicleMetrics& metrics, const VehicleSeries& s, const Values& aside, double begin) {
  Values lateral, inwards;
  for (std::size_t i = first_point(s, begin); i < s.t.size(); ++i) {
    const double size = std::abs(s.lateral_acceleration[i]);
    if (std::isnan(aside[i]) || size < kLeastTurn || size > kLinearUpTo) continue;
    lateral.push_back(size);
    inwards.push_back(sign_of(s.yaw_rate[i]) * aside[i]);
  }
  if (lateral.size() < 10) return metrics.notes.push_back("offtracking: too few points in a turn below 3 m/s^2");
  const auto [low, high] = std::minmax_element(lateral.begin(), lateral.end());
  if (*high - *low < kLinearUpTo / 4) {
    add(metrics, "offtracking", mean(inwards, {0, inwards.size()}), "m",
        "of the rearmost axle to the inside of the foremost one's path (ISO 14791)");
    return;
  }
  const Line line = fitted_line(lateral, inwards);
  add(metrics, "offtracking", line.offset, "m",
      "of the rearmost axle to the inside of the foremost one's path, without lateral acceleration (ISO 14791)");
  add(metrics, "offtracking_gradient", line.slope, "m/(m/s^2)", "its growth with lateral acceleration");
  metrics.diagrams.push_back(
      {"Offtracking", {"lateral acceleration", "m/s^2"}, {"offtracking", "m"}, {{"inwards", lateral, inwards}}});
}

/// Adds the damping of the free articulation oscillation after the last change of the steer angle.
void add_damping(VehicleMetrics& metrics, const VehicleSeries& s) {
  std::size_t first = s.t.size() - 1;
  while (first > 0 && std::abs(s.steer[first - 1] - s.steer.back()) <= kRestOfSteer * largest(s.steer)) --first;
  Values rate;
  for (std::size_t i = 0; i < s.t.size(); ++i) rate.push_back(s.towed.yaw_rate[i] - s.yaw_rate[i]);
  const double most = largest(rate);
  Values swings;
  for (std::size_t i = std::max<std::size_t>(first, 1); i + 1 < rate.size(); ++i) {
    const double before = std::abs(rate[i - 1]), here = std::abs(rate[i]), behind = std::abs(rate[i + 1]);
    if (here < kLeastSwing * most || here < before || here <= behind || before == 0) continue;
    const double bend = before - 2 * here + behind;
    swings.push_back(sign_of(rate[i]) * (bend == 0 ? here : here - (behind - before) * (behind - before) / (8 * bend)));
  }
  double sum = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < swings.size(); ++i)
    if (swings[i] * swings[i - 1] < 0) sum += std::log(std::abs(swings[i - 1] / swings[i])), ++pairs;
  if (pairs < 2)
    return metrics.notes.push_back(
        "yaw_damping: behind the last change of the steer angle the articulation swings less than three times");
  const double decrement = sum / static_cast<double>(pairs);
  add(metrics, "yaw_damping", decrement / std::hypot(std::numbers::pi, decrement), "1",
      fmt::format("damping ratio of the articulation rate, mean of {} half swings (ISO 14791)", pairs));
}

}  // namespace

VehicleMetrics towing_metrics(const VehicleSeries& s, const Towing& towing) {
  const std::string fault = fault_of(s, {{"x of the towed unit", &s.towed.x},
                                         {"y of the towed unit", &s.towed.y},
                                         {"heading of the towed unit", &s.towed.heading},
                                         {"lateral acceleration of the towed unit", &s.towed.lateral_acceleration},
                                         {"yaw rate of the towed unit", &s.towed.yaw_rate},
                                         {"lateral acceleration", &s.lateral_acceleration},
                                         {"yaw rate", &s.yaw_rate},
                                         {"steer angle", &s.steer},
                                         {"x", &s.x},
                                         {"y", &s.y},
                                         {"heading", &s.heading}});
  if (!fault.empty()) return refused("towed unit", fault);
  VehicleMetrics metrics;
  const Values aside = offtracking(s, towing);
  // The headings of both units are without jumps each, but may begin whole turns apart.
  const double first = s.towed.heading.front() - s.heading.front();
  const double turns = first - std::remainder(first, 2 * std::numbers::pi);
  Values articulation;
  for (std::size_t i = 0; i < s.t.size(); ++i) articulation.push_back(s.towed.heading[i] - s.heading[i] - turns);
  add(metrics, "largest_articulation", largest(articulation), "rad", "heading of the last unit against the first");
  if (towing.is_circle) {
    add_circle(metrics, s, aside, towing.begin);
    return metrics;
  }
  const auto amplification = [&](const char* name, const Values& first, const Values& last, const char* meaning) {
    if (largest(first) > kLeastMotion) add(metrics, name, largest(last) / largest(first), "1", meaning);
  };
  amplification("rearward_amplification", s.lateral_acceleration, s.towed.lateral_acceleration,
                "largest lateral acceleration of the last unit, divided by the first unit's (ISO 14791)");
  amplification("rearward_amplification_yaw_rate", s.yaw_rate, s.towed.yaw_rate,
                "largest yaw rate of the last unit, divided by the first unit's (ISO 14791)");
  double most = 0;
  for (const double value : aside) most = std::max(most, std::isnan(value) ? 0 : std::abs(value));
  add(metrics, "largest_offtracking", most, "m", "of the rearmost axle from the foremost one's path (ISO 14791)");
  add_damping(metrics, s);
  return metrics;
}

}  // namespace mbgen
