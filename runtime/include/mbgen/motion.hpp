#pragma once
// Functions of a generated solver for integrators: rates and projections, with notices about near singular positions.
// `System` is described in blocks.hpp.

#include <limits>

#include "mbgen/number.hpp"
#include "mbgen/solver.hpp"
#include "mbgen/solver/closure.hpp"
#include "mbgen/solver/sides.hpp"

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
      if (System::kDriven[i] == 0 && !(magnitude(to.z[i] - from.z[i]) <= largest)) return b;
    }
  }
  return -1;
}

template <class System, Correction correction>
Status project(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
               typename System::State& state, int& closures) noexcept {
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  Status status;
  if constexpr (System::kHasClosure) {
    typename System::State trial;
    copy_state<System>(state, trial);
    status = close_loops<System, correction>(parameters, inputs, trial, closures);
    if (!status.ok()) return status;
    if constexpr (System::kBlocks > 0) {
      const int block = moved_far<System>(state, trial);
      if (block >= 0) return {Code::loop_not_closed, block};
    }
    copy_state<System>(trial, state);
  }
  return status;
}

template <class System, Correction correction>
Status project(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
               typename System::State& state) noexcept {
  int closures = kNewtonIterations + 1;
  return project<System, correction>(parameters, inputs, state, closures);
}

/// The same with the evaluations that are left to a step. Fails: as that, and loop_singular without any.
template <class System, Correction correction>
Status project_in_step(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       typename System::State& state, int& left) noexcept {
  if (left <= 0) return {Code::loop_singular, 0};
  const int most = left < kNewtonIterations + 1 ? left : kNewtonIterations + 1;
  int closures = most;
  const Status status = project<System, correction>(parameters, inputs, state, closures);
  left -= most - (closures > 0 ? closures : 0);
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

/// The same without a look at singular positions: for a state that is known to be near one.
template <class System>
Status solve_near(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                  const typename System::State& state, typename System::Derivative& derivative) noexcept {
  static constexpr RealOf<System> kNoForces[System::kCoordinates] = {};
  typename System::Accelerations values;
  return solver_detail::evaluate<System>(parameters, inputs, state, kNoForces, values, derivative);
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
/// closures: evaluations of the closures that are left to a step. Fails then: loop_singular without any.
template <class System>
Status project_motion(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      typename System::State& state, int& closures) noexcept {
  return solver_detail::project_in_step<System, solver_detail::Correction::in_steps>(parameters, inputs, state,
                                                                                     closures);
}

namespace solver_detail {

/// Number of pivots of a block that are not small: these identify its coordinates at a singular position.
template <class System>
int large_pivots(int b, const LoopFactorsOf<RealOf<System>>& loop) noexcept {
  using Real = RealOf<System>;
  const Real least = kSingular<Real> * static_cast<Real>(System::kBlockLayout[b].pivot);
  int count = 0;
  while (count < loop.rank && magnitude(loop_detail::row_of(loop, count)[count]) >= least) ++count;
  return count;
}

/// Solution of a block by the pivots of its fine blocks that are not small.
template <class System>
struct ByLargeFinePivots {
  const ByFineBlocks<System>& fine;

  void directions(RealOf<System>* rz) const noexcept { fine.directions(rz); }
  void closing(RealOf<System>* x) const noexcept { fine.closing(x); }
  void moving(RealOf<System>* x) const noexcept { fine.accelerating(x); }
};

/// dz and zd of block b of `terms` by its pivots that are not small. Result: the smallest pivot, over its typical
/// value.
template <class System>
double correct_by_large_pivots(int b, typename System::ClosureTerms& terms, const typename System::State& state,
                               CorrectionWork<System>& work, typename System::Closure& closure) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  if constexpr (kHasFineBlocks<System>) {
    for (int c = 0; c < block.coordinates; ++c)
      work.told[c] = state.zd[System::kBlockCoordinate[block.first_coordinate + c]];
    if (work.fine.solves(b, terms, kSingular<Real>, false, work.told)) {
      correct_block<System, Correction::of_dependents>(b, ByLargeFinePivots<System>{work.fine}, state, work, closure);
      return static_cast<double>(work.fine.smallest_pivot()) / block.pivot;
    }
  }
  LoopFactorsOf<Real> loop = work.factors.factors_of(b, terms);
  const double share = static_cast<double>(smallest_pivot(loop)) / block.pivot;
  const bool has_rank = loop.rank == block.rank;
  loop.rank = large_pivots<System>(b, loop);  // the first pivots are the same without the others
  correct_block<System, Correction::of_dependents>(b, loop, terms, state, work, closure);
  return has_rank ? share : 0;
}

/// Residuals of all blocks, and dz and zd by their pivots that are not small. Result: the smallest pivot of all, over
/// its typical value.
template <class System>
double correct_by_large_pivots(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                               const typename System::State& state, typename System::Closure& closure) noexcept {
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  copy(terms.Phi, closure.residual, System::kEquations);
  CorrectionWork<System> work;
  double smallest = std::numeric_limits<double>::infinity();
  for (int b = 0; b < System::kBlocks; ++b) {
    const double share = correct_by_large_pivots<System>(b, terms, state, work, closure);
    smallest = share < smallest ? share : smallest;
  }
  return smallest;
}

}  // namespace solver_detail

/// Closes a state in the middle of a singular position, where two branches cross: by the pivots that are not small
/// there. Fails: loop_singular where more than the closure tolerance stays open, as it does where branches come close
/// and do not cross; not_a_number. The state is then unchanged. clearance: the smallest pivot at the given state, over
/// its typical value. closures: evaluations that are left.
template <class System>
Status project_crossing(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        typename System::State& state, double& clearance, int& closures) noexcept {
  using namespace solver_detail;
  using Real = RealOf<System>;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  typename System::State trial;
  copy_state<System>(state, trial);
  typename System::Closure closure;
  Real previous = std::numeric_limits<Real>::infinity();
  bool is_first = true;
  while (closures-- > 0) {
    System::closure(parameters, inputs, trial, closure);
    const double here = correct_by_large_pivots<System>(parameters, inputs, trial, closure);
    if (is_first) clearance = here;
    is_first = false;
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
template <class System>
Status project_crossing(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        typename System::State& state, double& clearance) noexcept {
  int closures = kCrossingClosures;
  return project_crossing<System>(parameters, inputs, state, clearance, closures);
}

/// The same as project_motion with the shortest corrections, as far as rounding lets them go: a smooth function of the
/// guess.
template <class System>
Status project_nearest(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       typename System::State& state) noexcept {
  using namespace solver_detail;
  return solver_detail::project<System, Correction::shortest>(parameters, inputs, state);
}
/// closures: as project_motion has it.
template <class System>
Status project_nearest(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       typename System::State& state, int& closures) noexcept {
  return solver_detail::project_in_step<System, solver_detail::Correction::shortest>(parameters, inputs, state,
                                                                                     closures);
}

}  // namespace mbgen
