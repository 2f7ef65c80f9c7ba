// Metrics of a towed unit against closed forms: a cart on a circle, a cart behind a wave, a swing that dies out.

#include "tests/manoeuvre/metrics_support.hpp"

namespace mbgen::metrics_test {
namespace {

VehicleSeries towing_series(std::size_t n, double step) {
  VehicleSeries s = empty_series(n, step);
  for (auto* values : {&s.towed.x, &s.towed.y, &s.towed.heading, &s.towed.lateral_acceleration, &s.towed.yaw_rate})
    values->assign(n, 0.0);
  return s;
}

// Wheels of a cart that roll without slip: hitched to the foremost axle, its own axle is on a circle of the radius
// sqrt(R^2 - L^2). Points of both units lie 0.7 m behind the hitch and 1.9 m before the cart's axle.
TEST(Towing, OfftrackingOfACartOnACircle) {
  constexpr double kRadius = 12, kLength = 5, kBehind = 0.7, kBefore = 1.9;
  for (const double turn : {1.0, -1.0})
    for (const double growth : {0.0, 0.08}) {
      VehicleSeries s = towing_series(4001, 0.01);
      const double inner = std::sqrt(kRadius * kRadius - kLength * kLength), lag = std::atan2(kLength, inner);
      for (std::size_t i = 0; i < s.t.size(); ++i) {
        const double t = s.t[i], speed = 1.5 + growth * t, angle = (1.5 * t + growth * t * t / 2) / kRadius;
        const double rear = angle - lag;
        s.heading[i] = turn * angle;
        s.x[i] = kRadius * std::sin(angle) - kBehind * std::cos(angle);
        s.y[i] = turn * (kRadius * (1 - std::cos(angle)) - kBehind * std::sin(angle));
        s.towed.heading[i] = turn * rear;
        s.towed.x[i] = inner * std::sin(rear) + kBefore * std::cos(rear);
        s.towed.y[i] = turn * (kRadius - inner * std::cos(rear) + kBefore * std::sin(rear));
        s.yaw_rate[i] = s.towed.yaw_rate[i] = turn * speed / kRadius;
        s.lateral_acceleration[i] = turn * speed * speed / kRadius;
      }
      const VehicleMetrics metrics = towing_metrics(s, {kBehind, kBefore, true});
      EXPECT_NEAR(value(metrics, "offtracking"), kRadius - inner, 1e-4) << turn << growth;
      EXPECT_EQ(has(metrics, "offtracking_gradient"), growth > 0);
      EXPECT_NEAR(growth > 0 ? value(metrics, "offtracking_gradient") : 0, 0, 1e-4);
      EXPECT_NEAR(value(metrics, "largest_articulation"), lag, 1e-12);
      EXPECT_NEAR(value(towing_metrics(s, {kBehind, kBefore, false}), "largest_offtracking"), kRadius - inner, 1e-4);
    }
}

// Straight on and the way into the circle are not the circle; headings on both sides of half a turn are near.
TEST(Towing, OfftrackingIsOfTheCircleAlone) {
  VehicleSeries s = towing_series(2001, 0.01);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const bool is_circle = s.t[i] >= 10;
    s.x[i] = 10 * s.t[i], s.towed.x[i] = s.x[i] - 8;
    s.towed.y[i] = is_circle ? 0.3 : 0.1;
    s.heading[i] = 0.001, s.towed.heading[i] = 2 * kPi - 0.001;
    s.yaw_rate[i] = 0.1;
    s.lateral_acceleration[i] = is_circle ? 1 : 0.5;
  }
  EXPECT_NEAR(value(towing_metrics(s, {.is_circle = true, .begin = 10}), "offtracking"), 0.3, 1e-3);
  EXPECT_NEAR(value(towing_metrics(s, {.is_circle = true, .begin = 10}), "largest_articulation"), 0.002, 1e-12);
}

// A cart whose hitch runs along a small sine: its axle follows as 1 / (1 + s L / v). Its heading is psi(s) = y(s) s / v
// of that, and its axle is off the path by what both waves are apart at one place.
TEST(Towing, ACartBehindAWave) {
  constexpr double kSpeed = 20, kLength = 6, kOmega = 2 * kPi * 0.5, kWave = 1e-3;
  VehicleSeries s = towing_series(6001, 0.001);
  const Complex lag = 1.0 / Complex(1, kOmega * kLength / kSpeed);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const Complex wave = kWave * std::polar(1.0, kOmega * s.t[i]), rate(0, kOmega);
    s.x[i] = kSpeed * s.t[i], s.y[i] = wave.imag();
    s.heading[i] = (wave * rate / kSpeed).imag();
    s.yaw_rate[i] = (wave * rate * rate / kSpeed).imag();
    s.lateral_acceleration[i] = (wave * rate * rate).imag();
    s.towed.x[i] = s.x[i] - kLength, s.towed.y[i] = (wave * lag).imag();
    s.towed.heading[i] = (wave * lag * rate / kSpeed).imag();
    s.towed.yaw_rate[i] = (wave * lag * rate * rate / kSpeed).imag();
    s.towed.lateral_acceleration[i] = (wave * lag * rate * rate).imag();
    s.steer[i] = s.yaw_rate[i];
  }
  const VehicleMetrics metrics = towing_metrics(s, {});
  EXPECT_NEAR(value(metrics, "rearward_amplification"), std::abs(lag), 1e-6);
  EXPECT_NEAR(value(metrics, "rearward_amplification_yaw_rate"), std::abs(lag), 1e-6);
  const Complex there = std::polar(1.0, -kOmega * kLength / kSpeed);  // the hitch was there that much earlier
  EXPECT_NEAR(value(metrics, "largest_offtracking"), kWave * std::abs(lag - there), 1e-5 * kWave);
  EXPECT_NEAR(value(metrics, "largest_articulation"), kWave * kOmega / kSpeed * std::abs(lag - 1.0), 1e-9);
  EXPECT_FALSE(has(metrics, "yaw_damping"));
}

