#pragma once
// Closing the loops of a mechanism at double, from any position.

#include <Eigen/Core>
#include <vector>

#include "compiler/analysis/sparse_elimination.hpp"
#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Blocks of more joints are large: analysed by sparse elimination, at configurations along their freedoms (the rule is
/// in docs/evidence/growth.md). Singular values would take minutes, and random starts never close so many loops at
/// once.
constexpr std::size_t kLargestSmallBlock = 40;
inline bool is_large(const LoopBlock& block) { return block.joints.size() > kLargestSmallBlock; }

/// Closure of one block at one closed configuration.
struct BlockSample {
  Eigen::MatrixXd jacobian;  ///< equations x coordinates; empty for a large block
  SparseRows sparse;         ///< the same of a large block, else empty
  /// Chosen rows and columns of it, ascending.
  Eigen::MatrixXd part(const std::vector<int>& rows, const std::vector<int>& columns) const;
};

/// A position of all coordinates; a block that could not be closed there is marked.
struct Configuration {
  std::vector<double> z;
  std::vector<bool> closed;                ///< per block: the equations asked for are, on the branch of the reference
  std::vector<BlockSample> blocks;         ///< per block, valid where closed
  std::vector<Eigen::VectorXd> residuals;  ///< per block
  /// Per block, rad or m: the step that would come next. At a singular position a small residual leaves a large one.
  std::vector<Eigen::VectorXd> corrections;
};

/// The formulation at double for a model at default parameters and inputs, t = 0.
class NumericSystem {
 public:
  NumericSystem(const Model& model, const Topology& topology);
  NumericSystem(const NumericSystem&) = delete;
  System<double>& at(const std::vector<double>& z);
  const Model& model() const { return system_.model; }
  const Topology& topology() const { return system_.topology; }
  /// Of a point of a body, global at the reference configuration, m.
  Vector<double> reference_position(const Attachment& at) const;
  const Constants<double>& constants() const { return system_.constants; }
  /// Of a block: rows that hold velocities alone.
  const std::vector<int>& velocity_rows(std::size_t b) const { return velocity_rows_[b]; }

 private:
  Layout layout_;
  Annotator<double> annotator_;
  System<double> system_;
  std::vector<std::vector<int>> velocity_rows_;  // per block
};

/// Residuals of a block, to first order, after the step that would come next: the part that closing some of its
/// equations only to kClosedForRank leaves of the others is taken out.
Eigen::VectorXd residual_left(const Configuration& configuration, std::size_t b);

/// Residuals and Jacobians of all blocks at a position.
void evaluate_closures(NumericSystem& numbers, Configuration& configuration);
/// The same of the blocks whose coordinates moved since (per block): no closure sees the coordinates of another block.
void evaluate_closures(NumericSystem& numbers, Configuration& configuration, const std::vector<bool>& moved);

/// Steps towards closed loops. Damped ones, by the size of the residual, also reach places about which the rank drops,
/// as a branch does where it meets another one; large blocks take none. Source: J. Fan, Y. Yuan, "On the quadratic
/// convergence of the Levenberg-Marquardt method without nonsingularity assumption", Computing 74, 2005.
enum class Newton { full, damped };

/// Closes the chosen equations of each block (local rows, ascending; none: the block stays) from a start by
/// least-squares Newton steps, largest residual kClosedForRank; the steps of large blocks leave independent coordinates
/// where they are. Rows of velocities alone choose among the steps that rows of positions leave. Driven coordinates
/// move like the others.
Configuration close_equations(NumericSystem& numbers, std::vector<double> start,
                              const std::vector<std::vector<int>>& equations, Newton newton = Newton::full);

}  // namespace mbgen
