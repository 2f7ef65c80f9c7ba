#pragma once
// A matrix that is eliminated from the last row to the first, without its structural zeros, and only once for the two
// entries of a symmetric pair.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "compiler/formulation/elements/slope.hpp"

namespace mbgen {

/// A square matrix. mirrored: [row][column < row], whether both entries of the pair are one value.
template <class T>
struct MirroredMatrix {
  std::vector<std::vector<T>> entry;
  std::vector<std::vector<bool>> mirrored;

  explicit MirroredMatrix(std::size_t size)
      : entry(size, std::vector<T>(size, T(0.0))), mirrored(size, std::vector<bool>(size, false)) {}
  std::size_t size() const { return entry.size(); }
  void set_pair(std::size_t a, std::size_t b, const T& value) {
    entry[a][b] = entry[b][a] = value;
    mirrored[std::max(a, b)][std::min(a, b)] = true;
  }
};

/// Factors of a matrix after elimination from the last row to the first; matrices are [row][column].
template <class T>
struct ImplicitFactors {
  std::vector<std::vector<T>> factor, lower;  ///< columns above and rows left of the pivots, over them
  std::vector<T> reciprocal;                  ///< of the pivots
};

/// With the pivots, less what rounding leaves of one.
template <class T>
struct WatchedFactors {
  ImplicitFactors<T> factors;
  std::vector<T> pivot;
};

namespace detail {

/// Takes off a pair of entries of a matrix what the elimination of row q leaves there. a >= b.
template <class T>
void eliminate_pair(const ImplicitFactors<T>& f, std::size_t q, std::size_t a, std::size_t b, MirroredMatrix<T>& m) {
  const bool changes_lower = !is_zero(f.factor[a][q]) && !is_zero(m.entry[q][b]);
  const bool changes_upper = a != b && !is_zero(f.factor[b][q]) && !is_zero(m.entry[q][a]);
  if (!changes_lower && !changes_upper) return;
  if (changes_lower) m.entry[a][b] = m.entry[a][b] - f.factor[a][q] * m.entry[q][b];
  if (a == b) return;
  if (m.mirrored[a][b] && m.mirrored[q][a] && m.mirrored[q][b]) {
    m.entry[b][a] = m.entry[a][b];
    return;
  }
  m.mirrored[a][b] = false;
  if (changes_upper) m.entry[b][a] = m.entry[b][a] - f.factor[b][q] * m.entry[q][a];
}

}  // namespace detail

template <class T>
WatchedFactors<T> implicit_factors(MirroredMatrix<T> matrix) {
  constexpr double kRounding = 1e-12;
  const std::size_t n = matrix.size();
  WatchedFactors<T> watched;
  ImplicitFactors<T>& f = watched.factors;
  f.lower = f.factor = std::vector<std::vector<T>>(n, std::vector<T>(n, T(0.0)));
  f.reciprocal = watched.pivot = std::vector<T>(n, T(0.0));
  std::vector<T> diagonal;
  using std::abs;
  for (std::size_t q = 0; q < n; ++q) diagonal.push_back(matrix.entry[q][q]);
  for (std::size_t q = n; q-- > 0;) {
    const T& pivot = matrix.entry[q][q];
    watched.pivot[q] = q + 1 == n ? pivot : pivot - T(kRounding) * T(abs(diagonal[q]));
    f.reciprocal[q] = T(1.0) / pivot;
    for (std::size_t b = 0; b < q; ++b) {
      f.factor[b][q] = Slope<T>::times(matrix.entry[b][q], f.reciprocal[q]);
      f.lower[q][b] = matrix.mirrored[q][b] ? f.factor[b][q] : Slope<T>::times(matrix.entry[q][b], f.reciprocal[q]);
    }
    for (std::size_t a = 0; a < q; ++a)
      for (std::size_t b = 0; b <= a; ++b) detail::eliminate_pair(f, q, a, b, matrix);
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
    right[q] = Slope<T>::times(right[q], f.reciprocal[q]);
    for (std::size_t b = 0; b < q; ++b)
      if (!is_zero(f.lower[q][b]) && !is_zero(right[b])) right[q] = right[q] - f.lower[q][b] * right[b];
  }
}

}  // namespace mbgen
