#pragma once
// Closing the loops of a generated solver: Newton with the frozen partition, and with a pivoted one where that is bad.
// `System` is described in blocks.hpp. Source: theory.md sections 3 and 4.

#include <limits>

#include "mbgen/blocks.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/corrections.hpp"
#include "mbgen/solver/newton.hpp"
#include "mbgen/solver/regular.hpp"

namespace mbgen {

namespace solver_detail {

/// Largest residual that ends Newton: the model's, as far as the precision has it.
template <class System>
constexpr RealOf<System> closure_tolerance() noexcept {
  constexpr RealOf<System> least = kLeastClosureTolerance<RealOf<System>>;
  return System::kClosureTolerance > least ? System::kClosureTolerance : least;
}

/// True when block b is hardly corrected: then it does not matter by which coordinates. A NaN is not slight.
template <class System>
bool is_slight(int b, const typename System::State& state, const typename System::Closure& closure) noexcept {
  constexpr RealOf<System> limit = kSlightCorrection<RealOf<System>> * closure_tolerance<System>();
  const BlockLayout& block = System::kBlockLayout[b];
  bool slight = true;
  for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
    const int i = System::kBlockCoordinate[c];
    slight = slight && magnitude(closure.dz[i]) <= limit && magnitude(closure.zd[i] - state.zd[i]) <= limit;
  }
  return slight;
}

/// True when a step is not to correct the dependents of block b alone.
template <class System, Correction correction>
bool is_unfair(int b, const typename System::State& state, const typename System::Closure& closure) noexcept {
  if (correction != Correction::in_steps || System::kBlockLayout[b].free == 0) return false;
  return closure.pivot[b] < kFairPivot<RealOf<System>> && !is_slight<System>(b, state, closure);
}

/// True when a pivoted correction is to be taken in place of the one by the frozen partition.
template <class System, Correction correction>
bool is_replaced(int b, const typename System::State& state, const typename System::Closure& closure) noexcept {
  using Real = RealOf<System>;
  if (!(closure.pivot[b] >= kPivotThreshold<Real>)) return true;
  return closure.pivot[b] < kNearSingular<Real> && is_unfair<System, correction>(b, state, closure);
}

/// Whether block b may be near a singular position. The shortest corrections are asked for near one anyway: there it is
/// looked at where the frozen partition is bad.
template <class System, Correction correction>
bool is_watched(int b, const typename System::Closure& closure) noexcept {
  using Real = RealOf<System>;
  constexpr Real least = correction == Correction::shortest ? kPivotThreshold<Real> : kNearSingular<Real>;
  return !(closure.pivot[b] >= least);
}

/// Whether the free directions of the frozen partition are to shorten the corrections of block b.
template <class System, Correction correction>
bool is_shortened(int b, const typename System::State& state, const typename System::Closure& closure) noexcept {
  if (correction == Correction::shortest) return System::kBlockLayout[b].free > 0;
  return is_unfair<System, correction>(b, state, closure);
}

/// Replaces dz and zd of blocks that are watched, see correct_closure.
template <class System, Correction correction>
Status correct_watched(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& state, typename System::Closure& closure) noexcept {
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  CorrectionWork<System> work;
  Status notice;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (!is_watched<System, correction>(b, closure)) continue;
    const bool replaced = is_replaced<System, correction>(b, state, closure);
    const Status of_block = solve_block<System>(
        b, terms, closure.pivot[b], work.factors, work.fine, work.right_hand_side, [&](const auto& solution) {
          if (replaced) correct_block<System, correction>(b, solution, state, work, closure);
        });
    if (!of_block.ok()) return of_block;
    notice = graver(notice, of_block);
  }
  return notice;
}

/// Shortens dz and zd of the blocks whose frozen partition is only fair at this position. Replaces them by the
/// corrections of a pivoted partition for ill-conditioned blocks. The status may be a notice. Fails: loop_singular.
template <class System, Correction correction>
Status correct_closure(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& state, typename System::Closure& closure) noexcept {
  bool serves = true;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (is_watched<System, correction>(b, closure)) {
      serves = false;
    } else if (is_shortened<System, correction>(b, state, closure)) {
      shorten_block<System>(b, state, closure, [](const auto& value, auto& to) { to = value; });
    }
  }
  if (serves) return {};
  if constexpr (kRegularOnly<System>) {
    return {kNotRegular, -1};
  } else {
    return correct_watched<System, correction>(parameters, inputs, state, closure);
  }
}

