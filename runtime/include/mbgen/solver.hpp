#pragma once
// Accelerations and constraint forces of a generated solver: the frozen program where the pivot monitors are good, the
// pivoting factorisation where one trips. `System` is described in blocks.hpp.

#include <limits>

#include "mbgen/blocks.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/closure.hpp"
#include "mbgen/solver/regular.hpp"

namespace mbgen {

namespace solver_detail {

/// Coordinate of a free direction under the partition that `columns` of its block holds: the place-th one that is
/// neither dependent nor driven, in ascending order.
template <class System>
int free_coordinate(const FreeDirection& direction, const BlockFactors<System>& factors) noexcept {
  if (direction.block < 0) return direction.coordinate;
  const BlockLayout& block = System::kBlockLayout[direction.block];
  const int* columns = factors.columns + block.first_coordinate;
  int place = direction.place;
  for (int c = 0; c < block.coordinates; ++c) {
    bool is_free = System::kBlockDriven[block.first_coordinate + c] == 0;
    for (int k = 0; k < block.rank; ++k) is_free = is_free && columns[k] != c;
    if (is_free && place-- == 0) return System::kBlockCoordinate[block.first_coordinate + c];
  }
  return direction.coordinate;
}

/// Copies zdd and xd of a program's result when they are finite and elements hold.
template <class System, class Values>
Status deliver(const Values& values, typename System::Derivative& derivative) noexcept {
  if constexpr (constexpr int places = kHoldsOf<System>; places > 0) {
    if (const Status status = status_of_holds(values.hold, places); !status.ok()) return status;
  }
  Total<RealOf<System>> total(0);
  total.add(values.zdd, System::kCoordinates);
  total.add(values.xd, System::kAuxiliaryStates);
  if (!is_finite(total.value())) {
    const int coordinate = first_not_finite(values.zdd, System::kCoordinates);
    if (coordinate >= 0) return {Code::not_a_number, coordinate};
    const int auxiliary = first_not_finite(values.xd, System::kAuxiliaryStates);
    if (auxiliary >= 0) return {Code::auxiliary_not_a_number, auxiliary};
  }
  copy(values.zdd, derivative.zdd, System::kCoordinates);
  copy(values.xd, derivative.xd, System::kAuxiliaryStates);
  // The array of a solver without auxiliary states has one entry all the same, and integrators integrate it.
  if constexpr (System::kAuxiliaryStates == 0) derivative.xd[0] = 0;
  return {};
}

/// zdd_star and Rz of block b by its solution (block_solution.hpp). Source: (61), (62).
template <class System, class Solution>
void project_by(int b, const Solution& solution, const typename System::ClosureTerms& terms,
                typename System::Projection& projection) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  RealOf<System>* zdd_star = projection.zdd_star + block.first_coordinate;
  for (int c = 0; c < block.coordinates; ++c) {
    const int place = block.first_coordinate + c;
    const bool driven = System::kBlockDriven[place] != 0;
    zdd_star[c] = driven ? terms.driven_acceleration[System::kBlockCoordinate[place]] : RealOf<System>(0);
  }
  solution.accelerating(zdd_star);
  solution.directions(projection.Rz + block.first_projection);
}

/// Accelerations with a partition chosen here and now by full pivoting; the status may be a notice. frozen_pivot: per
/// block. Source: (60)-(63).
template <class System>
Status pivoted_accelerations(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                             const typename System::State& state, const RealOf<System>* tau,
                             const RealOf<System>* frozen_pivot, typename System::Derivative& derivative) noexcept {
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  typename System::Projection projection;
  BlockFactors<System> factors;
  [[maybe_unused]] ByFineBlocks<System> fine;
  Status notice;
  for (int b = 0; b < System::kBlocks; ++b) {
    const Status of_block =
        solve_block<System>(b, terms, frozen_pivot[b], factors, fine, nullptr,
                            [&](const auto& solution) { project_by<System>(b, solution, terms, projection); });
    if (!of_block.ok()) return of_block;
    notice = graver(notice, of_block);
  }
  typename System::ChosenAccelerations values;
  System::chosen_accelerations(parameters, inputs, state, tau, projection, values);
  for (int k = 0; k < System::kFreeDirections; ++k) {
    if (!(values.inertia[k] > 0)) {
      return {Code::no_inertia, free_coordinate<System>(System::kFreeDirection[k], factors)};
    }
  }
  const Status delivered = deliver<System>(values, derivative);
  return delivered.ok() ? notice : delivered;
}

/// The same of a program for a known partition, when all its inertias are positive.
template <class System, class Values>
Status deliver_sound(const Values& values, typename System::Derivative& derivative) noexcept {
  if (!all_positive(values.inertia, System::kFreeDirections)) {
    for (int k = 0; k < System::kFreeDirections; ++k)
      if (!(values.inertia[k] > 0)) return {Code::no_inertia, System::kFreeDirection[k].coordinate};
  }
  return deliver<System>(values, derivative);
}

/// Accelerations of a state with a ball in its other chart, by the program that takes charts; the status may be a
/// notice. values: of the frozen program; its pivots, unused here, are set to 1.
template <class System>
Status other_chart_accelerations(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                                 const typename System::State& state, const RealOf<System>* tau,
                                 [[maybe_unused]] typename System::Accelerations& values,
                                 typename System::Derivative& derivative) noexcept {
  if constexpr (System::kBlocks > 0) {
    for (int b = 0; b < System::kBlocks; ++b) values.pivot[b] = 1;
    return pivoted_accelerations<System>(parameters, inputs, state, tau, values.pivot, derivative);
  } else {
    typename System::ChosenAccelerations chosen;
    System::chosen_accelerations(parameters, inputs, state, tau, chosen);
    return deliver_sound<System>(chosen, derivative);
  }
}

/// Factors of block b for its multipliers: equations that the frozen path leaves out get no multiplier, unless the
/// others lose rank here.
template <class System>
LoopFactorsOf<RealOf<System>> multiplier_factors(int b, const typename System::ClosureTerms& terms,
                                                 typename System::ClosureTerms& factored,
                                                 BlockFactors<System>& factors) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  const int entries = block.equations * block.coordinates;
  copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, entries);
  for (int e = 0; e < block.equations; ++e) {
    RealOf<System>* row = factored.Jz + block.first_jacobian + e * block.coordinates;
    for (int c = 0; c < block.coordinates; ++c)
      row[c] = System::kRedundant[block.first_equation + e] != 0 ? RealOf<System>(0) : row[c];
  }
  const LoopFactorsOf<RealOf<System>> kept = factors.factors_of(b, factored);
  if (kept.rank == block.rank) return kept;
  copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, entries);
  return factors.factors_of(b, factored);
}

