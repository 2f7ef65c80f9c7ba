#pragma once
// Private to the topology room: choice of tree joints and cut joints.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

struct SpanningTree {
  std::vector<bool> in_tree;            ///< per model joint
  std::vector<std::string> cut_reason;  ///< per model joint, empty in the tree and for free joints
};

/// Chooses the tree by rank: joints marked "cut": false, joints with used coordinates, then joints with most equations
/// if cut; among equals the nearest to ground, then the first in the file. Then joints of equal rank are exchanged as
/// long as this shortens the loops, measured in coordinates over all loops. Fails: a body with no path to ground,
/// marked joints that form a cycle, a used coordinate of a joint that is cut. Cost: joints * log(joints), and for the
/// exchange the square of the loops' total length per improvement.
Result<SpanningTree> choose_spanning_tree(const Model& model);

}  // namespace mbgen
