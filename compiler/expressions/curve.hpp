#pragma once
// Tables as functions of one argument, over any scalar: their value, its integral, and of smooth ones the
// derivatives.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "compiler/expressions/table.hpp"
#include "compiler/expressions/table_pieces.hpp"
#include "mbgen/math/table.hpp"

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

/// Rise of y over the whole periods before. at: argument_in of the argument.
template <class T>
T rise_before(const Table& table, const T& argument, const T& at) {
  if (!table.periodic || rise_of(table) == 0) return T(0.0);
  return rise_of(table) / width_of(table) * (argument - at);
}

/// y at the argument. Cost: linear in the number of points, or the cost of piece_at.
template <class A>
A value_along(const Table& table, const A& argument) {
  const int count = static_cast<int>(table.x.size());
  const A at = argument_in(table, argument);
  const auto of_piece = [&] {
    const auto piece = piece_at(table, base_of(at));
    const A offset = at - A(piece.start);
    if (table.slopes.empty()) return A(A(piece.value) + A(piece.slope) * offset);
    return A(A(piece.value) + offset * (A(piece.slope) + offset * (A(piece.square) + offset * A(piece.cube))));
  };
  const A value = table.data ? of_piece()
                  : table.slopes.empty()
                      ? interpolate_linear(table.x.data(), table.y.data(), count, at)
                      : interpolate_monotone_cubic(table.x.data(), table.y.data(), table.slopes.data(), count, at);
  return table.periodic ? value + rise_before(table, argument, at) : value;
}

/// y and its derivatives by x.
template <class T>
struct CurvePoint {
  T value, slope, curvature;
};

namespace detail {

/// The piece that holds an argument, without its integral, chosen by operations. Requires: a cubic or spline table.
template <class T>
TablePiece<T> chosen_piece(const Table& table, const T& at) {
  using mbgen::select;
  TablePiece<T> piece{T(table.x.front()), T(table.y.front()), T(table.slopes.front()), T(0.0), T(0.0), T(0.0)};
  const auto piece_from = [&](std::size_t i, double square, double cube) {
    const T beyond = at - table.x[i];
    piece.start = select(beyond, T(table.x[i]), piece.start);
    piece.value = select(beyond, T(table.y[i]), piece.value);
    piece.slope = select(beyond, T(table.slopes[i]), piece.slope);
    piece.square = select(beyond, T(square), piece.square);
    piece.cube = select(beyond, T(cube), piece.cube);
  };
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i) {
    const double width = table.x[i + 1] - table.x[i], secant = (table.y[i + 1] - table.y[i]) / width;
    const double left = table.slopes[i], right = table.slopes[i + 1];
    piece_from(i, (3 * secant - 2 * left - right) / width, (left + right - 2 * secant) / (width * width));
  }
  if (!table.periodic) piece_from(table.x.size() - 1, 0, 0);
  return piece;
}

}  // namespace detail

/// The same with derivatives, of a cubic or spline table: the argument chooses the coefficients of its piece. Cost: six
/// operations per point, or the cost of piece_at.
template <class T>
CurvePoint<T> curve_at(const Table& table, const T& argument) {
  const T at = argument_in(table, argument);
  const TablePiece<T> piece = table.data ? piece_at(table, at) : detail::chosen_piece(table, at);
  const auto& [start, value, slope, integral, second, third] = piece;
  const T offset = at - start;
  return {value + offset * (slope + offset * (second + offset * third)) + rise_before(table, argument, at),
          slope + offset * (T(2.0) * second + T(3.0) * (offset * third)), T(2.0) * second + T(6.0) * (offset * third)};
}

namespace detail {

/// Integral from the first point on, of a table of many points.
template <class A>
A integral_by_data(const Table& table, const A& at) {
  const auto piece = piece_at(table, base_of(at));
  const A offset = at - A(piece.start);
  A slopes(0.5 * piece.slope);
  if (!table.slopes.empty()) slopes = slopes + offset * (A(1.0 / 3 * piece.square) + offset * A(0.25 * piece.cube));
  return A(piece.integral) + offset * (A(piece.value) + offset * slopes);
}

/// Integral of a table over its argument from its first point on, `at` within or beyond its points.
template <class T>
T integral_within(const Table& table, const T& at) {
  using mbgen::select;
  if (table.data) return integral_by_data(table, at);
  const std::size_t last = table.x.size() - 1;
  const bool is_straight = table.slopes.empty();
  const auto width = [&](std::size_t i) { return table.x[i + 1] - table.x[i]; };
  const auto secant = [&](std::size_t i) { return (table.y[i + 1] - table.y[i]) / width(i); };
  const auto slope = [&](std::size_t i) { return is_straight ? secant(std::min(i, last - 1)) : table.slopes[i]; };
  double begin = 0;  // integral up to the point
  const auto piece_from = [&](std::size_t i, double square, double cube, const auto& offset) {
    using A = std::decay_t<decltype(offset)>;
    return A(A(begin) +
             offset * (A(table.y[i]) + offset * (A(slope(i) / 2) + offset * (A(square / 3) + offset * A(cube / 4)))));
  };
  T integral = piece_from(0, 0, 0, T(at - table.x[0]));
  for (std::size_t i = 0; i < last; ++i) {
    const double w = width(i), left = slope(i), right = slope(i + 1);
    const double square = is_straight ? 0 : (3 * secant(i) - 2 * left - right) / w;
    const double cube = is_straight ? 0 : (left + right - 2 * secant(i)) / (w * w);
    const T offset = at - table.x[i];
    integral = select(offset, piece_from(i, square, cube, offset), integral);
    begin = piece_from(i, square, cube, w);
  }
  const T beyond = at - table.x[last];
  return select(beyond, piece_from(last, 0, 0, beyond), integral);
}

}  // namespace detail

/// Integral of y over the argument, from zero; units of y times units of x. Cost: as in value_along.
template <class T>
T integral_along(const Table& table, const T& argument) {
  const auto from_start = [&](const auto& to) {
    using A = std::decay_t<decltype(to)>;
    const A at = argument_in(table, to);
    const A integral = detail::integral_within(table, at);
    if (!table.periodic) return integral;
    // Each period before it is higher than the one before that.
    const A periods = (to - at) / A(width_of(table)), higher = A(rise_of(table)) * periods;
    return A(integral + periods * A(detail::integral_within(table, table.x.back())) +
             higher * (at - A(table.x.front()) + A(width_of(table) / 2) * (periods - A(1.0))));
  };
  return from_start(argument) - T(from_start(0.0));
}

}  // namespace mbgen
