#pragma once
// Bristles of frictions in linear equations: those that nothing presses hold nothing.

#include <vector>

#include "compiler/formulation/elements/bristle_ends.hpp"
#include "compiler/linearisation/linear_system.hpp"

namespace mbgen {

/// The bristles of the model's frictions at a point, in the order of their states. Parameters have the model's values.
std::vector<BristleEnd> bristles_at(const Model& model, const Topology& topology, const OperatingPoint& point);

/// Takes the bristles without a limit out of a system: their parts slide as if no friction were there, so that neither
/// deflection nor rate acts, and a deflection that is left fades with the law's lag. The law itself holds such parts
/// within 1e-15 of a deflection, and its derivative there is the whole stiffness. Where the parts slide, inputs and
/// auxiliary states that open the limit act against the motion, by the derivative to the side to which it opens.
void release_bristles(const Model& model, const Topology& topology, const OperatingPoint& point, LinearSystem& system);

/// Bends the bristles of parts that slide to where they stay bent, and straightens those without a limit. Bristles that
/// hold keep their deflection. Result: bristles_at the point.
std::vector<BristleEnd> settle_bristles(const Model& model, const Topology& topology, OperatingPoint& point);

}  // namespace mbgen
