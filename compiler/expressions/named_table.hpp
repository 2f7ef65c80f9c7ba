#pragma once
// The value of a table that expressions name, over any scalar.

#include "compiler/expressions/curve.hpp"

namespace mbgen {

/// Coefficients of a map by its grid. z: row by row along x. slopes of a smooth map are those of monotone cubic tables
/// along every line of the grid; its mixed derivatives are the mean of the slopes of these along the other lines.
/// Requires: x and y strictly increasing, two or more each. Source: Hermite's bicubic patch.
std::vector<double> map_coefficients(const std::vector<double>& x, const std::vector<double>& y,
                                     const std::vector<double>& z, int degree);

/// Table of the number of lines before a place.
Table lines_before(const std::vector<double>& lines);

namespace detail {

/// The powers 0 to 3 of a place between 0 and 1, continued as straight lines.
template <class A>
std::vector<A> straightened_powers(const A& place, int degree) {
  if (degree == 1) return {A(1.0), place};
  using mbgen::max, mbgen::min;
  const A inside = min(max(place, A(0.0)), A(1.0)), beyond = place - inside;
  const A square = inside * inside;
  return {A(1.0), place, square + 2.0 * (inside * beyond), square * inside + 3.0 * (square * beyond)};
}

/// The cell of a place among `lines` lines, as a whole number.
template <class T>
T cell_of(const T& place, std::size_t lines) {
  using mbgen::max, mbgen::min;
  using std::floor;
  return max(min(T(floor(place)), T(static_cast<double>(lines - 2))), T(0.0));
}

}  // namespace detail

/// z at (x, y). Cost: two calls of value_along, and 4 or 16 samples.
template <class A>
A value_on(const CharacteristicMap& map, const A& x, const A& y) {
  const A along_x = value_along(map.along_x, x), along_y = value_along(map.along_y, y);
  const auto row = detail::cell_of(base_of(along_x), map.along_x.x.size());
  const auto column = detail::cell_of(base_of(along_y), map.along_y.x.size());
  using T = std::remove_const_t<decltype(row)>;
  const int count = map.degree + 1;
  const T cell = T(static_cast<double>(map.along_y.x.size() - 1)) * row + column;
  const T first = T(static_cast<double>(count * count)) * cell + T(static_cast<double>(map.first));
  const std::vector<A> powers_x = detail::straightened_powers<A>(along_x - A(row), map.degree);
  const std::vector<A> powers_y = detail::straightened_powers<A>(along_y - A(column), map.degree);
  A value(0.0);
  for (int i = 0; i < count; ++i) {
    A sum(0.0);
    for (int j = 0; j < count; ++j) {
      const T coefficient = sample(*map.samples, T(first + T(static_cast<double>(count * i + j))));
      sum = sum + A(coefficient) * powers_y[static_cast<std::size_t>(j)];
    }
    value = value + sum * powers_x[static_cast<std::size_t>(i)];
  }
  return value;
}

/// Value of a table; y counts for maps alone.
template <class A>
A value_of(const NamedTable& named, const A& x, const A& y) {
  using mbgen::max, mbgen::min;
  const auto within = [&](const Table& line, const A& argument) {
    return named.holds ? A(min(max(argument, A(line.x.front())), A(line.x.back()))) : argument;
  };
  if (const auto* curve = std::get_if<Table>(&named.table)) return value_along(*curve, within(*curve, x));
  const auto& map = std::get<CharacteristicMap>(named.table);
  return value_on(map, within(map.along_x, x), within(map.along_y, y));
}

}  // namespace mbgen
