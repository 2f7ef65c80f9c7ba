#pragma once
// Size of the equations of implicit steps before they are written.

#include "compiler/analysis/findings.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// About the operations of the equations of an implicit step (M - g D - g^2 K): the elimination of the free directions
/// with the fill-in by elements between two bodies, and their projections; 0 for explicit integrators. The elimination
/// is counted until it takes more than `most`.
double implicit_operations(const Model& model, const Topology& topology, const Analysis& analysis, double most);

}  // namespace mbgen
