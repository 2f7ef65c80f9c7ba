#pragma once
// A part of a loop block, a loop alone or several together, and its Jacobian free of units at the closed
// configurations.

#include <Eigen/Core>
#include <vector>

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/equations.hpp"

namespace mbgen {

/// A unit-free Jacobian has its number of larger singular values as rank; closures are exact to 1e-11. Pivots of the
/// solver are judged by kRankTolerance of mbgen/math/precision.hpp.
constexpr double kLeastSingularValue = 1e-8;

/// Some loops of a block with the joints that they constrain; rows and columns local to the block, ascending.
struct BlockPart {
  std::vector<int> loops, rows, columns;
};

bool contains(const std::vector<int>& values, int value);

/// The loops given, of one block.
BlockPart block_part(const Topology& topology, const LoopBlock& block, const std::vector<int>& loops);

/// Loops of a block put together where they share a joint.
std::vector<std::vector<int>> connected(const Topology& topology, const std::vector<int>& loops);

/// A part seen at the closed configurations of its block. Rows in metres are divided by the size of the part (diagonal
/// of the box around its joints at the reference), columns of prismatic joints multiplied by it: J = diag(row_scale)
/// Phi_z diag(column_scale).
struct PartView {
  BlockPart part;
  Eigen::VectorXd row_scale, column_scale;
  std::vector<int> configurations;         ///< indices of the closed ones
  std::vector<Eigen::MatrixXd> jacobians;  ///< J at each of them
  std::vector<Eigen::VectorXd> singular_values;
  std::vector<int> ranks;  ///< singular values above kLeastSingularValue, and above their uncertainty
  int rank = 0;            ///< generic: the largest seen
  std::vector<int> late;   ///< indices into part.rows: rows that hold velocities alone
  /// Weakest singular value that counts as rank over the largest one, at least 1: at view index `s`.
  double margin(std::size_t s) const;
  /// View index with the largest margin.
  std::size_t best() const;
  /// No coordinate of the part can move.
  bool locked() const { return rank == static_cast<int>(part.columns.size()); }
};

/// Requires: at least one configuration in which block `b` is closed.
PartView view(const NumericSystem& numbers, std::size_t b, const BlockPart& part,
              const std::vector<ClosureEquation>& equations, const std::vector<Configuration>& configurations);

/// Orthonormal directions (columns) in which a matrix of this rank does not change its product.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, int rank);

/// Rows that elimination with full pivoting takes first, ascending; late ones after the rank of the others.
std::vector<int> strongest_rows(const Eigen::MatrixXd& matrix, int count, const std::vector<int>& late);

}  // namespace mbgen
