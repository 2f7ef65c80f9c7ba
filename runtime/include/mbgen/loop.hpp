#pragma once
// Loop closures at run time: LU with full pivoting of one block's Jacobian, and what is solved with it.

#include <cmath>

namespace mbgen {

/// Factors of one block Jacobian (equations x coordinates, row by row) with full pivoting, in the caller's memory.
/// Rows and columns are permuted so that the leading rank x rank part is the dependent Jacobian.
struct LoopFactors {
  int equations = 0;
  int coordinates = 0;
  int rank = 0;                 ///< number of pivots taken
  double* matrix = nullptr;     ///< equations x coordinates; after factorisation: L below, U on and above the diagonal, in permuted order
  int* rows = nullptr;          ///< rows[k]: equation in place k
  int* columns = nullptr;       ///< columns[k]: coordinate in place k; the first `rank` are dependent
  double smallest_ratio = 0;    ///< smallest accepted |pivot| over the largest pivot
};

/// Factorises in place with full pivoting. Columns with driven[c] != 0 are never dependent; `driven` may be null.
/// Stops at `rank_limit` pivots, or when the next pivot is below tolerance times the first.
/// Requires: matrix filled, rows and columns point to arrays of their sizes. Cost: equations * coordinates * rank.
inline void factorise(LoopFactors& loop, int rank_limit, const unsigned char* driven, double tolerance) noexcept;

/// Solves Phi_d x_d = right_hand_side - Phi_i x_i for the dependent entries of x, the others of x given.
/// right_hand_side: per equation (original order); x: per coordinate (original order); work: equations doubles.
/// Result: largest residual over the equations that were not used as pivots (redundant ones).
/// Source: (60)-(62).
inline double solve_dependent(const LoopFactors& loop, const double* right_hand_side, double* x, double* work) noexcept;

/// Rz of the block, coordinates x f row by row, f = free directions = coordinates - rank - driven: zd = Rz zd_free.
/// Free direction q belongs to the q-th non-dependent, non-driven coordinate in ascending original order. work: equations doubles.
/// Source: (61).
inline void free_directions(const LoopFactors& loop, const unsigned char* driven, double* rz, double* work) noexcept;

}  // namespace mbgen
