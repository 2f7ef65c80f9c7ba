// Frequency responses and weave of the linear single-track vehicle against its transfer functions.

#include <functional>

#include "tests/manoeuvre/metrics_support.hpp"
#include "workbench/manoeuvre/signal.hpp"

namespace mbgen::metrics_test {
namespace {

Complex on_axis(double frequency) { return {0, 2 * kPi * frequency}; }

/// Steering by a sum of sines of random phase from 0.1 to 4 Hz, with the steady answers of the transfer functions.
VehicleSeries random_steering(const SingleTrack& car, double duration) {
  VehicleSeries s = empty_series(static_cast<std::size_t>(duration * 100) + 1, 0.01);
  s.speed.assign(s.t.size(), car.speed);
  std::mt19937 engine(7);
  for (double frequency = 0.1; frequency < 4; frequency += 0.0137) {
    const double phase = 2 * kPi * engine() / std::mt19937::max();
    const Complex yaw = car.yaw(on_axis(frequency)), lateral = car.lateral_acceleration(on_axis(frequency));
    for (std::size_t i = 0; i < s.t.size(); ++i) {
      const Complex turned = std::polar(0.001, 2 * kPi * frequency * s.t[i] + phase);
      s.steer[i] += turned.imag();
      s.yaw_rate[i] += (yaw * turned).imag(), s.lateral_acceleration[i] += (lateral * turned).imag();
    }
  }
  return s;
}

/// The motion by the Runge-Kutta method from straight ahead.
VehicleSeries steered(const SingleTrack& car, double duration, const std::function<double(double)>& steer) {
  constexpr double kStep = 0.005;
  VehicleSeries s = empty_series(static_cast<std::size_t>(duration / kStep) + 1, kStep);
  s.speed.assign(s.t.size(), car.speed);
  using Pair = std::array<double, 2>;
  const auto slope = [&](double t, Pair z) {
    return Pair{car.a11() * z[0] + car.a12() * z[1] + car.b1() * steer(t),
                car.a21() * z[0] + car.a22() * z[1] + car.b2() * steer(t)};
  };
  const auto moved = [](Pair z, Pair by, double h) { return Pair{z[0] + h * by[0], z[1] + h * by[1]}; };
  Pair z{0, 0};
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double t = s.t[i];
    const Pair k1 = slope(t, z), k2 = slope(t + kStep / 2, moved(z, k1, kStep / 2));
    const Pair k3 = slope(t + kStep / 2, moved(z, k2, kStep / 2)), k4 = slope(t + kStep, moved(z, k3, kStep));
    s.steer[i] = steer(t), s.yaw_rate[i] = z[1], s.lateral_acceleration[i] = k1[0] + car.speed * z[1];
    for (int c = 0; c < 2; ++c) z[c] += kStep / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
  }
  return s;
}

/// A sine whose frequency grows evenly from 0.1 to 4 Hz.
VehicleSeries swept_sine(const SingleTrack& car, double duration) {
  return steered(car, duration,
                 [=](double t) { return 0.02 * std::sin(2 * kPi * (0.1 * t + 3.9 * t * t / (2 * duration))); });
}

/// Every number against the closed form, within a share of it.
void expect_responses(const VehicleMetrics& metrics, const SingleTrack& car, double share) {
  const auto near = [&](const std::string& name, double expected) {
    EXPECT_NEAR(value(metrics, name), expected, share * std::abs(expected)) << name;
  };
  const auto yaw_gain = [&](double f) { return std::abs(car.yaw(on_axis(f))); };
  const auto lateral_gain = [&](double f) { return std::abs(car.lateral_acceleration(on_axis(f))); };
  near("yaw_rate_gain", car.speed / (car.wheelbase() + car.understeer() * car.speed * car.speed));
  near("lateral_acceleration_gain", lateral_gain(0));
  near("yaw_rate_bandwidth", root([&](double f) { return yaw_gain(0) / std::sqrt(2) - yaw_gain(f); }, 0.5, 4));
  near("lateral_acceleration_bandwidth",
       root([&](double f) { return lateral_gain(0) / std::sqrt(2) - lateral_gain(f); }, 0.1, 2));
  near("yaw_rate_phase_1hz", std::arg(car.yaw(on_axis(1))));
  near("yaw_rate_delay_1hz", -std::arg(car.yaw(on_axis(1))) / (2 * kPi));
  near("lateral_acceleration_phase_1hz", std::arg(car.lateral_acceleration(on_axis(1))));
  double best = 0;
  for (double f = 0; f < 3; f += 1e-4) best = yaw_gain(f) > yaw_gain(best) ? f : best;
  near("yaw_rate_peak_ratio", yaw_gain(best) / yaw_gain(0));
  EXPECT_NEAR(value(metrics, "yaw_rate_peak_frequency"), best, 0.03);
  near("yaw_damping", car.sigma() / std::sqrt(car.square()));
  near("yaw_natural_frequency", std::sqrt(car.square()) / (2 * kPi));
}

TEST(SineSweep, RandomSteeringGivesTheTransferFunctions) {
  const SingleTrack car{.speed = 35};
  expect_responses(sine_sweep_metrics(random_steering(car, 120), {.lowest = 0.1, .highest = 4}), car, 0.006);
}

TEST(SineSweep, SweptSineGivesTheTransferFunctions) {
  const SingleTrack car{.speed = 35};
  expect_responses(sine_sweep_metrics(swept_sine(car, 80), {.lowest = 0.1, .highest = 4}), car, 0.006);
  // The range from the spectrum alone.
  expect_responses(sine_sweep_metrics(swept_sine(car, 80), {}), car, 0.006);
}

// A bandwidth shortly below the last frequency counts where the response may die out; else its number has a note.
TEST(SineSweep, TheEndOfTheSweepCounts) {
  const SingleTrack car{.speed = 35};
  const auto yaw_gain = [&](double f) { return std::abs(car.yaw(on_axis(f))); };
  const double bandwidth = root([&](double f) { return yaw_gain(0) / std::sqrt(2) - yaw_gain(f); }, 0.5, 4);
  Signal sweep;
  sweep.add_sweep(0.02, 1, 0.1, 1.1 * bandwidth, 56);
  const auto steer = [&](double t) { return sweep.at(t).value; };
  const SineSweep asked{.lowest = 0.1, .highest = 1.1 * bandwidth};
  const VehicleMetrics whole = sine_sweep_metrics(steered(car, 62, steer), asked);
  EXPECT_NEAR(value(whole, "yaw_rate_bandwidth"), bandwidth, 4e-3 * bandwidth);
  EXPECT_FALSE(notes(whole, "dies out"));
  EXPECT_TRUE(
      notes(sine_sweep_metrics(steered(car, 57, steer), asked), "yaw_rate: the series ends before its response"));
}

TEST(SineSweep, NoiseOfTheAnswersIsAveragedOut) {
  const SingleTrack car{.speed = 35};
  VehicleSeries s = random_steering(car, 300);
  add_noise(s.yaw_rate, 0.01, 1), add_noise(s.lateral_acceleration, 0.3, 2);
  expect_responses(sine_sweep_metrics(s, {.lowest = 0.1, .highest = 4, .segment = 15}), car, 0.05);
}

TEST(SineSweep, MirroredSteeringIsAGainBelowZero) {
  const SingleTrack car{.speed = 35};
  VehicleSeries s = swept_sine(car, 80);
  const VehicleMetrics metrics = sine_sweep_metrics(s, {});
  for (double& steer : s.steer) steer = -steer;
  const VehicleMetrics mirrored = sine_sweep_metrics(s, {});
  EXPECT_DOUBLE_EQ(value(mirrored, "yaw_rate_gain"), -value(metrics, "yaw_rate_gain"));
  EXPECT_DOUBLE_EQ(value(mirrored, "yaw_rate_phase_1hz"), value(metrics, "yaw_rate_phase_1hz"));
}

TEST(SineSweep, SaysWhereTheResponseCannotBeTrusted) {
  const SingleTrack car{.speed = 35};
  VehicleSeries s = random_steering(car, 120);
  add_noise(s.yaw_rate, 3, 1);
  const VehicleMetrics noisy = sine_sweep_metrics(s, {.lowest = 0.1, .highest = 4});
  EXPECT_FALSE(has(noisy, "yaw_rate_gain"));
  EXPECT_TRUE(has(noisy, "lateral_acceleration_gain"));
  EXPECT_TRUE(notes(noisy, "yaw_rate: its coherence with the steer angle is"));

  const VehicleMetrics small = sine_sweep_metrics(swept_sine(car, 20), {});
  EXPECT_TRUE(small.values.empty());
  EXPECT_TRUE(notes(small, "drive 24 s at least")) << small.notes.front();

  const VehicleMetrics high = sine_sweep_metrics(random_steering(car, 120), {.lowest = 0.8, .highest = 4});
  EXPECT_FALSE(has(high, "yaw_rate_gain"));
  EXPECT_FALSE(has(high, "yaw_rate_bandwidth"));
  EXPECT_TRUE(has(high, "yaw_rate_phase_1hz"));
  EXPECT_TRUE(notes(high, "too high to tell of slow steering"));

  const VehicleMetrics low = sine_sweep_metrics(random_steering(car, 120), {.lowest = 0.1, .highest = 0.8});
  EXPECT_FALSE(has(low, "yaw_rate_bandwidth"));
  EXPECT_FALSE(has(low, "yaw_rate_phase_1hz"));
  EXPECT_TRUE(notes(low, "yaw_rate_phase_1hz: the response goes from"));

  EXPECT_TRUE(notes(sine_sweep_metrics(s, {.lowest = 6}), "yaw_rate: the steer angle holds no frequency of the range"));
  s.steer.assign(s.t.size(), 0.0);
  EXPECT_TRUE(notes(sine_sweep_metrics(s, {}), "the steer angle is zero"));
}

/// A weave in its steady state.
VehicleSeries weave_series(const SingleTrack& car, double frequency, double duration) {
  VehicleSeries s = empty_series(static_cast<std::size_t>(std::lround(duration * 100)) + 1, 0.01);
  s.speed.assign(s.t.size(), car.speed);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const Complex turned = std::polar(0.02, 2 * kPi * frequency * s.t[i] + 0.3);
    s.steer[i] = turned.imag() + 0.001;
    s.yaw_rate[i] = (car.yaw(on_axis(frequency)) * turned).imag();
    s.lateral_acceleration[i] = (car.lateral_acceleration(on_axis(frequency)) * turned).imag() + 0.05;
  }
  return s;
}

