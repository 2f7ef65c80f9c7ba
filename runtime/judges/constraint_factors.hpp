#pragma once
// Gaussian elimination of the constraint Jacobian with row and column exchanges: (12), and the bases (24) from it.

#include <Eigen/Dense>
#include <vector>

namespace mbgen {

/// Entries allowed as pivots.
struct PivotRule {
  double smallest = 1e-10;     ///< relative to the first pivot; a pivot that is not larger is zero
  std::vector<int> equations;  ///< equations with possible pivots; empty: all
  std::vector<int> late = {};  ///< nonholonomic ones: pivots only after all others
};

/// Right-hand side of the equations after elimination, L^-1 P c of (13).
struct ReducedBias {
  Eigen::VectorXd kept;     ///< c_1:r, in the order of the pivots
  Eigen::VectorXd dropped;  ///< per equation the expression of (14) that must be zero; zero for kept equations
};

/// P Phi_q = L [U; 0] of rank r (12). The pivot is the largest remaining entry, so its columns are the dependent
/// coordinates of (21) and the equations without a pivot are the redundant ones. m equations, n coordinates. Cost: r m
/// n at most, much less for a sparse Jacobian.
class ConstraintFactors {
 public:
  ConstraintFactors(const Eigen::MatrixXd& jacobian, const PivotRule& rule);

  /// Equations with a pivot, in the order of the pivots; the others are redundant.
  const std::vector<int>& kept() const { return pivot_rows_; }
  int rank() const { return static_cast<int>(pivot_rows_.size()); }
  /// U of (13), r x n, columns in the order of the coordinates.
  const Eigen::MatrixXd& reduced() const { return reduced_; }
  /// R of (24), n x (n - r): a basis of the motions allowed by the equations, the identity at independent coordinates.
  const Eigen::MatrixXd& null_basis() const { return null_basis_; }

  ReducedBias reduce(const Eigen::VectorXd& bias) const;
  /// S c of (29): satisfies the equations with zero at the independent coordinates. bias: ReducedBias::kept.
  Eigen::VectorXd particular(const Eigen::VectorXd& bias) const;
  /// S' f of (28), r multipliers of the reduced equations. force: n.
  Eigen::VectorXd reduced_multipliers(const Eigen::VectorXd& force) const;
  /// Multipliers of all m equations from the multipliers of the reduced ones, P' L^-T of (13): zero at redundant
  /// equations.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& reduced) const;
  /// Weights y of all m equations with y' Phi_q = 0 and 1 at a redundant `equation`.
  Eigen::VectorXd dependency(int equation) const;

 private:
  void eliminate(const Eigen::MatrixXd& jacobian, const PivotRule& rule);

  std::vector<int> pivot_rows_, pivot_columns_, independent_columns_;
  Eigen::MatrixXd lower_;      ///< m x r: multiple of pivot equation k subtracted from an equation
  Eigen::MatrixXd reduced_;    ///< r x n
  Eigen::MatrixXd dependent_;  ///< r x r, upper triangular: reduced_ at the pivot columns
  Eigen::MatrixXd null_basis_;
};

}  // namespace mbgen
