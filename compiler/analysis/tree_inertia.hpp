#pragma once
// Which directions of a tree move an inertia, body by body.

#include <span>
#include <vector>

#include "compiler/formulation/constants.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether each free coordinate of a mechanism without loops moves more inertia, while those further out are free, than
/// rounding leaves of none, at one position. The pivots are those that elimination of the mass matrix from the last
/// coordinate to the first finds (articulated bodies: R. Featherstone, Int. J. Robotics Research 2, 1983,
/// 13), without the matrix: the cost is that of the bodies, not of their cube. False may be for rounding; then the
/// matrix decides. z: per tree coordinate. rounding: per tree coordinate, kg m^2 or kg.
bool tree_has_inertia(const Topology& topology, const Constants<double>& constants, const std::vector<bool>& driven,
                      std::span<const double> z, std::span<const double> rounding);

}  // namespace mbgen