// The loop of two sines is an ellipse.
void expect_weave(const VehicleMetrics& metrics, const SingleTrack& car, double frequency, double share) {
  const Complex yaw = car.yaw(on_axis(frequency)), lateral = car.lateral_acceleration(on_axis(frequency));
  const double lag = -std::arg(lateral), steer = 0.02;
  const auto near = [&](const std::string& name, double expected) {
    EXPECT_NEAR(value(metrics, name), expected, share * std::abs(expected)) << name;
  };
  near("steer_amplitude", steer);
  near("lateral_acceleration_amplitude", steer * std::abs(lateral));
  near("steering_sensitivity", std::abs(lateral) / std::cos(lag));
  near("steer_hysteresis", 2 * steer * std::sin(lag));
  near("lateral_acceleration_hysteresis", 2 * steer * std::abs(lateral) * std::sin(lag));
  near("yaw_rate_gain", yaw.real());
  near("yaw_rate_hysteresis", 2 * steer * std::abs(yaw.imag()));
  near("lateral_acceleration_lag", lag / (2 * kPi * frequency));
  near("yaw_rate_lag", -std::arg(yaw) / (2 * kPi * frequency));
}

TEST(Weave, LoopIsTheEllipseOfTheTransferFunction) {
  const SingleTrack car{.speed = 27.8};
  expect_weave(weave_metrics(weave_series(car, 0.2, 20), {}), car, 0.2, 1e-3);
  expect_weave(weave_metrics(weave_series(car, 0.3, 20), {.frequency = 0.3, .settled = 4}), car, 0.3, 1e-3);
}

