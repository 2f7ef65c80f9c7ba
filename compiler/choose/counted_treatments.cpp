#include "compiler/choose/counted_treatments.hpp"

#include <map>
#include <utility>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// The treatments of the recursive form by name, each taken away.
constexpr std::pair<const char*, RecursionChoices> kTreatments[] = {
    {"rotors held by their base", {.rotors = false}},
    {"bodies of blocks held by the body below", {.subtrees = false}},
    {"bodies seen from their centres of mass", {.centres = false}},
    {"arms turn with their base", {.arms = false}},
    {"arms of other bodies of blocks turn with them", {.outer_arms = false}},
    {"arms outside blocks turn with their base", {.arm_runs = false}},
    {"bodies turning in a plane turn with their base", {.in_plane = false}}};

}  // namespace

long count_operations_of(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  if (!is_worth_writing(form, topology, analysis)) return 0;
  return count_operations(optimise(trace_accelerations(model, topology, analysis, form))).total();
}

std::vector<Saving> count_savings(const Model& model, const Topology& topology, const Analysis& analysis, long with) {
  std::vector<Saving> savings;
  std::map<std::string, long> counted;  // a treatment that the model gives no place leaves the program of another one
  for (const auto& [name, without] : kTreatments) {
    const Program program = trace_recursive_accelerations(model, topology, analysis, Role::accelerations, without);
    const auto [count, is_new] = counted.try_emplace(dump(program));
    if (is_new) count->second = count_operations(optimise(program)).total();
    savings.push_back({name, count->second, with});
  }
  return savings;
}

}  // namespace mbgen