/// The closure of a state with a ball in its other chart: residuals and corrections of all blocks by closure_terms,
/// which take charts. Of the frozen program driven coordinates alone are right. The status may be a notice. Fails:
/// loop_singular.
template <class System, Correction correction>
Status correct_other_chart(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, typename System::Closure& closure) noexcept {
  if constexpr (kRegularOnly<System>) {
    return {kNotRegular, -1};
  } else if constexpr (System::kBlocks > 0) {
    typename System::ClosureTerms terms;
    System::closure_terms(parameters, inputs, state, terms);
    copy(terms.Phi, closure.residual, System::kEquations);
    CorrectionWork<System> work;
    Status notice;
    for (int b = 0; b < System::kBlocks; ++b) {
      const Status of_block = solve_block<System>(
          b, terms, RealOf<System>(1), work.factors, work.fine, work.right_hand_side,
          [&](const auto& solution) { correct_block<System, correction>(b, solution, state, work, closure); });
      if (!of_block.ok()) return of_block;
      notice = graver(notice, of_block);
    }
    return notice;
  } else {
    return {};
  }
}

/// A residual and the equation that has it, -1 for none.
template <class Real>
struct Misfit {
  Real size = 0;
  int equation = -1;
};

/// Largest residual of the equations whose redundancy flag is `redundant`; NaN is larger than every number.
template <class System>
Misfit<RealOf<System>> largest_residual(const typename System::Closure& closure, unsigned char redundant) noexcept {
  Misfit<RealOf<System>> largest;
  for (int e = 0; e < System::kEquations; ++e) {
    if (System::kRedundant[e] != redundant) continue;
    const RealOf<System> size = magnitude(closure.residual[e]);
    if (is_nan(size)) return {size, e};
    if (size > largest.size) largest = {size, e};
  }
  return largest;
}

/// Largest distance of a driven coordinate from its motion.
template <class System>
RealOf<System> largest_driven_step(const typename System::Closure& closure) noexcept {
  RealOf<System> largest = 0;
  for (int g = 0; g < System::kDrives; ++g) {
    const RealOf<System> size = magnitude(closure.dz[System::kDriveCoordinate[g]]);
    if (is_nan(size)) return size;
    largest = size > largest ? size : largest;
  }
  return largest;
}

/// Block of an equation.
template <class System>
int block_of(int equation) noexcept {
  for (int b = System::kBlocks - 1; b >= 0; --b) {
    if (equation >= System::kBlockLayout[b].first_equation) return b;
  }
  return -1;
}

/// z += dz, shortened when a coordinate outside the motions would jump.
template <class System>
void apply_step(const typename System::Closure& closure, typename System::State& state) noexcept {
  using Real = RealOf<System>;
  Real largest = 0;
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] == 0) largest = magnitude(closure.dz[i]) > largest ? magnitude(closure.dz[i]) : largest;
  }
  const Real factor = shortening(largest, kLargestNewtonStep<Real>);
  for (int i = 0; i < System::kCoordinates; ++i) {
    state.z[i] += System::kDriven[i] != 0 ? closure.dz[i] : factor * closure.dz[i];
  }
}

/// Puts driven coordinates where their motions are: a state that is closed within the tolerance is off by as much.
template <class System>
void move_driven(const typename System::Closure& closure, typename System::State& state) noexcept {
  for (int g = 0; g < System::kDrives; ++g) {
    state.z[System::kDriveCoordinate[g]] += closure.dz[System::kDriveCoordinate[g]];
  }
}

/// Accepts a closed position: redundant equations must hold, and velocities become consistent.
template <class System>
Status accept(const typename System::Closure& closure, typename System::State& trial) noexcept {
  const Misfit<RealOf<System>> contradiction = largest_residual<System>(closure, 1);
  if (!(contradiction.size <= kRedundantTolerance<RealOf<System>>)) {
    return {Code::loop_not_closed, block_of<System>(contradiction.equation)};
  }
  move_driven<System>(closure, trial);
  copy(closure.zd, trial.zd, System::kCoordinates);
  // A motion can have a velocity where it has no position: the square root of a constant input.
  if (is_finite(sum(trial.zd, System::kCoordinates) + sum(trial.z, System::kCoordinates))) return {};
  int bad = first_not_finite(trial.zd, System::kCoordinates);
  if (bad < 0) bad = first_not_finite(trial.z, System::kCoordinates);
  return bad < 0 ? Status{} : Status{Code::not_a_number, bad};
}

