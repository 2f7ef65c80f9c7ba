#pragma once
// Factorisation of one block Jacobian that chooses the dependent columns as it goes (60), by LU or by QR.

#include <Eigen/Dense>
#include <type_traits>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "mbgen/blocks.hpp"
#include "runtime/generic/sparse_lu.hpp"

namespace mbgen {

using SparseRows = std::vector<SparseRow<double>>;

/// A matrix by its rows, zeros left out.
SparseRows sparse_rows(const std::vector<std::vector<double>>& matrix);

/// The same matrix dense, row by row.
std::vector<double> written_out(const SparseRows& rows, int columns);

/// The members of SparseLu, by Eigen on a dense matrix.
class PivotedLu {
 public:
  void compute(const SparseRows& rows, int columns, int rank_limit);
  int rank() const { return rank_; }
  int column(int k) const { return static_cast<int>(factors_.permutationQ().indices()[k]); }
  Eigen::MatrixXd dependence() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const;

 private:
  Eigen::FullPivLU<Eigen::MatrixXd> factors_;
  int rank_ = 0;
};

/// Householder QR with column pivoting, A P = Q R. The members mean what those of SparseLu mean, but that solve gives
/// the least residual where b is not compatible, and solve_transposed the smallest y.
class PivotedQr {
 public:
  void compute(const SparseRows& rows, int columns, int rank_limit);
  int rank() const { return rank_; }
  int column(int k) const { return static_cast<int>(factors_.colsPermutation().indices()[k]); }
  Eigen::MatrixXd dependence() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
  int rank_ = 0;
};

/// One block: pivot columns are dependent, the rest independent or driven.
template <class Pivoted>
class BlockFactorsOf {
 public:
  /// columns: of the block; driven: those of them that never are dependent; rank_limit: generic rank.
  BlockFactorsOf(int columns, const std::vector<int>& driven, int rank_limit);
  /// The same, with a Jacobian at hand.
  BlockFactorsOf(const SparseRows& jacobian, int columns, const std::vector<int>& driven, int rank_limit)
      : BlockFactorsOf(columns, driven, rank_limit) {
    factorise(jacobian);
  }

  /// jacobian: per equation.
  void factorise(const SparseRows& jacobian);
  int rank() const { return pivoted_.rank(); }
  const std::vector<int>& dependent() const { return dependent_; }
  /// Columns that are neither dependent nor driven.
  const std::vector<int>& free() const { return free_; }
  const Pivoted& pivoted() const { return pivoted_; }

  /// Calls use(d, q, value): how the d-th dependent velocity follows from the q-th free one, Rz (61) less its ones.
  template <class Use>
  void each_dependence(const Use& use) const {
    const auto follow = pivoted_.dependence();
    if constexpr (std::is_same_v<decltype(follow), const SparseRows>) {
      for (std::size_t d = 0; d < follow.size(); ++d)
        for (std::size_t e = 0; e < follow[d].columns.size(); ++e)
          use(static_cast<int>(d), follow[d].columns[e], -follow[d].values[e]);
    } else {
      for (int d = 0; d < rank(); ++d)
        for (int q = 0; q < static_cast<int>(free_.size()); ++q) use(d, q, -follow(d, q));
    }
  }
  /// Rz: [column][free direction], directions in the order of free().
  std::vector<std::vector<double>> rz() const;
  /// Fills the dependent entries of x, the others given: Phi_d x_d = right_hand_side - Phi_i x_i.
  void solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const;
  /// lambda of Phi_d' lambda = right_hand_side_d, per equation; right_hand_side per column.
  std::vector<double> multipliers(const std::vector<double>& right_hand_side) const;

 private:
  int columns_ = 0, rank_limit_ = 0;
  std::vector<int> place_, column_;  ///< per column its place among the movable ones, -1 for driven ones; the way back
  SparseRows jacobian_, candidates_;
  Pivoted pivoted_;
  std::vector<int> dependent_, free_;
};

using BlockFactors = BlockFactorsOf<SparseLu>;

/// A block Jacobian, dense, with full pivoting in the order of its rows: as generated solvers have it.
class PivotedBlock {
 public:
  /// At most `rank_limit` pivots.
  PivotedBlock(const BlockAnalysis& analysis, const SparseRows& jacobian, int columns, int rank_limit);
  PivotedBlock(const PivotedBlock&) = delete;
  PivotedBlock& operator=(const PivotedBlock&) = delete;
  const LoopFactors& factors() const { return factors_; }

 private:
  std::vector<double> matrix_;
  std::vector<int> rows_, columns_;
  LoopFactors factors_;
};

/// Nothing in place of rows of velocities alone that repeat others at this position, where a block has such rows.
void drop_repeating_rows(const BlockAnalysis& analysis, SparseRows& jacobian, int columns);

}  // namespace mbgen
