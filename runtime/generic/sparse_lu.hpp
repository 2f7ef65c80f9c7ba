#pragma once
// Gauss elimination with full pivoting of matrices whose rows have few entries.

#include <Eigen/Dense>
#include <vector>

#include "compiler/formulation/closure.hpp"

namespace mbgen {

/// P A Q = L U with the largest entry of all that are left as each pivot, zeros never touched: the pivots and the
/// numbers are those of dense elimination, which of equal entries takes another one. The memory is kept from matrix to
/// matrix.
class SparseLu {
 public:
  /// Takes pivots until there are rank_limit, or the next one is below kRankTolerance of the first. Of equal entries
  /// the first row has it, in it the first column. A matrix with an entry that is not finite has rank 0. columns: of A.
  /// Cost: the entries of the rows in which each pivot column stands, and a logarithm of the rows for each.
  void compute(const std::vector<SparseRow<double>>& rows, int columns, int rank_limit);
  int rank() const { return static_cast<int>(pivots_.size()); }
  /// Column of A in place k: the column of pivot k, then columns without a pivot in ascending order.
  int column(int k) const { return columns_[static_cast<std::size_t>(k)]; }
  /// Rows of A with pivots, in their order.
  std::vector<int> rows() const;
  /// Infinite without pivots.
  double smallest_pivot() const;
  /// U11^-1 U12 row by row: the pivot columns of A times this are its other columns, in the order of `column`.
  std::vector<SparseRow<double>> dependence() const;
  /// x with A_pivots x = b, for b compatible with A.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// y with A_pivots' y = f, zero at the rows without a pivot.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const;
  /// Multiplications of the last elimination.
  long multiplications() const { return multiplications_; }

 private:
  struct Entry {
    int index = 0;  ///< column, in L the row
    double value = 0;
  };
  struct Pivot {
    int row = 0, column = 0;
    double value = 0;
    std::vector<Entry> above, below;  ///< rest of the row in U, of the column in L
  };
  bool take(const std::vector<SparseRow<double>>& rows, int columns);
  void eliminate(int row);
  void subtract(int from, double factor, const Pivot& pivot);
  void set_largest(int row);
  int larger_of(int a, int b) const;

  std::vector<std::vector<Entry>> left_;   ///< per row: entries that are not yet eliminated
  std::vector<std::vector<int>> rows_of_;  ///< per column: rows that have or had an entry there
  std::vector<Entry> largest_;             ///< per row: its largest entry by size; value 0 where it has none
  std::vector<int> contest_;               ///< a tree of rows, each node the one of its two with the larger entry
  std::vector<int> place_in_row_;          ///< per column, of the row in hand; -1: none
  std::vector<Pivot> pivots_;
  std::vector<Pivot> spare_;  ///< memory of pivots of other matrices
  std::vector<int> columns_, place_of_column_;
  int rows_ = 0;
  std::size_t leaves_ = 1;
  long multiplications_ = 0;
};

}  // namespace mbgen
