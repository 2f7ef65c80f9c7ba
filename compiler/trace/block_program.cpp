#include <algorithm>

#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {

Program trace_block(const Model& model, const Topology& topology, const Analysis& analysis, int block,
                    const LoopPartition& partition, TraceOrder order) {
  Tracing tracing(Role::accelerations, model, topology, analysis, Form::recursive);
  const LoopBlock& traced = topology.blocks[block];
  std::erase_if(tracing.recursion.units, [&](const RecursionUnit& unit) {
    if (unit.block == block) return false;
    if (unit.base != kGround && std::binary_search(traced.joints.begin(), traced.joints.end(), unit.base)) return false;
    return std::none_of(unit.joints.begin(), unit.joints.end(),
                        [&](int j) { return traced.base != kGround && on_path(topology, traced.base, j); });
  });
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = kinematics(system);
  AppliedForces<Expr> none;
  none.wrench.resize(topology.bodies.size());
  none.joint.resize(topology.bodies.size());
  std::vector<BlockProjection<Expr>> projections(topology.blocks.size());
  for (std::size_t b = 0; b < projections.size(); ++b) projections[b] = analysis.blocks[b].quasi;
  projections[block] = partition;
  const RecursiveSolution<Expr> solution = recursive_accelerations(
      system, tracing.recursion, k, none, tracing.drive, tracing.inputs(Array::tau, tracing.size()), projections);
  tracing.outputs(Array::zdd, solution.zdd);
  tracing.output(Array::pivot, block, solution.quality[block]);
  return order == TraceOrder::canonical ? tracing.builder.finish_in_canonical_order() : tracing.builder.finish();
}

}  // namespace mbgen
