#include "workbench/manoeuvre/signal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/motion/course.hpp"

namespace mbgen {
namespace {

Rates product(const Rates& a, const Rates& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2 * a.rate * b.rate + a.value * b.acceleration};
}

/// Sine of a phase, rad, with its derivatives.
Rates sine_of(const Rates& phase) {
  const double s = std::sin(phase.value), c = std::cos(phase.value);
  return {s, c * phase.rate, c * phase.acceleration - s * phase.rate * phase.rate};
}

Rates smooth_change(double change, double at, double over, double t) {
  const Rates step = smooth_step((t - at) / over);
  return {change * step.value, change * step.rate / over, change * step.acceleration / (over * over)};
}

}  // namespace

Rates smooth_step(double u) {
  if (u <= 0) return {};
  if (u >= 1) return {1, 0, 0};
  const double rest = 1 - u;
  return {u * u * u * (10 + u * (6 * u - 15)), 30 * u * u * rest * rest, 60 * u * rest * (1 - 2 * u)};
}

Rates Signal::at(double t) const {
  Rates sum;
  for (const Part& part : parts) {
    const Rates rates = t < part.end ? part.rates(t) : Rates{part.held, 0, 0};
    sum = {sum.value + rates.value, sum.rate + rates.rate, sum.acceleration + rates.acceleration};
  }
  return sum;
}

void Signal::add(double value) {
  parts.push_back({[value](double) { return Rates{value, 0, 0}; }});
}

void Signal::add_change(double change, double at, double over) {
  parts.push_back({[=](double t) { return smooth_change(change, at, over, t); }});
}

void Signal::go_to(double value, double at, double over) {
  const double present = this->at(at).value;
  for (Part& part : parts) {
    if (part.end <= at) continue;
    part.held = part.rates(at).value;
    part.end = at;
  }
  add_change(value - present, at, over);
}

void Signal::add_ramp(double change, double at, double rate) {
  // The rate changes smoothly: its integral over a rise of one second equals half a second at the full rate.
  const double whole = std::abs(change / rate), rise = std::min(1.0, whole), signed_rate = std::copysign(rate, change);
  const auto integral = [rise](double u) {  // of smooth_step over t; u: s since its start
    if (u <= 0) return 0.0;
    const double v = std::min(1.0, u / rise);
    return rise * v * v * v * v * (2.5 + v * (v - 3)) + std::max(0.0, u - rise);
  };
  parts.push_back({[=](double t) {
    const double begin = t - at, end = begin - whole;
    const Rates up = smooth_step(begin / rise), down = smooth_step(end / rise);
    return Rates{signed_rate * (integral(begin) - integral(end)), signed_rate * (up.value - down.value),
                 signed_rate * (up.rate - down.rate) / rise};
  }});
}

void Signal::add_sine(double amplitude, double at, double frequency, double cycles) {
  const double turning = 2 * std::numbers::pi * frequency, end = at + cycles / frequency;
  parts.push_back({[=](double t) {
    const double s = std::min(t, end) - at;
    if (s <= 0) return Rates{};
    const Rates sine = sine_of({turning * s, turning, 0});
    if (t >= end) return Rates{amplitude * sine.value, 0, 0};
    return Rates{amplitude * sine.value, amplitude * sine.rate, amplitude * sine.acceleration};
  }});
}

void Signal::add_sine_with_dwell(double amplitude, double at, double frequency, double dwell) {
  const double turning = 2 * std::numbers::pi * frequency, peak = 0.75 / frequency, end = 1 / frequency;
  parts.push_back({[=](double t) {
    const double s = t - at < peak ? t - at : std::max(peak, t - at - dwell);
    if (s <= 0 || s >= end) return Rates{};
    const Rates sine = sine_of({turning * s, turning, 0});
    if (s == peak) return Rates{amplitude * sine.value, 0, 0};
    return Rates{amplitude * sine.value, amplitude * sine.rate, amplitude * sine.acceleration};
  }});
}

void Signal::add_sweep(double amplitude, double at, double first_frequency, double last_frequency, double duration) {
  const double growth = std::log(last_frequency / first_frequency) / duration;  // 1/s
  const double turning = 2 * std::numbers::pi * first_frequency, fade = sweep_fade(last_frequency);
  parts.push_back({[=](double t) {
    const double s = t - at;
    if (s <= 0 || s >= duration + fade) return Rates{};
    const double factor = std::exp(growth * s);
    const Rates sine = sine_of({turning * (factor - 1) / growth, turning * factor, turning * growth * factor});
    const Rates fall = smooth_change(1, duration, fade, s);
    return product(product(smooth_change(amplitude, 0, 1 / first_frequency, s), sine),
                   {1 - fall.value, -fall.rate, -fall.acceleration});
  }});
}

void Signal::add_table(const std::vector<std::array<double, 2>>& points, double at) {
  std::vector<double> t, y;
  for (const std::array<double, 2>& point : points) {
    t.push_back(at + point[0]);
    y.push_back(point[1]);
  }
  const Course course = pchip(t, y), rate = derivative(course), acceleration = derivative(rate);
  parts.push_back({[=](double now) {
    constexpr double kRounding = 1e-9;  // s
    if (now <= at + kRounding) return Rates{};
    return Rates{course.at(now), rate.at(now), acceleration.at(now)};
  }});
}

}  // namespace mbgen
