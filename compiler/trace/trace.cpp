#include "compiler/trace/trace.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/trace/closure_programs.hpp"
#include "compiler/trace/given_state.hpp"
#include "compiler/trace/recursive.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Projection of a joint outside all blocks: free, or prescribed by a motion.
GroupProjection<Expr> single_projection(const Tracing& tracing, int joint) {
  for (const Drive<Expr>& d : tracing.drive)
    if (d.coordinate == joint) return {{{}}, {d.acceleration}};
  return {{{Expr(1.0)}}, {Expr(0.0)}};
}

/// What the frozen path knows of a block: factors, Rz and zdd_star.
struct FrozenBlocks {
  std::vector<FrozenFactors<Expr>> factors;
  std::vector<std::vector<std::vector<Expr>>> rz;
  std::vector<std::vector<Expr>> zdd_star;
};

/// Step 2.
void frozen_jacobians(Tracing& tracing, const Kinematics<Expr>& k, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.scribe.step(Step::jacobian);
  const RelativeMotion<Expr> rest = at_rest<Expr>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const SparseClosure<Expr> closed = sparse_closure(system, k, system.topology.blocks[b], rest);
    const auto heading = tracing.scribe.within(OwnerKind::loop_block, b);
    const std::size_t coordinates = system.topology.blocks[b].joints.size();
    blocks.factors.push_back(factorise_frozen(closed.jacobian, tracing.analysis.blocks[b], coordinates));
  }
}

/// Step 3.
void frozen_projections(Tracing& tracing, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.scribe.step(Step::projection);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const auto heading = tracing.scribe.within(OwnerKind::loop_block, b);
    blocks.rz.push_back(
        frozen_rz(blocks.factors[b], tracing.analysis.blocks[b], system.topology.blocks[b].joints.size()));
    for (std::size_t c = 0; c < blocks.rz[b].size(); ++c)
      for (std::size_t q = 0; q < blocks.rz[b][c].size(); ++q)
        tracing.scribe.name(
            blocks.rz[b][c][q],
            fmt::format("Rz_{}_{}", system.topology.bodies[system.topology.blocks[b].joints[c]].coordinate, q));
  }
}

/// Step 6.
void frozen_bias(Tracing& tracing, const Kinematics<Expr>& k, FrozenBlocks& blocks) {
  System<Expr>& system = tracing.system;
  const auto step = tracing.scribe.step(Step::closure_bias);
  RelativeMotion<Expr> relative = at_rest<Expr>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const LoopBlock& block = system.topology.blocks[b];
    set_relative_motion(system, k, block, relative);
    const SparseClosure<Expr> closed = sparse_closure(system, k, block, relative);
    const auto heading = tracing.scribe.within(OwnerKind::loop_block, b);
    blocks.zdd_star.push_back(frozen_zdd_star(blocks.factors[b], tracing.analysis.blocks[b], closed,
                                              tracing.driven_values(block, &Drive<Expr>::acceleration)));
    for (std::size_t c = 0; c < block.joints.size(); ++c)
      tracing.scribe.name(blocks.zdd_star[b][c], "zdd_star_", system.topology.bodies[block.joints[c]].coordinate);
  }
}

/// Steps 7 to 9 from projections, common to the frozen and the chosen partition.
void trace_solution(Tracing& tracing, const Kinematics<Expr>& k, const Inertias<Expr>& m, const Velocities<Expr>& v,
                    const AppliedForces<Expr>& forces, const std::vector<GroupProjection<Expr>>& projections) {
  System<Expr>& system = tracing.system;
  const std::vector<Expr> q = tracing.in(Step::accelerations, [&] {
    const Accelerations<Expr> a = accelerations(system, k, v, starred_accelerations(system.topology, projections));
    return tree_forces(system, k, m, v, a, forces, tracing.inputs(Array::tau, tracing.size()));
  });
  const ReducedSystem<Expr> reduced =
      tracing.in(Step::reduced_system, [&] { return reduced_system(system, k, m, projections, q); });
  const auto step = tracing.scribe.step(Step::solution);
  const ReducedSolution<Expr> solution = solve_reduced(reduced);
  tracing.outputs(Array::inertia, solution.inertia);
  tracing.outputs(Array::zdd, joint_accelerations(system.topology, projections, reduced, solution.acceleration));
  tracing.outputs(Array::xd, forces.xd);
}

