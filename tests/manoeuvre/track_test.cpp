// Lane changes, braking and ride against closed forms; W_k against the factors of ISO 2631-1.

#include <nlohmann/json.hpp>

#include "tests/manoeuvre/metrics_support.hpp"
#include "workbench/manoeuvre/metrics_text.hpp"

namespace mbgen::metrics_test {
namespace {

/// A path at constant speed along x of the track with constant heading, then the whole turned and moved.
VehicleSeries straight_path(double speed, double y, double heading, const LaneChange& lanes) {
  VehicleSeries s = empty_series(1001, 0.01);
  const double c = std::cos(lanes.heading), k = std::sin(lanes.heading);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double x = -20 + speed * s.t[i];
    s.x[i] = lanes.x + c * x - k * y, s.y[i] = lanes.y + k * x + c * y, s.heading[i] = lanes.heading + heading;
    s.speed[i] = speed * std::cos(heading), s.lateral_speed[i] = -speed * std::sin(heading);
    s.lateral_acceleration[i] = 3 * std::sin(s.t[i]), s.yaw_rate[i] = -0.2 * std::sin(s.t[i]);
    s.roll[i] = 0.01 * std::sin(s.t[i]);
  }
  return s;
}

// A body of 4 m by 1.8 m about the reference point, in three lanes.
LaneChange three_lanes() {
  return {.sections = {{0, 15, 1.2, -1.2}, {45, 70, 5, 2}, {95, 125, 1.5, -1.5}},
          .front = 2.2,
          .rear = 1.8,
          .to_left = 0.9,
          .to_right = 0.9};
}

TEST(LaneChange, SpeedsAndLimitsAreThoseOfAStraightPath) {
  LaneChange lanes = three_lanes();
  lanes.sections[1] = {45, 70, 1.05, -3};
  for (const double turn : {0.0, 0.7, -2.5}) {
    lanes.x = 30 * turn, lanes.y = -12 * turn, lanes.heading = turn;
    const VehicleMetrics metrics = lane_change_metrics(straight_path(20, 0.1, 0, lanes), lanes);
    EXPECT_NEAR(value(metrics, "entry_speed"), 20, 1e-9);
    EXPECT_NEAR(value(metrics, "exit_speed"), 20, 1e-9);
    EXPECT_NEAR(value(metrics, "mean_speed"), 20, 1e-9);
    EXPECT_NEAR(value(metrics, "lane_excess"), 0.1 + 0.9 - 1.05, 1e-9);  // 5 cm are left in the second lane
    EXPECT_NEAR(value(metrics, "largest_lateral_acceleration"), 3, 1e-4);
    EXPECT_NEAR(value(metrics, "largest_yaw_rate"), 0.2, 1e-5);
    EXPECT_NEAR(value(metrics, "largest_roll"), 0.01, 1e-6);
    EXPECT_TRUE(metrics.notes.empty());
  }
}

// A body that is turned, along a lane: its front corner on the left is nearest to the limit within the lane. At the
// lane's begin a cone stands beside the body, where no corner is.
TEST(LaneChange, CornersAndConesBesideTheBodyCount) {
  LaneChange lanes = three_lanes();
  lanes.sections = {{0, 40, 1.5, -9}};
  const double heading = 0.1, y = -0.4;
  const double corner = y + 2.2 * std::sin(heading) + 0.9 * std::cos(heading);
  EXPECT_NEAR(value(lane_change_metrics(straight_path(20, y, heading, lanes), lanes), "lane_excess"), corner - 1.5,
              1e-9);
  // A lane of 1 m: of 4 m of the body the cones at both ends see the part that is beside them.
  lanes.sections = {{20, 21, 1, -9}};
  lanes.front = 2.2, lanes.rear = 1.8;
  const VehicleSeries turned = straight_path(20, y, 0, lanes);
  EXPECT_NEAR(value(lane_change_metrics(turned, lanes), "lane_excess"), y + 0.9 - 1, 1e-9);
  VehicleSeries across = empty_series(3, 0.1);  // at rest across the lane, its corners before and behind it
  across.x.assign(3, 20.5), across.y.assign(3, 0.0), across.heading.assign(3, 0.0);
  const VehicleMetrics metrics = lane_change_metrics(across, lanes);
  EXPECT_NEAR(value(metrics, "lane_excess"), -0.1, 1e-12);
  lanes.sections = {{20, 21, 9, -1}};
  lanes.to_right = 1.25;
  EXPECT_NEAR(value(lane_change_metrics(across, lanes), "lane_excess"), 0.25, 1e-12);
  EXPECT_TRUE(notes(metrics, "exit_speed: the vehicle does not pass the track's end at 21 m"));
  EXPECT_FALSE(has(metrics, "mean_speed"));
}

TEST(LaneChange, LeavingALaneIsSaid) {
  const LaneChange lanes = three_lanes();
  const VehicleMetrics metrics = lane_change_metrics(straight_path(20, 0.1, 0, lanes), lanes);
  EXPECT_NEAR(value(metrics, "lane_excess"), 2 - (0.1 - 0.9), 1e-9);
  EXPECT_TRUE(notes(metrics, "the body leaves its lane by 2.8 m in section 2 at"));
  EXPECT_TRUE(notes(lane_change_metrics(straight_path(20, 0, 0, lanes), {}), "the track has no sections"));
  LaneChange crossed = lanes;
  std::swap(crossed.sections[0].left, crossed.sections[0].right);
  EXPECT_TRUE(notes(lane_change_metrics(straight_path(20, 0, 0, lanes), crossed), "is empty"));
}

constexpr double kBrakeSpeed = 25, kBrakeBegin = 1, kBrakeRise = 0.4, kDeceleration = 6.5;

/// From 1 s on the deceleration rises evenly in 0.4 s, then it stays; along a line at 30 degrees, drifting to the left.
VehicleSeries braking_series(double duration) {
  VehicleSeries s = empty_series(static_cast<std::size_t>(std::lround(duration * 200)) + 1, 0.005);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double t = std::max(0.0, s.t[i] - kBrakeBegin), jerk = kDeceleration / kBrakeRise,
                 rise = std::min(t, kBrakeRise);
    const double stop = kBrakeRise + (kBrakeSpeed - kDeceleration * kBrakeRise / 2) / kDeceleration;
    const double held = std::clamp(t, kBrakeRise, stop) - kBrakeRise,
                 at_rise = kBrakeSpeed - kDeceleration * kBrakeRise / 2;
    double speed = kBrakeSpeed - jerk * rise * rise / 2, way = kBrakeSpeed * rise - jerk * rise * rise * rise / 6;
    if (t > kBrakeRise) speed = at_rise - kDeceleration * held, way += at_rise * held - kDeceleration * held * held / 2;
    way += kBrakeSpeed * std::min(s.t[i], kBrakeBegin);
    s.x[i] = way * std::cos(kPi / 6), s.y[i] = way * std::sin(kPi / 6);
    s.speed[i] = speed, s.heading[i] = kPi / 6 + 0.05 * std::sin(std::min(t, stop)), s.yaw_rate[i] = 0.05 * std::cos(t);
  }
  return s;
}

