#pragma once
// A linear single-track vehicle with its closed forms, and what tests ask of metrics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>

#include "workbench/manoeuvre/metrics.hpp"

namespace mbgen::metrics_test {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

/// Of a number; fails the test where it is missing.
inline double value(const VehicleMetrics& metrics, const std::string& name) {
  for (const VehicleMetric& metric : metrics.values)
    if (metric.name == name) return metric.value;
  ADD_FAILURE() << "no " << name << (metrics.notes.empty() ? "" : "; " + metrics.notes.front());
  return std::nan("");
}

inline bool has(const VehicleMetrics& metrics, const std::string& name) {
  return std::any_of(metrics.values.begin(), metrics.values.end(),
                     [&](const VehicleMetric& m) { return m.name == name; });
}

/// Whether a note holds these words.
inline bool notes(const VehicleMetrics& metrics, const std::string& words) {
  return std::any_of(metrics.notes.begin(), metrics.notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// A series of n points at rest at the origin.
inline VehicleSeries empty_series(std::size_t n, double step) {
  VehicleSeries s;
  for (std::size_t i = 0; i < n; ++i) s.t.push_back(step * static_cast<double>(i));
  for (auto* values : {&s.x, &s.y, &s.heading, &s.speed, &s.lateral_speed, &s.longitudinal_acceleration,
                       &s.lateral_acceleration, &s.vertical_acceleration, &s.yaw_rate, &s.roll, &s.pitch, &s.steer})
    values->assign(n, 0.0);
  return s;
}

/// Adds evenly distributed noise.
inline void add_noise(std::vector<double>& values, double size, unsigned seed) {
  std::mt19937 engine(seed);
  for (double& value : values) value += size * (2.0 * engine() / std::mt19937::max() - 1);
}

/// Textbook single-track model, linear in sideslip and yaw rate (Mitschke and Wallentowitz, Dynamik der
/// Kraftfahrzeuge, part C; Gillespie, Fundamentals of Vehicle Dynamics, chapter 6). Reference point: centre of mass.
struct SingleTrack {
  double mass = 1500, inertia = 2500, front = 1.2, rear = 1.5;  // kg, kg m^2, m, m
  double front_stiffness = 90e3, rear_stiffness = 110e3;        // N/rad
  double speed = 25;                                            // m/s

  double wheelbase() const { return front + rear; }
  /// K = m / l (l_r / C_f - l_f / C_r), rad/(m/s^2).
  double understeer() const { return mass / wheelbase() * (rear / front_stiffness - front / rear_stiffness); }

  double sum() const { return front_stiffness + rear_stiffness; }
  double moment() const { return front * front_stiffness - rear * rear_stiffness; }
  double turning() const { return front * front * front_stiffness + rear * rear * rear_stiffness; }
  double a11() const { return -sum() / (mass * speed); }
  double a12() const { return -moment() / (mass * speed) - speed; }
  double a21() const { return -moment() / (inertia * speed); }
  double a22() const { return -turning() / (inertia * speed); }
  double b1() const { return front_stiffness / mass; }
  double b2() const { return front * front_stiffness / inertia; }
  /// s^2 + 2 sigma s + square.
  double sigma() const { return -(a11() + a22()) / 2; }
  double square() const { return a11() * a22() - a12() * a21(); }

  /// Of yaw rate, lateral speed and lateral acceleration to the steer angle at the wheels.
  Complex yaw(Complex s) const { return (b2() * (s - a11()) + a21() * b1()) / denominator(s); }
  Complex lateral_speed(Complex s) const { return (b1() * (s - a22()) + a12() * b2()) / denominator(s); }
  Complex lateral_acceleration(Complex s) const { return s * lateral_speed(s) + speed * yaw(s); }
  Complex denominator(Complex s) const { return s * s + 2 * sigma() * s + square(); }
};

/// Solution of f(x) = 0 between two places where f has different signs.
template <class Function>
double root(const Function& f, double low, double high) {
  const bool grows = f(high) > 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > 0) == grows ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace mbgen::metrics_test
