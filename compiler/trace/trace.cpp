#include "compiler/trace/trace.hpp"

#include <utility>

#include "compiler/model/tyres.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {

bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis) {
  const LeastOperations least = least_operations(topology, analysis);
  return form == Form::matrix ? is_worth_writing(least.matrix, least.recursive)
                              : is_worth_writing(least.recursive, least.matrix);
}

Form form_of(const Topology& topology, const Analysis& analysis) {
  return is_worth_writing(Form::recursive, topology, analysis) ? Form::recursive : Form::matrix;
}

namespace {

/// Whether blocks or balls are chosen again while a solver runs.
bool chooses(const Topology& topology) {
  return (!topology.loops.empty() || !topology.balls.empty()) && chooses_again(topology);
}

/// Adds every program but the accelerations.
void trace_others(const Model& model, const Topology& topology, const Analysis& analysis, Spelling spelling,
                  Programs& programs) {
  const Form form = programs.form;
  programs.closure = trace_closure(model, topology, analysis, form, spelling);
  if (!topology.loops.empty()) programs.closure_terms = trace_closure_terms(model, topology, analysis, form, spelling);
  programs.multipliers = trace_multipliers(model, topology, analysis, form, spelling);
  programs.outputs = trace_outputs(model, topology, analysis, form, spelling);
  if (!model.sampled.empty()) programs.sampled = trace_sampled(model, topology, analysis, form, spelling);
  if (!tyres_on_host(model).empty())
    programs.ground_places = trace_ground_places(model, topology, analysis, form, spelling);
  if (model.solver.is_implicit()) {
    auto [tangents, changes] = trace_implicit(model, topology, analysis, spelling);
    programs.tangents = std::move(tangents);
    programs.changes = std::move(changes);
  }
}

}  // namespace

WholePrograms trace(const Model& model, const Topology& topology, const Analysis& analysis,
                    std::optional<TracedRecursion> recursion) {
  WholePrograms whole;
  Programs& programs = whole.programs;
  programs.form = recursion ? Form::recursive : Form::matrix;
  // The frozen and the chosen partition are in one form, so that both are the same equations.
  if (recursion) {
    programs.accelerations = std::move(recursion->program);
    if (chooses(topology))
      programs.accelerations_chosen =
          trace_recursive_accelerations(model, topology, analysis, Role::accelerations_chosen, recursion->choices);
    whole.around_laws = trace_around_laws(model, topology, analysis, recursion->choices);
  } else {
    programs.accelerations = trace_matrix_accelerations(model, topology, analysis, Role::accelerations);
    if (chooses(topology))
      programs.accelerations_chosen = trace_matrix_accelerations(model, topology, analysis, Role::accelerations_chosen);
  }
  trace_others(model, topology, analysis, Spelling::fast, programs);
  return whole;
}

Programs trace_for_reading(const Model& model, const Topology& topology, const Analysis& analysis,
                           std::optional<RecursionChoices> choices) {
  Programs programs;
  programs.form = choices ? Form::recursive : Form::matrix;
  const auto accelerations = [&](Role role) {
    return choices ? trace_recursive_accelerations(model, topology, analysis, role, *choices, {}, Spelling::reading)
                   : trace_matrix_accelerations(model, topology, analysis, role, Spelling::reading);
  };
  programs.accelerations = accelerations(Role::accelerations);
  if (chooses(topology)) programs.accelerations_chosen = accelerations(Role::accelerations_chosen);
  trace_others(model, topology, analysis, Spelling::reading, programs);
  return programs;
}

AlikeInputs alike_inputs(const Model& model, const Topology& topology, const WholePrograms& whole) {
  if (whole.programs.form == Form::matrix) return {};
  const std::vector<SharedLaw> laws = whole.around_laws ? whole.around_laws->laws : std::vector<SharedLaw>();
  return {mirrored_inputs(model, topology, laws), twin_inputs(model, topology, laws)};
}

}  // namespace mbgen
