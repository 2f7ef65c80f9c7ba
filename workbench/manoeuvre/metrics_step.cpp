// Step of the steering angle, ISO 7401.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kStart = 0.05;           ///< of the step: straight ahead until it is exceeded
constexpr double kResponse = 0.9;         ///< of the steady value: end of the response time
constexpr double kMostDrift = 0.02;       ///< of the step, between the halves of the time of the steady values
constexpr double kLeastOvershoot = 0.01;  ///< of the steady value: smaller peaks are not reported

/// Position of the step in a series.
struct SteerStep {
  Span before, steady;
  double half_time = 0;  ///< s, at half of the step of the steer angle
  double size = 0;       ///< rad
};

struct Found {
  SteerStep step;
  std::string fault;  ///< "" when there is a step
};

/// Mean over the first and over the second half of a span.
std::pair<double, double> halves(const Values& values, Span span) {
  const std::size_t middle = (span.begin + span.end) / 2;
  return {mean(values, {span.begin, middle}), mean(values, {middle, span.end})};
}

Found find_step(const VehicleSeries& s, const StepSteer& asked, std::size_t reach) {
  Found found;
  SteerStep& step = found.step;
  const auto steady = static_cast<std::size_t>(std::lround(asked.steady_time / step_of(s))) + 1;
  if (steady < 4 || 2 * steady > s.t.size()) {
    found.fault = fmt::format("the series lasts {:.6g} s, steady values take the last {:.6g} s and need twice as long",
                              s.t.back() - s.t.front(), asked.steady_time);
    return found;
  }
  step.steady = {s.t.size() - steady, s.t.size()};
  const Values steer = smoothed(s.steer, reach);
  const double last = mean(s.steer, step.steady), first = steer.front();
  const double drift = spread(s.steer, step.steady, last);
  const double size = last - first;
  if (!(std::abs(size) > 1e-9) || drift > 0.1 * std::abs(size)) {
    found.fault = fmt::format("the steer angle goes from {:.3g} to {:.3g} rad, with {:.3g} rad about its end: no step",
                              first, last, drift);
    return found;
  }
  Values risen;
  for (const double angle : steer) risen.push_back((angle - first) / size);
  std::size_t start = 0;
  while (risen[start] < kStart) ++start;
  step.half_time = time_of_rise(s.t, risen, 0.5, 0);
  // The reference ends half a rise time before the step, so that smoothing does not reach it.
  const auto rise = static_cast<std::size_t>((step.half_time - s.t[start]) / step_of(s)) + 1;
  step.before = {0, start > rise ? start - rise : 1};
  step.size = last - mean(s.steer, step.before);
  return found;
}

/// A response: its steady change, and its times. NaN: none.
struct StepResponse {
  double change = 0, response_time = 0, peak_time = 0, overshoot = 0;
  bool is_steady = false;
};

StepResponse response_of(VehicleMetrics& metrics, const VehicleSeries& s, const std::string& name, const Values& values,
                         const SteerStep& step, std::size_t reach) {
  StepResponse response;
  const double base = mean(values, step.before);
  const auto [early, late] = halves(values, step.steady);
  response.change = mean(values, step.steady) - base;
  response.is_steady = std::abs(late - early) <= kMostDrift * std::abs(response.change);
  if (!response.is_steady) {
    metrics.notes.push_back(fmt::format(
        "{}: no steady value; its mean goes from {:.4g} to {:.4g} in the last {:.3g} s, more than {:.3g} % of its step",
        name, early, late, s.t.back() - s.t[step.steady.begin], 100 * kMostDrift));
    return response;
  }
  Values risen = smoothed(values, reach);
  for (double& value : risen) value = (value - base) / response.change;
  response.response_time = time_of_rise(s.t, risen, kResponse, step.before.end - 1) - step.half_time;
  const Peak peak = peak_of(s.t, risen, step.before.end - 1);
  response.overshoot = std::max(0.0, peak.value - 1);
  const bool has_peak = response.overshoot > kLeastOvershoot;
  response.peak_time = has_peak ? peak.time - step.half_time : std::nan("");
  return response;
}

void add_response(VehicleMetrics& metrics, const std::string& name, const std::string& unit,
                  const StepResponse& response, const SteerStep& step) {
  const std::string words = name == "yaw_rate" ? "yaw rate" : "lateral acceleration";
  add(metrics, "steady_" + name, response.change, unit, "steady " + words + " after the step (ISO 7401)");
  add(metrics, name + "_gain", response.change / step.size, name == "yaw_rate" ? "1/s" : "(m/s^2)/rad",
      "steady " + words + " over steer angle (ISO 7401)");
  add(metrics, name + "_response_time", response.response_time, "s",
      "from half of the step of the steer angle to 90 % of the steady " + words + " (ISO 7401)");
  add(metrics, name + "_overshoot", response.overshoot, "1",
      "largest " + words + " beyond the steady one, over it (ISO 7401)");
  if (std::isnan(response.peak_time)) {
    metrics.notes.push_back(fmt::format("{}_peak_time: {} does not rise by {:.3g} % above its steady value", name,
                                        words, 100 * kLeastOvershoot));
  } else {
    add(metrics, name + "_peak_time", response.peak_time, "s",
        "from half of the step of the steer angle to the largest " + words + " (ISO 7401)");
  }
}

/// Adds the steady-state angles.
void add_angles(VehicleMetrics& metrics, const VehicleSeries& s, const SteerStep& step, const StepResponse& yaw) {
  const Values sideslip = sideslip_of(s);
  const double steady = mean(sideslip, step.steady) - mean(sideslip, step.before);
  add(metrics, "steady_sideslip", steady, "rad", "steady sideslip angle of the reference point (ISO 7401)");
  add(metrics, "steady_roll", mean(s.roll, step.steady) - mean(s.roll, step.before), "rad", "steady roll angle");
  if (!std::isnan(yaw.peak_time)) {
    add(metrics, "tb_factor", std::abs(steady) * yaw.peak_time, "rad s",
        "steady sideslip angle times the time of the largest yaw rate (ISO 7401)");
  }
}

}  // namespace

VehicleMetrics step_steer_metrics(const VehicleSeries& s, const StepSteer& asked) {
  std::string fault = fault_of(s, {{"speed", &s.speed},
                                   {"lateral speed", &s.lateral_speed},
                                   {"lateral acceleration", &s.lateral_acceleration},
                                   {"yaw rate", &s.yaw_rate},
                                   {"roll angle", &s.roll},
                                   {"steer angle", &s.steer}});
  std::size_t reach = 0;
  SteerStep step;
  if (fault.empty()) {
    reach = static_cast<std::size_t>(std::lround(asked.smoothing / step_of(s)));
    Found found = find_step(s, asked, reach);
    step = found.step;
    fault = found.fault;
  }
  if (!fault.empty()) return refused("step steer", fault);
  VehicleMetrics metrics;
  add(metrics, "steer_step", step.size, "rad", "change of the angle at the steering input");
  add(metrics, "speed", mean(s.speed, step.before), "m/s", "before the step");
  const StepResponse yaw = response_of(metrics, s, "yaw_rate", s.yaw_rate, step, reach);
  const StepResponse lateral = response_of(metrics, s, "lateral_acceleration", s.lateral_acceleration, step, reach);
  if (yaw.is_steady) add_response(metrics, "yaw_rate", "rad/s", yaw, step);
  if (lateral.is_steady) add_response(metrics, "lateral_acceleration", "m/s^2", lateral, step);
  if (yaw.is_steady && lateral.is_steady) add_angles(metrics, s, step, yaw);
  return metrics;
}

}  // namespace mbgen
