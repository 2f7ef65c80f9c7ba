#include <algorithm>
#include <utility>

#include "compiler/trace/each_program.hpp"
#include "compiler/trace/shared_laws.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Projections of the blocks: over their frozen partitions, or inputs of the program. An opened block needs none.
std::vector<BlockProjection<Expr>> block_projections(Tracing& tracing) {
  std::vector<BlockProjection<Expr>> projections;
  for (std::size_t b = 0; b < tracing.analysis.blocks.size(); ++b) {
    if (tracing.role == Role::accelerations || tracing.system.topology.blocks[b].opened)
      projections.emplace_back(tracing.analysis.blocks[b].quasi);
    else
      projections.emplace_back(tracing.chosen_projection(b));
  }
  return projections;
}

/// The inertia of every free direction, by its place among free_coordinates.
void output_inertia(Tracing& tracing, const std::vector<DirectionInertia<Expr>>& directions) {
  const Topology& topology = tracing.system.topology;
  const std::vector<int> names = free_coordinates(topology, tracing.analysis);
  for (const DirectionInertia<Expr>& direction : directions) {
    const int coordinate = direction.block < 0
                               ? direction.place
                               : topology.blocks[direction.block]
                                     .joints[tracing.analysis.blocks[direction.block].independent[direction.place]];
    const auto index = std::find(names.begin(), names.end(), coordinate) - names.begin();
    tracing.output(Array::inertia, static_cast<int>(index), direction.value);
  }
}

}  // namespace

Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Role role,
                                      RecursionChoices choices, const std::vector<SharedLaw>& laws, Spelling spelling) {
  Tracing tracing(role, model, topology, analysis, Form::recursive, choices, spelling);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  const Velocities<Expr> v =
      tracing.in(Step::velocities, [&] { return velocities(system, k, MotionPoint::body_origin); });
  const AppliedForces<Expr> forces =
      tracing.in(Step::forces, [&] { return applied_forces(system, k, v, shared_tyre_law(tracing, laws)); });
  const RecursiveSolution<Expr> solution =
      recursive_accelerations(system, tracing.recursion, k, forces, tracing.drive,
                              tracing.inputs(Array::tau, tracing.size()), block_projections(tracing));
  output_inertia(tracing, solution.inertia);
  tracing.outputs(Array::zdd, solution.zdd);
  tracing.outputs(Array::xd, forces.xd);
  tracing.outputs(Array::hold, forces.hold);
  for (std::size_t b = 0; role == Role::accelerations && b < topology.blocks.size(); ++b)
    tracing.output_pivot(b, solution.quality[b]);
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