/// Newton's iteration on z of `trial`; at the end its velocities are consistent. The status may be a notice. correct:
/// replaces corrections of the frozen partition if another one is needed. ends_at_tolerance: false to iterate while it
/// improves: near a singular position a small residual does not determine the coordinates. closures: evaluations that
/// are left, at least one.
template <class System, class Correct>
Status close_loops(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   typename System::State& trial, bool ends_at_tolerance, const Correct& correct,
                   int& closures) noexcept {
  using Real = RealOf<System>;
  constexpr Real tolerance = closure_tolerance<System>();
  typename System::Closure closure;
  Misfit<Real> misfit;
  Real previous = std::numeric_limits<Real>::infinity();
  int derivatives = kDerivativeSteps;
  while (closures-- > 0) {
    System::closure(parameters, inputs, trial, closure);
    const Status notice = correct(closure);
    if (!notice.ok()) return notice;
    misfit = largest_residual<System>(closure, 0);
    const Real driven = largest_driven_step<System>(closure);
    const Real size = driven > misfit.size ? driven : misfit.size;
    const bool gains = size > 0 && size < Real(0.5) * previous && closures > 0;
    const bool is_enough = size <= tolerance && ends_at_tolerance;
    const bool is_closed = is_enough || (!gains && size <= kRoundingFloor<Real>);
    if (is_closed && (derivatives-- == 0 || keeps_derivatives(closure.dz, trial.z, System::kCoordinates))) {
      const Status accepted = accept<System>(closure, trial);
      return accepted.ok() ? notice : accepted;
    }
    previous = size;
    apply_step<System>(closure, trial);
    if (!is_finite(sum(trial.z, System::kCoordinates))) break;
  }
  return {Code::loop_not_closed, block_of<System>(misfit.equation)};
}

/// The same with as many evaluations as one projection takes.
template <class System, class Correct>
Status close_loops(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   typename System::State& trial, bool ends_at_tolerance, const Correct& correct) noexcept {
  int closures = kNewtonIterations + 1;
  return close_loops<System>(parameters, inputs, trial, ends_at_tolerance, correct, closures);
}

/// The same by the frozen partition, or by a pivoted one where that is bad.
template <class System, Correction correction>
Status close_loops(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   typename System::State& trial, int& closures) noexcept {
  const auto correct = [&](typename System::Closure& closure) {
    if constexpr (kChartsOf < typename System::State >> 0) {
      if (in_other_chart(trial)) {
        return correct_other_chart<System, correction>(parameters, inputs, trial, closure);
      }
    }
    if constexpr (kChoosesAgain<System>) {
      return correct_closure<System, correction>(parameters, inputs, trial, closure);
    } else {
      return frozen_status<System>(closure.pivot);
    }
  };
  return close_loops<System>(parameters, inputs, trial, correction != Correction::shortest, correct, closures);
}

template <class System, Correction correction>
Status close_loops(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   typename System::State& trial) noexcept {
  int closures = kNewtonIterations + 1;
  return close_loops<System, correction>(parameters, inputs, trial, closures);
}

/// Adds Phi_z zd to the values per equation.
template <class System>
void add_rates(const typename System::ClosureTerms& terms, const typename System::State& state,
               RealOf<System>* velocity) noexcept {
  if constexpr (kChoosesAgain<System>) {
    for (int b = 0; b < System::kBlocks; ++b) {
      const BlockLayout& block = System::kBlockLayout[b];
      for (int e = 0; e < block.equations; ++e) {
        const RealOf<System>* row = terms.Jz + block.first_jacobian + e * block.coordinates;
        for (int c = 0; c < block.coordinates; ++c) {
          velocity[block.first_equation + e] += row[c] * state.zd[System::kBlockCoordinate[block.first_coordinate + c]];
        }
      }
    }
  } else {
    for (int e = 0; e < System::kEquations; ++e) velocity[e] += terms.rate[e];
  }
}

}  // namespace solver_detail

/// Closes every loop from the state as a guess, sets driven coordinates to their motions and makes velocities
/// consistent; independent coordinates and velocities stay.
/// Fails: not_a_number, loop_not_closed, loop_singular; the state is then unchanged. Gives no notices. Cost: at most
/// kNewtonIterations steps.
template <class System>
Status project_state(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                     typename System::State& state) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  if constexpr (System::kHasClosure) {
    typename System::State trial;
    copy_state<System>(state, trial);
    const Status status = close_loops<System, Correction::of_dependents>(parameters, inputs, trial);
    if (!status.ok()) return status;
    copy_state<System>(trial, state);
  }
  return {};
}

/// Residuals of every closure equation: positions Phi, velocities Phi_z zd, and the largest of each.
/// Fails: not_a_number for the arguments; the residuals are then unchanged.
template <class System, class Residual>
Status closure_residuals(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                         const typename System::State& state, Residual& residual) noexcept {
  using namespace solver_detail;
  const Status status = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!status.ok()) return status;
  if constexpr (System::kBlocks > 0) {
    typename System::ClosureTerms terms;
    System::closure_terms(parameters, inputs, state, terms);
    copy(terms.Phi, residual.position, System::kEquations);
    for (int e = 0; e < System::kEquations; ++e) residual.velocity[e] = 0;
    add_rates<System>(terms, state, residual.velocity);
  }
  residual.largest_position = largest(residual.position, System::kEquations);
  residual.largest_velocity = largest(residual.velocity, System::kEquations);
  return {};
}

}  // namespace mbgen
