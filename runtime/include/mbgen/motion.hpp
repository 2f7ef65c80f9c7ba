#pragma once
// Functions of a generated solver for integrators: rates and projections, with notices about near singular positions.
// `System` is described in blocks.hpp.

#include <limits>

#include "mbgen/solver.hpp"
#include "mbgen/solver/closure.hpp"

namespace mbgen {

/// Largest correction of a coordinate by the projection of a step (rad or m). In a motion that is followed at all it is
/// of the order of the fifth power of the step; a larger one would be a jump to another way of assembly.
template <class Real>
inline constexpr Real kLargestCorrection = Real(0.2);

namespace solver_detail {

/// Block with a coordinate without a motion that is farther than kLargestCorrection from its former value, or -1.
template <class System>
int moved_far(const typename System::State& from, const typename System::State& to) noexcept {
  constexpr RealOf<System> largest = kLargestCorrection<RealOf<System>>;
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
      const int i = System::kBlockCoordinate[c];
      if (System::kDriven[i] == 0 && !(std::abs(to.z[i] - from.z[i]) <= largest)) return b;
    }
  }
  return -1;
}

template <class System, Correction correction>
Status project(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
               typename System::State& state) noexcept {
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  Status status;
  if constexpr (System::kHasClosure) {
    typename System::State trial;
    copy_state<System>(state, trial);
    status = close_loops<System, correction>(parameters, inputs, trial);
    if (!status.ok()) return status;
    if constexpr (System::kBlocks > 0) {
      const int block = moved_far<System>(state, trial);
      if (block >= 0) return {Code::loop_not_closed, block};
    }
    copy_state<System>(trial, state);
  }
  return status;
}

}  // namespace solver_detail

/// solve_accelerations without joint forces from outside. Gives notices of chosen coordinates and singular positions.
template <class System>
Status solve_motion(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                    const typename System::State& state, typename System::Derivative& derivative) noexcept {
  static constexpr RealOf<System> kNoForces[System::kCoordinates] = {};
  typename System::Accelerations values;
  const Status status = solver_detail::evaluate<System>(parameters, inputs, state, kNoForces, values, derivative);
  if constexpr (System::kBlocks > 0) {
    if (status.code == Code::ok) return solver_detail::notice_at<System>(parameters, inputs, state, values.pivot);
  }
  return status;
}

/// project_state from a good guess, by the shortest corrections if corrections of dependents alone would move the
/// mechanism along its free directions. Gives notices. Fails: as project_state; loop_not_closed also if a coordinate
/// would move by more than kLargestCorrection.
template <class System>
Status project_motion(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      typename System::State& state) noexcept {
  using namespace solver_detail;
  return solver_detail::project<System, Correction::in_steps>(parameters, inputs, state);
}

namespace solver_detail {

/// Number of pivots of a block that are not small: these identify its coordinates at a singular position.
template <class System>
int large_pivots(int b, const LoopFactorsOf<RealOf<System>>& loop) noexcept {
  using Real = RealOf<System>;
  const Real least = kSingular<Real> * static_cast<Real>(System::kBlockLayout[b].pivot);
  int count = 0;
  while (count < loop.rank && std::abs(loop_detail::row_of(loop, count)[count]) >= least) ++count;
  return count;
}

/// Residuals of all blocks, and dz and zd by their pivots that are not small. Result: the smallest pivot of all, over
/// its typical value.
template <class System>
double correct_by_large_pivots(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                               const typename System::State& state, typename System::Closure& closure) noexcept {
  typename System::ClosureTerms terms, factored;
  System::closure_terms(parameters, inputs, state, terms);
  copy(terms.Phi, closure.residual, System::kEquations);
  CorrectionWork<System> work;
  double smallest = std::numeric_limits<double>::infinity();
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, block.equations * block.coordinates);
    const LoopFactorsOf<RealOf<System>> whole = work.factors.factors_of(b, factored);
    const int count = large_pivots<System>(b, whole);
    const double share = static_cast<double>(smallest_pivot(whole)) / block.pivot;
    smallest = whole.rank < block.rank ? 0 : share < smallest ? share : smallest;
    const LoopFactorsOf<RealOf<System>> loop = work.factors.factors_of(b, terms, count);
    correct_block<System, Correction::of_dependents>(b, loop, terms, state, work, closure);
  }
  return smallest;
}

}  // namespace solver_detail

/// Closes a state in the middle of a singular position, where two branches cross: by the pivots that are not small
/// there. Fails: loop_singular where more than the closure tolerance stays open, as it does where branches come close
/// and do not cross; not_a_number. The state is then unchanged. clearance: the smallest pivot at the given state, over
/// its typical value.
template <class System>
Status project_crossing(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        typename System::State& state, double& clearance) noexcept {
  using namespace solver_detail;
  using Real = RealOf<System>;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  typename System::State trial;
  copy_state<System>(state, trial);
  typename System::Closure closure;
  Real previous = std::numeric_limits<Real>::infinity();
  // Half as many as of a projection: each factorises twice.
  for (int iteration = 0; iteration < kNewtonIterations / 2; ++iteration) {
    System::closure(parameters, inputs, trial, closure);
    const double here = correct_by_large_pivots<System>(parameters, inputs, trial, closure);
    if (iteration == 0) clearance = here;
    const Misfit<Real> misfit = largest_residual<System>(closure, 0);
    if (misfit.size <= kSlightCorrection<Real> * closure_tolerance<System>()) {
      const Status status = accept<System>(closure, trial);
      if (status.ok()) copy_state<System>(trial, state);
      return status;
    }
    if (!(misfit.size < Real(0.5) * previous)) return {Code::loop_singular, block_of<System>(misfit.equation)};
    previous = misfit.size;
    apply_step<System>(closure, trial);
  }
  return {Code::loop_singular, 0};
}

namespace solver_detail {

/// Largest rank of a block, at least 1.
template <class System>
constexpr int most_pivots() noexcept {
  int most = 1;
  for (int b = 0; b < System::kBlocks; ++b) {
    most = System::kBlockLayout[b].rank > most ? System::kBlockLayout[b].rank : most;
  }
  return most;
}

}  // namespace solver_detail

/// Loop block that is on another side of a singular position at `to` than at `from`, or -1: see changes_side. inputs:
/// of the step between them. Requires: states that are finite and in the same charts.
template <class System>
int changed_side(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& from, const typename System::State& to) noexcept {
  using Real = RealOf<System>;
  typename System::ClosureTerms start, factored, end;
  System::closure_terms(parameters, inputs, from, start);
  System::closure_terms(parameters, inputs, to, end);
  solver_detail::BlockFactors<System> factors;
  constexpr int most = solver_detail::most_pivots<System>();
  Real product[most * most];
  int rows[most], columns[most];
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    const int first = block.first_jacobian;
    solver_detail::copy(start.Jz + first, factored.Jz + first, block.equations * block.coordinates);
    const LoopFactorsOf<Real> loop = factors.factors_of(b, factored);
    const unsigned char* const driven = System::kBlockDriven + block.first_coordinate;
    const SideWork<Real> work = {product, rows, columns};
    if (changes_side(loop, start.Jz + first, end.Jz + first, driven, work)) return b;
  }
  return -1;
}

/// The same as project_motion with the shortest corrections, as far as rounding lets them go: a smooth function of the
/// guess.
template <class System>
Status project_nearest(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       typename System::State& state) noexcept {
  using namespace solver_detail;
  return solver_detail::project<System, Correction::shortest>(parameters, inputs, state);
}

}  // namespace mbgen
