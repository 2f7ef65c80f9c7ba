#pragma once
// Loop closures at run time, fine block by fine block: once the free coordinates of a loop block are known, its
// equations fall into small systems that are solved one after another, as the legs of a walking machine under its
// crank. Source: (60)-(62); Dulmage and Mendelsohn.

#include <limits>

#include "mbgen/number.hpp"

namespace mbgen {

/// A small system of equations for as many coordinates, given the coordinates of earlier ones.
struct FineBlock {
  int size;
  int first;          ///< into the rows and the columns of the loop block
  int first_earlier;  ///< into its earlier columns
  int earlier;        ///< columns of earlier fine blocks, and others, where these equations have entries
};

/// Fine structure of one loop block: rows and columns are local to it, fine block after fine block.
struct FineStructure {
  const FineBlock* blocks;
  int count;           ///< 0: none is known
  const int* rows;     ///< equations with a pivot
  const int* columns;  ///< coordinates that depend on the others
  const int* earlier;  ///< see FineBlock
  const int* others;   ///< columns that no fine block determines: free ones, and driven ones
  int other_count;     ///< coordinates of the loop block less its rank
  int coordinates;     ///< of the loop block
  int largest;         ///< size of the largest fine block
};

/// A coordinate of the loop block per row: its motion by one of each other column, the change that closes open
/// positions, and its acceleration at rest of the others. In the caller's memory.
template <class Real>
struct FineSolution {
  Real* rows = nullptr;   ///< coordinates x (others + 2)
  int* others = nullptr;  ///< columns that depend on none: of the structure, or exchanged for one of a fine block
  int other_count = 0;
  Real smallest_pivot = 0;
  int sign = 1;  ///< of the determinant of the structure's columns, but for its order; 0: one was exchanged

  int stride() const noexcept { return other_count + 2; }
  Real* row(int column) const noexcept { return rows + column * stride(); }
};

/// Numbers of memory for the equations of one fine block, and for the exchanged entries of a row.
constexpr int fine_work(int largest, int others) noexcept { return largest * (largest + others + 3); }

/// Factor of an entry in an other column, when a pivot is searched: a coordinate of the fine block is preferred, since
/// an exchange changes all earlier rows.
template <class Real>
inline constexpr Real kExchangeFactor = Real(0.25);

namespace fine_detail {

/// One fine block under elimination: rows of `size` columns of its own, of one per other, and of two right-hand sides.
template <class Real>
struct Elimination {
  const FineStructure& loop;
  const FineBlock& block;
  Real* work;
  int width;
  int* taken;  ///< per row: place of its pivot
  int* place;  ///< per column of its own: the slot of the other column that it takes over, or -1

