#pragma once
// Motions that nothing holds, as after a forgotten tie rod.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Notes on free motions at the reference that turn a body about a line near the vertical, where gravity does not hold
/// it, and that no spring, friction, joint force or torque acts on; only of models with springs or tyres, and neither
/// of free joints nor of balanced rotors nor of what carries springs of its own, as a trailer does.
Diagnostics unrestrained_motions(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
