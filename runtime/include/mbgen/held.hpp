#pragma once
// Loop closures whose independent coordinates the caller holds: an integrator outside of the solver that has them as
// its states, as an importer of an FMU does. `System` is described in blocks.hpp.

#include "mbgen/motion.hpp"

namespace mbgen {

/// The smallest pivot of a block's held coordinates, over the largest that they had, below which others are chosen.
constexpr double kWornPivot = 0.15;
/// The same over the smallest pivot of full pivoting at this position: a smaller share is bad from the start.
constexpr double kBadPivot = 0.01;

namespace solver_detail {

/// Whether block b has the independent coordinates of the frozen partition. held: per coordinate.
template <class System>
bool holds_frozen(int b, const unsigned char* held) noexcept {
  for (int k = 0; k < System::kFreeDirections; ++k) {
    if (System::kFreeDirection[k].block == b && held[System::kFreeDirection[k].coordinate] == 0) return false;
  }
  return true;
}

/// Factors of block b of `terms`, in place, with every coordinate dependent that is neither driven nor held.
template <class System>
LoopFactorsOf<RealOf<System>> held_factors(int b, const unsigned char* held, typename System::ClosureTerms& terms,
                                           BlockFactors<System>& factors) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  unsigned char fixed[System::kBlockCoordinates];
  for (int c = 0; c < block.coordinates; ++c) {
    const int place = block.first_coordinate + c;
    fixed[c] = System::kBlockDriven[place] != 0 || held[System::kBlockCoordinate[place]] != 0 ? 1 : 0;
  }
  LoopFactorsOf<RealOf<System>> loop;
  loop.equations = block.equations;
  loop.coordinates = block.coordinates;
  loop.matrix = terms.Jz + block.first_jacobian;
  loop.rows = factors.rows + block.first_equation;
  loop.columns = factors.columns + block.first_coordinate;
  factorise(loop, block.rank, fixed, kRankTolerance<RealOf<System>>, PivotOrder<System>::of(b));
  return loop;
}

/// Corrections that leave the held coordinates where they are. Fails: loop_singular.
template <class System>
Status correct_held(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                    const typename System::State& state, const unsigned char* held,
                    typename System::Closure& closure) noexcept {
  const bool is_other = in_other_chart(state);  // which the frozen program does not know
  const auto is_frozen = [&](int b) {
    return !is_other && closure.pivot[b] >= kPivotThreshold<RealOf<System>> && holds_frozen<System>(b, held);
  };
  bool all_frozen = true;
  for (int b = 0; b < System::kBlocks; ++b) all_frozen = all_frozen && is_frozen(b);
  if (all_frozen) return {};
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  if (is_other) copy(terms.Phi, closure.residual, System::kEquations);
  CorrectionWork<System> work;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (is_frozen(b)) continue;
    const LoopFactorsOf<RealOf<System>> loop = held_factors<System>(b, held, terms, work.factors);
    if (loop.rank < System::kBlockLayout[b].rank) return {Code::loop_singular, b};
    correct_block<System, Correction::of_dependents>(b, loop, terms, state, work, closure);
  }
  return {};
}

/// Takes for block b the independent coordinates that full pivoting leaves.
template <class System>
void hold_best(int b, const LoopFactorsOf<RealOf<System>>& best, unsigned char* held) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  for (int c = 0; c < block.coordinates; ++c) {
    held[coordinate[c]] = System::kBlockDriven[block.first_coordinate + c] != 0 ? 0 : 1;
  }
  for (int k = 0; k < best.rank; ++k) held[coordinate[best.columns[k]]] = 0;
}

}  // namespace solver_detail

/// Closes every loop from a near guess: held coordinates keep their positions and velocities.
/// held: per coordinate, 1 for the independent ones.
/// Fails: as project_state; loop_not_closed also when a coordinate would move by more than kLargestCorrection; the
/// state is then unchanged.
template <class System>
Status project_holding(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const unsigned char* held, typename System::State& state) noexcept {
  using namespace solver_detail;
  if constexpr (kChoosesAgain<System>) {
    const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
    if (!arguments.ok()) return arguments;
    typename System::State trial;
    copy_state<System>(state, trial);
    const auto correct = [&](typename System::Closure& closure) {
      return correct_held<System>(parameters, inputs, trial, held, closure);
    };
    const Status status = close_loops<System>(parameters, inputs, trial, true, correct);
    if (!status.ok()) return status;
    const int block = moved_far<System>(state, trial);
    if (block >= 0) return {Code::loop_not_closed, block};
    copy_state<System>(trial, state);
    return {};
  } else {
    static_cast<void>(held);
    return without_notice(project_motion<System>(parameters, inputs, state));
  }
}

/// Chooses other independent coordinates for the blocks whose held ones serve badly at a closed state.
/// reference: per block, the largest that its smallest pivot was since the choice; 0 at first.
/// Result: whether a choice has changed. Singular blocks keep theirs.
template <class System>
bool choose_held(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& state, unsigned char* held, double* reference) noexcept {
  bool has_changed = false;
  if constexpr (kChoosesAgain<System>) {
    using namespace solver_detail;
    typename System::ClosureTerms terms, factored;
    System::closure_terms(parameters, inputs, state, terms);
    BlockFactors<System> factors;
    for (int b = 0; b < System::kBlocks; ++b) {
      const BlockLayout& block = System::kBlockLayout[b];
      if (block.free == 0) continue;
      const int entries = block.equations * block.coordinates;
      copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, entries);
      const LoopFactorsOf<RealOf<System>> now = held_factors<System>(b, held, factored, factors);
      const double pivot = now.rank < block.rank ? 0 : static_cast<double>(smallest_pivot(now));
      reference[b] = pivot > reference[b] ? pivot : reference[b];
      copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, entries);
      const LoopFactorsOf<RealOf<System>> best = factors.factors_of(b, factored);
      if (best.rank < block.rank) continue;
      const double largest = static_cast<double>(smallest_pivot(best));
      if (pivot >= kWornPivot * reference[b] && pivot >= kBadPivot * largest) continue;
      hold_best<System>(b, best, held);
      reference[b] = largest;
      has_changed = true;
    }
  }
  return has_changed;
}

}  // namespace mbgen