TEST(Braking, DistancesAndDecelerationsAreThoseOfTheClosedForm) {
  const VehicleMetrics metrics = braking_metrics(braking_series(8), {.begin = kBrakeBegin});
  EXPECT_NEAR(value(metrics, "initial_speed"), kBrakeSpeed, 1e-12);
  EXPECT_NEAR(value(metrics, "mean_fully_developed_deceleration"), kDeceleration, 1e-6);
  const double after = kBrakeSpeed - kDeceleration * kBrakeRise / 2;
  const double way =
      kBrakeSpeed * kBrakeRise - kDeceleration * kBrakeRise * kBrakeRise / 6 + after * after / (2 * kDeceleration);
  EXPECT_NEAR(value(metrics, "stopping_distance"), way, 1e-6);
  EXPECT_NEAR(value(metrics, "stopping_time"), kBrakeRise + after / kDeceleration, 1e-6);
  EXPECT_NEAR(value(metrics, "mean_deceleration"), kBrakeSpeed * kBrakeSpeed / (2 * way), 1e-6);
  EXPECT_NEAR(value(metrics, "largest_lateral_deviation"), 0, 1e-9);
  EXPECT_NEAR(value(metrics, "heading_change"), 0.05 * std::sin(kBrakeRise + after / kDeceleration), 1e-9);
  EXPECT_NEAR(value(metrics, "largest_yaw_rate"), 0.05, 1e-9);
}

