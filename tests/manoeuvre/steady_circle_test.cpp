// Steady circles of the linear single-track vehicle: its gradients are closed forms.

#include "tests/manoeuvre/metrics_support.hpp"

namespace mbgen::metrics_test {
namespace {

using Kind = SteadyCircle::Kind;
constexpr double kRatio = 16, kRollGradient = 0.004, kFrontTransfer = 320, kRearTransfer = 180;
constexpr double kFrontTrack = 1.5, kRearTrack = 1.6;

SteadyCircle circle_of(Kind kind, const SingleTrack& car) {
  return {.kind = kind,
          .wheelbase = car.wheelbase(),
          .radius = 100,
          .steering_ratio = kRatio,
          .tracks = {kFrontTrack, kRearTrack}};
}

/// Steady states one after the other, lateral acceleration from 0.3 to 6 m/s^2 on the left. Above 3 m/s^2 more steer
/// is needed than of a linear vehicle.
VehicleSeries circle_series(const SingleTrack& car, Kind kind) {
  VehicleSeries s = empty_series(6001, 0.01);
  s.loads.assign(4, std::vector<double>(s.t.size()));
  s.wheels = {{"front_left", 0, true}, {"front_right", 0, false}, {"rear_left", 1, true}, {"rear_right", 1, false}};
  const double steer = 0.05;
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double lateral = 0.3 + 5.7 * std::min(1.0, s.t[i] / 55), more = std::pow(std::max(0.0, lateral - 3), 2);
    double curvature = 0.01;
    if (kind == Kind::constant_speed) curvature = lateral / (car.speed * car.speed);
    if (kind == Kind::constant_steer) curvature = (steer - car.understeer() * lateral - 0.002 * more) / car.wheelbase();
    const double speed = std::sqrt(lateral / curvature);
    s.steer[i] = kRatio * (car.wheelbase() * curvature + car.understeer() * lateral + 0.002 * more);
    // Sideslip of the centre of mass: l_r / R - m l_f / (l C_r) a_y.
    const double sideslip =
        car.rear * curvature - car.mass * car.front / (car.wheelbase() * car.rear_stiffness) * lateral;
    s.speed[i] = speed * std::cos(sideslip), s.lateral_speed[i] = speed * std::sin(sideslip);
    s.lateral_acceleration[i] = lateral, s.yaw_rate[i] = speed * curvature, s.roll[i] = kRollGradient * lateral;
    const double transfers[] = {-kFrontTransfer, kFrontTransfer, -kRearTransfer, kRearTransfer};
    for (std::size_t w = 0; w < 4; ++w) s.loads[w][i] = 4000 + transfers[w] * lateral;
  }
  return s;
}

TEST(SteadyCircle, GradientsOfASingleTrackAreItsClosedForms) {
  const SingleTrack car;
  for (const Kind kind : {Kind::constant_radius, Kind::constant_speed, Kind::constant_steer}) {
    const VehicleMetrics metrics = steady_circle_metrics(circle_series(car, kind), circle_of(kind, car));
    const double k = car.understeer();
    EXPECT_NEAR(value(metrics, "understeer_gradient"), k, 1e-9 * k);
    EXPECT_NEAR(value(metrics, "characteristic_speed"), std::sqrt(car.wheelbase() / k), 1e-6);
    EXPECT_NEAR(value(metrics, "roll_gradient"), kRollGradient, 1e-12);
    EXPECT_NEAR(value(metrics, "largest_lateral_acceleration"), 6, 1e-12);
    EXPECT_NEAR(value(metrics, "load_transfer_axle_1"), kFrontTransfer, 1e-8);
    EXPECT_NEAR(value(metrics, "load_transfer_axle_2"), kRearTransfer, 1e-8);
    const double front = kFrontTransfer * kFrontTrack, rear = kRearTransfer * kRearTrack;
    EXPECT_NEAR(value(metrics, "roll_moment_share_axle_1"), front / (front + rear), 1e-12);
    EXPECT_NEAR(value(metrics, "roll_moment_share_axle_2"), rear / (front + rear), 1e-12);
    EXPECT_EQ(has(metrics, "yaw_rate_gain"), kind == Kind::constant_speed);
    EXPECT_TRUE(metrics.notes.empty()) << metrics.notes.front();
  }
}

TEST(SteadyCircle, SideslipAndYawGainAreThoseOfTheirSpeedAndRadius) {
  const SingleTrack car;
  const VehicleMetrics radius =
      steady_circle_metrics(circle_series(car, Kind::constant_radius), circle_of(Kind::constant_radius, car));
  const double of_load = -car.mass * car.front / (car.wheelbase() * car.rear_stiffness);
  EXPECT_NEAR(value(radius, "sideslip_gradient"), of_load, 1e-12);
  const VehicleMetrics speed =
      steady_circle_metrics(circle_series(car, Kind::constant_speed), circle_of(Kind::constant_speed, car));
  const double squared = car.speed * car.speed;
  EXPECT_NEAR(value(speed, "sideslip_gradient"), of_load + car.rear / squared, 1e-12);
  // v / (l + K v^2), over the ratio.
  EXPECT_NEAR(value(speed, "yaw_rate_gain"), car.speed / (car.wheelbase() + car.understeer() * squared) / kRatio, 1e-9);
}

TEST(SteadyCircle, ToTheRightIsTheMirrorOfToTheLeft) {
  const SingleTrack car;
  VehicleSeries s = circle_series(car, Kind::constant_radius);
  for (auto* values : {&s.steer, &s.lateral_speed, &s.lateral_acceleration, &s.yaw_rate, &s.roll})
    for (double& one : *values) one = -one;
  std::swap(s.loads[0], s.loads[1]), std::swap(s.loads[2], s.loads[3]);
  const VehicleMetrics metrics = steady_circle_metrics(s, circle_of(Kind::constant_radius, car));
  EXPECT_NEAR(value(metrics, "understeer_gradient"), car.understeer(), 1e-12);
  EXPECT_NEAR(value(metrics, "roll_gradient"), kRollGradient, 1e-12);
  EXPECT_NEAR(value(metrics, "load_transfer_axle_1"), kFrontTransfer, 1e-8);
  EXPECT_NEAR(value(metrics, "largest_lateral_acceleration"), 6, 1e-12);
}

TEST(SteadyCircle, OversteerHasACriticalSpeed) {
  SingleTrack car;
  std::swap(car.front_stiffness, car.rear_stiffness), std::swap(car.front, car.rear);
  ASSERT_LT(car.understeer(), 0);
  const VehicleMetrics metrics =
      steady_circle_metrics(circle_series(car, Kind::constant_radius), circle_of(Kind::constant_radius, car));
  EXPECT_NEAR(value(metrics, "understeer_gradient"), car.understeer(), 1e-12);
  EXPECT_NEAR(value(metrics, "critical_speed"), std::sqrt(-car.wheelbase() / car.understeer()), 1e-6);
  EXPECT_FALSE(has(metrics, "characteristic_speed"));
}

TEST(SteadyCircle, NoiseDoesNotBreakIt) {
  const SingleTrack car;
  VehicleSeries s = circle_series(car, Kind::constant_radius);
  add_noise(s.steer, 0.02, 1), add_noise(s.lateral_acceleration, 0.1, 2), add_noise(s.yaw_rate, 0.005, 3);
  add_noise(s.roll, 0.001, 4), add_noise(s.loads[0], 50, 5);
  const VehicleMetrics metrics = steady_circle_metrics(s, circle_of(Kind::constant_radius, car));
  EXPECT_NEAR(value(metrics, "understeer_gradient"), car.understeer(), 0.03 * car.understeer());
  EXPECT_NEAR(value(metrics, "roll_gradient"), kRollGradient, 0.02 * kRollGradient);
  EXPECT_NEAR(value(metrics, "load_transfer_axle_1"), kFrontTransfer, 0.02 * kFrontTransfer);
  EXPECT_NEAR(value(metrics, "largest_lateral_acceleration"), 6, 0.02);
}

TEST(SteadyCircle, SaysWhatItCannotGive) {
  const SingleTrack car;
  const SteadyCircle circle = circle_of(Kind::constant_radius, car);
  VehicleSeries slow = circle_series(car, Kind::constant_radius);
  for (double& lateral : slow.lateral_acceleration) lateral *= 0.2;
  VehicleMetrics metrics = steady_circle_metrics(slow, circle);
  EXPECT_FALSE(has(metrics, "understeer_gradient"));
  EXPECT_TRUE(notes(metrics, "the lateral acceleration covers 1.14 m/s^2"));
  EXPECT_NEAR(value(metrics, "largest_lateral_acceleration"), 1.2, 1e-12);

  VehicleSeries weaving = circle_series(car, Kind::constant_radius);
  for (std::size_t i = 0; i < weaving.t.size(); ++i) weaving.steer[i] += 0.5 * std::sin(weaving.t[i]);
  metrics = steady_circle_metrics(weaving, circle);
  EXPECT_FALSE(has(metrics, "understeer_gradient"));
  EXPECT_TRUE(notes(metrics, "the motion is not steady"));
  EXPECT_TRUE(has(metrics, "roll_gradient"));

  VehicleSeries wide = circle_series(car, Kind::constant_speed);
  EXPECT_TRUE(notes(steady_circle_metrics(wide, circle), "departs from a radius of 100 m"));

  SteadyCircle unknown = circle;
  unknown.wheelbase = 0;
  EXPECT_TRUE(notes(steady_circle_metrics(wide, unknown), "the wheelbase is not known"));
  wide.roll.pop_back();
  EXPECT_TRUE(notes(steady_circle_metrics(wide, circle), "roll angle: 6000 values for 6001 points"));
  VehicleSeries broken = circle_series(car, Kind::constant_radius);
  broken.yaw_rate[100] = std::nan("");
  EXPECT_TRUE(notes(steady_circle_metrics(broken, circle), "yaw rate: not finite at 1 s"));
  broken.t[7] += 0.002;
  EXPECT_TRUE(notes(steady_circle_metrics(broken, circle), "the steps of time are not equal"));
}

}  // namespace
}  // namespace mbgen::metrics_test
