// The programs of an implicit step: its equations, and the changes that solve them.

#include "compiler/formulation/implicit.hpp"

#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Puts inputs of another program in place of the values, numbered as they come; constants stay.
void take_as_inputs(Tracing& tracing, ImplicitEquations<Expr>& equations) {
  int next = 0;
  detail::each_entry(equations, [&](Expr& value) {
    if (!value.is_constant()) value = tracing.input(Array::tangent, next++);
  });
}

}  // namespace

ImplicitPrograms trace_implicit(const Model& model, const Topology& topology, const Analysis& analysis) {
  ImplicitPrograms programs;
  Tracing tracing(Role::tangents, model, topology, analysis, Form::matrix);
  WatchedEquations<Expr> watched = tracing.in(Step::tangents, [&] {
    return implicit_equations(tracing.system, analysis.blocks, analysis.driven, tracing.input(Array::step, 0));
  });
  int next = 0;
  detail::each_entry(watched.equations, [&](Expr& value) {
    if (!value.is_constant()) tracing.output(Array::tangent, next++, value);
  });
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) tracing.output_pivot(b, watched.quality[b]);
  tracing.outputs(Array::inertia, watched.pivot);
  tracing.outputs(Array::state_pivot, watched.state_pivot);
  programs.tangents = tracing.builder.finish_in_canonical_order();

  Tracing changing(Role::changes, model, topology, analysis, Form::matrix);
  take_as_inputs(changing, watched.equations);
  const auto step = changing.scribe.step(Step::tangents);
  const int n = topology.size(), states = auxiliary_state_count(model);
  const ImplicitRates<Expr> rates{changing.inputs(Array::zd, n), changing.inputs(Array::zdd, n),
                                  changing.inputs(Array::xd, states)};
  const ImplicitRates<Expr> changes = implicit_changes(topology, free_coordinates(topology, analysis),
                                                       watched.equations, changing.input(Array::step, 0), rates);
  changing.outputs(Array::zdd, changes.zdd);
  changing.outputs(Array::xd, changes.xd);
  programs.changes = changing.builder.finish_in_canonical_order();
  return programs;
}

}  // namespace mbgen
