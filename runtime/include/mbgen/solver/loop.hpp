#pragma once
// Loop closures at run time: LU with full pivoting of one block's Jacobian, and the systems solved with it.

#include <cstddef>
#include <limits>

#include "mbgen/number.hpp"

namespace mbgen {

/// Factors of one block Jacobian (equations x coordinates, row by row) with full pivoting, in the caller's memory.
/// Rows and columns are permuted so that the leading rank x rank part is the dependent Jacobian. Real: double or float.
template <class Real>
struct LoopFactorsOf {
  int equations = 0;
  int coordinates = 0;
  int rank = 0;             ///< number of pivots taken
  int filled = 0;           ///< rows with an entry that is not zero: the others come last, as those out of a plane do
  Real* matrix = nullptr;   ///< equations x coordinates; after factorisation, in permuted order: L (unit diagonal)
                            ///< below, U on and above the diagonal of the pivots, what elimination left beyond
  int* rows = nullptr;      ///< rows[k]: equation in place k
  int* columns = nullptr;   ///< columns[k]: coordinate in place k; the first `rank` are dependent
  Real smallest_ratio = 0;  ///< smallest accepted |pivot| over the largest pivot; 0 without pivots
  Real* largest =
      nullptr;  ///< per row, memory for its largest entry and the place of that: then a pivot is searched only
  int* largest_at = nullptr;  ///< in rows that elimination changed. Null: in all of them; the pivots are the same
  int* places = nullptr;  ///< per column, memory to eliminate few entries alone where they are few; the same factors
};

using LoopFactors = LoopFactorsOf<double>;

/// Rows that get pivots last: equations of velocities alone. If rows are redundant, position equations then keep their
/// pivots; only these can be closed.
struct LatePivots {
  const unsigned char* late = nullptr;  ///< per equation; null: no row is late
  int early_rank = 0;                   ///< pivots of the other rows
};

namespace loop_detail {

template <class Real>
inline Real* row_of(const LoopFactorsOf<Real>& loop, int row) noexcept {
  return loop.matrix + std::ptrdiff_t{row} * loop.coordinates;
}

template <class T>
void swap(T& a, T& b) noexcept {
  const T kept = a;
  a = b;
  b = kept;
}

inline bool is_driven(const unsigned char* driven, int coordinate) noexcept {
  return driven != nullptr && driven[coordinate] != 0;
}

/// A candidate for the next pivot; size 0 when there is none.
template <class Real>
struct Pivot {
  int row = 0, column = 0;
  Real size = 0;
};

/// Keeps the first of the largest entries of a row from column `first` on, driven columns left out.
template <class Real>
inline void search_row(const LoopFactorsOf<Real>& loop, int i, int first, const unsigned char* driven) noexcept {
  const Real* row = row_of(loop, i);
  Real largest = 0;
  int at = -1;
  for (int j = first; j < loop.coordinates; ++j) {
    const Real size = magnitude(row[j]);
    if (size > largest && !is_driven(driven, loop.columns[j])) largest = size, at = j;
  }
  loop.largest[i] = largest;
  loop.largest_at[i] = at;
}

/// Moves rows of zeros behind the others, which keep their order, and keeps the largest entries of these. Result: false
/// for a matrix that is not finite.
template <class Real>
inline bool move_empty_rows(LoopFactorsOf<Real>& loop, const unsigned char* driven) noexcept {
  loop.filled = 0;
  Real zero = 0;  // not a number once an entry is not finite
  for (int i = 0; i < loop.equations; ++i) {
    Real* const row = row_of(loop, i);
    int first = 0;
    while (first < loop.coordinates && row[first] == 0) ++first;
    if (first == loop.coordinates) continue;
    for (int j = first; j < loop.coordinates; ++j) zero += row[j] * 0;
    Real* const to = row_of(loop, loop.filled);
    for (int j = 0; to != row && j < loop.coordinates; ++j) to[j] = row[j], row[j] = 0;
    swap(loop.rows[i], loop.rows[loop.filled]);
    if (loop.largest != nullptr) search_row(loop, loop.filled, first, driven);
    ++loop.filled;
  }
  return zero == 0;
}

/// Whether an equation waits for its pivot while place k is filled, or has none left by then.
inline bool is_passed_over(const LatePivots& order, int equation, int k) noexcept {
  return order.late != nullptr && (order.late[equation] != 0) != (k >= order.early_rank);
}

/// Largest entry among the rows and columns from place `first` on, driven columns left out.
template <class Real>
inline Pivot<Real> find_pivot(const LoopFactorsOf<Real>& loop, int first, const unsigned char* driven,
                              const LatePivots& order) noexcept {
  Pivot<Real> pivot;
  for (int i = first; i < loop.filled; ++i) {
    if (is_passed_over(order, loop.rows[i], first)) continue;
    if (loop.largest != nullptr) {
      if (loop.largest[i] > pivot.size) pivot = {i, loop.largest_at[i], loop.largest[i]};
      continue;
    }
    const Real* row = row_of(loop, i);
    for (int j = first; j < loop.coordinates; ++j) {
      const Real size = magnitude(row[j]);
      if (size > pivot.size && !is_driven(driven, loop.columns[j])) pivot = {i, j, size};
    }
  }
  return pivot;
}

/// Brings the pivot to place k of the diagonal.
template <class Real>
inline void move_pivot(LoopFactorsOf<Real>& loop, int k, const Pivot<Real>& pivot) noexcept {
  if (pivot.row != k) {
    for (int j = 0; j < loop.coordinates; ++j) swap(row_of(loop, k)[j], row_of(loop, pivot.row)[j]);
    swap(loop.rows[k], loop.rows[pivot.row]);
    if (loop.largest != nullptr) {
      swap(loop.largest[k], loop.largest[pivot.row]);
      swap(loop.largest_at[k], loop.largest_at[pivot.row]);
    }
  }
  if (pivot.column != k) {
    for (int i = 0; i < loop.filled; ++i) swap(row_of(loop, i)[k], row_of(loop, i)[pivot.column]);
    swap(loop.columns[k], loop.columns[pivot.column]);
  }
}

/// Places of the entries of row k behind the diagonal that are not zero, in loop.places. Result: how many; -1 where
/// they are no small part, or the row is short (8), and whole rows are as fast.
template <class Real>
inline int few_entries(const LoopFactorsOf<Real>& loop, int k) noexcept {
  if (loop.places == nullptr || loop.coordinates - k <= 8) return -1;
  int count = 0;
  for (int j = k + 1; j < loop.coordinates; ++j) {
    loop.places[count] = j;
    count += row_of(loop, k)[j] != 0 ? 1 : 0;
  }
  return 3 * count <= loop.coordinates - k ? count : -1;
}

/// Keeps the largest entry of row i where entries in `count` places changed, and no other.
template <class Real>
inline void search_changed(const LoopFactorsOf<Real>& loop, int i, int k, int count,
                           const unsigned char* driven) noexcept {
  const Real* const row = row_of(loop, i);
  for (int n = 0; n < count; ++n) {
    if (loop.places[n] == loop.largest_at[i]) return search_row(loop, i, k + 1, driven);
  }
  for (int n = 0; n < count; ++n) {
    const int j = loop.places[n];
    const Real size = magnitude(row[j]);
    const bool is_first = size > loop.largest[i] || (size == loop.largest[i] && j < loop.largest_at[i]);
    if (is_first && !is_driven(driven, loop.columns[j])) loop.largest[i] = size, loop.largest_at[i] = j;
  }
}

/// Eliminates column k below the diagonal and keeps the factors in its place. moved: the place that its pivot came
/// from.
template <class Real>
inline void eliminate(LoopFactorsOf<Real>& loop, int k, int moved, const unsigned char* driven) noexcept {
  const Real* const pivot_row = row_of(loop, k);
  const int few = few_entries(loop, k);
  for (int i = k + 1; i < loop.filled; ++i) {
    Real* const row = row_of(loop, i);
    // Of equal entries the first one counts: columns that changed places may have changed that.
    const bool is_changed = loop.largest != nullptr && (loop.largest_at[i] == k || loop.largest_at[i] == moved);
    if (row[k] == 0) {
      if (is_changed) search_row(loop, i, k + 1, driven);
      continue;
    }
    const Real factor = row[k] / pivot_row[k];
    row[k] = factor;
    for (int j = k + 1; few < 0 && j < loop.coordinates; ++j) row[j] -= factor * pivot_row[j];
    for (int n = 0; n < few; ++n) row[loop.places[n]] -= factor * pivot_row[loop.places[n]];
    if (loop.largest == nullptr) continue;
    is_changed || few < 0 ? search_row(loop, i, k + 1, driven) : search_changed(loop, i, k, few, driven);
  }
}

}  // namespace loop_detail

/// Factorises in place with full pivoting. Columns with driven[c] != 0 are never dependent; `driven` may be null.
/// Stops at `rank_limit` pivots, or when the next pivot is below tolerance times the first.
/// Requires: matrix filled, rows and columns point to arrays of their sizes. Cost: equations * coordinates * rank.
/// A matrix with an entry that is not finite has rank 0. order: which rows get pivots last.
template <class Real>
inline void factorise(LoopFactorsOf<Real>& loop, int rank_limit, const unsigned char* driven, Real tolerance,
                      const LatePivots& order = {}) noexcept {
  for (int i = 0; i < loop.equations; ++i) loop.rows[i] = i;
  for (int j = 0; j < loop.coordinates; ++j) loop.columns[j] = j;
  loop.rank = 0;
  loop.smallest_ratio = 0;
  if (!loop_detail::move_empty_rows(loop, driven)) return;
  Real first = 0, smallest = 0, largest = 0;
  while (loop.rank < rank_limit) {
    const int k = loop.rank;
    const loop_detail::Pivot<Real> pivot = loop_detail::find_pivot(loop, k, driven, order);
    if (k == 0) first = smallest = pivot.size;
    if (!(pivot.size > 0) || pivot.size < tolerance * first) break;
    smallest = pivot.size < smallest ? pivot.size : smallest;
    largest = pivot.size > largest ? pivot.size : largest;
    loop_detail::move_pivot(loop, k, pivot);
    loop_detail::eliminate(loop, k, pivot.column, driven);
    ++loop.rank;
  }
  if (loop.rank > 0) loop.smallest_ratio = smallest / largest;
}

/// Smallest pivot taken, in the units of the matrix; infinite without pivots.
template <class Real>
inline Real smallest_pivot(const LoopFactorsOf<Real>& loop) noexcept {
  Real smallest = std::numeric_limits<Real>::infinity();
  for (int k = 0; k < loop.rank; ++k) {
    const Real size = magnitude(loop_detail::row_of(loop, k)[k]);
    smallest = size < smallest ? size : smallest;
  }
  return smallest;
}

/// Solves Phi_d x_d = right_hand_side - Phi_i x_i for the dependent entries of x, the others of x given.
/// right_hand_side: per equation (original order); x: per coordinate (original order); work: equations numbers.
/// Result: largest residual over the equations that were not used as pivots (redundant ones).
/// Source: (60)-(62).
template <class Real>
inline Real solve_dependent(const LoopFactorsOf<Real>& loop, const Real* right_hand_side, Real* x,
                            Real* work) noexcept {
  for (int i = 0; i < loop.equations; ++i) {
    const Real* row = loop_detail::row_of(loop, i);
    work[i] = right_hand_side[loop.rows[i]];
    for (int j = 0; i < loop.filled && j < i && j < loop.rank; ++j) work[i] -= row[j] * work[j];
  }
  for (int k = loop.rank - 1; k >= 0; --k) {
    const Real* row = loop_detail::row_of(loop, k);
    Real value = work[k];
    for (int j = k + 1; j < loop.coordinates; ++j) value -= row[j] * x[loop.columns[j]];
    x[loop.columns[k]] = value / row[k];
  }
  Real largest = 0;
  for (int i = loop.rank; i < loop.equations; ++i) {
    const Real* row = loop_detail::row_of(loop, i);
    Real residual = work[i];
    for (int j = loop.rank; j < loop.coordinates; ++j) residual -= row[j] * x[loop.columns[j]];
    if (is_nan(residual)) return residual;
    largest = magnitude(residual) > largest ? magnitude(residual) : largest;
  }
  return largest;
}

/// Solves Phi_d' lambda = force_d: multipliers, zero at equations without a pivot. On return `force` is reduced by Phi'
/// lambda: zero at dependent coordinates. force: per coordinate (original order); lambda: per equation (original
/// order); work: equations numbers. Source: theory.md section 4.
template <class Real>
inline void solve_transposed(const LoopFactorsOf<Real>& loop, Real* force, Real* lambda, Real* work) noexcept {
  for (int k = 0; k < loop.rank; ++k) {
    Real value = force[loop.columns[k]];
    for (int m = 0; m < k; ++m) value -= loop_detail::row_of(loop, m)[k] * work[m];
    work[k] = value / loop_detail::row_of(loop, k)[k];
  }
  for (int k = 0; k < loop.rank; ++k) force[loop.columns[k]] = 0;
  for (int place = loop.rank; place < loop.coordinates; ++place) {
    for (int k = 0; k < loop.rank; ++k) force[loop.columns[place]] -= loop_detail::row_of(loop, k)[place] * work[k];
  }
  for (int i = loop.equations - 1; i >= 0; --i) {
    Real value = i < loop.rank ? work[i] : Real(0);
    for (int m = i + 1; m < loop.rank; ++m) value -= loop_detail::row_of(loop, m)[i] * lambda[loop.rows[m]];
    lambda[loop.rows[i]] = value;
  }
}

/// Rz of the block, coordinates x f row by row, f = free directions = coordinates - rank - driven: zd = Rz zd_free.
/// Free direction q belongs to the q-th non-dependent, non-driven coordinate in ascending original order.
/// work: equations numbers. Source: (61).
template <class Real>
inline void free_directions(const LoopFactorsOf<Real>& loop, const unsigned char* driven, Real* rz,
                            Real* work) noexcept {
  int count = 0;
  for (int place = loop.rank; place < loop.coordinates; ++place) {
    count += loop_detail::is_driven(driven, loop.columns[place]) ? 0 : 1;
  }
  for (int i = 0; i < loop.coordinates * count; ++i) rz[i] = 0;
  for (int place = loop.rank; place < loop.coordinates; ++place) {
    const int coordinate = loop.columns[place];
    if (loop_detail::is_driven(driven, coordinate)) continue;
    int q = 0;
    for (int other = loop.rank; other < loop.coordinates; ++other) {
      const int candidate = loop.columns[other];
      q += candidate < coordinate && !loop_detail::is_driven(driven, candidate) ? 1 : 0;
    }
    rz[coordinate * count + q] = 1;
    for (int k = loop.rank - 1; k >= 0; --k) {
      const Real* row = loop_detail::row_of(loop, k);
      Real value = -row[place];
      for (int j = k + 1; j < loop.rank; ++j) value -= row[j] * work[j];
      work[k] = value / row[k];
      rz[loop.columns[k] * count + q] = work[k];
    }
  }
}

namespace loop_detail {

/// -1 for an odd permutation of the places 0 to count - 1, else 1.
inline int parity(const int* places, int count) noexcept {
  int sign = 1;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) sign = places[j] < places[i] ? -sign : sign;
  }
  return sign;
}

}  // namespace loop_detail

