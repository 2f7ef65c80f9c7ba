#pragma once
// Closing the loops of a generated solver: Newton with the frozen partition, and with a pivoted one where that is bad.
// `System` is described in blocks.hpp. Source: theory.md sections 3 and 4.

#include "mbgen/blocks.hpp"

namespace mbgen {

/// Newton steps before a block counts as not closed; from a fair guess five are enough.
constexpr int kNewtonIterations = 20;
/// Largest change of a coordinate in one Newton step (rad or m): a linear step says nothing about half a turn.
constexpr double kLargestNewtonStep = 0.5;
/// A closure that stopped improving is accepted below this residual (m or 1): large mechanisms round above the
/// tolerance.
constexpr double kRoundingFloor = 1e-9;
/// Residual (m or 1) above which a redundant equation contradicts the others.
constexpr double kRedundantTolerance = 1e-6;

namespace solver_detail {

/// Replaces dz and zd of the blocks whose frozen partition is bad at this position by those of a pivoted one.
/// Independent coordinates keep their position and velocity, driven ones take those of their motions.
template <class System>
Status repair_closure(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, typename System::Closure& closure) noexcept {
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  BlockFactors<System> factors;
  double right_hand_side[System::kEquations];
  double solution[System::kBlockCoordinates];
  for (int b = 0; b < System::kBlocks; ++b) {
    if (closure.pivot[b] >= kPivotThreshold) continue;
    const BlockLayout& block = System::kBlockLayout[b];
    const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
    const LoopFactors loop = factors.factors_of(b, terms);
    if (loop.rank < block.rank) return {Code::loop_singular, b};

    for (int e = 0; e < block.equations; ++e) right_hand_side[e] = -terms.Phi[block.first_equation + e];
    for (int c = 0; c < block.coordinates; ++c) {
      solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.dz[coordinate[c]] : 0.0;
    }
    solve_dependent(loop, right_hand_side, solution, factors.work);
    for (int c = 0; c < block.coordinates; ++c) closure.dz[coordinate[c]] = solution[c];

    for (int c = 0; c < block.coordinates; ++c) {
      solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.zd[coordinate[c]] : state.zd[coordinate[c]];
    }
    solve_dependent(loop, terms.ct + block.first_equation, solution, factors.work);
    for (int c = 0; c < block.coordinates; ++c) closure.zd[coordinate[c]] = solution[c];
  }
  return {};
}

/// A residual and the equation that has it, -1 for none.
struct Misfit {
  double size = 0;
  int equation = -1;
};

/// Largest residual of the equations whose redundancy flag is `redundant`; NaN is larger than every number.
template <class System>
Misfit largest_residual(const typename System::Closure& closure, unsigned char redundant) noexcept {
  Misfit largest;
  for (int e = 0; e < System::kEquations; ++e) {
    const double size = std::abs(closure.residual[e]);
    if (System::kRedundant[e] == redundant && !(size <= largest.size)) largest = {size, e};
  }
  return largest;
}

/// Largest distance of a driven coordinate from its motion.
template <class System>
double largest_driven_step(const typename System::Closure& closure) noexcept {
  double largest = 0;
  for (int i = 0; i < System::kCoordinates; ++i) {
    const double size = System::kDriven[i] != 0 ? std::abs(closure.dz[i]) : 0.0;
    if (!(size <= largest)) largest = size;
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
  double largest = 0;
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] == 0) largest = std::abs(closure.dz[i]) > largest ? std::abs(closure.dz[i]) : largest;
  }
  const double factor = largest > kLargestNewtonStep ? kLargestNewtonStep / largest : 1.0;
  for (int i = 0; i < System::kCoordinates; ++i) {
    state.z[i] += System::kDriven[i] != 0 ? closure.dz[i] : factor * closure.dz[i];
  }
}

/// Puts driven coordinates where their motions are: a state that is closed within the tolerance is off by as much.
template <class System>
void settle_driven(const typename System::Closure& closure, typename System::State& state) noexcept {
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] != 0) state.z[i] += closure.dz[i];
  }
}

/// Newton on z and t of `trial`; at the end its velocities are consistent.
template <class System>
Status close_loops(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   typename System::State& trial) noexcept {
  typename System::Closure closure;
  Misfit misfit;
  double previous = 0;
  for (int iteration = 0; iteration <= kNewtonIterations; ++iteration) {
    System::closure(parameters, inputs, trial, closure);
    if constexpr (System::kBlocks > 0) {
      if (!frozen_is_good<System>(closure.pivot)) {
        const Status status = repair_closure<System>(parameters, inputs, trial, closure);
        if (!status.ok()) return status;
      }
    }
    misfit = largest_residual<System>(closure, 0);
    const double driven = largest_driven_step<System>(closure);
    const double size = driven > misfit.size ? driven : misfit.size;
    const bool stalled = iteration > 0 && size <= kRoundingFloor && size > 0.5 * previous;
    if (size <= System::kClosureTolerance || stalled) {
      const Misfit contradiction = largest_residual<System>(closure, 1);
      if (!(contradiction.size <= kRedundantTolerance)) {
        return {Code::loop_not_closed, block_of<System>(contradiction.equation)};
      }
      settle_driven<System>(closure, trial);
      copy(closure.zd, trial.zd, System::kCoordinates);
      const int bad = first_not_finite(trial.zd, System::kCoordinates);
      return bad < 0 ? Status{} : Status{Code::not_a_number, bad};
    }
    previous = size;
    apply_step<System>(closure, trial);
    if (!std::isfinite(sum(trial.z, System::kCoordinates))) break;
  }
  return {Code::loop_not_closed, block_of<System>(misfit.equation)};
}

}  // namespace solver_detail

/// Closes every loop from the state as a guess, sets driven coordinates to their motions and makes velocities
/// consistent; independent coordinates and velocities stay.
/// Fails: not_a_number, loop_not_closed, loop_singular; the state is then unchanged. Cost: at most kNewtonIterations
/// steps.
template <class System>
Status project_state(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                     typename System::State& state) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  if constexpr (System::kHasClosure) {
    typename System::State trial;
    copy_state<System>(state, trial);
    const Status status = close_loops<System>(parameters, inputs, trial);
    if (!status.ok()) return status;
    copy_state<System>(trial, state);
  }
  return {};
}

/// Residuals of every closure equation: positions Phi, velocities Phi_z zd - ct, and the largest of each.
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
    for (int b = 0; b < System::kBlocks; ++b) {
      const BlockLayout& block = System::kBlockLayout[b];
      for (int e = 0; e < block.equations; ++e) {
        const double* row = terms.Jz + block.first_jacobian + e * block.coordinates;
        double rate = -terms.ct[block.first_equation + e];
        for (int c = 0; c < block.coordinates; ++c) {
          rate += row[c] * state.zd[System::kBlockCoordinate[block.first_coordinate + c]];
        }
        residual.velocity[block.first_equation + e] = rate;
      }
    }
  }
  residual.largest_position = largest(residual.position, System::kEquations);
  residual.largest_velocity = largest(residual.velocity, System::kEquations);
  return {};
}

}  // namespace mbgen
