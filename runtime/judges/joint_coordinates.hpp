#pragma once
// Relative coordinates of a joint of the tree, from the poses and motions of its two bodies.

#include <array>
#include <vector>

#include "runtime/judges/rows.hpp"

namespace mbgen::cartesian {

/// One coordinate of a joint: z'' = on_from' qdd_from + on_to' qdd_to - row.bias, where row.residual is z itself.
struct JointCoordinate {
  int index = -1;  ///< of the tree
  double zd = 0;
  Row row;  ///< its columns are also the wrenches of a unit generalised force
};

/// The coordinates of a joint in the order of its freedoms. Angles of a sequence are the nearest to `guess`: per tree
/// coordinate. For bodies that violate the joint's constraints, the coordinates are a least-squares fit. Requires: the
/// sequence is not at its singular position.
std::vector<JointCoordinate> joint_coordinates(const PartJoint& joint, const std::vector<Part>& parts,
                                               const std::vector<Moving>& bodies, const std::vector<double>& guess);

}  // namespace mbgen::cartesian
