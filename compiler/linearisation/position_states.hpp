#pragma once
// Positions among the states of a linear system. With rolling bodies or blades there are more free positions than
// velocities: some of the positions changed by the closure are states, too.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Coordinates with positions as states.
struct PositionStates {
  std::vector<int> coordinates;  ///< independent ones, then those dependent by rolling only, ascending
  /// coordinates x states: deviations of all positions for a unit change of one of these and none of the others; empty
  /// if these are the independent ones, since the closure then gives the deviations
  Eigen::MatrixXd along;
};

/// closing: coordinates x coordinates, change of each position by Newton's step of the closure after a unit change of
/// one of them. It restores the rows of positions, in directions allowed by rolling. Result: none if the number of free
/// positions differs from the usual one.
std::optional<PositionStates> position_states(const Topology& topology, const Analysis& analysis,
                                              const Eigen::MatrixXd& closing);

}  // namespace mbgen
