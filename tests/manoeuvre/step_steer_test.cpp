// A ramp of the steering angle, as short as a step, to the linear single-track vehicle: its response is a closed form.

#include "tests/manoeuvre/metrics_support.hpp"

namespace mbgen::metrics_test {
namespace {

constexpr double kStepBegin = 1, kRamp = 0.1, kSteer = 0.03;  // s, s, rad

/// Response to a unit step: steady + e^(-sigma t) (-steady cos w t + s sin w t), from its value and slope at the begin.
struct StepResponse {
  double steady, sigma, w, s;
  StepResponse(const SingleTrack& car, double steady_value, double slope)
      : steady(steady_value), sigma(car.sigma()), w(std::sqrt(car.square() - sigma * sigma)) {
    s = (slope - sigma * steady) / w;
  }
  double at(double t) const {
    return t < 0 ? 0 : steady + std::exp(-sigma * t) * (s * std::sin(w * t) - steady * std::cos(w * t));
  }
  /// Integral from the start.
  double integral(double t) const {
    if (t < 0) return 0;
    const double square = sigma * sigma + w * w;
    const auto of_sine = [&](double x) {
      return -std::exp(-sigma * x) * (sigma * std::sin(w * x) + w * std::cos(w * x)) / square;
    };
    const auto of_cosine = [&](double x) {
      return std::exp(-sigma * x) * (w * std::sin(w * x) - sigma * std::cos(w * x)) / square;
    };
    return steady * t + s * (of_sine(t) - of_sine(0)) - steady * (of_cosine(t) - of_cosine(0));
  }
  /// To the ramp, and its slope.
  double ramp(double t) const { return kSteer / kRamp * (integral(t) - integral(t - kRamp)); }
  double ramp_slope(double t) const { return kSteer / kRamp * (at(t) - at(t - kRamp)); }
};

/// Lateral acceleration is the slope of the lateral speed and speed times yaw rate.
struct Answers {
  SingleTrack car;
  StepResponse yaw{car, car.yaw(0).real(), car.b2()}, across{car, car.lateral_speed(0).real(), car.b1()};
  double lateral(double t) const { return across.ramp_slope(t) + car.speed * yaw.ramp(t); }
};

VehicleSeries step_series(const Answers& answers, double step, double duration) {
  VehicleSeries s = empty_series(static_cast<std::size_t>(std::lround(duration / step)) + 1, step);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double t = s.t[i] - kStepBegin;
    s.steer[i] = kSteer * std::clamp(t / kRamp, 0.0, 1.0);
    s.speed[i] = answers.car.speed;
    s.lateral_speed[i] = answers.across.ramp(t), s.yaw_rate[i] = answers.yaw.ramp(t);
    s.lateral_acceleration[i] = answers.lateral(t), s.roll[i] = 0.005 * s.lateral_acceleration[i];
  }
  return s;
}

/// Values of the closed form, all times from half of the ramp.
struct Expected {
  double steady_yaw, steady_lateral, steady_sideslip, yaw_90, lateral_90, yaw_peak, overshoot;
};

Expected expected_of(const Answers& answers) {
  Expected e{};
  const SingleTrack& car = answers.car;
  const double v = car.speed;
  // v / (l + K v^2): the same by another formula than the transfer function.
  e.steady_yaw = kSteer * v / (car.wheelbase() + car.understeer() * v * v);
  e.steady_lateral = v * e.steady_yaw;
  e.steady_sideslip = std::atan(kSteer * car.lateral_speed(0).real() / v);
  e.yaw_90 = root([&](double t) { return answers.yaw.ramp(t) - 0.9 * e.steady_yaw; }, 0, 0.5) - kRamp / 2;
  e.lateral_90 = root([&](double t) { return answers.lateral(t) - 0.9 * e.steady_lateral; }, 0.1, 0.6) - kRamp / 2;
  const double peak = root([&](double t) { return answers.yaw.ramp_slope(t); }, 0.15, 0.8);
  e.yaw_peak = peak - kRamp / 2;
  e.overshoot = answers.yaw.ramp(peak) / e.steady_yaw - 1;
  return e;
}

TEST(StepSteer, TimesAreThoseOfTheClosedForm) {
  const Answers answers{{.speed = 35}};
  const Expected e = expected_of(answers);
  ASSERT_GT(e.overshoot, 0.05);
  const struct {
    double smoothing, time, share;  // tolerances: s, relative
  } cases[] = {{0, 1e-5, 1e-5}, {0.05, 1e-3, 2e-3}};
  for (const auto& c : cases) {
    const VehicleMetrics metrics = step_steer_metrics(step_series(answers, 1e-3, 6), {.smoothing = c.smoothing});
    EXPECT_NEAR(value(metrics, "steer_step"), kSteer, 1e-9);
    EXPECT_NEAR(value(metrics, "speed"), 35, 1e-9);
    EXPECT_NEAR(value(metrics, "steady_yaw_rate"), e.steady_yaw, 1e-5 * e.steady_yaw);
    EXPECT_NEAR(value(metrics, "yaw_rate_gain"), e.steady_yaw / kSteer, 1e-5 * e.steady_yaw / kSteer);
    EXPECT_NEAR(value(metrics, "steady_lateral_acceleration"), e.steady_lateral, 1e-5 * e.steady_lateral);
    EXPECT_NEAR(value(metrics, "steady_sideslip"), e.steady_sideslip, 1e-5 * std::abs(e.steady_sideslip));
    EXPECT_NEAR(value(metrics, "steady_roll"), 0.005 * e.steady_lateral, 1e-5 * 0.005 * e.steady_lateral);
    EXPECT_NEAR(value(metrics, "yaw_rate_response_time"), e.yaw_90, c.time);
    EXPECT_NEAR(value(metrics, "lateral_acceleration_response_time"), e.lateral_90, c.time);
    EXPECT_NEAR(value(metrics, "yaw_rate_peak_time"), e.yaw_peak, c.time);
    EXPECT_NEAR(value(metrics, "yaw_rate_overshoot"), e.overshoot, c.share);
    EXPECT_NEAR(value(metrics, "tb_factor"), std::abs(e.steady_sideslip) * e.yaw_peak, 1e-3 * e.yaw_peak);
  }
}

TEST(StepSteer, ToTheRightIsTheMirrorOfToTheLeft) {
  const Answers answers{{.speed = 35}};
  VehicleSeries s = step_series(answers, 1e-3, 6);
  const VehicleMetrics left = step_steer_metrics(s, {});
  for (auto* values : {&s.steer, &s.lateral_speed, &s.lateral_acceleration, &s.yaw_rate, &s.roll})
    for (double& one : *values) one = -one;
  const VehicleMetrics right = step_steer_metrics(s, {});
  for (const char* name : {"yaw_rate_gain", "yaw_rate_response_time", "yaw_rate_peak_time", "yaw_rate_overshoot"})
    EXPECT_DOUBLE_EQ(value(right, name), value(left, name)) << name;
  EXPECT_DOUBLE_EQ(value(right, "steady_yaw_rate"), -value(left, "steady_yaw_rate"));
}

TEST(StepSteer, NoiseDoesNotBreakIt) {
  const Answers answers{{.speed = 35}};
  const Expected e = expected_of(answers);
  VehicleSeries s = step_series(answers, 2e-3, 6);
  add_noise(s.yaw_rate, 0.03 * e.steady_yaw, 1), add_noise(s.lateral_acceleration, 0.03 * e.steady_lateral, 2);
  add_noise(s.steer, 0.01 * kSteer, 3), add_noise(s.lateral_speed, 0.01, 4);
  const VehicleMetrics metrics = step_steer_metrics(s, {});
  EXPECT_NEAR(value(metrics, "steady_yaw_rate"), e.steady_yaw, 0.003 * e.steady_yaw);
  EXPECT_NEAR(value(metrics, "yaw_rate_response_time"), e.yaw_90, 0.01);
  EXPECT_NEAR(value(metrics, "lateral_acceleration_response_time"), e.lateral_90, 0.02);
  EXPECT_NEAR(value(metrics, "yaw_rate_peak_time"), e.yaw_peak, 0.05);
  EXPECT_NEAR(value(metrics, "yaw_rate_overshoot"), e.overshoot, 0.015);
}

TEST(StepSteer, SlowVehicleHasNoPeak) {
  const Answers answers{{.inertia = 1200, .speed = 14.7}};
  const SingleTrack& car = answers.car;
  ASSERT_GT(car.square(), car.sigma() * car.sigma());
  const VehicleMetrics metrics = step_steer_metrics(step_series(answers, 1e-3, 6), {});
  EXPECT_LT(value(metrics, "yaw_rate_overshoot"), 0.01);
  EXPECT_FALSE(has(metrics, "yaw_rate_peak_time"));
  EXPECT_FALSE(has(metrics, "tb_factor"));
  EXPECT_TRUE(notes(metrics, "yaw_rate_peak_time: yaw rate does not rise by 1 %"));
}

TEST(StepSteer, SaysWhatItCannotGive) {
  const Answers answers{{.speed = 35}};
  VehicleMetrics metrics = step_steer_metrics(step_series(answers, 1e-3, 1.5), {});
  EXPECT_TRUE(metrics.values.empty());
  EXPECT_TRUE(notes(metrics, "the series lasts 1.5 s")) << metrics.notes.front();
  metrics = step_steer_metrics(step_series(answers, 1e-3, 2.2), {});
  EXPECT_FALSE(has(metrics, "steady_yaw_rate"));
  EXPECT_TRUE(notes(metrics, "yaw_rate: no steady value"));
  VehicleSeries straight = step_series(answers, 1e-3, 6);
  straight.steer.assign(straight.t.size(), 0.0);
  EXPECT_TRUE(notes(step_steer_metrics(straight, {}), "no step"));
  VehicleSeries sine = step_series(answers, 1e-3, 6);
  for (std::size_t i = 0; i < sine.t.size(); ++i) sine.steer[i] = 0.03 * std::sin(10 * sine.t[i]);
  EXPECT_TRUE(notes(step_steer_metrics(sine, {}), "no step"));
}

}  // namespace
}  // namespace mbgen::metrics_test