TEST(Towing, DampingOfASwingThatDiesOut) {
  for (const double damping : {0.05, 0.2}) {
    VehicleSeries s = towing_series(1001, 0.01);
    for (std::size_t i = 0; i < s.t.size(); ++i) {
      const double t = s.t[i] - 1, omega = 4;
      s.x[i] = 20 * s.t[i], s.towed.x[i] = s.x[i] - 8;
      s.steer[i] = t < 0 ? std::sin(2 * kPi * s.t[i]) : 0;
      s.yaw_rate[i] = 0.1 * s.steer[i];
      s.towed.yaw_rate[i] =
          t < 0 ? s.yaw_rate[i]
                : 0.2 * std::exp(-damping * omega * t) * std::sin(std::sqrt(1 - damping * damping) * omega * t);
    }
    EXPECT_NEAR(value(towing_metrics(s, {}), "yaw_damping"), damping, 2e-3 * damping);
  }
}

TEST(Towing, WhatIsMissingIsSaid) {
  VehicleSeries s = towing_series(1001, 0.01);
  for (std::size_t i = 0; i < s.t.size(); ++i) s.x[i] = 20 * s.t[i], s.towed.x[i] = s.x[i] - 8;
  s.steer[100] = 0.1, s.yaw_rate[100] = 0.1;
  EXPECT_TRUE(notes(towing_metrics(s, {}), "yaw_damping: behind the last change of the steer angle the articulation"));
  EXPECT_TRUE(notes(towing_metrics(s, {.is_circle = true}), "offtracking: too few points in a turn"));
  s.towed.yaw_rate.pop_back();
  EXPECT_TRUE(notes(towing_metrics(s, {}), "towed unit: "));
}

}  // namespace
}  // namespace mbgen::metrics_test
