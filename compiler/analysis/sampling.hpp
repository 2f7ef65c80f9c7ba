#pragma once
// Closed configurations of a mechanism, found from random positions around the reference.

#include <Eigen/Dense>
#include <vector>

#include "compiler/formulation/formulation.hpp"

namespace mbgen {

constexpr double kClosed = 1e-11;  ///< m or 1: Newton reaches it in a few steps from a good start

/// Closure of one block at one closed configuration.
struct BlockSample {
  Eigen::MatrixXd jacobian;  ///< equations x coordinates
};

/// A position of all coordinates; a block that could not be closed there is marked.
struct Configuration {
  std::vector<double> z;
  std::vector<bool> closed;                ///< per block: the equations asked for are
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

 private:
  Layout layout_;
  Scribe<double> scribe_;
  System<double> system_;
};

/// Residuals and Jacobians of all blocks at a position.
void evaluate_closures(NumericSystem& numbers, Configuration& configuration);

/// Closes the chosen equations of each block (local rows, ascending; none: the block stays) from a start by
/// least-squares Newton steps, largest residual kClosed. Driven coordinates move like the others.
Configuration close_equations(NumericSystem& numbers, std::vector<double> start,
                              const std::vector<std::vector<int>>& equations);

/// The reference configuration first, then up to `wanted` more from deterministic random starts of growing distance.
std::vector<Configuration> closed_configurations(NumericSystem& numbers, int wanted);

}  // namespace mbgen
