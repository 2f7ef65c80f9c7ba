#pragma once
// Tables as functions of one argument, over any scalar: their value, and of smooth ones the derivatives too.

#include <cmath>
#include <numbers>
#include <vector>

#include "compiler/model/elements.hpp"
#include "mbgen/table.hpp"

namespace mbgen {

/// Slopes of a cubic or spline table at its points, units of y over units of x; none of a linear one. A spline is
/// continuous to its second derivative; the third one is continuous next to the ends, or all three derivatives go on
/// from one period to the next.
/// Source: C. de Boor, A Practical Guide to Splines, 1978, chapter IV; monotone ones as monotone_slopes.
std::vector<double> slopes_of(const Table& table);

/// Length of the table, and what a period adds to y.
inline double width_of(const Table& table) { return table.x.back() - table.x.front(); }
inline double rise_of(const Table& table) { return table.y.back() - table.y.front(); }

/// Where the argument of a table lies in it: of a periodic one the place in the first period. By an angle, since a
/// scalar of expressions has no whole part.
template <class T>
T argument_in(const Table& table, const T& argument) {
  using std::atan2, std::cos, std::sin;
  if (!table.periodic) return argument;
  const double turn = 2 * std::numbers::pi / width_of(table);
  const T angle = turn * (argument - table.x.front());
  return T(table.x.front()) + (1 / turn) * (T(std::numbers::pi) + atan2(-sin(angle), -cos(angle)));
}

/// What whole periods before it add to y. at: argument_in of the argument.
template <class T>
T rise_before(const Table& table, const T& argument, const T& at) {
  if (!table.periodic || rise_of(table) == 0) return T(0.0);
  return rise_of(table) / width_of(table) * (argument - at);
}

/// y at the argument. Cost: linear in the number of points.
template <class T>
T value_along(const Table& table, const T& argument) {
  const int count = static_cast<int>(table.x.size());
  const T at = argument_in(table, argument);
  const T value = table.slopes.empty()
                      ? interpolate_linear(table.x.data(), table.y.data(), count, at)
                      : interpolate_monotone_cubic(table.x.data(), table.y.data(), table.slopes.data(), count, at);
  return table.periodic ? value + rise_before(table, argument, at) : value;
}

/// y and its derivatives by x.
template <class T>
struct CurvePoint {
  T value, slope, curvature;
};

/// The same with derivatives, of a cubic or spline table: the argument chooses the coefficients of its piece. Cost:
/// six operations per point.
template <class T>
CurvePoint<T> curve_at(const Table& table, const T& argument) {
  using mbgen::select;
  const T at = argument_in(table, argument);
  T start(table.x.front()), value(table.y.front()), slope(table.slopes.front()), second(0.0), third(0.0);
  const auto piece_from = [&](std::size_t i, double square, double cube) {
    const T beyond = at - table.x[i];
    start = select(beyond, T(table.x[i]), start);
    value = select(beyond, T(table.y[i]), value);
    slope = select(beyond, T(table.slopes[i]), slope);
    second = select(beyond, T(square), second);
    third = select(beyond, T(cube), third);
  };
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i) {
    const double width = table.x[i + 1] - table.x[i], secant = (table.y[i + 1] - table.y[i]) / width;
    const double left = table.slopes[i], right = table.slopes[i + 1];
    piece_from(i, (3 * secant - 2 * left - right) / width, (left + right - 2 * secant) / (width * width));
  }
  if (!table.periodic) piece_from(table.x.size() - 1, 0, 0);
  const T offset = at - start;
  return {value + offset * (slope + offset * (second + offset * third)) + rise_before(table, argument, at),
          slope + offset * (T(2.0) * second + T(3.0) * (offset * third)), T(2.0) * second + T(6.0) * (offset * third)};
}

}  // namespace mbgen
