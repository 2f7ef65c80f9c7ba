// Tables as functions: splines and monotone cubics against polynomials and a sine, with and without a period.

#include "compiler/expressions/curve.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace mbgen {
namespace {

Table table_of(Table::Interpolation interpolation, std::vector<double> x, std::vector<double> y, bool periodic) {
  Table table{interpolation, std::move(x), std::move(y), periodic, {}};
  table.slopes = slopes_of(table);
  return table;
}

constexpr auto kSpline = Table::Interpolation::spline;
constexpr auto kMonotone = Table::Interpolation::monotone_cubic;

// Two points are a line, three a parabola, four and more a cubic: whatever polynomial the points are of.
TEST(Spline, OfAPolynomialIsThePolynomial) {
  const std::vector<double> places = {-1, 0.5, 0.7, 2.5, 3};
  for (std::size_t count = 2; count <= places.size(); ++count) {
    const double square = count > 2 ? 0.7 : 0, cube = count > 3 ? -0.2 : 0;
    const auto f = [&](double x) { return 1 + x * (2 + x * (square + x * cube)); };
    const std::vector<double> x(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<double> y;
    for (const double at : x) y.push_back(f(at));
    const Table table = table_of(kSpline, x, y, false);
    for (double at = x.front(); at < x.back(); at += 0.1) {
      const CurvePoint<double> point = curve_at(table, at);
      EXPECT_NEAR(point.value, f(at), 1e-14) << count << " " << at;
      EXPECT_NEAR(point.slope, 2 + at * (2 * square + 3 * at * cube), 1e-13) << count << " " << at;
      EXPECT_NEAR(point.curvature, 2 * square + 6 * at * cube, 1e-12) << count << " " << at;
      EXPECT_NEAR(value_along(table, at), point.value, 1e-15) << count << " " << at;
      const auto integral = [&](double to) { return to * (1 + to * (1 + to * (square / 3 + to * cube / 4))); };
      EXPECT_NEAR(integral_along(table, at) - integral_along(table, x.front()), integral(at) - integral(x.front()),
                  1e-14);
    }
  }
}

TEST(Spline, GoesOnFromPeriodToPeriod) {
  const double period = 1.6, turn = 2 * std::numbers::pi / period, rise = 0.4;
  const auto f = [&](double x) { return 0.3 * std::sin(turn * x) + rise / period * x; };
  std::vector<double> x, y;
  for (int k = 0; k <= 40; ++k) {
    x.push_back(0.2 + period * (k + (k % 40 == 0 ? 0 : 0.2 * std::sin(5.0 * k))) / 40);
    y.push_back(f(x.back()));
  }
  const Table table = table_of(kSpline, x, y, true);
  EXPECT_EQ(table.slopes.front(), table.slopes.back());
  for (double at = -7; at < 9; at += 0.0377) {
    const CurvePoint<double> point = curve_at(table, at);
    EXPECT_NEAR(point.value, f(at), 2e-6) << at;
    EXPECT_NEAR(point.slope, 0.3 * turn * std::cos(turn * at) + rise / period, 2e-4) << at;
    EXPECT_NEAR(point.curvature, -0.3 * turn * turn * std::sin(turn * at), 0.04) << at;
    EXPECT_NEAR(value_along(table, at), point.value, 1e-14) << at;
    const double integral = 0.3 / turn * (1 - std::cos(turn * at)) + rise / period / 2 * at * at;
    EXPECT_NEAR(integral_along(table, at), integral, 3e-6) << at;
  }
  const CurvePoint<double> before = curve_at(table, 0.2 + 3 * period - 1e-9),
                           after = curve_at(table, 0.2 + 3 * period + 1e-9);
  EXPECT_NEAR(before.value, after.value, 1e-8);
  EXPECT_NEAR(before.slope, after.slope, 1e-7);
  EXPECT_NEAR(before.curvature, after.curvature, 1e-6);
}

// The turns of the data stay the turns of the curve, over the seam too; and a saw has its teeth.
TEST(PeriodicTable, KeepsTheShapeOfItsPoints) {
  const Table dwell = table_of(kMonotone, {0, 1, 2, 3, 4}, {0, 0, 1, 1, 0}, true);
  for (double at = -8; at < 12; at += 0.05) {
    const CurvePoint<double> point = curve_at(dwell, at);
    EXPECT_GE(point.value, -1e-14) << at;
    EXPECT_LE(point.value, 1 + 1e-14) << at;
    EXPECT_NEAR(value_along(dwell, at), point.value, 1e-15) << at;
  }
  const Table ramp = table_of(kMonotone, {0, 1, 3}, {0, 1, 3}, true);
  const Table saw = table_of(Table::Interpolation::linear, {0, 1, 3}, {0, 2, 0}, true);
  for (double at = -8; at < 12; at += 0.05) {
    EXPECT_NEAR(value_along(ramp, at), at, 1e-13);
    const double in = at - 3 * std::floor(at / 3);
    EXPECT_NEAR(value_along(saw, at), in < 1 ? 2 * in : 3 - in, 1e-13) << at;
    EXPECT_NEAR(integral_along(ramp, at), at * at / 2, 1e-12) << at;
    const double teeth = std::floor(at / 3), part = in < 1 ? in * in : 3 - (3 - in) * (3 - in) / 2;
    EXPECT_NEAR(integral_along(saw, at), 3 * teeth + part, 1e-12) << at;
  }
}

// Beyond its points a table goes straight on, and the integral with it; zero lies where it lies.
TEST(Integral, GoesOnBeyondThePoints) {
  const Table linear = table_of(Table::Interpolation::linear, {1, 2, 4}, {3, 5, 1}, false);
  // y = 1 + 2 x up to 2, then 9 - 2 x
  for (const double at : {-3.0, 0.0, 0.5, 1.7}) EXPECT_NEAR(integral_along(linear, at), at + at * at, 1e-14) << at;
  for (const double at : {2.0, 3.0, 4.0, 9.0})
    EXPECT_NEAR(integral_along(linear, at), 9 * at - at * at - 8, 1e-13) << at;
  const Table smooth = table_of(kMonotone, {-2, -1, 1, 3}, {-8, -1, 1, 27}, false);
  const double before = integral_along(smooth, -2.0), after = integral_along(smooth, 3.0);
  EXPECT_NEAR(integral_along(smooth, -5.0), before + 3 * 8 + 7 * 9 / 2.0, 1e-13);
  EXPECT_NEAR(integral_along(smooth, 5.0), after + 2 * 27 + 13 * 4 / 2.0, 1e-13);
}

}  // namespace
}  // namespace mbgen
