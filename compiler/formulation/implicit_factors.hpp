#pragma once
// A matrix that is eliminated from the last row to the first, without touching what is zero at every state.

#include <cmath>
#include <cstddef>
#include <vector>

#include "compiler/formulation/slope.hpp"

namespace mbgen {

/// Factors of a matrix; matrices are [row][column].
template <class T>
struct ImplicitFactors {
  std::vector<std::vector<T>> lower, factor;  ///< after elimination from the last row to the first
  std::vector<T> reciprocal;                  ///< of the pivots
};

/// With the pivots, less what rounding leaves of one.
template <class T>
struct WatchedFactors {
  ImplicitFactors<T> factors;
  std::vector<T> pivot;
};

/// Factors of a matrix. is_symmetric: it is, and only a half is worked on.
template <class T>
WatchedFactors<T> implicit_factors(std::vector<std::vector<T>> matrix, bool is_symmetric) {
  constexpr double kRounding = 1e-12;
  const std::size_t n = matrix.size();
  WatchedFactors<T> watched;
  ImplicitFactors<T>& f = watched.factors;
  f.lower = f.factor = std::vector<std::vector<T>>(n, std::vector<T>(n, T(0.0)));
  f.reciprocal = watched.pivot = std::vector<T>(n, T(0.0));
  std::vector<T> diagonal;
  using std::abs;
  for (std::size_t q = 0; q < n; ++q) diagonal.push_back(matrix[q][q]);
  for (std::size_t q = n; q-- > 0;) {
    watched.pivot[q] = q + 1 == n ? matrix[q][q] : matrix[q][q] - T(kRounding) * T(abs(diagonal[q]));
    f.reciprocal[q] = T(1.0) / matrix[q][q];
    for (std::size_t b = 0; b < q; ++b) f.lower[q][b] = matrix[q][b];
    for (std::size_t a = 0; a < q; ++a) {
      const T& entry = is_symmetric ? matrix[q][a] : matrix[a][q];
      if (is_zero(entry)) continue;
      const T factor = f.factor[a][q] = entry * f.reciprocal[q];
      for (std::size_t b = 0; b < (is_symmetric ? a + 1 : q); ++b)
        if (!is_zero(matrix[q][b])) matrix[a][b] = matrix[a][b] - factor * matrix[q][b];
    }
  }
  return watched;
}

/// Solves in place.
template <class T>
void solve(const ImplicitFactors<T>& f, std::vector<T>& right) {
  const std::size_t n = right.size();
  for (std::size_t q = n; q-- > 0;)
    for (std::size_t a = 0; a < q; ++a)
      if (!is_zero(f.factor[a][q]) && !is_zero(right[q])) right[a] = right[a] - f.factor[a][q] * right[q];
  for (std::size_t q = 0; q < n; ++q) {
    for (std::size_t b = 0; b < q; ++b)
      if (!is_zero(f.lower[q][b]) && !is_zero(right[b])) right[q] = right[q] - f.lower[q][b] * right[b];
    right[q] = Slope<T>::times(right[q], f.reciprocal[q]);
  }
}

}  // namespace mbgen
