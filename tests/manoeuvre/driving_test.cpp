// Parts of a driver: signals with their derivatives, courses, lanes, hands and the controller of speed; and every
// message about a manoeuvre file: tests/errors/manoeuvres/<rule>.json and the exact text beside it, which
// MBGEN_UPDATE=1 rewrites.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "tests/support/expected_text.hpp"
#include "workbench/manoeuvre/driver.hpp"
#include "workbench/manoeuvre/manoeuvre.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
namespace fs = std::filesystem;

/// Derivatives against central differences, everywhere but next to corners.
void expect_consistent(const Signal& signal, double end, double scale) {
  constexpr double kStep = 1e-5;
  for (double t = 0.01; t < end; t += 0.0371) {
    const Rates before = signal.at(t - kStep), here = signal.at(t), after = signal.at(t + kStep);
    EXPECT_NEAR((after.value - before.value) / (2 * kStep), here.rate, 1e-5 * scale) << t;
    EXPECT_NEAR((after.rate - before.rate) / (2 * kStep), here.acceleration, 1e-3 * scale) << t;
  }
}

TEST(Signal, DerivativesAreThoseOfTheValue) {
  Signal change, ramp, sine, sweep, table;
  change.add_change(2, 0.5, 1.5);
  expect_consistent(change, 3, 2);
  EXPECT_DOUBLE_EQ(change.at(3).value, 2);
  EXPECT_NEAR(change.at(1.25).rate, kSmoothRate * 2 / 1.5, 1e-12);
  change.go_to(-1, 3, 1);
  EXPECT_DOUBLE_EQ(change.at(5).value, -1);
  change.go_to(4, 3.5, 1);  // while it still goes to -1
  EXPECT_DOUBLE_EQ(change.at(5).value, 4);
  ramp.add_ramp(-3, 0.5, 0.7);
  expect_consistent(ramp, 8, 3);
  EXPECT_NEAR(ramp.at(3).rate, -0.7, 1e-12);
  EXPECT_NEAR(ramp.at(8).value, -3, 1e-12);
  sine.add_sine(0.4, 0, 0.5, 10);
  expect_consistent(sine, 8, 1);
  EXPECT_NEAR(sine.at(0.5).value, 0.4, 1e-12);
  EXPECT_NEAR(sine.at(30).value, 0, 1e-12);
  sweep.add_sweep(0.3, 0.2, 0.5, 2, 10);
  expect_consistent(sweep, 10, 10);
  table.add_table({{0, 1}, {1, 3}, {2, 2}}, 0.5);
  EXPECT_DOUBLE_EQ(table.at(1.5).value, 3);
  EXPECT_DOUBLE_EQ(table.at(9).value, 2);
}

// A change that is interrupted ends there: the next one starts at its value, and does not go beyond its target.
TEST(Signal, AnInterruptedChangeEndsWithoutOvershoot) {
  Signal signal;
  signal.go_to(0.05, 1, 10);
  const double reached = signal.at(2).value;
  signal.go_to(0, 2, 0.1);
  EXPECT_GT(reached, 0);
  EXPECT_DOUBLE_EQ(signal.at(2).value, reached);
  for (double t = 2; t < 30; t += 0.01) {
    EXPECT_LE(signal.at(t).value, reached) << t;
    EXPECT_GE(signal.at(t).value, -1e-15) << t;
  }
  EXPECT_NEAR(signal.at(2.1).value, 0, 1e-15);
}

TEST(Signal, ATableIsNothingBeforeItsInstant) {
  Signal table;
  table.add_table({{0, 0.2}, {1, 0.3}}, 2);
  for (const double t : {0.0, 1.0, 2.0}) EXPECT_EQ(table.at(t).value, 0) << t;
  EXPECT_NEAR(table.at(2.001).value, 0.2, 1e-3);
}

TEST(Signal, ASweepFallsToRestBehindItsEnd) {
  Signal sweep;
  sweep.add_sweep(0.3, 0.2, 0.5, 2, 10.1);
  expect_consistent(sweep, 14, 10);
  for (const double t : {10.8001, 12.0}) {
    EXPECT_EQ(sweep.at(t).value, 0) << t;
    EXPECT_EQ(sweep.at(t).rate, 0) << t;
    EXPECT_EQ(sweep.at(t).acceleration, 0) << t;
  }
}

