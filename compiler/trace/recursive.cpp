#include "compiler/trace/recursive.hpp"

#include <algorithm>

#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

std::vector<LoopPartition> quasi_partitions(const Analysis& analysis) {
  std::vector<LoopPartition> partitions;
  for (const BlockAnalysis& block : analysis.blocks) partitions.push_back(block.quasi);
  return partitions;
}

}  // namespace

Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                      RecursionChoices choices) {
  const Recursion recursion = plan_recursion(model, topology, analysis.driven, choices);
  Tracing tracing("accelerations", model, topology, analysis, &recursion.layout);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = kinematics(system);
  tracing.scribe.step(Step::forces);
  const AppliedForces<Expr> forces = applied_forces(system, k, velocities(system, k));
  const RecursiveSolution<Expr> solution = recursive_accelerations(
      system, recursion, k, forces, tracing.drive, tracing.inputs("tau", tracing.size()), quasi_partitions(analysis));
  const std::vector<int> names = free_coordinates(topology, analysis);
  for (const DirectionInertia<Expr>& direction : solution.inertia) {
    const int coordinate =
        direction.block < 0
            ? direction.place
            : topology.blocks[direction.block].joints[analysis.blocks[direction.block].independent[direction.place]];
    const auto index = std::find(names.begin(), names.end(), coordinate) - names.begin();
    tracing.output("inertia", static_cast<int>(index), direction.value);
  }
  tracing.outputs("zdd", solution.zdd);
  tracing.outputs("xd", forces.xd);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    if (analysis.blocks[b].rank > 0) tracing.output("pivot", static_cast<int>(b), solution.quality[b]);
  return tracing.builder.finish_in_canonical_order();
}

Program cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis) {
  Program cheapest = trace_recursive_accelerations(model, topology, analysis);
  if (topology.blocks.empty()) return cheapest;
  for (const RecursionChoices choices :
       {RecursionChoices{.holding = true, .centres = false}, RecursionChoices{.holding = false, .centres = true},
        RecursionChoices{.holding = false, .centres = false}}) {
    Program other = trace_recursive_accelerations(model, topology, analysis, choices);
    if (count_operations(other).total() < count_operations(cheapest).total()) cheapest = std::move(other);
  }
  return cheapest;
}

std::vector<std::pair<std::string, Program>> trace_without(const Model& model, const Topology& topology,
                                                           const Analysis& analysis) {
  std::vector<std::pair<std::string, Program>> programs;
  programs.emplace_back("rotors held by their base",
                        trace_recursive_accelerations(model, topology, analysis, {.rotors = false}));
  programs.emplace_back("bodies of blocks held by the body below",
                        trace_recursive_accelerations(model, topology, analysis, {.holding = false}));
  programs.emplace_back("bodies seen from their centres of mass",
                        trace_recursive_accelerations(model, topology, analysis, {.centres = false}));
  programs.emplace_back("arms turn with their base",
                        trace_recursive_accelerations(model, topology, analysis, {.arms = false}));
  return programs;
}

}  // namespace mbgen
