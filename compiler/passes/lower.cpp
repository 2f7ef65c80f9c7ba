#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "compiler/pairs/pairs.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/program/in_threads.hpp"

namespace mbgen {
namespace {

/// Share of the code, by size_of_code, up to which pairs are worth it: with left and right alone the truck took 1 %
/// fewer bytes than without; at 0.90 and less coach.json and others took 19 % fewer.
constexpr double kWorthPairs = 0.93;

/// A pass on programs by themselves, the largest first. Dead values go each time: what a pass replaces stays behind,
/// and would count.
template <class Run>
void run_on(std::span<Program* const> programs, const Run& run) {
  std::vector<Program*> order(programs.begin(), programs.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const Program* a, const Program* b) { return a->nodes.size() > b->nodes.size(); });
  in_threads(order.size(), [&](std::size_t i) { *order[i] = remove_dead_values(run(std::move(*order[i]))); });
}

template <auto run>
WholePrograms on_each(WholePrograms whole, const AlikeInputs&) {
  run_on(solver_programs(whole), run);
  return whole;
}

/// The same of the accelerations alone, where a pass takes longer than it gains in programs that run less often.
template <auto run>
WholePrograms on_accelerations(WholePrograms whole, const AlikeInputs&) {
  std::vector<Program*> programs = {&whole.programs.accelerations};
  if (whole.around_laws) programs.push_back(&whole.around_laws->program);
  run_on(programs, run);
  return whole;
}

/// None where no pair is worth it.
std::optional<PairedAccelerations> folded(Program program, bool holds_twins, bool holds_sides) {
  if (program.outputs.empty()) return {};
  return PairedAccelerations{remove_dead_values(std::move(program)), holds_twins, holds_sides};
}

/// Left and right as pairs, or twins and then left and right of what they leave: what takes less code.
WholePrograms with_pairs_folded(WholePrograms whole, const AlikeInputs& alike) {
  const Program& program = whole.accelerations_of_text();
  std::optional<PairedAccelerations> sides, twins;
  in_threads(2, [&](std::size_t task) {
    if (task == 0) {
      sides = folded(fold_pairs(program, alike.mirror), false, true);
      return;
    }
    twins = folded(fold_twins(program, alike.twins), true, false);
    if (!twins) return;
    if (auto both = folded(fold_pairs(twins->program, alike.mirror), true, true)) twins = std::move(both);
  });
  whole.in_pairs = std::move(sides);
  if (!twins) return whole;
  if (!whole.in_pairs || size_of_code(twins->program) < size_of_code(whole.in_pairs->program))
    whole.in_pairs = std::move(twins);
  return whole;
}

/// Pairs that do not pay leave no trace.
WholePrograms with_pairs_that_pay(WholePrograms whole, const AlikeInputs&) {
  if (!whole.in_pairs) return whole;
  const double most = kWorthPairs * static_cast<double>(size_of_code(whole.accelerations_of_text()));
  if (static_cast<double>(size_of_code(whole.in_pairs->program)) > most) whole.in_pairs.reset();
  return whole;
}

WrittenPrograms with_derived_constants_of_text(WrittenPrograms written) {
  written.programs.derived_constants =
      take_out_derived(solver_programs(written), Array::par, name_of(Role::derived_constants));
  return with_numbers_of_pairs(std::move(written));
}

WrittenPrograms contracted(WrittenPrograms written) {
  run_on(solver_programs(written), contract);
  return with_numbers_of_pairs(std::move(written));
}

constexpr WholePass kWholePasses[] = {
    {"dead-values", on_each<remove_dead_values>},
    {"equal-values", on_each<merge_equal_values>},
    {"shorter-forms", on_accelerations<write_shorter_forms>},
    {"divisions", on_each<merge_divisions>},
    {"pairs", with_pairs_folded},  // before sums, which factor left and right apart
    {"sums", on_each<factor_sums>},
    {"optimised", on_each<factor_sums>},  // sums of what that left
    {"equal-sums", on_each<merge_equal_values>},
    {"shorter-sums", on_accelerations<write_shorter_forms>},
    {"pairs-kept", with_pairs_that_pay},
};

constexpr WrittenPass kWrittenPasses[] = {
    {"derived-constants", with_derived_constants_of_text},
    {"contraction", contracted},
};

}  // namespace

std::span<const WholePass> whole_passes() { return kWholePasses; }

std::span<const WrittenPass> written_passes() { return kWrittenPasses; }

WholePrograms optimise(WholePrograms whole, const AlikeInputs& alike) {
  for (const WholePass& pass : kWholePasses) whole = pass.run(std::move(whole), alike);
  return whole;
}

Program optimise(const Program& program) {
  WholePrograms whole;
  whole.programs.accelerations = program;
  return optimise(std::move(whole)).programs.accelerations;
}

Programs with_derived_constants(Programs programs) {
  programs.derived_constants =
      take_out_derived(solver_programs(programs), Array::par, name_of(Role::derived_constants));
  return programs;
}

}  // namespace mbgen