// A second harmonic makes one branch steeper and the other flatter, by the same.
TEST(Weave, SensitivityIsThatOfBothBranches) {
  const SingleTrack car{.speed = 27.8};
  VehicleSeries s = weave_series(car, 0.2, 20);
  const Complex lateral = car.lateral_acceleration(on_axis(0.2));
  for (std::size_t i = 0; i < s.t.size(); ++i)
    s.steer[i] += 0.001 * std::sin(2 * (2 * kPi * 0.2 * s.t[i] + 0.3 + std::arg(lateral)));
  const VehicleMetrics metrics = weave_metrics(s, {});
  const double expected = std::abs(lateral) / std::cos(std::arg(lateral));
  EXPECT_NEAR(value(metrics, "steering_sensitivity"), expected, 1e-3 * expected);
}

// Rest behind the steering is no cycle.
TEST(Weave, RestBehindTheSteeringDoesNotCount) {
  const SingleTrack car{.speed = 27.8};
  VehicleSeries s = weave_series(car, 0.2, 20.8);
  for (std::size_t i = 2001; i < s.t.size(); ++i) s.steer[i] = s.yaw_rate[i] = s.lateral_acceleration[i] = 0;
  expect_weave(weave_metrics(s, {.end = 20}), car, 0.2, 1e-3);
  EXPECT_TRUE(notes(weave_metrics(s, {.end = 12}), "the steering ends at 12 s"));
}

TEST(Weave, NoiseDoesNotBreakIt) {
  const SingleTrack car{.speed = 27.8};
  VehicleSeries s = weave_series(car, 0.2, 40);
  add_noise(s.lateral_acceleration, 0.05, 1), add_noise(s.yaw_rate, 0.003, 2);
  expect_weave(weave_metrics(s, {}), car, 0.2, 0.05);
}

TEST(Weave, SaysWhatItCannotGive) {
  const SingleTrack car{.speed = 27.8};
  EXPECT_TRUE(notes(weave_metrics(weave_series(car, 0.2, 12), {}), "two whole cycles of 5 s after the first one"));
  EXPECT_TRUE(notes(weave_metrics(weave_series(car, 0.2, 40), {.frequency = 0.31}), "no sine of 0.31 Hz"));
  VehicleSeries s = weave_series(car, 0.2, 20);
  s.yaw_rate.assign(s.t.size(), 0.0);
  EXPECT_TRUE(notes(weave_metrics(s, {}), "the yaw rate does not follow"));
}

}  // namespace
}  // namespace mbgen::metrics_test