// Whole cycles within a second at both ends of the sweep: its frequency is that which was asked for.
TEST(Signal, ASweepBeginsAndEndsAtItsFrequencies) {
  Signal sweep;
  sweep.add_sweep(1, 0, 0.5, 4, 60);
  double first = 0, last = 0;
  for (double t = 0; t < 60; t += 1e-3) {
    const bool crosses = sweep.at(t).value < 0 && sweep.at(t + 1e-3).value >= 0;
    if (!crosses) continue;
    if (first == 0) first = t;
    last = t;
  }
  EXPECT_NEAR(first, 2, 0.1);  // a little more than 0.5 Hz by then
  EXPECT_GT(last, 59.7);
}

TEST(Path, ACircleHasItsRadiusAndItsCentre) {
  const Path path = circle_path(10, -40, 20);
  const PathPoint end = path.at(150);
  EXPECT_NEAR(end.curvature, -1.0 / 40, 1e-12);
  // The centre lies a radius to the right of every point of the circle.
  const auto centre = [](const PathPoint& p) {
    return std::pair(p.x + 40 * std::sin(p.heading), p.y - 40 * std::cos(p.heading));
  };
  const auto one = centre(path.at(60)), other = centre(end);
  EXPECT_NEAR(one.first, other.first, 1e-3);
  EXPECT_NEAR(one.second, other.second, 1e-3);
  EXPECT_NEAR(path.nearest(end.x + 0.3 * std::sin(end.heading), end.y - 0.3 * std::cos(end.heading), 149.5), 150, 2e-3);
}

// The table ends where the circle begins; from there on it is one to rounding, however long.
TEST(Path, ACircleGoesOnWithoutATable) {
  const double radius = 1e6;
  const Path path = circle_path(20, radius, 60);
  EXPECT_LT(path.points.size(), 400u);
  const auto centre = [&](double way) {
    const PathPoint p = path.at(way);
    return std::pair(p.x - radius * std::sin(p.heading), p.y + radius * std::cos(p.heading));
  };
  const auto [x, y] = centre(100);
  for (const double way : {1e3, 1e5, 1e7}) {
    EXPECT_NEAR(centre(way).first, x, 1e-6) << way;
    EXPECT_NEAR(centre(way).second, y, 1e-6) << way;
    EXPECT_NEAR(path.at(way).heading - path.at(100).heading, (way - 100) / radius, 1e-12);
  }
  EXPECT_EQ(path.at(3).y, 0);
  EXPECT_DOUBLE_EQ(path.at(3).x, 3);
}

// ISO 3888-2:2011, table 1, of a car of 1.573 m: sections of 12, 13.5, 11, 12.5 and 12 m, the first 1.98 m wide, the
// third 2.573 m and 1 m beside the first, the last at least 3 m wide.
TEST(Lanes, AreThoseOfTheStandards) {
  const auto avoidance = obstacle_avoidance(1.573, 50, 1);
  ASSERT_EQ(avoidance.size(), 3u);
  EXPECT_DOUBLE_EQ(avoidance[0].to, 62);
  EXPECT_DOUBLE_EQ(avoidance[1].from, 75.5);
  EXPECT_DOUBLE_EQ(avoidance[2].to, 50 + 61);
  EXPECT_NEAR(avoidance[0].left - avoidance[0].right, 1.98, 1e-3);
  EXPECT_NEAR(avoidance[1].right - avoidance[0].left, 1, 1e-12);
  EXPECT_NEAR(avoidance[1].left - avoidance[1].right, 2.573, 1e-12);
  EXPECT_NEAR(avoidance[2].left - avoidance[2].right, 3, 1e-12);
  // ISO 3888-1: 125 m, the other lane 3.5 m beside the first.
  const auto change = double_lane_change(1.8, 0, -1);
  EXPECT_DOUBLE_EQ(change[2].to, 125);
  EXPECT_NEAR(change[0].left - change[1].left, 3.5, 1e-12);
  EXPECT_NEAR(change[1].left - change[1].right, 1.2 * 1.8 + 0.25, 1e-12);
}

