#include "compiler/trace/recursive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace mbgen {
namespace {

/// Projections of the blocks: over their frozen partitions, or inputs of the program.
std::vector<BlockProjection<Expr>> block_projections(Tracing& tracing, Partition partition) {
  std::vector<BlockProjection<Expr>> projections;
  for (std::size_t b = 0; b < tracing.analysis.blocks.size(); ++b) {
    if (partition == Partition::frozen)
      projections.emplace_back(tracing.analysis.blocks[b].quasi);
    else
      projections.emplace_back(chosen_projection(tracing, b));
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

GroupProjection<Expr> chosen_projection(Tracing& tracing, std::size_t block) {
  GroupProjection<Expr> chosen;
  const int free = static_cast<int>(tracing.analysis.blocks[block].independent.size());
  const int columns = static_cast<int>(tracing.system.topology.blocks[block].joints.size());
  for (int c = 0; c < columns; ++c) {
    chosen.zdd_star.push_back(tracing.input(of_block(Array::zdd_star, block), c));
    chosen.rz.emplace_back();
    for (int q = 0; q < free; ++q) chosen.rz.back().push_back(tracing.input(of_block(Array::Rz, block), c * free + q));
  }
  return chosen;
}

Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                      Partition partition, RecursionChoices choices) {
  const Recursion recursion = plan_recursion(model, topology, analysis.driven, choices);
  const bool is_frozen = partition == Partition::frozen;
  Tracing tracing(is_frozen ? Role::accelerations : Role::accelerations_chosen, model, topology, analysis,
                  &recursion.layout);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  const Velocities<Expr> v =
      tracing.in(Step::velocities, [&] { return velocities(system, k, MotionPoint::body_origin); });
  const AppliedForces<Expr> forces = tracing.in(Step::forces, [&] { return applied_forces(system, k, v); });
  const RecursiveSolution<Expr> solution =
      recursive_accelerations(system, recursion, k, forces, tracing.drive, tracing.inputs(Array::tau, tracing.size()),
                              block_projections(tracing, partition));
  output_inertia(tracing, solution.inertia);
  tracing.outputs(Array::zdd, solution.zdd);
  tracing.outputs(Array::xd, forces.xd);
  for (std::size_t b = 0; is_frozen && b < topology.blocks.size(); ++b)
    if (analysis.blocks[b].rank > 0) tracing.output(Array::pivot, static_cast<int>(b), solution.quality[b]);
  return tracing.builder.finish_in_canonical_order();
}

Program trace_block(const Model& model, const Topology& topology, const Analysis& analysis, int block,
                    const LoopPartition& partition, TraceOrder order) {
  Recursion recursion = plan_recursion(model, topology, analysis.driven);
  const LoopBlock& traced = topology.blocks[block];
  std::erase_if(recursion.units, [&](const RecursionUnit& unit) {
    if (unit.block == block) return false;
    if (unit.base != kGround && std::binary_search(traced.joints.begin(), traced.joints.end(), unit.base)) return false;
    return std::none_of(unit.joints.begin(), unit.joints.end(),
                        [&](int j) { return traced.base != kGround && on_path(topology, traced.base, j); });
  });
  Tracing tracing(Role::accelerations, model, topology, analysis, &recursion.layout);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = kinematics(system);
  AppliedForces<Expr> none;
  none.wrench.resize(topology.bodies.size());
  none.joint.resize(topology.bodies.size());
  std::vector<BlockProjection<Expr>> projections(topology.blocks.size());
  for (std::size_t b = 0; b < projections.size(); ++b) projections[b] = analysis.blocks[b].quasi;
  projections[block] = partition;
  const RecursiveSolution<Expr> solution = recursive_accelerations(
      system, recursion, k, none, tracing.drive, tracing.inputs(Array::tau, tracing.size()), projections);
  tracing.outputs(Array::zdd, solution.zdd);
  tracing.output(Array::pivot, block, solution.quality[block]);
  return order == TraceOrder::canonical ? tracing.builder.finish_in_canonical_order() : tracing.builder.finish();
}

CheapestRecursion cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto traced = [&](RecursionChoices choices) {
    return CheapestRecursion{trace_recursive_accelerations(model, topology, analysis, Partition::frozen, choices),
                             choices};
  };
  CheapestRecursion cheapest = traced({});
  if (topology.blocks.empty()) return cheapest;
  for (const RecursionChoices choices :
       {RecursionChoices{.holding = true, .centres = false}, RecursionChoices{.holding = false, .centres = true},
        RecursionChoices{.holding = false, .centres = false}}) {
    CheapestRecursion other = traced(choices);
    if (count_operations(other.program).total() < count_operations(cheapest.program).total())
      cheapest = std::move(other);
  }
  return cheapest;
}

std::vector<std::pair<std::string, Program>> trace_without(const Model& model, const Topology& topology,
                                                           const Analysis& analysis) {
  std::vector<std::pair<std::string, Program>> programs;
  programs.emplace_back("rotors held by their base",
                        trace_recursive_accelerations(model, topology, analysis, Partition::frozen, {.rotors = false}));
  programs.emplace_back(
      "bodies of blocks held by the body below",
      trace_recursive_accelerations(model, topology, analysis, Partition::frozen, {.holding = false}));
  programs.emplace_back(
      "bodies seen from their centres of mass",
      trace_recursive_accelerations(model, topology, analysis, Partition::frozen, {.centres = false}));
  programs.emplace_back("arms turn with their base",
                        trace_recursive_accelerations(model, topology, analysis, Partition::frozen, {.arms = false}));
  return programs;
}

}  // namespace mbgen
