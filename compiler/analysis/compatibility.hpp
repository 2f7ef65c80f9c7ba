#pragma once
// Do the redundant equations of a block follow from the others wherever it can go? The rule is
// docs/method/redundancy.md.

#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Refuses the parts of a block whose equations hold it only because they contradict each other: each loop alone, loops
/// that cannot move together, the whole block.
/// whole: the view of all loops of block `b`; immobile: its local columns that never move.
/// Result: empty when the equations agree, else one diagnostic per part with the residual, the equation and the joint.
Diagnostics contradictions(NumericSystem& numbers, std::size_t b, const PartView& whole,
                           const std::vector<int>& immobile, const std::vector<ClosureEquation>& equations,
                           const std::vector<Configuration>& configurations);

/// Residuals of the redundant equations of a block while it moved with its kept equations closed.
struct Watch {
  int steps = 0;             ///< finite steps that could be made
  Eigen::VectorXd residual;  ///< per row of the block: the largest, m or 1; zero for kept ones
  Diagnostics problems;      ///< one when that is more than rounding
};

/// Moves every block from its closed configurations by a finite step along its freedoms and closes its kept equations
/// alone. kept: local rows per block; blocks without redundant equations stay.
std::vector<Watch> watch_redundant(NumericSystem& numbers, const std::vector<PartView>& views,
                                   const std::vector<std::vector<int>>& kept,
                                   const std::vector<std::vector<ClosureEquation>>& equations,
                                   const std::vector<Configuration>& configurations);

}  // namespace mbgen
