#pragma once
// Which directions of a tree move an inertia, body by body.

#include <span>
#include <vector>

#include "compiler/formulation/constants.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether each free coordinate of a mechanism without loops moves more inertia, with the outboard ones free, than
/// rounding leaves of zero, at one position. The pivots equal those of the mass matrix, eliminated from the last
/// coordinate to the first (articulated bodies: R. Featherstone, Int. J. Robotics Research 2, 1983, 13), without the
/// matrix: the cost is linear in the bodies, not cubic. False may be due to rounding; then the matrix decides. z: per
/// tree coordinate. rounding: per tree coordinate, kg m^2 or kg.
bool tree_has_inertia(const Topology& topology, const Constants<double>& constants, const std::vector<bool>& driven,
                      std::span<const double> z, std::span<const double> rounding);

}  // namespace mbgen
