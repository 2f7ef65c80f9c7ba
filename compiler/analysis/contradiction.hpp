#pragma once
// Redundant equations that contradict the others of their block. The rule is in docs/method/redundancy.md.

#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Refuses the parts of a block whose equations hold it only because they contradict each other: each loop alone, loops
/// that cannot move together, the whole block.
/// whole: the view of all loops of block `b`; immobile: its local columns that stand still.
/// Result: empty when the equations agree, else one diagnostic per part with the residual, the equation and the joint.
Diagnostics contradictions(NumericSystem& numbers, std::size_t b, const PartView& whole,
                           const std::vector<int>& immobile, const std::vector<ClosureEquation>& equations,
                           const std::vector<Configuration>& configurations);

}  // namespace mbgen
