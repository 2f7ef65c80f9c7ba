// Characteristics and force laws, against values calculated by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "mbgen/math/table.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {
namespace {

constexpr double kX[] = {-1, 0, 2, 3};
constexpr double kY[] = {4, 1, 2, 2};

TEST(InterpolateLinear, RunsThroughItsPointsAndStraightBeyondThem) {
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 4, kX[i]), kY[i]);
  EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 4, -0.5), 2.5);
  EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 4, 0.5), 1.25);
  EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 4, -3.0), 10);
  EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 4, 50.0), 2);
  EXPECT_DOUBLE_EQ(interpolate_linear(kX, kY, 2, 50.0), -149);
}

TEST(MonotoneSlopes, AreThoseOfFritschAndCarlson) {
  // Secants -3, 1/2, 0: a turn at 0, and a flat segment after 2.
  double slopes[4];
  monotone_slopes(kX, kY, 4, slopes);
  EXPECT_EQ(slopes[0], -3);
  EXPECT_EQ(slopes[1], 0);
  EXPECT_EQ(slopes[2], 0);
  EXPECT_EQ(slopes[3], 0);
  // Secants 1 over a width of 2, 4 over 1: the parabola's slope (1*1 + 2*4)/3 = 3 is kept; secants 1 and 16 give 11,
  // held at three times the gentler one.
  const double x[] = {0, 2, 3}, gentle[] = {0, 2, 6}, steep[] = {0, 2, 18};
  monotone_slopes(x, gentle, 3, slopes);
  EXPECT_DOUBLE_EQ(slopes[1], 3);
  monotone_slopes(x, steep, 3, slopes);
  EXPECT_DOUBLE_EQ(slopes[1], 3);
  const double falling[] = {0, -2, -18};
  monotone_slopes(x, falling, 3, slopes);
  EXPECT_DOUBLE_EQ(slopes[1], -3);
}

TEST(MonotoneSlopes, AreKnownToTheCompiler) {
  struct Slopes {
    double value[4];
  };
  constexpr Slopes slopes = [] {
    Slopes s{};
    monotone_slopes(kX, kY, 4, s.value);
    return s;
  }();
  static_assert(slopes.value[0] == -3.0);
}

TEST(InterpolateMonotoneCubic, FollowsItsPointsSlopesAndStraightEnds) {
  const double x[] = {0, 1, 3}, y[] = {0, 1, 2};
  double slopes[3];
  monotone_slopes(x, y, 3, slopes);  // 1, 5/6, 1/2
  EXPECT_DOUBLE_EQ(slopes[1], 5.0 / 6.0);
  const auto value = [&](double at) { return interpolate_monotone_cubic(x, y, slopes, 3, at); };
  for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(value(x[i]), y[i]);
  EXPECT_DOUBLE_EQ(value(-2.0), -2.0);
  EXPECT_DOUBLE_EQ(value(5.0), 3.0);
  // Hermite at half of the first segment: (y0 + y1)/2 + h (d0 - d1)/8 = 1/2 + (1/6)/8.
  EXPECT_DOUBLE_EQ(value(0.5), 0.5 + 1.0 / 48.0);
  const double step = 1e-6;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR((value(x[i] + step) - value(x[i])) / step, slopes[i], 1e-5);
    EXPECT_NEAR((value(x[i]) - value(x[i] - step)) / step, slopes[i], 1e-5);
  }
}

TEST(InterpolateMonotoneCubic, RisesWhereItsPointsRise) {
  // Akima's points, which make ordinary cubic splines overshoot.
  const std::vector<double> x{0, 2, 3, 5, 6, 8, 9, 11, 12, 14, 15};
  const std::vector<double> y{10, 10, 10, 10, 10, 10, 10.5, 15, 50, 60, 85};
  std::vector<double> slopes(x.size());
  monotone_slopes(x.data(), y.data(), 11, slopes.data());
  double previous = 10;
  for (int i = 0; i <= 1500; ++i) {
    const double value = interpolate_monotone_cubic(x.data(), y.data(), slopes.data(), 11, 0.01 * i);
    EXPECT_GE(value, previous - 1e-13) << 0.01 * i;
    previous = value;
  }
  EXPECT_DOUBLE_EQ(previous, 85);
}

