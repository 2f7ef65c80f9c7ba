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

Program trace_actuators(const Model& model, const Topology& topology, const Analysis& analysis, Form,
                        Spelling spelling) {
  Tracing tracing(Role::actuators, model, topology, analysis, Form::matrix, {}, spelling);
  const ActuatorsSeen<Expr> seen = tracing.in(Step::velocities, [&] { return actuators_seen(tracing.system); });
  tracing.outputs(Array::position, seen.position);
  tracing.outputs(Array::drift, seen.drift);
  for (std::size_t i = 0; i < seen.direction.size(); ++i)
    for (int c = 0; c < tracing.size(); ++c)
      if (!is_zero(seen.direction[i][c]))
        tracing.output(Array::direction, static_cast<int>(i) * tracing.size() + c, seen.direction[i][c]);
  return tracing.builder.finish_in_canonical_order();
}

Program trace_required_forces(const Model& model, const Topology& topology, const Analysis& analysis, Form,
                              Spelling spelling) {
  Tracing tracing(Role::required_forces, model, topology, analysis, Form::matrix, {}, spelling);
  const std::vector<Expr> given = tracing.inputs(Array::zdd, tracing.size());
  const std::vector<Expr> tau = tracing.inputs(Array::tau, tracing.size());
  tracing.outputs(Array::required,
                  tracing.in(Step::accelerations, [&] { return required_forces(tracing.system, given, tau); }));
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
