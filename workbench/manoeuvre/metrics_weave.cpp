// Weave on centre, ISO 13674-1.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kNearCentre = 0.5;     ///< of the amplitude: fitted part of a branch
constexpr int kDegree = 3;              ///< of the fit of a branch
constexpr double kMostHarmonics = 0.2;  ///< of the amplitude: residual of the sine of the steer angle
constexpr double kLeastAnswer = 0.5;    ///< of the spread of a response: least amplitude of its sine

/// mean + amplitude sin(omega t + phase).
struct Sine {
  double mean = 0, amplitude = 0, phase = 0, omega = 0;
  double left = 0;  ///< root-mean-square residual
  double rate_sign(double t) const { return sign_of(std::cos(omega * t + phase)); }
};

/// Least-squares sine over whole cycles, where sine, cosine and constant are orthogonal.
Sine fitted_sine(const Values& t, const Values& values, Span span, double frequency) {
  Sine sine{mean(values, span), 0, 0, 2 * std::numbers::pi * frequency};
  double in = 0, across = 0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    in += (values[i] - sine.mean) * std::sin(sine.omega * t[i]);
    across += (values[i] - sine.mean) * std::cos(sine.omega * t[i]);
  }
  const double count = static_cast<double>(span.size());
  sine.amplitude = 2 * std::hypot(in, across) / count;
  sine.phase = std::atan2(across, in);
  Values left;
  for (std::size_t i = span.begin; i < span.end; ++i)
    left.push_back(values[i] - sine.mean - sine.amplitude * std::sin(sine.omega * t[i] + sine.phase));
  sine.left = spread(left, {0, left.size()}, 0);
  return sine;
}

/// Hysteresis loop of one value over another near the centre, by a polynomial per branch.
struct SlowLoop {
  double slope = 0;  ///< mean slope of the branches at zero of `across`
  double width = 0;  ///< distance of the branches there
};

/// Loop of `up` over `across`, both minus their means. Branches: `across` rises, `across` falls.
SlowLoop loop_at_zero(const Values& t, const Values& across, const Sine& of_across, const Values& up, const Sine& of_up,
                      Span span) {
  Values x[2], y[2];
  for (std::size_t i = span.begin; i < span.end; ++i) {
    const double place = across[i] - of_across.mean;
    if (std::abs(place) > kNearCentre * of_across.amplitude) continue;
    const int branch = of_across.rate_sign(t[i]) > 0 ? 0 : 1;
    x[branch].push_back(place), y[branch].push_back(up[i] - of_up.mean);
  }
  const Values rising = polynomial(x[0], y[0], kDegree), falling = polynomial(x[1], y[1], kDegree);
  return {(rising[1] + falling[1]) / 2, std::abs(rising[0] - falling[0])};
}

/// Whole cycles after the settling time, empty for fewer than two.
Span whole_cycles(const VehicleSeries& s, const Weave& weave) {
  const double first = std::max(weave.settled > 0 ? weave.settled : s.t.front() + 1 / weave.frequency, s.t.front());
  const double step = step_of(s), period = 1 / weave.frequency;
  const double last = weave.end > 0 ? std::min(weave.end, s.t.back()) : s.t.back();
  const double cycles = std::floor((last - first) / period + 1e-6);
  if (cycles < 2) return {};
  // The last point of a cycle is the first point of the next.
  const auto points = static_cast<std::size_t>(std::lround(cycles * period / step));
  const std::size_t begin = first_point(s, first);
  return {begin, std::min(begin + points, s.t.size())};
}

