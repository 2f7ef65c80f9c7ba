#pragma once
// What each closure equation asks for, in words a mechanic uses, and in which unit.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Unit of a closure equation's residual.
enum class ResidualUnit { metre, one };

/// One closure equation of a block, in the order of the block's rows.
struct ClosureEquation {
  int loop = 0;         ///< index into Topology::loops
  std::string name;     ///< `loop.row`
  std::string meaning;  ///< "position along x", "axis tilt about z"; directions at the reference, of the global frame
  ResidualUnit unit = ResidualUnit::metre;
};

/// The equations of a block. Source: theory.md section 3.
std::vector<ClosureEquation> closure_equations(const Model& model, const Topology& topology, const LoopBlock& block);

}  // namespace mbgen
