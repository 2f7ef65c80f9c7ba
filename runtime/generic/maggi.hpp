#pragma once
// Dense linear algebra of the generic runtime: the paper's double-step Maggi solution on Eigen, nothing specialised.

#include <Eigen/Dense>
#include <vector>

#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Gauss elimination with full pivoting of one block Jacobian: pivot columns are dependent, the rest independent (60).
class BlockFactors {
 public:
  /// jacobian: [equation][column]; driven: columns that never are dependent; rank_limit: generic rank.
  BlockFactors(const std::vector<std::vector<double>>& jacobian, const std::vector<int>& driven, int rank_limit);
  int rank() const { return rank_; }
  /// Fills the dependent entries of x, the others given: Phi_d x_d = right_hand_side - Phi_i x_i.
  void solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const;
  /// Rz (61): [column][free direction], free directions in ascending order of the columns that are neither dependent
  /// nor driven.
  std::vector<std::vector<double>> rz() const;
  /// lambda of Phi_d' lambda = right_hand_side_d, per equation, zero at equations without a pivot.
  std::vector<double> multipliers(const std::vector<double>& right_hand_side) const;

 private:
  Eigen::MatrixXd jacobian_, dependent_;
  std::vector<int> dependent_columns_, free_columns_, rows_;
  int rank_ = 0;
  Eigen::FullPivLU<Eigen::MatrixXd> factors_;
};

/// Dense mass matrix of the opened tree (49), rods' couplings included.
Eigen::MatrixXd tree_mass_matrix(System<double>& system, const Kinematics<double>& kinematics,
                                 const Inertias<double>& inertias);

/// Rz of all joint groups as one matrix, coordinates x free directions.
Eigen::MatrixXd dense_rz(const Topology& topology, const std::vector<GroupProjection<double>>& projections);

/// Solves Rz' M Rz zdd_free = Rz' q and returns zdd = zdd_star + Rz zdd_free (63), (62).
/// q: tree forces under zdd_star. singular: coordinate whose direction has no inertia, else unchanged.
std::vector<double> solve_maggi(const Eigen::MatrixXd& mass, const std::vector<double>& q,
                                const std::vector<double>& zdd_star, const Topology& topology,
                                const std::vector<GroupProjection<double>>& projections, int& singular);

}  // namespace mbgen