/// Sign of the determinant of a square matrix of `rank` rows, whose memory is overwritten; 0 where it has lost its
/// rank.
template <class Real>
int sign_of_determinant(int rank, Real* matrix, int* rows, int* columns) noexcept {
  LoopFactorsOf<Real> square;
  square.equations = square.coordinates = rank;
  square.matrix = matrix;
  square.rows = rows;
  square.columns = columns;
  factorise(square, rank, nullptr, Real(0));
  if (square.rank != rank) return 0;
  int sign = loop_detail::parity(rows, rank) * loop_detail::parity(columns, rank);
  for (int k = 0; k < rank; ++k) sign = loop_detail::row_of(square, k)[k] < 0 ? -sign : sign;
  return sign;
}

/// Memory to compare the Jacobians of a block at two states: rank^2 numbers, and rank numbers twice.
template <class Real>
struct SideWork {
  Real* product;
  int *rows, *columns;
};

/// Whether det(J(to) J(from)') of the equations with pivots is negative: a motion that takes its free directions along
/// keeps the sign as long as the block keeps its rank, and changes it where two branches cross.
/// loop: factors of J(from); from, to: the Jacobians themselves, row by row; driven: as factorise has it. Cost:
/// coordinates * rank^2.
template <class Real>
bool changes_side(const LoopFactorsOf<Real>& loop, const Real* from, const Real* to, const unsigned char* driven,
                  const SideWork<Real>& work) noexcept {
  const int rank = loop.rank;
  for (int k = 0; k < rank; ++k) {
    for (int m = 0; m < rank; ++m) {
      Real sum = 0;
      const Real* const left = to + std::ptrdiff_t{loop.rows[k]} * loop.coordinates;
      const Real* const right = from + std::ptrdiff_t{loop.rows[m]} * loop.coordinates;
      for (int c = 0; c < loop.coordinates; ++c)
        sum += loop_detail::is_driven(driven, c) ? Real(0) : left[c] * right[c];
      work.product[k * rank + m] = sum;
    }
  }
  return sign_of_determinant(rank, work.product, work.rows, work.columns) < 0;
}

}  // namespace mbgen