  Real* row(int i) const noexcept { return work + i * width; }
  Real* shares() const noexcept { return work + block.size * width; }
};

/// The equations with the earlier coordinates put in.
template <class Real>
void gather(const Elimination<Real>& e, const Real* jacobian, const Real* open, const Real* bias,
            const FineSolution<Real>& solution) noexcept {
  const int size = e.block.size, stride = solution.stride();
  for (int i = 0; i < size; ++i) {
    const int equation = e.loop.rows[e.block.first + i];
    const Real* const entries = jacobian + equation * e.loop.coordinates;
    Real* const row = e.row(i);
    for (int j = 0; j < size; ++j) row[j] = entries[e.loop.columns[e.block.first + j]];
    Real* const rest = row + size;
    for (int t = 0; t < solution.other_count; ++t) rest[t] = 0;
    rest[solution.other_count] = open[equation];
    rest[solution.other_count + 1] = bias == nullptr ? Real(0) : -bias[equation];
    for (int k = 0; k < e.block.earlier; ++k) {
      const int column = e.loop.earlier[e.block.first_earlier + k];
      const Real entry = entries[column];
      const Real* const known = solution.row(column);
      for (int q = 0; q < stride; ++q) rest[q] += entry * known[q];
    }
  }
}

/// Sign of the order of the pivots' columns, 0 where one is an other column.
template <class Real>
int sign_of_columns(const Elimination<Real>& e) noexcept {
  int sign = 1;
  for (int i = 0; i < e.block.size; ++i) {
    if (e.taken[i] >= e.block.size) return 0;
    for (int j = i + 1; j < e.block.size; ++j) sign = e.taken[j] < e.taken[i] ? -sign : sign;
  }
  return sign;
}

/// Solves the equations for one coordinate each, until a pivot is below `least`; e.taken is -1 from there on. Result:
/// the smallest pivot, that one too, and 0 where there is none. sign: multiplied by the sign of the determinant.
template <class Real>
Real reduce(const Elimination<Real>& e, int others, const unsigned char* is_movable, Real least, int& sign) noexcept {
  const int size = e.block.size;
  Real smallest = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < size; ++i) e.taken[i] = -1;
  for (int i = 0; i < size; ++i) {
    Real largest = 0;
    int at_row = i, at = -1;
    for (int r = i; r < size; ++r) {
      const Real* const row = e.row(r);
      for (int j = 0; j < size + others; ++j) {
        if (j >= size && is_movable[j - size] == 0) continue;
        const Real entry = magnitude(row[j]) * (j < size ? Real(1) : kExchangeFactor<Real>);
        if (entry > largest) largest = entry, at_row = r, at = j;
      }
    }
    if (at < 0) return 0;
    Real* const pivot_row = e.row(i);
    Real* const chosen = e.row(at_row);
    for (int j = 0; at_row != i && j < e.width; ++j) {
      const Real kept = pivot_row[j];
      pivot_row[j] = chosen[j];
      chosen[j] = kept;
    }
    if ((at_row != i) != (pivot_row[at] < 0)) sign = -sign;
    const Real pivot = magnitude(pivot_row[at]), reciprocal = 1 / pivot_row[at];
    smallest = pivot < smallest ? pivot : smallest;
    if (!(pivot >= least)) return smallest;
    for (int j = 0; j < e.width; ++j) pivot_row[j] *= reciprocal;
    pivot_row[at] = 1;
    for (int r = 0; r < size; ++r) {
      Real* const row = e.row(r);
      const Real factor = row[at];
      if (r == i || factor == 0) continue;
      for (int j = 0; j < e.width; ++j) row[j] -= factor * pivot_row[j];
      row[at] = 0;
    }
    e.taken[i] = at;
  }
  sign *= sign_of_columns(e);
  return smallest;
}

/// Gives the columns of its own without a pivot to slots whose other columns got one. Result: how many.
template <class Real>
int exchange(const Elimination<Real>& e) noexcept {
  const int size = e.block.size;
  for (int j = 0; j < size; ++j) e.place[j] = -2;
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] >= 0 && e.taken[i] < size) e.place[e.taken[i]] = -1;
  }
  int count = 0, next = 0;
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] < size) continue;
    while (e.place[next] != -2) ++next;
    const int slot = e.taken[i] - size;
    e.place[next] = slot;
    for (int r = 0; r < size; ++r) e.row(r)[size + slot] = e.row(r)[next];
    ++count;
  }
  return count;
}

/// Puts rows that were solved for other columns into a row known before.
template <class Real>
void put_exchanged(const Elimination<Real>& e, const FineSolution<Real>& solution, int column) noexcept {
  const int size = e.block.size;
  Real* const known = solution.row(column);
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] >= size) e.shares()[i] = known[e.taken[i] - size];
  }
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] >= size) known[e.taken[i] - size] = 0;
  }
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] < size) continue;
    const Real share = e.shares()[i];
    const Real* const row = e.row(i) + size;
    for (int q = 0; q < solution.stride(); ++q) known[q] -= share * row[q];
  }
}

/// Row of an other column: it moves by itself alone.
template <class Real>
void put_unit(const FineSolution<Real>& solution, int slot) noexcept {
  Real* const row = solution.row(solution.others[slot]);
  for (int q = 0; q < solution.stride(); ++q) row[q] = 0;
  row[slot] = 1;
}

