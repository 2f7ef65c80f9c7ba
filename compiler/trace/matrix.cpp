#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Values of a block on the frozen path: factors, Rz and zdd_star.
struct FrozenBlocks {
  std::vector<FrozenFactors<Expr>> factors;
  std::vector<std::vector<std::vector<Expr>>> rz;
  std::vector<std::vector<Expr>> zdd_star;
};

/// Step 2: Phi_z and the factors of Phi_d (60).
void frozen_jacobians(Tracing& tracing, const Kinematics<Expr>& k, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.annotator.step(Step::jacobian);
  const RelativeMotion<Expr> rest = at_rest<Expr>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const SparseClosure<Expr> closed = sparse_closure(system, k, system.topology.blocks[b], rest);
    const auto heading = within_block(tracing.annotator, b);
    const std::size_t coordinates = system.topology.blocks[b].joints.size();
    blocks.factors.push_back(factorise_frozen(closed.jacobian, tracing.analysis.blocks[b], coordinates));
  }
}

/// Step 3: Rz (61).
void frozen_projections(Tracing& tracing, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.annotator.step(Step::projection);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const auto heading = within_block(tracing.annotator, b);
    blocks.rz.push_back(
        frozen_rz(blocks.factors[b], tracing.analysis.blocks[b], system.topology.blocks[b].joints.size()));
    name_rz(system, {system.topology, system.topology.blocks[b].joints}, blocks.rz[b]);
  }
}

/// Step 6: z* (62).
void frozen_bias(Tracing& tracing, const Kinematics<Expr>& k, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.annotator.step(Step::closure_bias);
  RelativeMotion<Expr> relative = at_rest<Expr>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const LoopBlock& block = system.topology.blocks[b];
    set_relative_motion(system, k, block, relative);
    const SparseClosure<Expr> closed = sparse_closure(system, k, block, relative);
    const auto heading = within_block(tracing.annotator, b);
    blocks.zdd_star.push_back(frozen_zdd_star(blocks.factors[b], tracing.analysis.blocks[b], closed,
                                              tracing.driven_values(block, &Drive<Expr>::acceleration)));
    name_zdd_star(system, {system.topology, block.joints}, blocks.zdd_star[b]);
  }
}

/// Steps 7 to 9 from projections (63), common to the frozen and the chosen partition.
void trace_solution(Tracing& tracing, const Kinematics<Expr>& k, const Inertias<Expr>& m, const Velocities<Expr>& v,
                    const AppliedForces<Expr>& forces, const std::vector<GroupProjection<Expr>>& projections) {
  System<Expr>& system = tracing.system;
  const std::vector<Expr> q = tracing.in(Step::accelerations, [&] {
    const Accelerations<Expr> a = accelerations(system, k, v, starred_accelerations(system.topology, projections));
    return tree_forces(system, k, m, v, a, forces, tracing.inputs(Array::tau, tracing.size()));
  });
  const ReducedSystem<Expr> reduced =
      tracing.in(Step::reduced_system, [&] { return reduced_system(system, k, m, projections, q); });
  const auto step = tracing.annotator.step(Step::solution);
  const ReducedSolution<Expr> solution = solve_reduced(system, reduced);
  tracing.outputs(Array::inertia, solution.inertia);
  tracing.outputs(Array::zdd, joint_accelerations(system.topology, projections, solution.acceleration));
  tracing.outputs(Array::xd, forces.xd);
  tracing.outputs(Array::hold, forces.hold);
}

/// Projection of a joint outside all blocks: free, or prescribed by a motion.
GroupProjection<Expr> single_projection(const Tracing& tracing, int joint) {
  for (const Drive<Expr>& d : tracing.drive)
    if (d.coordinate == joint) return {{{}}, {d.acceleration}};
  return {{{Expr(1.0)}}, {Expr(0.0)}};
}

/// Projections of all joint groups.
std::vector<GroupProjection<Expr>> group_projections(Tracing& tracing, const FrozenBlocks& blocks) {
  std::vector<GroupProjection<Expr>> projections;
  for (const JointGroup& group : tracing.system.topology.groups)
    if (group.block < 0)
      projections.push_back(single_projection(tracing, group.joints[0]));
    else if (tracing.role == Role::accelerations_chosen)
      projections.push_back(tracing.chosen_projection(static_cast<std::size_t>(group.block)));
    else
      projections.push_back({blocks.rz[group.block], blocks.zdd_star[group.block]});
  return projections;
}

}  // namespace

Program trace_matrix_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Role role,
                                   Spelling spelling) {
  const bool is_frozen = role == Role::accelerations;
  Tracing tracing(role, model, topology, analysis, Form::matrix, {}, spelling);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  const Inertias<Expr> m = tracing.in(Step::inertias, [&] { return inertias(system, k); });
  FrozenBlocks blocks;
  if (is_frozen) {
    frozen_jacobians(tracing, k, blocks);
    frozen_projections(tracing, blocks);
  }
  const Velocities<Expr> v = tracing.in(Step::velocities, [&] { return velocities(system, k); });
  const AppliedForces<Expr> forces = tracing.in(Step::forces, [&] { return applied_forces(system, k, v); });
  if (is_frozen) frozen_bias(tracing, k, blocks);
  trace_solution(tracing, k, m, v, forces, group_projections(tracing, blocks));
  for (std::size_t b = 0; b < blocks.factors.size(); ++b) tracing.output_pivot(b, blocks.factors[b].quality);
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
