#pragma once
// Vectors nearest to targets under sparse linear equations, for loop blocks that are too large for dense
// decompositions.

#include <Eigen/Dense>
#include <vector>

#include "compiler/formulation/closure.hpp"

namespace mbgen {

/// rows x.
Eigen::VectorXd product(const std::vector<SparseRow<double>>& rows, const Eigen::VectorXd& x);

/// Sparse equations rows x = b of full row rank, and least solutions of them. Cost: as the entries of rows rows' after
/// elimination.
class SparseEquations {
 public:
  /// Keeps the rows to which full pivoting gives a pivot; the others repeat them. columns: of the rows; movable: the
  /// columns that x has, in its order.
  SparseEquations(const std::vector<SparseRow<double>>& rows, int columns, const std::vector<int>& movable);

  /// x of the least sum of weight x^2 / 2 - pull x with rows x = b. weight: above zero; b: per row given.
  Eigen::VectorXd least(const Eigen::VectorXd& weight, const Eigen::VectorXd& pull, const Eigen::VectorXd& b) const;
  /// x of the least |rows x - b|^2 + damping |x|^2, the equations that repeat others left out.
  Eigen::VectorXd damped(const Eigen::VectorXd& b, double damping) const;
  /// x of the least |weight (x - target)| with rows x = b; where that leaves a choice, near the least x.
  Eigen::VectorXd nearest(const Eigen::VectorXd& weight, const Eigen::VectorXd& target, const Eigen::VectorXd& b) const;
  /// Rows that were given.
  Eigen::Index given() const { return given_; }
  /// Whether no direction is left.
  bool is_rigid() const { return static_cast<int>(kept_.size()) == columns_; }

 private:
  void add_transposed(const Eigen::VectorXd& y, Eigen::VectorXd& x) const;
  Eigen::VectorXd of_kept(const Eigen::VectorXd& b) const;

  Eigen::Index given_ = 0;
  int columns_ = 0;
  std::vector<int> kept_;                ///< rows as given
  std::vector<SparseRow<double>> rows_;  ///< the kept ones, over the movable columns
};

}  // namespace mbgen
