#include "compiler/choose/cheapest_recursion.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/in_threads.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// Operations of a program without its repeated values, which passes remove.
long operations_of(const Program& program) {
  return count_operations(merge_equal_values(remove_dead_values(program))).total();
}

/// Whether two programs do the same, so that they count the same.
bool are_same(const Program& a, const Program& b) {
  const auto is_same_value = [](const Node& one, const Node& other) {
    return one.op == other.op && std::ranges::equal(one.operands, other.operands) && one.constant == other.constant &&
           one.input == other.input;
  };
  const auto is_same_output = [](const OutputValue& one, const OutputValue& other) { return one.value == other.value; };
  return std::ranges::equal(a.nodes, b.nodes, is_same_value) &&
         std::ranges::equal(a.outputs, b.outputs, is_same_output);
}

struct Candidate {
  TracedRecursion recursion;
  long operations = 0;
};

}  // namespace

TracedRecursion cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto traced = [&](RecursionChoices choices) {
    return TracedRecursion{trace_recursive_accelerations(model, topology, analysis, Role::accelerations, choices),
                           choices};
  };
  std::vector<RecursionChoices> firsts(1);
  if (!topology.blocks.empty())
    for (const auto& [subtrees, centres] : {std::pair(true, false), {false, true}, {false, false}})
      firsts.push_back({.subtrees = subtrees, .centres = centres});
  std::vector<Candidate> candidates(firsts.size());
  in_threads(firsts.size(), [&](std::size_t i) { candidates[i].recursion = traced(firsts[i]); });
  std::vector<std::size_t> first_alike(firsts.size());
  for (std::size_t i = 0; i < firsts.size(); ++i)
    while (!are_same(candidates[first_alike[i]].recursion.program, candidates[i].recursion.program)) ++first_alike[i];
  in_threads(firsts.size(), [&](std::size_t i) {
    if (first_alike[i] == i) candidates[i].operations = operations_of(candidates[i].recursion.program);
  });
  for (std::size_t i = 0; i < firsts.size(); ++i) candidates[i].operations = candidates[first_alike[i]].operations;
  // Of equally short ones the first.
  Candidate cheapest =
      std::move(*std::min_element(candidates.begin(), candidates.end(),
                                  [](const Candidate& a, const Candidate& b) { return a.operations < b.operations; }));
  for (bool RecursionChoices::*treatment :
       {&RecursionChoices::outer_arms, &RecursionChoices::arm_runs, &RecursionChoices::in_plane}) {
    RecursionChoices without = cheapest.recursion.choices;
    without.*treatment = false;
    if (topology.blocks.empty() && treatment != &RecursionChoices::arm_runs) {
      cheapest.recursion.choices = without;  // a treatment of bodies of blocks: the program is the same
      continue;
    }
    Candidate other{traced(without)};
    other.operations = are_same(other.recursion.program, cheapest.recursion.program)
                           ? cheapest.operations
                           : operations_of(other.recursion.program);
    if (other.operations <= cheapest.operations) cheapest = std::move(other);  // the body's own forces keep their names
  }
  return std::move(cheapest.recursion);
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
