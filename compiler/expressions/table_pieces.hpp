#pragma once
// Tables of many points: their pieces are data that a search finds, where those of small ones are operations.

#include <bit>
#include <cmath>
#include <vector>

#include "compiler/expressions/sample.hpp"
#include "compiler/expressions/table.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// Points up to which a table is written as operations: more cost more than a search.
constexpr std::size_t kMostPointsAsOperations = 128;
/// Points up to which a table goes into a solver: its numbers are as many as those of the largest road.
constexpr std::size_t kMostPointsAsData = 300'000;

/// A piece of a table: y(at) = value + o (slope + o (square + o cube)) with o = at - start, and `integral`, of y from
/// the first point to `start`. T: without derivatives.
template <class T>
struct TablePiece {
  T start, value, slope, integral, square, cube;
};

/// Numbers of a piece among the samples: start, value, slope, integral, and of a curved table square and cube.
inline std::size_t numbers_of_piece(const Table& table) { return table.slopes.empty() ? 4 : 6; }

/// The pieces of a table, one after another: the one before the first point, between the points, and behind the last.
/// Requires: slopes are set, two points or more.
std::vector<double> pieces_of(const Table& table);

/// Distance of the points where each lies within a quarter of it of its place among equally spaced ones, 0 where one
/// does not.
double spacing_of(const Table& table);

/// The number that a scalar with derivatives has as its value.
template <class A>
auto base_of(const A& scalar) {
  if constexpr (
      requires { scalar.slope; } || requires { scalar.first; }) {
    return base_of(scalar.value);
  } else {
    return scalar;
  }
}

namespace detail {

/// Whole number of the piece that holds `at` of equally spaced points: guessed, then put right by one. start(i): of
/// piece i.
template <class T, class Start>
T piece_by_spacing(const Table& table, const T& at, const Start& start) {
  using mbgen::max, mbgen::min, mbgen::select;
  using std::floor;
  const T most(static_cast<double>(table.x.size() - 1));
  const T steps = T(1 / table.data->spacing) * (at - T(table.x.front()));
  const T guess = max(min(T(floor(steps) + T(1.0)), most), T(1.0)), next = guess + T(1.0);
  return select(T(at - start(next)), next, select(T(at - start(guess)), guess, T(guess - T(1.0))));
}

/// The same of any points, by halves: the first step leaves a power of two of pieces.
template <class T, class Start>
T piece_by_halves(const Table& table, const T& at, const Start& start) {
  using mbgen::select;
  const std::size_t count = table.x.size() + 1, power = std::bit_floor(count);
  T low(0.0);
  const auto probe = [&](std::size_t step) {
    const T there = low + T(static_cast<double>(step));
    low = select(T(at - start(there)), there, low);
  };
  if (count > power) probe(count - power);
  for (std::size_t step = power / 2; step > 0; step /= 2) probe(step);
  return low;
}

}  // namespace detail

/// The piece that holds an argument. at: argument_in of the argument. Requires: table.data. Cost: 20 operations where
/// the points are equally spaced, else six for each doubling of their number.
template <class T>
TablePiece<T> piece_at(const Table& table, const T& at) {
  const std::vector<double>& samples = *table.data->samples;
  const T numbers(static_cast<double>(numbers_of_piece(table)));
  const auto number = [&](const T& piece, int which) {
    return T(sample(samples, T(numbers * piece + T(static_cast<double>(table.data->first + which)))));
  };
  const auto start = [&](const T& piece) { return number(piece, 0); };
  const T found =
      table.data->spacing > 0 ? detail::piece_by_spacing(table, at, start) : detail::piece_by_halves(table, at, start);
  TablePiece<T> piece{start(found), number(found, 1), number(found, 2), number(found, 3), T(0.0), T(0.0)};
  if (!table.slopes.empty()) piece.square = number(found, 4), piece.cube = number(found, 5);
  return piece;
}

}  // namespace mbgen