// Curvature that a driver aims at who is beside a straight course, parallel to it.
TEST(Driver, TurnsBackToTheCourseAndAlongIt) {
  const DriverSettings driver{.preview = 1, .anticipation = 0, .gain = 0.5, .understeer = 0.002};
  const Path straight = path_of_curvature([](double) { return 0.0; }, 0, 1);
  PlaneMotion motion{.x = 20, .y = 0.5, .forward = 20};
  const CoursePlace place = find_place(straight, motion, 0);
  EXPECT_NEAR(place.way, 20, 1e-9);
  EXPECT_NEAR(place.offset, 0.5, 1e-9);
  const double curvature = -0.5 * 2 * 0.5 / (20 * 20);
  EXPECT_NEAR(steering_target(straight, place, motion, driver, 3), curvature * (3 + 0.002 * 400), 1e-12);
  const Path circle = path_of_curvature([](double) { return 0.01; }, 0, 100);
  motion = {.forward = 20};
  EXPECT_NEAR(steering_target(circle, {0, 0}, motion, driver, 3), 0.01 * (3 + 0.002 * 400), 1e-12);
}

TEST(Driver, HandsReachTheWishWithinTheirLimits) {
  Rates hand;
  const HandLimits limits{0.3, 0.5};
  double largest_rate = 0;
  for (int k = 0; k < 300; ++k) {
    const double a = hand_acceleration(hand, 0.4, 0.1, 0.01, limits);
    hand = {hand.value + 0.01 * (hand.rate + 0.005 * a), hand.rate + 0.01 * a, a};
    largest_rate = std::max(largest_rate, hand.rate);
    EXPECT_LT(hand.value, 0.3 * 1.02);
  }
  EXPECT_NEAR(hand.value, 0.3, 1e-6);
  EXPECT_NEAR(largest_rate, 0.5, 1e-9);
}

// A load of 1 m/s^2 on the controller: its integral takes it, and does not wind up at a limit.
TEST(SpeedController, TakesALoadAndDoesNotWindUp) {
  const SpeedSettings settings{.gain = 1, .integral_time = 4};
  SpeedController controller;
  double speed = 0, largest = 0;
  for (int k = 0; k < 6000; ++k) {
    speed += 0.01 * (controller.acceleration(settings, 20, speed, 0.01, -2, 3) - 1);
    largest = std::max(largest, speed);
  }
  EXPECT_NEAR(speed, 20, 1e-3);
  EXPECT_LT(largest, 22);
}

const fs::path kErrors = fs::path(MBGEN_SOURCE_DIR) / "tests" / "errors" / "manoeuvres";

TEST(ManoeuvreFile, EveryRuleHasItsExactMessage) {
  fs::current_path(kErrors);
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kErrors)) {
    if (entry.path().extension() != ".json") continue;
    const Result<Manoeuvre> result = read_manoeuvre_file(entry.path().filename().string());
    ASSERT_FALSE(result) << entry.path() << " was accepted";
    expect_text(fs::path(entry.path()).replace_extension(".txt"), to_text(result.problems()));
    ++count;
  }
  EXPECT_GT(count, 10);
}

// Every file that ends early is refused with a place in it.
TEST(ManoeuvreFile, TruncatedFilesAreRefused) {
  const std::string whole = content(fs::path(MBGEN_SOURCE_DIR) / "models" / "manoeuvres" / "turn_in.json");
  for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
    const Result<Manoeuvre> result = read_manoeuvre(whole.substr(0, size), "m.json");
    ASSERT_FALSE(result) << size;
    ASSERT_FALSE(result.problems().empty());
  }
}

TEST(ManoeuvreFile, ExamplesAreRead) {
  const fs::path examples = fs::path(MBGEN_SOURCE_DIR) / "models" / "manoeuvres";
  for (const fs::directory_entry& entry : fs::directory_iterator(examples)) {
    const Result<Manoeuvre> result = read_manoeuvre_file(entry.path().string());
    EXPECT_TRUE(result) << to_text(result.problems());
  }
  const Result<Manoeuvre> step = read_manoeuvre(
      R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": "72/3.6", "steer": { "deg": 2 } })", "step.json");
  ASSERT_TRUE(step) << to_text(step.problems());
  EXPECT_EQ(type_of(*step), "step_steer");
  EXPECT_DOUBLE_EQ(*base_of(*step).speed, 20);
  EXPECT_DOUBLE_EQ(*std::get<StepManoeuvre>(*step).steer, std::numbers::pi / 90);
}

}  // namespace
}  // namespace mbgen