TEST(InterpolateMonotoneCubic, ReproducesAStraightLine) {
  const double x[] = {-1, 0.5, 0.75, 4}, y[] = {-3, 0, 0.5, 7};
  double slopes[4];
  monotone_slopes(x, y, 4, slopes);
  for (double at = -3; at < 6; at += 0.125) {
    EXPECT_NEAR(interpolate_monotone_cubic(x, y, slopes, 4, at), 2 * at - 1, 1e-14);
  }
}

TEST(AirSpring, FollowsThePolytropicLaw) {
  // 6 bar absolute in 10 l; compressed to 8 l isothermally: 7.5 bar; less 1 bar ambient, on 0.02 m^2.
  EXPECT_NEAR(air_spring_force(6e5, 1e5, 1.0, 0.010, 0.008, 0.02), 13000, 1e-9);
  EXPECT_NEAR(air_spring_force(6e5, 1e5, 1.0, 0.010, 0.010, 0.02), 10000, 1e-9);
  // Halved adiabatically: 2^1.4 = 2.639015821545789 times the pressure.
  EXPECT_NEAR(air_spring_force(6e5, 1e5, 1.4, 0.010, 0.005, 0.02), (6e5 * 2.639015821545789 - 1e5) * 0.02, 1e-8);
  // Stiffness at the reference length: A (n p0 A / V0), the textbook formula for constant area.
  const double area = 0.02, exponent = 1.38, step = 1e-6;
  const auto force = [&](double compression) {
    return air_spring_force(6e5, 1e5, exponent, 0.010, 0.010 - area * compression, area);
  };
  EXPECT_NEAR((force(step) - force(-step)) / (2 * step), exponent * 6e5 * area * area / 0.010, 1e-3);
}

TEST(AirSpring, StaysFiniteWhenItsVolumeIsGone) {
  const double full = air_spring_force(6e5, 1e5, 1.38, 0.010, 1e-5, 0.02);
  for (const double volume : {0.0, -1.0, 1e-300}) {
    EXPECT_EQ(air_spring_force(6e5, 1e5, 1.38, 0.010, volume, 0.02), full);
  }
  EXPECT_TRUE(std::isfinite(full));
}

TEST(Friction, OpposesTheMotionAndFallsFromStictionToCoulomb) {
  const auto force = [](double rate) { return friction_force(10.0, 15.0, 2.0, 0.01, 0.1, rate); };
  EXPECT_EQ(force(0), 0);
  // At the Stribeck velocity: 10 + 5/e, tanh(10) = 0.99999999587769276, viscous 0.2.
  EXPECT_NEAR(force(0.1), -((10 + 5 * 0.36787944117144233) * 0.99999999587769276 + 0.2), 1e-12);
  EXPECT_NEAR(force(5), -(10 + 10), 1e-12);
  for (const double rate : {1e-5, 0.003, 0.02, 0.2, 4.0, 1e200}) {
    EXPECT_LT(force(rate), 0);
    EXPECT_EQ(force(-rate), -force(rate));
  }
  EXPECT_LT(force(0.03), force(0.5)) << "more friction near stiction than beyond";
}

TEST(Friction, VelocitiesOfZeroAreHeldAboveZero) {
  EXPECT_EQ(friction_force(10.0, 15.0, 0.0, 0.0, 0.0, 0.0), 0);
  EXPECT_EQ(friction_force(10.0, 15.0, 0.0, 0.0, 0.0, 1.0), -10);
}

TEST(Scalar, SelectTakesTheSecondForNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(select(0.0, 1.0, 2.0), 1);
  EXPECT_EQ(select(-0.0, 1.0, 2.0), 1);
  EXPECT_EQ(select(-1e-300, 1.0, 2.0), 2);
  EXPECT_EQ(select(nan, 1.0, 2.0), 2);
  EXPECT_FALSE(std::signbit(abs(-0.0)));
  EXPECT_TRUE(std::isnan(abs(nan)));
}

}  // namespace
}  // namespace mbgen
