#pragma once
// Closed configurations of a mechanism, found from random positions around the reference.

#include <Eigen/Dense>
#include <vector>

#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Closure of one block at one closed configuration.
struct BlockSample {
  Eigen::MatrixXd jacobian;  ///< equations x coordinates
};

/// A position of all coordinates; a block that could not be closed there is marked.
struct Configuration {
  std::vector<double> z;
  std::vector<bool> closed;                ///< per block
  std::vector<BlockSample> blocks;         ///< per block, valid where closed
  std::vector<Eigen::VectorXd> residuals;  ///< per block
};

/// The formulation at double for a model at default parameters and inputs, t = 0.
class NumericSystem {
 public:
  NumericSystem(const Model& model, const Topology& topology);
  NumericSystem(const NumericSystem&) = delete;
  System<double>& at(const std::vector<double>& z);
  const Layout& layout() const { return layout_; }

 private:
  Layout layout_;
  Scribe<double> scribe_;
  System<double> system_;
};

/// Residuals and Jacobians of all blocks at a position.
void evaluate_closures(NumericSystem& numbers, Configuration& configuration);

/// Closes all blocks from a start by least-squares Newton steps. Driven coordinates move like the others.
Configuration close_from(NumericSystem& numbers, std::vector<double> start);

/// The reference configuration first, then up to `wanted` more from deterministic random starts of growing distance.
std::vector<Configuration> closed_configurations(NumericSystem& numbers, int wanted);

}  // namespace mbgen
