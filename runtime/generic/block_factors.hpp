#pragma once
// Dense factorisation of one block Jacobian that chooses the dependent columns as it goes (60), by LU or by QR.

#include <Eigen/Dense>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "mbgen/blocks.hpp"

namespace mbgen {

/// Gauss elimination with full pivoting, P A Q = L U. All members but compute use its first `rank` pivots.
class PivotedLu {
 public:
  void compute(const Eigen::MatrixXd& a);
  int rank() const { return static_cast<int>(factors_.rank()); }
  /// Column of A that pivot k took.
  int column(int k) const { return static_cast<int>(factors_.permutationQ().indices()[k]); }
  /// Rows of A in the order of their pivots.
  std::vector<int> rows() const;
  /// U11^-1 U12: the pivot columns of A times this are its other columns, in the order of `column`.
  Eigen::MatrixXd dependence(int rank) const;
  /// x with A_pivots x = b, for b compatible with A.
  Eigen::VectorXd solve(int rank, const Eigen::VectorXd& b) const;
  /// y with A_pivots' y = f, zero at the rows without a pivot.
  Eigen::VectorXd solve_transposed(int rank, const Eigen::VectorXd& f) const;

 private:
  Eigen::FullPivLU<Eigen::MatrixXd> factors_;
};

/// Householder QR with column pivoting, A P = Q R. The members mean what those of PivotedLu mean, but that solve gives
/// the least residual where b is not compatible, and solve_transposed the smallest y.
class PivotedQr {
 public:
  void compute(const Eigen::MatrixXd& a);
  int rank() const { return static_cast<int>(factors_.rank()); }
  int column(int k) const { return static_cast<int>(factors_.colsPermutation().indices()[k]); }
  Eigen::MatrixXd dependence(int rank) const;
  Eigen::VectorXd solve(int rank, const Eigen::VectorXd& b) const;
  Eigen::VectorXd solve_transposed(int rank, const Eigen::VectorXd& f) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
};

/// One block: pivot columns are dependent, the rest independent or driven.
template <class Pivoted>
class BlockFactorsOf {
 public:
  /// columns: of the block; driven: those of them that never are dependent; rank_limit: generic rank.
  BlockFactorsOf(int columns, const std::vector<int>& driven, int rank_limit);
  /// The same, with a Jacobian at hand.
  BlockFactorsOf(const std::vector<std::vector<double>>& jacobian, const std::vector<int>& driven, int rank_limit);

  /// jacobian: [equation][column].
  void factorise(const std::vector<std::vector<double>>& jacobian);
  int rank() const { return rank_; }
  const std::vector<int>& dependent() const { return dependent_; }
  /// Columns that are neither dependent nor driven.
  const std::vector<int>& free() const { return free_; }
  const Pivoted& pivoted() const { return pivoted_; }

  /// How dependent velocities follow from the free ones: minus the upper part of Rz (61), dependent() x free().
  Eigen::MatrixXd dependence() const {
    return rank_ > 0 ? pivoted_.dependence(rank_) : Eigen::MatrixXd(0, static_cast<Eigen::Index>(free_.size()));
  }
  /// Rz: [column][free direction], directions in the order of free().
  std::vector<std::vector<double>> rz() const;
  /// Fills the dependent entries of x, the others given: Phi_d x_d = right_hand_side - Phi_i x_i.
  void solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const;
  /// lambda of Phi_d' lambda = right_hand_side_d, per equation; right_hand_side per column.
  std::vector<double> multipliers(const std::vector<double>& right_hand_side) const;

 private:
  std::vector<int> movable_;
  int rank_limit_ = 0;
  Eigen::MatrixXd jacobian_, candidates_;
  Pivoted pivoted_;
  int rank_ = 0;
  std::vector<int> dependent_, free_;
};

using BlockFactors = BlockFactorsOf<PivotedLu>;

/// A block Jacobian, [equation][column], with full pivoting in the order of its rows: as generated solvers have it.
class PivotedBlock {
 public:
  /// At most `rank_limit` pivots.
  PivotedBlock(const BlockAnalysis& analysis, const std::vector<std::vector<double>>& jacobian, int rank_limit);
  PivotedBlock(const PivotedBlock&) = delete;
  PivotedBlock& operator=(const PivotedBlock&) = delete;
  const LoopFactors& factors() const { return factors_; }

 private:
  std::vector<double> matrix_;
  std::vector<int> rows_, columns_;
  LoopFactors factors_;
};

/// Zeros in place of rows of velocities alone that repeat others at this position, where a block has such rows.
void drop_repeating_rows(const BlockAnalysis& analysis, std::vector<std::vector<double>>& jacobian);

}  // namespace mbgen
