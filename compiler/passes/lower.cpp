#include <array>
#include <span>
#include <utility>

#include "compiler/pairs/pairs.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

using OnProgram = Program (*)(const Program&);

/// Share of the code, by size_of_code, up to which pairs are worth it: with left and right alone the truck took 1 %
/// fewer bytes than without; at 0.90 and less coach.json and others took 19 % fewer.
constexpr double kWorthPairs = 0.93;

/// A pass on programs by themselves. Dead values go each time: what a pass replaces stays behind, and would count.
void run_on(std::span<Program* const> programs, OnProgram run) {
  for (Program* program : programs) *program = remove_dead_values(run(*program));
}

template <OnProgram run>
Programs on_each(Programs programs) {
  run_on(solver_programs(programs), run);
  return programs;
}

/// The same of the accelerations alone, where a pass takes longer than it gains in programs that run less often.
template <OnProgram run>
Programs on_accelerations(Programs programs) {
  run_on(std::array{&programs.accelerations, &programs.around_laws}, run);
  return programs;
}

/// The accelerations of the text: those around laws that elements share.
const Program& written_accelerations(const Programs& programs) {
  return programs.laws.empty() ? programs.accelerations : programs.around_laws;
}

/// Left and right as pairs, or twins and then left and right of what they leave: what takes less code.
Programs with_pairs_folded(Programs programs) {
  const Program& program = written_accelerations(programs);
  programs.in_pairs = remove_dead_values(fold_pairs(program, programs.mirror));
  Program twins = remove_dead_values(fold_twins(program, programs.twins));
  if (twins.outputs.empty()) return programs;
  Program both = remove_dead_values(fold_pairs(twins, programs.mirror));
  if (!both.outputs.empty()) twins = std::move(both);
  programs.holds_twins = programs.in_pairs.outputs.empty() || size_of_code(twins) < size_of_code(programs.in_pairs);
  if (programs.holds_twins) programs.in_pairs = std::move(twins);
  return programs;
}

/// Pairs that do not pay leave no trace.
Programs with_pairs_that_pay(Programs programs) {
  if (programs.in_pairs.outputs.empty()) return programs;
  const double most = kWorthPairs * static_cast<double>(size_of_code(written_accelerations(programs)));
  if (static_cast<double>(size_of_code(programs.in_pairs)) > most) programs.in_pairs = {};
  return programs;
}

Programs with_derived_constants(Programs programs) {
  programs.derived_constants = take_out_derived(solver_programs(programs), Array::par, "derived_constants");
  return programs;
}

constexpr Pass kPasses[] = {
    {"dead-values", "values that no output needs taken out", Lowered::whole, on_each<remove_dead_values>},
    {"equal-values", "values that are equal by algebra merged", Lowered::whole, on_each<merge_equal_values>},
    {"shorter-forms", "accelerations: values written as one operation on others", Lowered::whole,
     on_accelerations<write_shorter_forms>},
    {"divisions", "divisions by one value merged", Lowered::whole, on_each<merge_divisions>},
    {"pairs", "left and right of a mirror, or twins, in two lanes", Lowered::whole, with_pairs_folded},
    {"sums", "sums factored", Lowered::whole, on_each<factor_sums>},
    {"optimised", "sums of what that left factored", Lowered::whole, on_each<factor_sums>},
    {"equal-sums", "equal values of what that left merged", Lowered::whole, on_each<merge_equal_values>},
    {"shorter-sums", "accelerations: values of what that left written shorter", Lowered::whole,
     on_accelerations<write_shorter_forms>},
    {"pairs-kept", "pairs left out that do not pay", Lowered::whole, with_pairs_that_pay},
    {"derived-constants", "what depends on parameters alone taken out", Lowered::lean, with_derived_constants},
    {"contraction", "products taken into sums, rounded once", Lowered::emitted, on_each<contract>},
};

}  // namespace

std::span<const Pass> passes() { return kPasses; }

Program optimise(const Program& program) {
  Programs programs;
  programs.accelerations = program;
  for (const Pass& pass : kPasses)
    if (pass.result == Lowered::whole) programs = pass.run(std::move(programs));
  return std::move(programs.accelerations);
}

}  // namespace mbgen
