// Rates made from values: continuity, range, lag, and what is left alone.

#include "mbgen/input_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mbgen {
namespace {

struct Inputs {
  double torque = 7, angle = 0, rate = 0, acceleration = 0, way = 0, speed = 0;
};

constexpr InputRow<Inputs, double> kRows[] = {{3, {&Inputs::angle, &Inputs::rate, &Inputs::acceleration}},
                                              {2, {&Inputs::way, &Inputs::speed}}};

using Paths = InputPaths<Inputs, kRows>;

constexpr double kStep = 0.01;

Inputs wanted(double angle, double way) {
  Inputs inputs;
  inputs.angle = angle;
  inputs.way = way;
  return inputs;
}

/// Where the row stands at the end of the step.
Inputs later(const Inputs& at, double h) {
  Inputs result = at;
  result.angle += h * at.rate + h * h / 2 * at.acceleration;
  result.rate += h * at.acceleration;
  result.way += h * at.speed;
  return result;
}

bool are_same(const Inputs& one, const Inputs& other) { return std::memcmp(&one, &other, sizeof one) == 0; }

TEST(InputPaths, FollowWithoutJumps) {
  Paths paths;
  Inputs end = wanted(0.1, 0.2);
  for (int k = 0; k < 200; ++k) {
    const double h = k < 100 ? kStep : kStep * (1 + 0.3 * std::sin(k));
    const Inputs at = paths.of_step(k == 0 ? end : wanted(std::sin(0.3 * k), k % 7), h);
    ASSERT_NEAR(at.angle, end.angle, 1e-14) << "step " << k;
    ASSERT_NEAR(at.rate, end.rate, 1e-11);
    ASSERT_NEAR(at.way, end.way, 1e-13);
    EXPECT_EQ(at.torque, 7);
    end = later(at, h);
    EXPECT_NEAR(paths.now(wanted(9, 9)).angle, end.angle, 1e-14);
  }
}

TEST(InputPaths, StayWithinTheValuesAndComeToRest) {
  Paths paths;
  paths.of_step(wanted(0, 0), kStep);
  EXPECT_FALSE(paths.moves(wanted(0, 0)));
  const Inputs target = wanted(0.785, -3);
  EXPECT_TRUE(paths.moves(target));
  double last = 0;
  for (int k = 0; k < 2; ++k) {
    const Inputs at = paths.of_step(target, kStep);
    for (int part = 0; part <= 10; ++part) {
      const Inputs inside = later(at, kStep * part / 10);
      EXPECT_GE(inside.angle, last - 1e-15);
      EXPECT_LE(inside.angle, 0.785 + 1e-15);
      EXPECT_LE(std::abs(inside.way + 1.5), 1.5 + 1e-15);
      last = inside.angle;
    }
  }
  EXPECT_TRUE(are_same(paths.of_step(target, kStep), target));
  EXPECT_FALSE(paths.moves(target));
  // Back to zero, where nothing but the way there says how large rounding is.
  for (int k = 0; k < 3; ++k) paths.of_step(wanted(0, 0), kStep);
  EXPECT_TRUE(are_same(paths.now(wanted(0, 0)), wanted(0, 0)));
}

/// A line is followed exactly, late by one step with one derivative, by one and a half with two; a parabola too, but
/// for the eighth of a step squared by which a quadratic spline lies beside its control points.
TEST(InputPaths, LagByHalfAStepForEachMember) {
  constexpr double kSlope = 2, kCurvature = 5;
  const auto angle = [](double t) { return kSlope * t + kCurvature / 2 * t * t; };
  Paths paths;
  for (int k = 0; k < 40; ++k) {
    const double t = k * kStep;
    const Inputs at = paths.of_step(wanted(angle(t), 3 * t), kStep);
    if (k < 3) continue;
    EXPECT_NEAR(at.way, 3 * (t - kStep), 1e-14);
    EXPECT_NEAR(at.speed, 3, 1e-11);
    const double then = t - 1.5 * kStep;
    EXPECT_NEAR(at.angle, angle(then) + kCurvature * kStep * kStep / 8, 1e-14);
    EXPECT_NEAR(at.rate, kSlope + kCurvature * then, 1e-11);
    EXPECT_NEAR(at.acceleration, kCurvature, 1e-9);
  }
}

TEST(InputPaths, LeaveGivenRatesAlone) {
  Paths paths, told;
  told.rates_given = true;
  for (int k = 0; k < 20; ++k) {
    Inputs inputs = wanted(std::sin(0.1 * k), std::cos(0.1 * k));
    inputs.rate = std::cos(0.1 * k);
    inputs.speed = k < 5 || k > 10 ? 0 : 1;
    const Inputs at = paths.of_step(inputs, kStep);
    EXPECT_EQ(at.angle, inputs.angle);
    EXPECT_EQ(at.rate, inputs.rate);
    EXPECT_EQ(at.acceleration, 0);
    if (k >= 5) {
      EXPECT_TRUE(are_same(at, inputs)) << "a rate that was given stays given where it is zero";
    }
    EXPECT_TRUE(are_same(told.of_step(inputs, kStep), inputs));
    EXPECT_TRUE(are_same(told.now(inputs), inputs));
    EXPECT_FALSE(told.moves(inputs));
  }
}

/// Rates that end to be given go on from where they led to; a restart stands at what it is given.
TEST(InputPaths, GoOnFromWhereTheyStand) {
  Paths paths;
  Inputs moving = wanted(0, 0);
  moving.speed = 2;
  paths.of_step(moving, kStep);
  paths.restart();
  const Inputs first = paths.of_step(wanted(0.4, 5), kStep);
  EXPECT_EQ(first.angle, 0.4);
  EXPECT_EQ(first.speed, 0);
  EXPECT_EQ(paths.of_step(wanted(0.5, 5), kStep).angle, 0.4);
  EXPECT_NEAR(paths.now(wanted(0.5, 5)).rate, 0.1 / kStep, 1e-12);
  const Paths before = paths;
  Paths again = before;
  EXPECT_TRUE(are_same(paths.of_step(wanted(0.7, 5), kStep), again.of_step(wanted(0.7, 5), kStep)));
}

/// Rows as long as they may be: the path of degree eight follows a line.
struct Long {
  double u[9];
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, i = 0, j = 0;
};
constexpr InputRow<Long, double> kLong[] = {
    {9, {&Long::a, &Long::b, &Long::c, &Long::d, &Long::e, &Long::f, &Long::g, &Long::i, &Long::j}}};

TEST(InputPaths, HaveUpToEightDerivatives) {
  InputPaths<Long, kLong> paths;
  Long inputs{}, at{};
  for (int k = 0; k < 40; ++k) {
    inputs.a = 0.25 * k;
    at = paths.of_step(inputs, 1);
  }
  EXPECT_NEAR(at.a, 0.25 * (39 - 4.5), 1e-9);
  EXPECT_NEAR(at.b, 0.25, 1e-9);
  EXPECT_NEAR(at.c, 0, 1e-9);
}

/// In single precision too it comes to rest.
struct Single {
  float angle = 0, rate = 0, acceleration = 0;
};
constexpr InputRow<Single, float> kSingle[] = {{3, {&Single::angle, &Single::rate, &Single::acceleration}}};

TEST(InputPaths, WorkInSinglePrecision) {
  InputPaths<Single, kSingle> paths;
  Single inputs;
  paths.of_step(inputs, 0.001);
  inputs.angle = 0.3f;
  for (int k = 0; k < 4; ++k) paths.of_step(inputs, 0.001);
  EXPECT_FALSE(paths.moves(inputs));
  EXPECT_EQ(paths.now(inputs).angle, 0.3f);
}

constexpr InputRow<Inputs, double> kMade[] = {{3, {&Inputs::angle, &Inputs::rate, &Inputs::acceleration}, true},
                                              {2, {&Inputs::way, &Inputs::speed}}};

// A caller who gives value and rate of 0.5 t^2, and knows no acceleration: it is 1 from the second step on.
TEST(InputPaths, MakeALastRateThatTheModelDoesNotName) {
  InputPaths<Inputs, kMade> paths;
  for (int k = 0; k < 20; ++k) {
    const double t = k * kStep;
    Inputs given = wanted(t * t / 2, 0.5);
    given.rate = t;
    if (k > 1) {
      EXPECT_NEAR(paths.now(given).acceleration, 1, 1e-12) << "outputs at the end of the last step";
    }
    const Inputs at = paths.of_step(given, kStep);
    EXPECT_EQ(at.angle, given.angle);
    EXPECT_EQ(at.rate, given.rate);
    if (k > 0) {
      EXPECT_NEAR(at.acceleration, 1, 1e-12) << k;
    }
    EXPECT_EQ(at.way, 0.5);
  }
  Inputs known = wanted(1, 0.5);
  known.rate = 2;
  known.acceleration = 3;
  EXPECT_TRUE(are_same(paths.of_step(known, kStep), known)) << "one that is given is taken";
  known.acceleration = 0;
  EXPECT_TRUE(are_same(paths.of_step(known, kStep), known));
}

}  // namespace
}  // namespace mbgen