TEST(Braking, DeviationIsSquareToTheLineAtTheBegin) {
  VehicleSeries s = braking_series(8);
  for (std::size_t i = 200; i < s.t.size(); ++i) {
    const double away = -0.3 * std::sin(s.t[i] - 1);  // to the right first
    s.x[i] -= away * std::sin(kPi / 6), s.y[i] += away * std::cos(kPi / 6);
  }
  const VehicleMetrics metrics = braking_metrics(s, {.begin = kBrakeBegin});
  EXPECT_NEAR(value(metrics, "largest_lateral_deviation"), 0.3, 1e-5);
  EXPECT_NEAR(value(metrics, "lateral_deviation"), -0.3 * std::sin(7), 1e-9);
}

TEST(Braking, SaysWhatItCannotGive) {
  VehicleMetrics metrics = braking_metrics(braking_series(3), {.begin = kBrakeBegin});
  EXPECT_FALSE(has(metrics, "stopping_distance"));
  EXPECT_FALSE(has(metrics, "mean_fully_developed_deceleration"));
  EXPECT_TRUE(notes(metrics, "the speed falls from 25 to 13.3 m/s, not to 2.5"));
  metrics = braking_metrics(braking_series(4.8), {.begin = kBrakeBegin});
  EXPECT_TRUE(has(metrics, "mean_fully_developed_deceleration"));
  EXPECT_FALSE(has(metrics, "stopping_distance"));
  EXPECT_TRUE(notes(metrics, "the vehicle does not stop, its speed is 1.6 m/s at the end"));
  EXPECT_TRUE(notes(braking_metrics(braking_series(3), {.begin = 9}), "braking begins at 9 s"));
  EXPECT_TRUE(notes(braking_metrics(braking_series(8), {.begin = 7}), "the speed is 0 m/s when braking begins"));
}

// Table 3 of ISO 2631-1:1997, factors times 1000 at the nominal frequencies of the one-third octaves; the table is
// found in manuals of vibration meters too. It is rounded to three digits.
TEST(VerticalWeighting, IsTheTableOfTheStandard) {
  const struct {
    double frequency, factor;
  } table[] = {{0.1, 31.2}, {0.125, 48.6}, {0.16, 79.0}, {0.2, 121},  {0.25, 182}, {0.315, 263}, {0.4, 352},
               {0.5, 418},  {0.63, 459},   {0.8, 477},   {1, 482},    {1.25, 484}, {1.6, 494},   {2, 531},
               {2.5, 631},  {3.15, 804},   {4, 967},     {5, 1039},   {6.3, 1054}, {8, 1036},    {10, 988},
               {12.5, 902}, {16, 768},     {20, 636},    {25, 513},   {31.5, 405}, {40, 314},    {50, 246},
               {63, 186},   {80, 132},     {100, 88.7},  {125, 54.0}, {160, 28.5}, {200, 15.2},  {250, 7.90},
               {315, 3.98}, {400, 1.95}};
  for (const auto& [frequency, factor] : table)
    EXPECT_NEAR(1000 * vertical_weighting(frequency), factor, std::max(0.005 * factor, 0.01)) << frequency << " Hz";
  EXPECT_EQ(vertical_weighting(0), 0);
}

VehicleSeries ride_series(double frequency, double amplitude, double duration, double step) {
  VehicleSeries s = empty_series(static_cast<std::size_t>(std::lround(duration / step)) + 1, step);
  s.loads.assign(1, {});
  s.wheels = {{"front", 0, true}};
  for (const double t : s.t) {
    const double sine = std::sin(2 * kPi * frequency * t);
    s.vertical_acceleration[s.loads[0].size()] = amplitude * sine;
    s.loads[0].push_back(4000 + 1200 * sine);
  }
  s.speed.assign(s.t.size(), 22);
  return s;
}

TEST(Ride, SineIsWeightedByTheStandardsFactor) {
  for (const auto& [frequency, factor] : {std::pair(1.0, 0.482), {5.0, 1.039}, {12.5, 0.902}, {40.0, 0.314}}) {
    const VehicleMetrics metrics = ride_metrics(ride_series(frequency, 2, 60, 0.002), {});
    EXPECT_NEAR(value(metrics, "vertical_acceleration_rms"), std::sqrt(2.0), 2e-3);
    EXPECT_NEAR(value(metrics, "weighted_acceleration_rms"), factor * std::sqrt(2.0), 0.008 * factor) << frequency;
    EXPECT_GT(value(metrics, "crest_factor"), 1.41);  // more: the weighting feels the sine begin
    EXPECT_LT(value(metrics, "crest_factor"), 2);
    EXPECT_NEAR(value(metrics, "dynamic_load_coefficient_front"), 0.3 / std::sqrt(2.0), 2e-4);
    EXPECT_NEAR(value(metrics, "speed"), 22, 1e-12);
  }
}