Program trace_matrix_accelerations(const Model& model, const Topology& topology, const Analysis& analysis) {
  Tracing tracing(Role::accelerations, model, topology, analysis);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  const Inertias<Expr> m = tracing.in(Step::inertias, [&] { return inertias(system, k); });
  FrozenBlocks blocks;
  frozen_jacobians(tracing, k, blocks);
  frozen_projections(tracing, blocks);
  const Velocities<Expr> v = tracing.in(Step::velocities, [&] { return velocities(system, k); });
  const AppliedForces<Expr> forces = tracing.in(Step::forces, [&] { return applied_forces(system, k, v); });
  frozen_bias(tracing, k, blocks);
  std::vector<GroupProjection<Expr>> projections;
  for (const JointGroup& group : topology.groups)
    projections.push_back(group.block < 0
                              ? single_projection(tracing, group.joints[0])
                              : GroupProjection<Expr>{blocks.rz[group.block], blocks.zdd_star[group.block]});
  trace_solution(tracing, k, m, v, forces, projections);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    if (analysis.blocks[b].rank > 0) tracing.output(Array::pivot, static_cast<int>(b), blocks.factors[b].quality);
  return tracing.builder.finish_in_canonical_order();
}

Program trace_matrix_accelerations_chosen(const Model& model, const Topology& topology, const Analysis& analysis) {
  Tracing tracing(Role::accelerations_chosen, model, topology, analysis);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  const Inertias<Expr> m = tracing.in(Step::inertias, [&] { return inertias(system, k); });
  const Velocities<Expr> v = tracing.in(Step::velocities, [&] { return velocities(system, k); });
  const AppliedForces<Expr> forces = tracing.in(Step::forces, [&] { return applied_forces(system, k, v); });
  std::vector<GroupProjection<Expr>> projections;
  for (const JointGroup& group : topology.groups) {
    if (group.block < 0) {
      projections.push_back(single_projection(tracing, group.joints[0]));
      continue;
    }
    projections.push_back(chosen_projection(tracing, static_cast<std::size_t>(group.block)));
  }
  trace_solution(tracing, k, m, v, forces, projections);
  return tracing.builder.finish_in_canonical_order();
}

/// The frozen and the chosen partition in one form, so that both are the same equations.
void trace_all_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                             Programs& programs) {
  const bool chooses = !topology.loops.empty() && chooses_again(topology);
  if (programs.form == Form::matrix) {
    programs.accelerations = trace_matrix_accelerations(model, topology, analysis);
    if (chooses) programs.accelerations_chosen = trace_matrix_accelerations_chosen(model, topology, analysis);
    return;
  }
  auto [program, choices] = cheapest_recursion(model, topology, analysis);
  programs.accelerations = std::move(program);
  if (chooses)
    programs.accelerations_chosen =
        trace_recursive_accelerations(model, topology, analysis, Partition::chosen, choices);
}

}  // namespace

bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis) {
  const LeastOperations least = least_operations(topology, analysis);
  return form == Form::matrix ? is_worth_writing(least.matrix, least.recursive)
                              : is_worth_writing(least.recursive, least.matrix);
}

Form form_of(const Topology& topology, const Analysis& analysis) {
  return is_worth_writing(Form::recursive, topology, analysis) ? Form::recursive : Form::matrix;
}

Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  return form == Form::matrix ? trace_matrix_accelerations(model, topology, analysis)
                              : cheapest_recursion(model, topology, analysis).program;
}

Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form) {
  Programs programs;
  programs.form = form.value_or(form_of(topology, analysis));
  trace_all_accelerations(model, topology, analysis, programs);
  programs.closure = trace_closure(model, topology, analysis, programs.form);
  if (!topology.loops.empty()) programs.closure_terms = trace_closure_terms(model, topology, analysis, programs.form);
  programs.multipliers = trace_multipliers(model, topology, analysis, programs.form);
  programs.outputs = trace_outputs(model, topology, analysis, programs.form);
  for (int i : free_coordinates(topology, analysis))
    programs.free_direction_coordinate.push_back(topology.bodies[i].coordinate);
  int equation = 0;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    programs.free_directions_of_block.push_back(static_cast<int>(analysis.blocks[b].independent.size()));
    programs.residual_equation_of.push_back(equation);
    equation += topology.blocks[b].equations;
  }
  return programs;
}

}  // namespace mbgen
