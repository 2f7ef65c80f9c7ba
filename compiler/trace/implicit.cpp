// The programs of an implicit step: its equations, and the changes that solve them.

#include "compiler/formulation/implicit/implicit.hpp"

#include <map>

#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Numbers of the values that the equations hold, each once; constants stay in the programs.
class EntryNumbers {
 public:
  /// The equations' values become outputs of their program.
  EntryNumbers(Tracing& tracing, ImplicitEquations<Expr>& equations) {
    detail::each_entry(equations, [&](const Expr& value) {
      if (value.is_constant()) return;
      const auto [entry, is_new] = number_.emplace(value.value(tracing.builder), static_cast<int>(number_.size()));
      if (is_new) tracing.output(Array::tangent, entry->second, value);
    });
  }
  /// Puts inputs of another program in place of the values, and constants without the names that their own program
  /// gave them. from: their own program.
  void take_as_inputs(Tracing& from, Tracing& to, ImplicitEquations<Expr>& equations) const {
    detail::each_entry(equations, [&](Expr& value) {
      value = value.is_constant() ? value.named(-1, nullptr)
                                  : to.input(Array::tangent, number_.at(value.value(from.builder)));
    });
  }

 private:
  std::map<ValueId, int> number_;
};

}  // namespace

ImplicitPrograms trace_implicit(const Model& model, const Topology& topology, const Analysis& analysis,
                                Spelling spelling) {
  ImplicitPrograms programs;
  Tracing tracing(Role::tangents, model, topology, analysis, Form::matrix, {}, spelling);
  WatchedEquations<Expr> watched = tracing.in(Step::tangents, [&] {
    return implicit_equations(tracing.system, analysis.blocks, analysis.driven, tracing.input(Array::step, 0));
  });
  const EntryNumbers numbers(tracing, watched.equations);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) tracing.output_pivot(b, watched.quality[b]);
  tracing.outputs(Array::inertia, watched.pivot);
  tracing.outputs(Array::state_pivot, watched.state_pivot);

  Tracing changing(Role::changes, model, topology, analysis, Form::matrix, {}, spelling);
  numbers.take_as_inputs(tracing, changing, watched.equations);
  programs.tangents = tracing.builder.finish_in_canonical_order();
  const auto step = changing.annotator.step(Step::tangents);
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
