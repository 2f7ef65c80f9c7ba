#pragma once
// Elimination of sparse Jacobians in step over many configurations: rank, dependent columns and order in one pass, for
// loop blocks too large for singular values.

#include <vector>

#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/loop_partition.hpp"

namespace mbgen {

constexpr double kPivotRatio = 0.05;  ///< smallest pivot over its column that keeps the digits

using SparseRows = std::vector<SparseRow<double>>;

struct SparseElimination {
  std::vector<Pivot> pivots;   ///< as many as the rank; rows without one follow from the others
  double worst_ratio = 1;      ///< smallest |pivot| / largest entry of its remaining row and column, over all samples
  double smallest_kept = 0;    ///< smallest pivot of the rows scaled to largest entry 1, over all samples
  double largest_dropped = 0;  ///< largest entry that was left in a row without pivot
};

/// Eliminates the chosen rows by Markowitz's rule among entries that are large enough in every sample. Ties go to the
/// earlier row and column unless one pivot is clearly larger, so that equal cells of a mechanism are treated alike.
/// samples: the same matrix at several configurations, at least one, rows in m or 1; rows: ascending; barred: per
/// column, true where it must not get a pivot; late: rows that get pivots when no other row has one left. Rank: a row
/// whose rest is below 1e-8 of its largest entry counts as zero. Cost: as the entries met, times the samples.
SparseElimination eliminate(const std::vector<const SparseRows*>& samples, const std::vector<int>& rows,
                            const std::vector<bool>& barred, const std::vector<int>& late = {});

}  // namespace mbgen
