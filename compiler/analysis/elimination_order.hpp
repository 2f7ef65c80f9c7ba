#pragma once
// The order in which a candidate for the dependent Jacobian of a loop block is eliminated, and about what that costs.

#include <Eigen/Core>
#include <tuple>
#include <vector>

#include "compiler/formulation/loop_partition.hpp"

namespace mbgen {

/// A square part of a block's Jacobian: equations and dependent coordinates, local, ascending.
struct Candidate {
  std::vector<int> rows, columns;
  bool operator<(const Candidate& other) const { return std::tie(columns, rows) < std::tie(other.columns, other.rows); }
};

/// That part of one Jacobian.
Eigen::MatrixXd part_of(const Eigen::MatrixXd& m, const std::vector<int>& rows, const std::vector<int>& columns);

struct Ordering {
  std::vector<Pivot> pivots;          ///< block-triangular, then by Markowitz's rule among pivots of kPivotRatio
  std::vector<int> triangular_sizes;  ///< of the diagonal blocks
  double worst_ratio = 1;             ///< smallest |pivot| over the largest entry of its remaining column
  double cost = 0;                    ///< operations, about
};

/// used: per sample, whether it counts; at least one does.
Ordering order_pivots(const std::vector<Eigen::MatrixXd>& jacobians, const std::vector<bool>& used,
                      const Candidate& candidate);

/// The same with these pivots, of a block of the same structure: their equations and coordinates in the same order, if
/// that is one of the candidate; empty otherwise. Their references and ratios are its own.
Ordering order_like(const std::vector<Pivot>& pivots, const std::vector<Eigen::MatrixXd>& jacobians,
                    const std::vector<bool>& used, const Candidate& candidate);

}  // namespace mbgen
