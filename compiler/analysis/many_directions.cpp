#include "compiler/analysis/many_directions.hpp"

#include <cmath>

#include "compiler/formulation/recursion/recursion.hpp"

namespace mbgen {
namespace {

std::vector<BlockProjection<double>> of_partitions(const Analysis& analysis) {
  std::vector<BlockProjection<double>> projections;
  for (const BlockAnalysis& block : analysis.blocks) projections.emplace_back(block.quasi);
  return projections;
}

/// The coordinate that names a free direction.
int coordinate_of(const Topology& topology, const Analysis& analysis, const DirectionInertia<double>& direction) {
  if (direction.block < 0) return direction.place;
  return topology.blocks[direction.block].joints[analysis.blocks[direction.block].independent[direction.place]];
}

/// Inertia per coordinate by the recursive form, with the coordinates of `locked` at rest; NaN of these, and of
/// coordinates that move one that has none.
std::vector<double> inertias_while(const System<double>& given, const Analysis& analysis,
                                   const std::vector<bool>& locked) {
  const Recursion recursion = plan_recursion(given.model, given.topology, locked);
  System<double> system{given.model, given.topology,  recursion.layout, given.environment,
                        given.x,     given.constants, given.annotator};
  const std::size_t n = given.topology.bodies.size();
  AppliedForces<double> none;
  none.wrench.resize(n);
  none.joint.assign(n, 0.0);
  none.about = MotionPoint::body_origin;
  std::vector<Drive<double>> still;
  for (std::size_t i = 0; i < n; ++i)
    if (locked[i]) still.push_back({static_cast<int>(i), 0.0, 0.0, 0.0});
  std::vector<double> result(n, std::nan(""));
  const std::vector<BlockProjection<double>> frozen = of_partitions(analysis);
  for (const DirectionInertia<double>& direction :
       recursive_accelerations(system, recursion, kinematics(system), none, still, std::vector<double>(n, 0.0), frozen)
           .inertia)
    result[coordinate_of(given.topology, analysis, direction)] = direction.value;
  return result;
}

}  // namespace

std::vector<double> inertias_by_recursion(const System<double>& system, const Analysis& analysis,
                                          const std::vector<int>& asked) {
  std::vector<bool> locked = analysis.driven;
  std::vector<double> inertia(locked.size(), 0.0);
  // A direction without inertia leaves none to be told of the coordinates that move it: it is locked, and the others
  // are asked again. One of a block stays: the block's partition is over it.
  const std::vector<int>& group_of = system.topology.group_of;
  for (bool again = true; again;) {
    again = false;
    const std::vector<double> found = inertias_while(system, analysis, locked);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (locked[i]) continue;
      inertia[i] = found[i];
      if (found[i] <= 0 && system.topology.groups[group_of[i]].block < 0) locked[i] = again = true;
    }
  }
  std::vector<double> result;
  for (const int i : asked) result.push_back(inertia[i]);
  return result;
}

}  // namespace mbgen
