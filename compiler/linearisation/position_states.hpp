#pragma once
// Positions that are states of a linear system. Where bodies roll or slide on blades, more positions are free than
// velocities: some of the positions that closing moves are states, too.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Coordinates whose positions are states.
struct PositionStates {
  std::vector<int> coordinates;  ///< the independent ones, then those that only rolling makes dependent, ascending
  /// coordinates x states: deviations of all positions when one of these changes by 1 and the others do not; empty
  /// where the independent ones are all, since closing gives these then
  Eigen::MatrixXd along;
};

/// closing: coordinates x coordinates, how far Newton's step of the closure moves each position after one of them has
/// moved by 1. It puts back what rows of positions ask for, by directions that roll.
/// Result: none where another number of positions is free than elsewhere.
std::optional<PositionStates> position_states(const Topology& topology, const Analysis& analysis,
                                              const Eigen::MatrixXd& closing);

}  // namespace mbgen
