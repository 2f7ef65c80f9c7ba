// Steady circle, ISO 4138.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kMostScatter = 0.1;   ///< residual of a fitted line, of the largest value
constexpr double kMostDetour = 0.05;   ///< of the nominal curvature
constexpr double kWindow = 1;          ///< s, averaging window of the largest lateral acceleration
constexpr double kLeastTurning = 0.1;  ///< m/s^2: below it the radius of a path is ill-conditioned

/// Points below the linear limit, and the values over them.
struct Linear {
  Values lateral, steer, curvature, sideslip, roll, yaw_rate;
  std::map<int, Values> transfer;  ///< N, per axle: half the difference of right and left load
};

Linear linear_range(const VehicleSeries& s, const SteadyCircle& circle) {
  Linear linear;
  const Values sideslip = sideslip_of(s);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double path_speed = std::hypot(s.speed[i], s.lateral_speed[i]);
    if (std::abs(s.lateral_acceleration[i]) > circle.linear_limit || path_speed == 0) continue;
    linear.lateral.push_back(s.lateral_acceleration[i]);
    linear.steer.push_back(s.steer[i] / circle.steering_ratio);
    linear.curvature.push_back(s.yaw_rate[i] / path_speed);
    linear.sideslip.push_back(sideslip[i]);
    linear.roll.push_back(s.roll[i]);
    linear.yaw_rate.push_back(s.yaw_rate[i]);
    std::map<int, double> sums;
    for (std::size_t w = 0; w < s.wheels.size(); ++w)
      sums[s.wheels[w].axle] += (s.wheels[w].is_left ? -0.5 : 0.5) * s.loads[w][i];
    for (const auto& [axle, sum] : sums) linear.transfer[axle].push_back(sum);
  }
  return linear;
}

std::string fault_of_circle(const VehicleSeries& s, const SteadyCircle& circle) {
  const std::string fault = fault_of(s, {{"speed", &s.speed},
                                         {"lateral speed", &s.lateral_speed},
                                         {"lateral acceleration", &s.lateral_acceleration},
                                         {"yaw rate", &s.yaw_rate},
                                         {"roll angle", &s.roll},
                                         {"steer angle", &s.steer}});
  if (!fault.empty()) return fault;
  if (const std::string of_loads = fault_of_loads(s); !of_loads.empty()) return of_loads;
  if (!(circle.wheelbase > 0)) return "the wheelbase is not known";
  if (!(std::abs(circle.steering_ratio) > 0)) return "the steering ratio is zero";
  return "";
}

/// Adds a slope over lateral acceleration. largest_size: of the fitted quantity, reference of its scatter.
bool add_gradient(VehicleMetrics& metrics, const std::string& name, const Linear& linear, const Values& values,
                  double largest_size, const std::string& unit, const std::string& meaning) {
  const Line line = fitted_line(linear.lateral, values);
  if (line.left > kMostScatter * largest_size) {
    metrics.notes.push_back(fmt::format(
        "{}: no straight line; the points scatter by {:.3g} about it, of at most {:.3g}: the motion is not steady",
        name, line.left, largest_size));
    return false;
  }
  add(metrics, name, line.slope, unit, meaning);
  return true;
}

/// Metrics from steer angles: the understeer gradient, and the characteristic or critical speed.
void add_understeer(VehicleMetrics& metrics, const Linear& linear, const SteadyCircle& circle) {
  Values beyond_path;
  for (std::size_t i = 0; i < linear.steer.size(); ++i)
    beyond_path.push_back(linear.steer[i] - circle.wheelbase * linear.curvature[i]);
  const std::size_t place = metrics.values.size();
  if (!add_gradient(metrics, "understeer_gradient", linear, beyond_path, largest(linear.steer), "rad/(m/s^2)",
                    "growth with lateral acceleration of the steer angle at the wheels beyond wheelbase / radius "
                    "(ISO 4138, ISO 8855)")) {
    return;
  }
  const double gradient = metrics.values[place].value;
  const double speed = std::sqrt(circle.wheelbase / std::abs(gradient));
  // The characteristic speed is ill-conditioned for a gradient within rounding of zero.
  if (!(speed < 1000)) {
    metrics.notes.push_back("characteristic_speed: the vehicle steers neutrally");
  } else if (gradient > 0) {
    add(metrics, "characteristic_speed", speed, "m/s", "speed of the largest yaw rate gain (ISO 4138)");
  } else {
    add(metrics, "critical_speed", speed, "m/s", "speed above which the oversteering vehicle is unstable (ISO 4138)");
  }
}

