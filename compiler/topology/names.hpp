#pragma once
// Names of the parts of a topology, for people.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Name of a tree body, "ground" for kGround.
std::string body_name(const Topology& topology, int body);

/// Names of the coordinates of these tree joints.
std::vector<std::string> coordinate_names(const Topology& topology, const std::vector<int>& joints);

/// Names of all coordinates, in the order of the tree.
std::vector<std::string> coordinate_names(const Topology& topology);

/// Names of the coordinates of these local columns of a block.
std::vector<std::string> local_names(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns);

/// Names of the loops of a block.
std::vector<std::string> loop_names(const Topology& topology, const LoopBlock& block);

}  // namespace mbgen
