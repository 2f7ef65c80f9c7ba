#pragma once
// The paper's own LU factorisation (section 2.3): a dense matrix of any rank, by columns with row swapping, built on
// cblas_idamax, cblas_dswap and cblas_dger.

#include <vector>

namespace mbgen {

/// P A Q = L [U W; 0 0] of an m x n matrix by columns. A column in which no row is left with a good pivot is put behind
/// the others and becomes independent; rows that never got a pivot are redundant.
class PaperLu {
 public:
  /// group_of_candidate: a group, any number, for each of the first columns, which may get a pivot; of each group at
  /// most most_of[group] get one.
  PaperLu(int rows, int columns, std::vector<int> group_of_candidate, std::vector<int> most_of);

  /// The matrix to fill in before factorise, column-major, zeros from the start; it is consumed.
  std::vector<double>& matrix() { return matrix_; }
  /// Result: pivots found.
  int factorise();
  int pivots() const { return pivots_; }
  int pivots_of(int group) const { return found_[group]; }
  /// Index before factorise of the column that now stands at `place`; pivot columns stand first.
  int column(int place) const { return column_at_[place]; }

  /// Solves U X = W for `count` columns of W from `first` on, by rank-1 updates: X is pivots() x count, column-major.
  void dependence(int first, int count, std::vector<double>& x) const;
  /// Solves A_pivots x = b - A_others given by rank-1 updates. b: per row. given: per place behind the pivots.
  void solve(const std::vector<double>& b, const std::vector<double>& given, std::vector<double>& x) const;

 private:
  bool take_pivot(int place, double share);
  void eliminate(int row, int place);

  int rows_, columns_, candidates_;
  std::vector<int> group_, most_, found_;
  std::vector<double> matrix_;
  std::vector<double> column_size_, group_size_;
  std::vector<int> row_at_, column_at_;
  int pivots_ = 0;
};

}  // namespace mbgen
