#include "compiler/choose/cheapest_recursion.hpp"

#include <utility>

#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// Operations of a program without its repeated values, which passes remove.
long operations_of(const Program& program) {
  return count_operations(merge_equal_values(remove_dead_values(program))).total();
}

}  // namespace

TracedRecursion cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto traced = [&](RecursionChoices choices) {
    return TracedRecursion{trace_recursive_accelerations(model, topology, analysis, Role::accelerations, choices),
                           choices};
  };
  TracedRecursion cheapest = traced({});
  long least = operations_of(cheapest.program);
  const auto compare = [&](RecursionChoices choices, long least_saving) {
    TracedRecursion other = traced(choices);
    const long count = operations_of(other.program);
    if (count + least_saving > least) return;
    cheapest = std::move(other);
    least = count;
  };
  if (!topology.blocks.empty()) {
    compare({.subtrees = true, .centres = false}, 1);
    compare({.subtrees = false, .centres = true}, 1);
    compare({.subtrees = false, .centres = false}, 1);
  }
  for (bool RecursionChoices::*treatment :
       {&RecursionChoices::outer_arms, &RecursionChoices::arm_runs, &RecursionChoices::in_plane}) {
    RecursionChoices without = cheapest.choices;
    without.*treatment = false;
    if (topology.blocks.empty() && treatment != &RecursionChoices::arm_runs)
      cheapest.choices = without;  // a treatment of bodies of blocks: the program is the same
    else
      compare(without, 0);  // the body's own forces keep their names
  }
  return cheapest;
}

Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  return form == Form::matrix ? trace_matrix_accelerations(model, topology, analysis, Role::accelerations)
                              : cheapest_recursion(model, topology, analysis).program;
}

WholePrograms traced_programs(const Model& model, const Topology& topology, const Analysis& analysis,
                              std::optional<Form> form) {
  std::optional<TracedRecursion> recursion;
  if (form.value_or(form_of(topology, analysis)) == Form::recursive)
    recursion = cheapest_recursion(model, topology, analysis);
  return trace(model, topology, analysis, std::move(recursion));
}

Programs programs_for_reading(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  std::optional<RecursionChoices> choices;
  if (form == Form::recursive) choices = cheapest_recursion(model, topology, analysis).choices;
  return trace_for_reading(model, topology, analysis, choices);
}

}  // namespace mbgen