/// Columns without a pivot move as they are told, and the solved ones with them.
template <class Real>
void follow_told(const Elimination<Real>& e, const FineSolution<Real>& solution, const Real* told) noexcept {
  const int size = e.block.size, last = solution.other_count + 1;
  for (int j = 0; j < size; ++j) {
    if (e.place[j] != -2) continue;
    const int column = e.loop.columns[e.block.first + j];
    for (int i = 0; i < size && e.taken[i] >= 0; ++i) e.row(i)[size + last] += e.row(i)[j] * told[column];
    Real* const known = solution.row(column);
    for (int q = 0; q < last; ++q) known[q] = 0;
    known[last] = told[column];
  }
}

template <class Real>
void keep(const Elimination<Real>& e, const FineSolution<Real>& solution, const Real* told) noexcept {
  const int size = e.block.size, exchanged = exchange(e);
  if (told != nullptr) follow_told(e, solution, told);
  if (exchanged > 0) {
    for (int k = 0; k < e.block.first; ++k) put_exchanged(e, solution, e.loop.columns[k]);
    for (int k = 0; k < e.loop.other_count; ++k) put_exchanged(e, solution, e.loop.others[k]);
  }
  for (int i = 0; i < size; ++i) {
    if (e.taken[i] < 0 || e.taken[i] >= size) continue;
    Real* const known = solution.row(e.loop.columns[e.block.first + e.taken[i]]);
    const Real* const row = e.row(i) + size;
    for (int q = 0; q < solution.stride(); ++q) known[q] = -row[q];
  }
  for (int j = 0; j < size; ++j) {
    if (e.place[j] < 0) continue;
    solution.others[e.place[j]] = e.loop.columns[e.block.first + j];
    put_unit(solution, e.place[j]);
  }
}

}  // namespace fine_detail

/// Solves the equations of one loop block, fine block by fine block, each with full pivoting among its own columns and
/// the other ones that are not driven. jacobian: of the loop block, row by row; open, bias: per equation, right-hand
/// sides -open for changes of positions and bias for accelerations; is_driven: per column. work: fine_work numbers;
/// places: 2 * largest; movable: other_count. Result: false as soon as a pivot is below `least`, or there is none.
/// told: velocities per column, with `bias` null: then equations without such a pivot are left out, the columns of
/// their fine blocks without one stay where they are and keep these velocities, and the last entries of the solution
/// are velocities at rest of the others. Cost: as the sizes of the fine blocks; an exchange: as the rows before.
template <class Real>
bool solve_finely(const FineStructure& loop, const Real* jacobian, const Real* open, const Real* bias,
                  const unsigned char* is_driven, Real least, FineSolution<Real>& solution, Real* work, int* places,
                  unsigned char* movable, const Real* told = nullptr) noexcept {
  solution.other_count = loop.other_count;
  solution.smallest_pivot = std::numeric_limits<Real>::infinity();
  solution.sign = 1;
  for (int t = 0; t < loop.other_count; ++t) {
    solution.others[t] = loop.others[t];
    movable[t] = is_driven[loop.others[t]] != 0 ? 0 : 1;
    fine_detail::put_unit(solution, t);
  }
  for (int p = 0; p < loop.count; ++p) {
    const FineBlock& block = loop.blocks[p];
    const fine_detail::Elimination<Real> e{
        loop, block, work, block.size + solution.stride(), places, places + loop.largest};
    fine_detail::gather(e, jacobian, open, bias, solution);
    const Real pivot = fine_detail::reduce(e, loop.other_count, movable, least, solution.sign);
    solution.smallest_pivot = pivot < solution.smallest_pivot ? pivot : solution.smallest_pivot;
    if (!(pivot >= least) && told == nullptr) return false;
    fine_detail::keep(e, solution, told);
  }
  return true;
}

}  // namespace mbgen
