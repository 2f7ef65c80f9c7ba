// Tables that expressions name: maps against the polynomials of their points and against tables along the lines of
// their grids; both with derivatives by time.

#include "compiler/expressions/named_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/jet.hpp"

namespace mbgen {
namespace {

const std::vector<double> kX = {-1, -0.2, 0.5, 2}, kY = {0, 0.3, 1.1, 1.4, 3};

template <class F>
NamedTable map_over(const F& f, int degree, bool holds = false) {
  std::vector<double> z;
  for (const double x : kX)
    for (const double y : kY) z.push_back(f(x, y));
  CharacteristicMap map{lines_before(kX), lines_before(kY), degree, nullptr, 3};
  std::vector<double> samples = {9, 9, 9};  // of others
  const std::vector<double> coefficients = map_coefficients(kX, kY, z, degree);
  samples.insert(samples.end(), coefficients.begin(), coefficients.end());
  map.samples = std::make_shared<const std::vector<double>>(samples);
  return {std::move(map), holds};
}

double bilinear(double x, double y) { return 1 + 2 * x - 3 * y + 0.5 * x * y; }
double wavy(double x, double y) { return std::sin(2 * x) * (1 + y * y) - x * y * y; }

TEST(NamedTable, LinearMapOfABilinearFunctionIsTheFunctionEverywhere) {
  const NamedTable map = map_over(bilinear, 1);
  for (double x = -2; x < 3; x += 0.17)
    for (double y = -1; y < 4; y += 0.19) EXPECT_NEAR(value_of(map, x, y), bilinear(x, y), 1e-14) << x << " " << y;
}

TEST(NamedTable, SmoothMapIsATableAlongEveryLineOfItsGridAndBeyond) {
  const NamedTable map = map_over(wavy, 3);
  const auto expect_line = [&](const std::vector<double>& places, const auto& values, const auto& on_map) {
    Table line{Table::Interpolation::monotone_cubic, places, {}};
    for (const double at : places) line.y.push_back(values(at));
    line.slopes = slopes_of(line);
    for (double at = places.front() - 1; at < places.back() + 1; at += 0.07)
      EXPECT_NEAR(on_map(at), value_along(line, at), 1e-13) << at;
  };
  for (const double y : kY)
    expect_line(
        kX, [&](double x) { return wavy(x, y); }, [&](double x) { return value_of(map, x, y); });
  for (const double x : kX)
    expect_line(
        kY, [&](double y) { return wavy(x, y); }, [&](double y) { return value_of(map, x, y); });
}

TEST(NamedTable, SmoothMapHasOneSlopeOnBothSidesOfEveryLine) {
  const NamedTable map = map_over(wavy, 3);
  const double h = 1e-6;
  for (const double x : kX) {
    for (double y = -0.5; y < 3.5; y += 0.23) {
      const double before = value_of(map, x, y) - value_of(map, x - h, y);
      const double behind = value_of(map, x + h, y) - value_of(map, x, y);
      EXPECT_NEAR(before / h, behind / h, 1e-4) << x << " " << y;
    }
  }
  for (const double y : kY) {
    for (double x = -1.5; x < 2.5; x += 0.23) {
      const double before = value_of(map, x, y) - value_of(map, x, y - h);
      const double behind = value_of(map, x, y + h) - value_of(map, x, y);
      EXPECT_NEAR(before / h, behind / h, 1e-4) << x << " " << y;
    }
  }
}

TEST(NamedTable, MapThatHoldsKeepsTheValueOfItsEdge) {
  for (const int degree : {1, 3}) {
    const NamedTable straight = map_over(wavy, degree), held = map_over(wavy, degree, true);
    for (double x = -2; x < 3; x += 0.31)
      for (double y = -1; y < 4; y += 0.29)
        EXPECT_NEAR(value_of(held, x, y),
                    value_of(straight, std::clamp(x, kX.front(), kX.back()), std::clamp(y, kY.front(), kY.back())),
                    1e-14);
  }
  const NamedTable held{Table{Table::Interpolation::linear, {0, 1}, {2, 5}}, true};
  EXPECT_EQ(value_of(held, -7.0, 0.0), 2);
  EXPECT_EQ(value_of(held, 0.5, 0.0), 3.5);
  EXPECT_EQ(value_of(held, 7.0, 0.0), 5);
}

// x(t) = 0.3 + 0.2 t and y(t) = 1.2 + 0.1 t^2 stay in one cell for t from 0 to 0.9.
TEST(NamedTable, DerivativesByTimeAreThoseOfTheMotion) {
  for (const int degree : {1, 3}) {
    const NamedTable map = map_over(wavy, degree);
    const auto at = [&](double t) { return value_of(map, 0.3 + 0.2 * t, 1.2 + 0.1 * t * t); };
    for (double t = 0.1; t < 0.8; t += 0.1) {
      const double h = 1e-4;
      const Jet<double> x{0.3 + 0.2 * t, 0.2, 0}, y{1.2 + 0.1 * t * t, 0.2 * t, 0.2};
      const Jet<double> value = value_of(map, x, y);
      EXPECT_NEAR(value.value, at(t), 1e-14);
      EXPECT_NEAR(value.first, (at(t + h) - at(t - h)) / (2 * h), 1e-7) << degree << " " << t;
      EXPECT_NEAR(value.second, (at(t + h) - 2 * at(t) + at(t - h)) / (h * h), 1e-5) << degree << " " << t;
    }
  }
}

}  // namespace
}  // namespace mbgen