// Weighted in the time domain by another way: a pulse's energy is that of its spectrum (Parseval). The Gaussian
// a exp(-t^2 / (2 d^2)) has the spectrum a d sqrt(2 pi) exp(-(w d)^2 / 2).
TEST(Ride, PulseKeepsTheEnergyOfItsWeightedSpectrum) {
  constexpr double kWidth = 0.05, kDuration = 40;
  VehicleSeries s = ride_series(1, 0, kDuration, 0.002);
  for (std::size_t i = 0; i < s.t.size(); ++i)
    s.vertical_acceleration[i] = 3 * std::exp(-std::pow((s.t[i] - 10) / kWidth, 2) / 2);
  double energy = 0;
  constexpr double kLine = 1e-3;
  for (double f = kLine; f < 40; f += kLine) {
    const double size = 3 * kWidth * std::sqrt(2 * kPi) * std::exp(-std::pow(2 * kPi * f * kWidth, 2) / 2);
    energy += 2 * std::pow(size * vertical_weighting(f), 2) * kLine;
  }
  const VehicleMetrics metrics = ride_metrics(s, {});
  const double rms = std::sqrt(energy / kDuration);
  EXPECT_NEAR(value(metrics, "weighted_acceleration_rms"), rms, 1e-3 * rms);
  EXPECT_GT(value(metrics, "crest_factor"), 9);
  EXPECT_TRUE(notes(metrics, "crest_factor"));
}

TEST(Ride, SaysWhatItCannotGive) {
  EXPECT_TRUE(notes(ride_metrics(ride_series(1, 1, 4, 0.01), {}), "goes on for 4 s from 0 s"));
  EXPECT_TRUE(notes(ride_metrics(ride_series(1, 1, 20, 0.01), {.begin = 17}), "goes on for 3 s from 17 s"));
  const VehicleMetrics coarse = ride_metrics(ride_series(1, 1, 20, 0.05), {});
  EXPECT_FALSE(has(coarse, "weighted_acceleration_rms"));
  EXPECT_TRUE(has(coarse, "vertical_acceleration_rms"));
  EXPECT_TRUE(notes(coarse, "20 points in a second"));
  VehicleSeries s = ride_series(1, 1, 20, 0.01);
  s.vertical_acceleration.clear();
  EXPECT_TRUE(notes(ride_metrics(s, {}), "vertical acceleration: 0 values"));
}

TEST(MetricsText, IsReadByPeopleAndByThePage) {
  const VehicleMetrics metrics{{{"understeer_gradient", 0.01, "rad/(m/s^2)", "more steer"},
                                {"gain", 1, "(m/s^2)/rad", "answer"},
                                {"share", 0.25, "1", "part"}},
                               {{"Path", {"x", "m"}, {"y", "m"}, {{"limits", {0, 1, 2}, {0, std::nan(""), 1.0 / 3}}}}},
                               {"why"}};
  EXPECT_EQ(metrics_text(metrics),
            "  understeer_gradient                      0.57296 deg/(m/s^2)\n"
            "  gain                                    0.017453 (m/s^2)/deg\n"
            "  share                                       0.25\n"
            "note: why\n");
  nlohmann::ordered_json run = {{"rows", 3}};
  add_metrics(run, metrics);
  EXPECT_EQ(
      run["metrics"][0],
      nlohmann::ordered_json(
          {{"name", "understeer_gradient"}, {"value", 0.01}, {"unit", "rad/(m/s^2)"}, {"meaning", "more steer"}}));
  EXPECT_EQ(run["diagrams"].dump(), R"([{"title":"Path","x":{"name":"x","unit":"m"},"y":{"name":"y","unit":"m"},)"
                                    R"("curves":[{"name":"limits","x":[0.0,1.0,2.0],"y":[0.0,null,0.333333]}]}])");
  EXPECT_EQ(run["metric_notes"].dump(), R"(["why"])");
}

}  // namespace
}  // namespace mbgen::metrics_test