std::string fault_of_weave(const VehicleSeries& s, const Weave& weave) {
  const std::string fault = fault_of(s, {{"lateral acceleration", &s.lateral_acceleration},
                                         {"yaw rate", &s.yaw_rate},
                                         {"speed", &s.speed},
                                         {"steer angle", &s.steer}});
  if (!fault.empty()) return fault;
  if (!(weave.frequency > 0)) return "its frequency is not known";
  if (weave.frequency * step_of(s) > 0.01)
    return fmt::format("{:.3g} points per cycle; the fits need 100", 1 / (weave.frequency * step_of(s)));
  const Span span = whole_cycles(s, weave);
  if (span.size() == 0) {
    return fmt::format("the {} at {:.4g} s; it has to hold two whole cycles of {:.4g} s after the first one",
                       weave.end > 0 && weave.end < s.t.back() ? "steering ends" : "series ends",
                       weave.end > 0 ? std::min(weave.end, s.t.back()) : s.t.back(), 1 / weave.frequency);
  }
  const Sine steer = fitted_sine(s.t, s.steer, span, weave.frequency);
  if (!(steer.amplitude > 0) || steer.left > kMostHarmonics * steer.amplitude)
    return fmt::format("the steer angle is no sine of {:.4g} Hz: amplitude {:.3g} rad, {:.3g} rad beside it",
                       weave.frequency, steer.amplitude, steer.left);
  for (const Values* values : {&s.lateral_acceleration, &s.yaw_rate}) {
    const Sine sine = fitted_sine(s.t, *values, span, weave.frequency);
    if (!(sine.amplitude > 0) || sine.left > kLeastAnswer * sine.amplitude)
      return fmt::format("{} does not follow the sine of the steer angle: amplitude {:.3g}, {:.3g} beside it",
                         values == &s.yaw_rate ? "the yaw rate" : "the lateral acceleration", sine.amplitude,
                         sine.left);
  }
  return "";
}

/// Lag of a sine behind another, s, within half a period.
double lag(const Sine& of, const Sine& behind) {
  return std::remainder(behind.phase - of.phase, 2 * std::numbers::pi) / of.omega;
}

}  // namespace

VehicleMetrics weave_metrics(const VehicleSeries& s, const Weave& weave) {
  if (const std::string fault = fault_of_weave(s, weave); !fault.empty()) return refused("weave", fault);
  VehicleMetrics metrics;
  const Span span = whole_cycles(s, weave);
  const auto sine = [&](const Values& values) { return fitted_sine(s.t, values, span, weave.frequency); };
  const Sine steer = sine(s.steer), lateral = sine(s.lateral_acceleration), yaw = sine(s.yaw_rate);
  const SlowLoop steer_over_lateral = loop_at_zero(s.t, s.lateral_acceleration, lateral, s.steer, steer, span);
  const SlowLoop lateral_over_steer = loop_at_zero(s.t, s.steer, steer, s.lateral_acceleration, lateral, span);
  const SlowLoop yaw_over_steer = loop_at_zero(s.t, s.steer, steer, s.yaw_rate, yaw, span);
  add(metrics, "speed", mean(s.speed, span), "m/s", "mean");
  add(metrics, "steer_amplitude", steer.amplitude, "rad", "at the steering input");
  add(metrics, "lateral_acceleration_amplitude", lateral.amplitude, "m/s^2", "of the weave");
  add(metrics, "steering_sensitivity", 1 / steer_over_lateral.slope, "(m/s^2)/rad",
      "growth of lateral acceleration with steer angle at zero lateral acceleration (ISO 13674-1)");
  add(metrics, "steer_hysteresis", steer_over_lateral.width, "rad",
      "width of the loop along the steer angle at zero lateral acceleration (ISO 13674-1)");
  add(metrics, "lateral_acceleration_hysteresis", lateral_over_steer.width, "m/s^2",
      "width of the loop along the lateral acceleration at zero steer angle (ISO 13674-1)");
  add(metrics, "yaw_rate_gain", yaw_over_steer.slope, "1/s",
      "growth of yaw rate with steer angle at zero steer angle (ISO 13674-1)");
  add(metrics, "yaw_rate_hysteresis", yaw_over_steer.width, "rad/s",
      "width of the loop along the yaw rate at zero steer angle (ISO 13674-1)");
  add(metrics, "lateral_acceleration_lag", lag(lateral, steer), "s", "of its sine behind the sine of the steer angle");
  add(metrics, "yaw_rate_lag", lag(yaw, steer), "s", "of its sine behind the sine of the steer angle");
  const auto part = [&](const Values& values) {
    return Values(values.begin() + static_cast<std::ptrdiff_t>(span.begin),
                  values.begin() + static_cast<std::ptrdiff_t>(span.end));
  };
  metrics.diagrams.push_back({"Weave",
                              {"steer angle", "rad"},
                              {"lateral acceleration", "m/s^2"},
                              {{"lateral acceleration", part(s.steer), part(s.lateral_acceleration)}}});
  return metrics;
}

}  // namespace mbgen
