#pragma once
// Coordinates that name directions of motion. Inside the analysis room.

#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// The independent coordinates of partitions, one LoopPartition per block, group by group. held: per tree coordinate.
template <class Partitions>
std::vector<int> names_of_directions(const Topology& topology, const Partitions& partitions,
                                     const std::vector<bool>& held) {
  std::vector<int> result;
  for (const JointGroup& group : topology.groups) {
    if (group.block < 0) {
      if (!held[group.joints[0]]) result.push_back(group.joints[0]);
      continue;
    }
    for (int c : partitions[group.block].independent) result.push_back(group.joints[c]);
  }
  return result;
}

}  // namespace mbgen
