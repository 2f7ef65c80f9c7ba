// Sine with dwell: the steering signal, and metrics of a motion in closed form.

#include "tests/manoeuvre/metrics_support.hpp"
#include "workbench/manoeuvre/signal.hpp"

namespace mbgen::metrics_test {
namespace {

constexpr double kBegin = 1, kFrequency = 0.7, kDwell = 0.5, kEnd = kBegin + 1 / kFrequency + kDwell;

Signal steering(double amplitude) {
  Signal signal;
  signal.add_sine_with_dwell(amplitude, kBegin, kFrequency, kDwell);
  return signal;
}

TEST(SineWithDwell, RestsAtItsSecondPeak) {
  const Signal steer = steering(0.1);
  const double peak = kBegin + 0.75 / kFrequency;
  EXPECT_EQ(steer.at(kBegin).value, 0);
  EXPECT_NEAR(steer.at(kBegin + 0.25 / kFrequency).value, 0.1, 1e-12);
  for (const double t : {peak + 1e-9, peak + 0.2, peak + kDwell - 1e-9}) {
    EXPECT_NEAR(steer.at(t).value, -0.1, 1e-12) << t;
    EXPECT_NEAR(steer.at(t).rate, 0, 1e-8) << t;
  }
  EXPECT_NEAR(steer.at(kEnd - 0.125 / kFrequency).value, -0.1 * std::sqrt(0.5), 1e-12);
  EXPECT_EQ(steer.at(kEnd + 1e-9).value, 0);
  for (double t = 0.503; t < 4; t += 0.0371) {  // rates are derivatives
    const double h = 1e-6;
    EXPECT_NEAR(steer.at(t).rate, (steer.at(t + h).value - steer.at(t - h).value) / (2 * h), 1e-6) << t;
  }
}

/// Yaw rate 3 sin of the phase of the steering, that decays with 1 s from the end on; lateral course 2 (t - begin)^2.
VehicleSeries turning_series(double side) {
  VehicleSeries s = empty_series(601, 0.01);
  const Signal steer = steering(0.1 * side);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double t = s.t[i], later = std::max(0.0, t - kBegin);
    s.steer[i] = steer.at(t).value;
    s.yaw_rate[i] =
        t < kEnd - 0.25 / kFrequency ? 3 * s.steer[i] : -0.3 * side * std::exp(-(t - kEnd + 0.25 / kFrequency));
    s.heading[i] = 0.3;
    s.x[i] = 20 * t * std::cos(0.3) - side * 2 * later * later * std::sin(0.3);
    s.y[i] = 20 * t * std::sin(0.3) + side * 2 * later * later * std::cos(0.3);
    s.speed[i] = 20, s.lateral_speed[i] = -t, s.roll[i] = 0.01 * t;
  }
  return s;
}

TEST(SineWithDwell, MetricsOfACourseInClosedForm) {
  for (const double side : {1.0, -1.0}) {
    const VehicleMetrics metrics = dwell_metrics(turning_series(side), {kBegin, kFrequency, kDwell});
    EXPECT_NEAR(value(metrics, "second_yaw_rate_peak"), 0.3, 1e-4);
    EXPECT_NEAR(value(metrics, "yaw_rate_ratio_1_00"), std::exp(-1 - 0.25 / kFrequency), 1e-3);
    EXPECT_NEAR(value(metrics, "yaw_rate_ratio_1_75"), std::exp(-1.75 - 0.25 / kFrequency), 1e-3);
    EXPECT_NEAR(value(metrics, "lateral_displacement_1_07"), 2 * 1.07 * 1.07, 1e-3);
    EXPECT_NEAR(value(metrics, "largest_sideslip"), std::atan2(6, 20), 1e-12);
    EXPECT_NEAR(value(metrics, "largest_roll"), 0.06, 1e-12);
  }
}

TEST(SineWithDwell, AShortSeriesIsRefused) {
  VehicleSeries s = turning_series(1);
  for (auto* values : {&s.t, &s.x, &s.y, &s.heading, &s.speed, &s.lateral_speed, &s.lateral_acceleration, &s.yaw_rate,
                       &s.roll, &s.steer})
    values->resize(400);
  const VehicleMetrics metrics = dwell_metrics(s, {kBegin, kFrequency, kDwell});
  EXPECT_TRUE(metrics.values.empty());
  EXPECT_TRUE(notes(metrics, "sine with dwell: the series ends at 3.99 s"));
}

}  // namespace
}  // namespace mbgen::metrics_test
