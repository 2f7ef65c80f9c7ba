#pragma once
// Symmetric equations of free directions by elimination from the last one to the first, without fill-in: the forms of
// the equations of motion share it.

#include <cstddef>
#include <vector>

#include "compiler/formulation/annotator.hpp"

namespace mbgen {

/// Of a matrix after elimination, per row.
template <class T>
struct EliminatedPivots {
  std::vector<T> reciprocal;  ///< of the pivot
  std::vector<T> inertia;     ///< not positive where motion has no inertia: pivot less what rounding leaves of one
};

/// Share of a diagonal that elimination may lose to rounding.
constexpr double kLostByElimination = 1e-12;

/// Eliminates in place; afterwards `mass` holds the rows for substitution. mass: lower triangle, [row][column <= row].
/// rounding: of diagonals, see inertia_left_by_rounding; `lost` of a diagonal is left by elimination. subtract(a,
/// factor, q): subtracts `factor` times the right-hand side of row q from row a.
template <class T, class Subtract>
EliminatedPivots<T> eliminate(std::vector<std::vector<T>>& mass, const T& rounding, const Subtract& subtract,
                              const T& lost = T(kLostByElimination)) {
  const std::size_t n = mass.size();
  EliminatedPivots<T> pivots{std::vector<T>(n, T(0.0)), std::vector<T>(n, T(0.0))};
  std::vector<T> diagonal;
  for (std::size_t q = 0; q < n; ++q) diagonal.push_back(mass[q][q]);
  for (std::size_t q = n; q-- > 0;) {
    const T rest = q + 1 == n ? mass[q][q] : mass[q][q] - lost * diagonal[q];
    pivots.inertia[q] = rest - rounding;
    pivots.reciprocal[q] = T(1.0) / mass[q][q];
    for (std::size_t a = 0; a < q; ++a) {
      if (is_zero(mass[q][a])) continue;
      const T factor = mass[q][a] * pivots.reciprocal[q];
      for (std::size_t b = 0; b <= a; ++b)
        if (!is_zero(mass[q][b])) mass[a][b] = mass[a][b] - factor * mass[q][b];
      subtract(a, factor, q);
    }
  }
  return pivots;
}

/// Solution of eliminated equations. right_hand_side(q): of row q, after elimination.
template <class T, class RightHandSide>
std::vector<T> substitute(const std::vector<std::vector<T>>& mass, const std::vector<T>& reciprocal,
                          const RightHandSide& right_hand_side) {
  std::vector<T> solution;
  for (std::size_t q = 0; q < mass.size(); ++q) {
    T value = right_hand_side(q);
    for (std::size_t a = 0; a < q; ++a)
      if (!is_zero(mass[q][a])) value = value - mass[q][a] * solution[a];
    solution.push_back(value * reciprocal[q]);
  }
  return solution;
}

}  // namespace mbgen
