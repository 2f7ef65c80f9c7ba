#pragma once
// The joint graph of a model with fixed joints merged: which joints stay in the tree, which are cut.

#include "compiler/topology/topology.hpp"

#include <string>
#include <vector>

namespace mbgen {

/// Bodies merged by fixed joints: a cluster moves as one.
struct Clusters {
  std::vector<int> cluster;          ///< per model body
  std::vector<bool> fixed_in_tree;   ///< per joint: fixed and merging
  int ground = 0;                    ///< cluster of ground
  int count = 0;
};

/// Merges bodies along fixed joints that are not marked as cuts. A fixed joint inside a cluster closes a loop.
Clusters merge_fixed(const Model& model);

/// Decision for each joint.
struct TreeChoice {
  std::vector<bool> in_tree;         ///< per joint
  std::vector<std::string> reasons;  ///< per joint: why it was cut, "" for tree joints
};

/// Fewest closure equations first, then shortest loops; marks are obeyed. Fails: marks that make a cycle.
Result<TreeChoice> choose_tree(const Model& model, const Clusters& clusters);

/// Equations that cutting a joint of this type costs.
int closure_equations(JointType type);

/// Joints whose coordinates something in the model refers to.
std::vector<bool> joints_in_use(const Model& model);

}  // namespace mbgen
