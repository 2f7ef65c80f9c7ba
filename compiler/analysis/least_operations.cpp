// Sizes of the forms before they are written.

#include "compiler/analysis/analysis.hpp"
#include "compiler/analysis/direction_names.hpp"

namespace mbgen {
namespace {

constexpr double kLeastOfABody = 64;  // operations; N-four-bars, which are planar, take 63

/// Of a block in the recursive form, beyond the operations of its bodies: by its free directions or its multipliers.
double operations_of_block(const Topology& topology, const Analysis& analysis, const JointGroup& group) {
  const double joints = static_cast<double>(group.joints.size());
  const double unknowns =
      static_cast<double>(topology.blocks[group.block].opened ? analysis.blocks[group.block].pivots.size()
                                                              : analysis.blocks[group.block].independent.size());
  return 3 * joints * unknowns * (unknowns - 1);
}

}  // namespace

std::vector<int> free_coordinates(const Topology& topology, const Analysis& analysis) {
  return names_of_directions(topology, analysis.blocks, analysis.driven);
}

std::vector<int> actuated_coordinates(const Topology& topology, const Analysis& analysis) {
  return names_of_directions(topology, analysis.directions.partitions, analysis.directions.held);
}

LeastOperations least_operations(const Topology& topology, const Analysis& analysis) {
  const double bodies = kLeastOfABody * topology.size();
  LeastOperations least{bodies, bodies};
  std::vector<double> below;  // per group: free directions of the groups that it moves on
  for (const JointGroup& group : topology.groups) {
    const double free = group.block >= 0 ? static_cast<double>(analysis.blocks[group.block].independent.size())
                                         : (analysis.driven[group.joints[0]] ? 0.0 : 1.0);
    const double before = group.parent < 0 ? 0.0 : below[group.parent];
    // each direction is taken out of the triangle of those before it
    for (double d = before; d < before + free; ++d) least.matrix += d * (d + 1);
    if (group.block >= 0) least.recursive += operations_of_block(topology, analysis, group);
    below.push_back(before + free);
  }
  return least;
}

}  // namespace mbgen