/// Replaces multipliers and driving forces of blocks with an ill-conditioned frozen partition by pivoted ones.
template <class System>
Status repair_multipliers(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& state, typename System::ConstraintForces& values) noexcept {
  typename System::ClosureTerms terms, factored;
  System::closure_terms(parameters, inputs, state, terms);
  BlockFactors<System> factors;
  RealOf<System> lambda[System::kEquations];
  for (int b = 0; b < System::kBlocks; ++b) {
    if (values.pivot[b] >= kPivotThreshold<RealOf<System>>) continue;
    const BlockLayout& block = System::kBlockLayout[b];
    const LoopFactorsOf<RealOf<System>> loop = multiplier_factors<System>(b, terms, factored, factors);
    if (loop.rank < block.rank) return {Code::loop_singular, b};
    RealOf<System>* force = values.missing + block.first_coordinate;
    solve_transposed(loop, force, lambda, factors.work);
    for (int e = 0; e < block.equations; ++e) {
      values.lambda[System::kMultiplierPlace[block.first_equation + e]] = lambda[e];
    }
    for (int g = 0; g < System::kDrives; ++g) {
      for (int c = 0; c < block.coordinates; ++c) {
        if (System::kBlockCoordinate[block.first_coordinate + c] == System::kDriveCoordinate[g]) {
          values.drive[g] = -force[c];
        }
      }
    }
  }
  return {};
}

