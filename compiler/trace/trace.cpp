#include "compiler/trace/trace.hpp"

#include <utility>

#include "compiler/model/host_ground.hpp"
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

Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  return form == Form::matrix ? trace_matrix_accelerations(model, topology, analysis, Role::accelerations)
                              : cheapest_recursion(model, topology, analysis).program;
}

Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form) {
  Programs programs;
  programs.form = form.value_or(form_of(topology, analysis));
  const bool chooses = (!topology.loops.empty() || !topology.balls.empty()) && chooses_again(topology);
  // The frozen and the chosen partition are in one form, so that both are the same equations.
  if (programs.form == Form::matrix) {
    programs.accelerations = trace_matrix_accelerations(model, topology, analysis, Role::accelerations);
    if (chooses)
      programs.accelerations_chosen = trace_matrix_accelerations(model, topology, analysis, Role::accelerations_chosen);
  } else {
    auto [program, choices] = cheapest_recursion(model, topology, analysis);
    programs.accelerations = std::move(program);
    if (chooses)
      programs.accelerations_chosen =
          trace_recursive_accelerations(model, topology, analysis, Role::accelerations_chosen, choices);
    programs.laws = plan_shared_laws(model);
    programs.mirror = mirrored_inputs(model, topology, programs.laws);
    programs.twins = twin_inputs(model, topology, programs.laws);
    if (!programs.laws.empty()) {
      programs.around_laws =
          trace_recursive_accelerations(model, topology, analysis, Role::accelerations, choices, programs.laws);
      trace_shared_laws(model, programs.laws, programs.around_laws);
    }
  }
  programs.closure = trace_closure(model, topology, analysis, programs.form);
  if (!topology.loops.empty()) programs.closure_terms = trace_closure_terms(model, topology, analysis, programs.form);
  programs.multipliers = trace_multipliers(model, topology, analysis, programs.form);
  programs.outputs = trace_outputs(model, topology, analysis, programs.form);
  if (!model.sampled.empty()) programs.sampled = trace_sampled(model, topology, analysis, programs.form);
  if (!tyres_on_host(model).empty())
    programs.ground_places = trace_ground_places(model, topology, analysis, programs.form);
  if (model.solver.is_implicit()) {
    auto [tangents, changes] = trace_implicit(model, topology, analysis);
    programs.tangents = std::move(tangents);
    programs.changes = std::move(changes);
  }
  return programs;
}

}  // namespace mbgen
