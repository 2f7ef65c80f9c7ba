#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {

/// In the frames and by the rows of the matrix form, whatever the others have: of its sums over the tree none is left
/// that these forces do not need.
Program trace_inverse_dynamics(const Model& model, const Topology& topology, const Analysis& analysis, Form,
                               Spelling spelling) {
  Tracing tracing(Role::inverse_dynamics, model, topology, analysis, Form::matrix, {}, spelling);
  const std::vector<Expr> given = tracing.inputs(Array::zdd, tracing.size());
  const std::vector<Expr> tau = tracing.inputs(Array::tau, tracing.size());
  const InverseDynamics<Expr> inverse =
      inverse_dynamics(tracing.system, analysis.directions, analysis.actuation, given, tau);
  tracing.outputs(Array::zdd, inverse.zdd);
  tracing.outputs(Array::force, inverse.force);
  tracing.outputs(Array::actuation, inverse.clearance);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) tracing.output_pivot(b, inverse.quality[b]);
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
