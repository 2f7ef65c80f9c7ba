#pragma once
// Bristles of frictions in linear equations: without normal force they have no force.

#include <vector>

#include "compiler/formulation/elements/bristle_ends.hpp"
#include "compiler/linearisation/linear_system.hpp"

namespace mbgen {

/// The bristles of the model's frictions at a point, in the order of their states. Parameters have the model's values.
std::vector<BristleEnd> bristles_at(const Model& model, const Topology& topology, const OperatingPoint& point);

/// Removes the bristles without a limit from a system: their parts slide without friction, so that neither deflection
/// nor rate acts, and a remaining deflection decays with the law's lag. The law itself sticks within 1e-15 of a
/// deflection, and its derivative there is the whole stiffness. If the parts slide, inputs and auxiliary states that
/// open the limit act against the motion, by the derivative to the side of the opening.
void release_bristles(const Model& model, const Topology& topology, const OperatingPoint& point, LinearSystem& system);

/// Sets the bristles of sliding parts to their steady deflection, and bristles without a limit to zero. Sticking
/// bristles keep their deflection. Result: bristles_at the point.
std::vector<BristleEnd> set_steady_bristles(const Model& model, const Topology& topology, OperatingPoint& point);

}  // namespace mbgen
