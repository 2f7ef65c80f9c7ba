#include "workbench/describe/counts.hpp"

#include <utility>

#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {
namespace {

/// Optional treatments of the recursive form by name, each switched off alone.
constexpr std::pair<const char*, RecursionChoices> kTreatments[] = {
    {"rotors held by their base", {.rotors = false}},
    {"bodies of blocks held by the body below", {.subtrees = false}},
    {"bodies seen from their centres of mass", {.centres = false}},
    {"arms turn with their base", {.arms = false}},
    {"arms of other bodies of blocks turn with them", {.outer_arms = false}},
    {"arms outside blocks turn with their base", {.arm_runs = false}},
    {"bodies turning in a plane turn with their base", {.in_plane = false}}};

}  // namespace

long count_operations_of(const Compilation& c, Form form) {
  if (form == c.programs.form) return count_operations(c.programs.accelerations).total();
  if (!is_worth_writing(form, c.topology, c.analysis)) return 0;
  return count_operations(optimise(trace_accelerations(c.model, c.topology, c.analysis, form))).total();
}

std::vector<Saving> count_savings(const Compilation& c) {
  std::vector<Saving> savings;
  if (c.programs.form != Form::recursive) return savings;
  const long with = count_operations(c.programs.accelerations).total();
  for (const auto& [name, without] : kTreatments) {
    const Program program =
        trace_recursive_accelerations(c.model, c.topology, c.analysis, Role::accelerations, without);
    savings.push_back({name, count_operations(optimise(program)).total(), with});
  }
  return savings;
}

}  // namespace mbgen
