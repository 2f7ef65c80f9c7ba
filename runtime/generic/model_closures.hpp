#pragma once
// The loop closures of one model at double (theory.md section 3), with the places of their entries known.

#include <vector>

#include "compiler/formulation/closure.hpp"

namespace mbgen {

using Closures = std::vector<SparseClosure<double>>;  ///< per loop block

/// sparse_closure of all blocks, in memory that is kept from state to state. It refers to the topology.
class ModelClosures {
 public:
  explicit ModelClosures(const Topology& topology);
  /// motion: of the blocks' bodies, or at_rest, where residuals and Jacobians are enough. Cost: entries of the rows.
  void evaluate(System<double>& system, const Kinematics<double>& k, const RelativeMotion<double>& motion,
                Closures& closures) const;

 private:
  /// A joint that moves an end of a loop.
  struct Mover {
    int joint = 0;
    bool moves_from = false, is_length = false;
  };
  struct Place {
    int loop = 0;
    std::vector<Mover> movers;  ///< empty for a coupling
    std::vector<int> columns;   ///< of the block, per mover
  };
  const Topology& topology_;
  std::vector<std::vector<Place>> loops_;  ///< per block
};

}  // namespace mbgen
