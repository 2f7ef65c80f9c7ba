#pragma once
// Turns that take one direction to another, without Eigen's way to them: a singular value decomposition in every file.

#include <Eigen/Geometry>

namespace mbgen {

/// The smallest rotation that takes the direction of `from` to the direction of `to`. Opposite directions: half a turn
/// about an axis across both, for the z axis about x, as MuJoCo does. Requires: neither is zero.
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace mbgen
