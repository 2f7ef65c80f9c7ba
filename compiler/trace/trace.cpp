#include "compiler/trace/trace.hpp"

#include "compiler/trace/closure_programs.hpp"
#include "compiler/trace/given_state.hpp"
#include "compiler/trace/matrix.hpp"
#include "compiler/trace/recursive.hpp"

namespace mbgen {
namespace {

/// The frozen and the chosen partition in one form, so that both are the same equations.
void trace_all_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                             Programs& programs) {
  const bool chooses = (!topology.loops.empty() || !topology.balls.empty()) && chooses_again(topology);
  if (programs.form == Form::matrix) {
    programs.accelerations = trace_matrix_accelerations(model, topology, analysis, Partition::frozen);
    if (chooses)
      programs.accelerations_chosen = trace_matrix_accelerations(model, topology, analysis, Partition::chosen);
    return;
  }
  auto [program, choices] = cheapest_recursion(model, topology, analysis);
  programs.accelerations = std::move(program);
  if (chooses)
    programs.accelerations_chosen =
        trace_recursive_accelerations(model, topology, analysis, Partition::chosen, choices);
}

}  // namespace

bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis) {
  const LeastOperations least = least_operations(topology, analysis);
  return form == Form::matrix ? is_worth_writing(least.matrix, least.recursive)
                              : is_worth_writing(least.recursive, least.matrix);
}

Form form_of(const Topology& topology, const Analysis& analysis) {
  return is_worth_writing(Form::recursive, topology, analysis) ? Form::recursive : Form::matrix;
}

Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  return form == Form::matrix ? trace_matrix_accelerations(model, topology, analysis, Partition::frozen)
                              : cheapest_recursion(model, topology, analysis).program;
}

std::vector<std::pair<std::string, Program>> trace_without(const Model& model, const Topology& topology,
                                                           const Analysis& analysis) {
  const std::pair<const char*, RecursionChoices> treatments[] = {
      {"rotors held by their base", {.rotors = false}},
      {"bodies of blocks held by the body below", {.subtrees = false}},
      {"bodies seen from their centres of mass", {.centres = false}},
      {"arms turn with their base", {.arms = false}},
  };
  std::vector<std::pair<std::string, Program>> programs;
  for (const auto& [name, without] : treatments)
    programs.emplace_back(name, trace_recursive_accelerations(model, topology, analysis, Partition::frozen, without));
  return programs;
}

Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form) {
  Programs programs;
  programs.form = form.value_or(form_of(topology, analysis));
  trace_all_accelerations(model, topology, analysis, programs);
  programs.closure = trace_closure(model, topology, analysis, programs.form);
  if (!topology.loops.empty()) programs.closure_terms = trace_closure_terms(model, topology, analysis, programs.form);
  programs.multipliers = trace_multipliers(model, topology, analysis, programs.form);
  programs.outputs = trace_outputs(model, topology, analysis, programs.form);
  for (int i : free_coordinates(topology, analysis))
    programs.free_direction_coordinate.push_back(topology.bodies[i].coordinate);
  int equation = 0;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    programs.free_directions_of_block.push_back(static_cast<int>(analysis.blocks[b].independent.size()));
    programs.residual_equation_of.push_back(equation);
    equation += topology.blocks[b].equations;
  }
  return programs;
}

}  // namespace mbgen