void add_load_transfer(VehicleMetrics& metrics, const Linear& linear, const SteadyCircle& circle) {
  std::map<int, double> moments;
  for (const auto& [axle, transfer] : linear.transfer) {
    const std::string name = fmt::format("load_transfer_axle_{}", axle + 1);
    const std::size_t place = metrics.values.size();
    if (!add_gradient(metrics, name, linear, transfer, largest(transfer), "N/(m/s^2)",
                      "load that moves to the outer wheels with lateral acceleration"))
      return;
    const auto a = static_cast<std::size_t>(axle);
    moments[axle] = metrics.values[place].value * (a < circle.tracks.size() ? circle.tracks[a] : 1);
  }
  double sum = 0;
  for (const auto& [axle, moment] : moments) sum += moment;
  if (moments.size() < 2 || sum == 0) return;
  const bool is_moment = circle.tracks.size() >= moments.size();
  for (const auto& [axle, moment] : moments)
    add(metrics, fmt::format("{}_share_axle_{}", is_moment ? "roll_moment" : "load_transfer", axle + 1), moment / sum,
        "1", is_moment ? "load transfer times track, of all axles'" : "of the load transfer of all axles");
}

/// Compares the path with the nominal one.
void compare_path(VehicleMetrics& metrics, const Linear& linear, const SteadyCircle& circle) {
  if (circle.kind != SteadyCircle::Kind::constant_radius || !(circle.radius > 0)) return;
  double worst = 0;
  for (std::size_t i = 0; i < linear.lateral.size(); ++i) {
    if (std::abs(linear.lateral[i]) < kLeastTurning) continue;
    worst = std::max(worst, std::abs(std::abs(linear.curvature[i]) * circle.radius - 1));
  }
  if (worst > kMostDetour) {
    metrics.notes.push_back(fmt::format(
        "the curvature of the path departs from a radius of {:.6g} m by {:.3g} %: understeer is of the path "
        "that was driven, sideslip and steer angles are not of one radius",
        circle.radius, 100 * worst));
  }
}

void add_diagrams(VehicleMetrics& metrics, const VehicleSeries& s) {
  const Heading across{"lateral acceleration", "m/s^2"};
  metrics.diagrams.push_back(
      {"Steer angle", across, {"steer angle", "rad"}, {{"steer angle", s.lateral_acceleration, s.steer}}});
  metrics.diagrams.push_back(
      {"Roll and sideslip",
       across,
       {"angle", "rad"},
       {{"roll angle", s.lateral_acceleration, s.roll}, {"sideslip angle", s.lateral_acceleration, sideslip_of(s)}}});
}

}  // namespace

VehicleMetrics steady_circle_metrics(const VehicleSeries& s, const SteadyCircle& circle) {
  if (const std::string fault = fault_of_circle(s, circle); !fault.empty()) return refused("steady circle", fault);
  VehicleMetrics metrics;
  add_diagrams(metrics, s);
  const auto width = static_cast<std::size_t>(std::lround(kWindow / step_of(s))) + 1;
  if (width > s.t.size()) {
    metrics.notes.push_back(fmt::format("steady circle: the series lasts less than {:.3g} s", kWindow));
    return metrics;
  }
  add(metrics, "largest_lateral_acceleration", largest_mean(s.lateral_acceleration, width), "m/s^2",
      fmt::format("largest mean over {:.3g} s that this run reached (ISO 4138)", kWindow));
  const Linear linear = linear_range(s, circle);
  const auto [low, high] = std::minmax_element(linear.lateral.begin(), linear.lateral.end());
  if (linear.lateral.size() < 10 || *high - *low < circle.linear_limit / 2) {
    metrics.notes.push_back(fmt::format(
        "gradients: below {:.3g} m/s^2 the lateral acceleration covers {:.3g} m/s^2 in {} points; a straight line "
        "needs half of that range and 10 points",
        circle.linear_limit, linear.lateral.empty() ? 0 : *high - *low, linear.lateral.size()));
    return metrics;
  }
  compare_path(metrics, linear, circle);
  add_understeer(metrics, linear, circle);
  add_gradient(metrics, "sideslip_gradient", linear, linear.sideslip, largest(linear.sideslip), "rad/(m/s^2)",
               "sideslip angle of the reference point over lateral acceleration, along this run (ISO 4138)");
  add_gradient(metrics, "roll_gradient", linear, linear.roll, largest(linear.roll), "rad/(m/s^2)",
               "roll angle over lateral acceleration (ISO 4138)");
  if (circle.kind == SteadyCircle::Kind::constant_speed) {
    const Line gain = fitted_line(linear.steer, linear.yaw_rate);
    if (gain.left <= kMostScatter * largest(linear.yaw_rate)) {
      add(metrics, "yaw_rate_gain", gain.slope / circle.steering_ratio, "1/s",
          "yaw rate over the angle at the steering input at this speed (ISO 4138)");
    } else {
      metrics.notes.push_back("yaw_rate_gain: yaw rate over steer angle is no straight line");
    }
  }
  add_load_transfer(metrics, linear, circle);
  return metrics;
}

}  // namespace mbgen