/// Frozen program, and the pivoted one where a monitor trips; the status may be a notice then.
/// values: of the frozen program.
template <class System>
Status evaluate(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                const typename System::State& state, const RealOf<System>* tau, typename System::Accelerations& values,
                typename System::Derivative& derivative) noexcept {
  if constexpr (kChartsOf < typename System::State >> 0) {
    if (in_other_chart(state)) {
      const Status status = check_arguments<System>(parameters, inputs, state, tau);
      if (!status.ok()) return status;
      if constexpr (kRegularOnly<System>) {
        return {kNotRegular, -1};
      } else {
        return other_chart_accelerations<System>(parameters, inputs, state, tau, values, derivative);
      }
    }
  }
  System::accelerations(parameters, inputs, state, tau, values);
  // After the program: its last operations wait for each other, and the arguments are at hand by then.
  const Status status = check_arguments<System>(parameters, inputs, state, tau);
  if (!status.ok()) return status;
  if constexpr (System::kBlocks > 0 && !kChoosesAgain<System>) {
    const Status frozen = frozen_status<System>(values.pivot);
    if (!frozen.ok()) return frozen;
  }
  if constexpr (kChoosesAgain<System>) {
    if (!frozen_is_good<System>(values.pivot)) {
      if constexpr (kRegularOnly<System>) {
        return {kNotRegular, -1};
      } else {
        return pivoted_accelerations<System>(parameters, inputs, state, tau, values.pivot, derivative);
      }
    }
  }
  return deliver_sound<System>(values, derivative);
}

}  // namespace solver_detail

/// All accelerations at a state: the frozen program, and the pivoted one where the monitor of a loop block trips.
/// Fails: not_a_number, no_inertia, loop_singular, kNotHeld; the derivative is then unchanged. Gives no notices.
template <class System>
Status solve_accelerations(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, const RealOf<System>* tau,
                           typename System::Derivative& derivative) noexcept {
  typename System::Accelerations values;
  return without_notice(solver_detail::evaluate<System>(parameters, inputs, state, tau, values, derivative));
}

/// Multipliers and driving forces at given accelerations: the frozen program, and the pivoted factorisation where the
/// monitor of a loop block trips. Fails: not_a_number, loop_singular; the values are then unchanged.
template <class System>
Status solve_multipliers(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                         const typename System::State& state, const RealOf<System>* tau,
                         const typename System::Derivative& derivative,
                         typename System::Multipliers& multipliers) noexcept {
  using namespace solver_detail;
  const Status status = check_arguments<System>(parameters, inputs, state, tau);
  if (!status.ok()) return status;
  if constexpr (System::kHasClosure) {
    typename System::ConstraintForces values;
    System::multipliers(parameters, inputs, state, tau, derivative, values);
    if constexpr (System::kBlocks > 0 && !kChoosesAgain<System>) {
      const Status frozen = frozen_status<System>(values.pivot);
      if (!frozen.ok()) return frozen;
    }
    if constexpr (kChoosesAgain<System>) {
      if (!frozen_is_good<System>(values.pivot)) {
        if constexpr (kRegularOnly<System>) {
          return {kNotRegular, -1};
        } else {
          const Status repaired = repair_multipliers<System>(parameters, inputs, state, values);
          if (!repaired.ok()) return repaired;
        }
      }
    }
    if (!is_finite(sum(values.lambda, System::kEquations) + sum(values.drive, System::kDrives))) {
      return {Code::not_a_number, first_not_finite(derivative.zdd, System::kCoordinates)};
    }
    copy(values.lambda, multipliers.lambda, System::kEquations);
    copy(values.drive, multipliers.drive, System::kDrives);
  }
  return {};
}

/// Multipliers for outputs: NaN if they cannot be computed, so that the other outputs remain available. Fails:
/// kNotRegular alone.
template <class System>
Status multipliers_or_nan(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& state, const RealOf<System>* tau,
                          const typename System::Derivative& derivative,
                          typename System::Multipliers& multipliers) noexcept {
  for (auto& value : multipliers.lambda) value = std::numeric_limits<RealOf<System>>::quiet_NaN();
  for (auto& value : multipliers.drive) value = std::numeric_limits<RealOf<System>>::quiet_NaN();
  const Status status = solve_multipliers<System>(parameters, inputs, state, tau, derivative, multipliers);
  return status.code == kNotRegular ? status : Status{};
}
template <class System>
typename System::Multipliers multipliers_or_nan(const typename System::Parameters& parameters,
                                                const typename System::Inputs& inputs,
                                                const typename System::State& state, const RealOf<System>* tau,
                                                const typename System::Derivative& derivative) noexcept {
  typename System::Multipliers multipliers;
  multipliers_or_nan<System>(parameters, inputs, state, tau, derivative, multipliers);
  return multipliers;
}

}  // namespace mbgen
