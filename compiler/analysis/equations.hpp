#pragma once
// The condition of each closure equation in words of mechanics, and its unit.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Unit of a closure equation's residual.
enum class ResidualUnit { metre, one, of_relation };

/// One closure equation of a block, in the order of the block's rows.
struct ClosureEquation {
  int loop = 0;         ///< index into Topology::loops
  std::string name;     ///< `loop.row`
  std::string meaning;  ///< "position along x", "axis tilt about z"; directions at the reference, of the global frame
  ResidualUnit unit = ResidualUnit::metre;
};

/// How far an equation with this residual opens its loop: m (of a rod the length that it lacks), or the sine of an
/// angle.
double opening(const Model& model, const Topology& topology, const ClosureEquation& equation, double residual);

/// An opening as people say it: "12.3 mm", or "4.5 deg".
std::string opening_text(ResidualUnit unit, double opening);

/// The equations of a block. Source: theory.md section 3.
std::vector<ClosureEquation> closure_equations(const Model& model, const Topology& topology, const LoopBlock& block);

}  // namespace mbgen
