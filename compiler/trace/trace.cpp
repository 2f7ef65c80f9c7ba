#include "compiler/trace/trace.hpp"

#include <functional>
#include <utility>
#include <vector>

#include "compiler/model/tyres.hpp"
#include "compiler/program/in_threads.hpp"
#include "compiler/solver/layout.hpp"
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

/// Traces of the programs beside the accelerations, to be run in any order.
void add_other_traces(const Model& model, const Topology& topology, const Analysis& analysis, Spelling spelling,
                      Programs& programs, std::vector<std::function<void()>>& traces) {
  const auto add = [&](auto trace_one, Program& program) {
    traces.emplace_back(
        [&, trace_one, spelling] { program = trace_one(model, topology, analysis, programs.form, spelling); });
  };
  if (model.solver.is_implicit())
    traces.emplace_back([&, spelling] {
      auto [tangents, changes] = trace_implicit(model, topology, analysis, spelling);
      programs.tangents = std::move(tangents);
      programs.changes = std::move(changes);
    });
  add(trace_closure, programs.closure);
  if (!topology.loops.empty()) add(trace_closure_terms, programs.closure_terms);
  add(trace_multipliers, programs.multipliers);
  add(trace_outputs, programs.outputs);
  if (!model.sampled.empty()) add(trace_sampled, programs.sampled);
  if (has_inverse_dynamics(model, topology, analysis)) add(trace_inverse_dynamics, programs.inverse_dynamics);
  const SolverLayout layout = solver_layout(model, topology, analysis);
  if (layout.maps_actuators) add(trace_actuators, programs.actuators);
  if (layout.pivots_actuators) add(trace_required_forces, programs.required_forces);
  if (!tyres_on_host(model).empty()) add(trace_ground_places, programs.ground_places);
}

}  // namespace

WholePrograms trace(const Model& model, const Topology& topology, const Analysis& analysis,
                    std::optional<TracedRecursion> recursion) {
  WholePrograms whole;
  Programs& programs = whole.programs;
  programs.form = recursion ? Form::recursive : Form::matrix;
  std::vector<std::function<void()>> traces;
  // The frozen and the chosen partition are in one form, so that both are the same equations.
  if (recursion) {
    programs.accelerations = std::move(recursion->program);
    if (chooses(topology))
      traces.emplace_back([&] {
        programs.accelerations_chosen =
            trace_recursive_accelerations(model, topology, analysis, Role::accelerations_chosen, recursion->choices);
      });
    traces.emplace_back([&] { whole.around_laws = trace_around_laws(model, topology, analysis, recursion->choices); });
  } else {
    const auto traced = [&](Role role) { return trace_matrix_accelerations(model, topology, analysis, role); };
    traces.emplace_back([&, traced] { programs.accelerations = traced(Role::accelerations); });
    if (chooses(topology))
      traces.emplace_back([&, traced] { programs.accelerations_chosen = traced(Role::accelerations_chosen); });
  }
  add_other_traces(model, topology, analysis, Spelling::fast, programs, traces);
  in_threads(traces.size(), [&](std::size_t i) { traces[i](); });
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
  std::vector<std::function<void()>> traces = {[&] { programs.accelerations = accelerations(Role::accelerations); }};
  if (chooses(topology))
    traces.emplace_back([&] { programs.accelerations_chosen = accelerations(Role::accelerations_chosen); });
  add_other_traces(model, topology, analysis, Spelling::reading, programs, traces);
  in_threads(traces.size(), [&](std::size_t i) { traces[i](); });
  return programs;
}

AlikeInputs alike_inputs(const Model& model, const Topology& topology, const WholePrograms& whole) {
  if (whole.programs.form == Form::matrix) return {};
  const std::vector<SharedLaw> laws = whole.around_laws ? whole.around_laws->laws : std::vector<SharedLaw>();
  return {mirrored_inputs(model, topology, laws), twin_inputs(model, topology, laws)};
}

}  // namespace mbgen
