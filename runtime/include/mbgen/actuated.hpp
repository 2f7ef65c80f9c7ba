#pragma once
// All coordinates of a mechanism from those of its actuators: positions and rates from a near pose, accelerations, the
// Jacobian, and forces from actuators to coordinates and back. `System` is described in blocks.hpp; beyond it kActuatedCoordinate and kGear of each actuator, which
// act on coordinates of their own and together determine every free direction.

#include "mbgen/actuation.hpp"
#include "mbgen/independent.hpp"
#include "mbgen/number.hpp"

namespace mbgen {

namespace solver_detail {

/// A flag per coordinate: 1 where an actuator acts.
template <class System>
struct ActuatedCoordinates {
  unsigned char is[System::kCoordinates] = {};
  ActuatedCoordinates() noexcept {
    for (const int coordinate : System::kActuatedCoordinate) is[coordinate] = 1;
  }
};

/// Solves every block for its other coordinates. given: 1 for coordinates that are known; use(block, coordinate,
/// solution): its coordinates, and its solution by factors.
/// Fails: loop_singular where the given coordinates do not determine a block.
template <class System, class Use>
Status each_given_block(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        const typename System::State& state, const unsigned char* given,
                        typename System::ClosureTerms& terms, const Use& use) noexcept {
  using Real = RealOf<System>;
  System::closure_terms(parameters, inputs, state, terms);
  BlockFactors<System> factors;
  Real right_hand_side[System::kEquations];
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    const LoopFactorsOf<Real> loop = chosen_factors<System>(b, given, terms, factors);
    const bool is_regular =
        loop.rank == block.rank && smallest_pivot(loop) >= kSingular<Real> * static_cast<Real>(block.pivot);
    if (block.rank > 0 && !is_regular) return {Code::loop_singular, b};
    use(block, System::kBlockCoordinate + block.first_coordinate,
        ByFactors<System>{b, loop, terms, factors.work, right_hand_side});
  }
  return {};
}

/// Rates of all coordinates for those of a column of given ones each, in place, row by row: coordinates x count.
/// Fails: not_a_number, loop_singular.
template <class System>
Status complete_rates(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, const unsigned char* given, int count,
                      RealOf<System>* rates) noexcept {
  if constexpr (System::kBlocks > 0) {
    typename System::ClosureTerms terms;
    const Status status = each_given_block<System>(
        parameters, inputs, state, given, terms,
        [&](const BlockLayout& block, const int* coordinate, const auto& solution) {
          RealOf<System> x[System::kBlockCoordinates];
          for (int i = 0; i < count; ++i) {
            for (int c = 0; c < block.coordinates; ++c) x[c] = rates[coordinate[c] * count + i];
            solution.moving(x);
            for (int c = 0; c < block.coordinates; ++c) rates[coordinate[c] * count + i] = x[c];
          }
        });
    if (!status.ok()) return status;
  }
  return is_finite(sum(rates, System::kCoordinates * count)) ? Status{} : Status{Code::not_a_number, -1};
}

}  // namespace solver_detail

/// Closes the loops with the motors at these positions and speeds, from the state as a near pose.
/// Fails: not_a_number, loop_singular; loop_not_closed also when another coordinate would jump; the state is then
/// unchanged.
template <class System>
Status complete_joints(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const RealOf<System>* position, const RealOf<System>* speed,
                       typename System::State& state) noexcept {
  typename System::State trial;
  solver_detail::copy_state<System>(state, trial);
  for (int i = 0; i < System::kActuators; ++i) {
    trial.z[System::kActuatedCoordinate[i]] = position[i] / System::kGear[i];
    trial.zd[System::kActuatedCoordinate[i]] = speed[i] / System::kGear[i];
  }
  const solver_detail::ActuatedCoordinates<System> actuated;
  const Status status = project_from_independent<System>(parameters, inputs, actuated.is, trial);
  if (status.ok()) solver_detail::copy_state<System>(trial, state);
  return status;
}

/// All accelerations from those of the motors, at a consistent state. Fails: not_a_number, loop_singular.
template <class System>
Status complete_accelerations(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                              const typename System::State& state, const RealOf<System>* acceleration,
                              RealOf<System>* zdd) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  RealOf<System> all[System::kCoordinates] = {};
  for (int i = 0; i < System::kActuators; ++i) all[System::kActuatedCoordinate[i]] = acceleration[i] / System::kGear[i];
  if constexpr (System::kBlocks > 0) {
    typename System::ClosureTerms terms;
    const ActuatedCoordinates<System> actuated;
    const Status status = each_given_block<System>(
        parameters, inputs, state, actuated.is, terms,
        [&](const BlockLayout& block, const int* coordinate, const auto& solution) {
          RealOf<System> x[System::kBlockCoordinates];
          for (int c = 0; c < block.coordinates; ++c)
            x[c] = System::kBlockDriven[block.first_coordinate + c] != 0 ? terms.driven_acceleration[coordinate[c]]
                                                                         : all[coordinate[c]];
          solution.accelerating(x);
          for (int c = 0; c < block.coordinates; ++c) all[coordinate[c]] = x[c];
        });
    if (!status.ok()) return status;
    if constexpr (System::kDrives > 0)
      for (int i = 0; i < System::kCoordinates; ++i)
        if (System::kDriven[i] != 0) all[i] = terms.driven_acceleration[i];
  }
  const int bad = first_not_finite(all, System::kCoordinates);
  if (bad >= 0) return {Code::not_a_number, bad};
  copy(all, zdd, System::kCoordinates);
  return {};
}

/// Rates of all coordinates for a unit speed of each motor, row by row: coordinates x actuators.
/// Fails: not_a_number, loop_singular; the rates are then unchanged.
template <class System>
Status actuator_jacobian(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                         const typename System::State& state, RealOf<System>* jacobian) noexcept {
  using namespace solver_detail;
  constexpr int n = System::kCoordinates, count = System::kActuators;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  RealOf<System> rates[n * count] = {};
  for (int i = 0; i < count; ++i) rates[System::kActuatedCoordinate[i] * count + i] = 1 / System::kGear[i];
  const Status status =
      complete_rates<System>(parameters, inputs, state, ActuatedCoordinates<System>().is, count, rates);
  if (status.ok()) copy(rates, jacobian, n * count);
  return status;
}

/// Forces of the motors with the same virtual work as generalised forces tau on the coordinates: the static map.
/// Fails: not_a_number, loop_singular; the forces are then unchanged.
template <class System>
Status forces_at_actuators(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, const RealOf<System>* tau,
                           RealOf<System>* force) noexcept {
  constexpr int n = System::kCoordinates, count = System::kActuators;
  RealOf<System> jacobian[n * count], found[count] = {};
  const Status status = actuator_jacobian<System>(parameters, inputs, state, jacobian);
  if (!status.ok()) return status;
  for (int c = 0; c < n; ++c)
    for (int i = 0; i < count; ++i) found[i] += jacobian[c * count + i] * tau[c];
  if (!is_finite(solver_detail::sum(found, count)))
    return {Code::not_a_number, solver_detail::first_not_finite(tau, n)};
  solver_detail::copy(found, force, count);
  return {};
}

/// Generalised forces on the independent coordinates with the same virtual work as forces of the motors, zero on the
/// others. Fails: not_a_number, loop_singular; tau is then unchanged.
template <class System>
Status forces_at_independent(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                             const typename System::State& state, const RealOf<System>* force,
                             RealOf<System>* tau) noexcept {
  using namespace solver_detail;
  constexpr int n = System::kCoordinates, count = System::kFreeDirections;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  RealOf<System> rates[n * count] = {}, found[n] = {};
  unsigned char independent[n] = {};
  for (int q = 0; q < count; ++q) {
    const int coordinate = System::kFreeDirection[q].coordinate;
    independent[coordinate] = 1;
    rates[coordinate * count + q] = 1;
  }
  const Status status = complete_rates<System>(parameters, inputs, state, independent, count, rates);
  if (!status.ok()) return status;
  for (int i = 0; i < System::kActuators; ++i)
    for (int q = 0; q < count; ++q)
      found[System::kFreeDirection[q].coordinate] +=
          System::kGear[i] * rates[System::kActuatedCoordinate[i] * count + q] * force[i];
  if (!is_finite(sum(found, n))) return {Code::not_a_number, -1};
  copy(found, tau, n);
  return {};
}

}  // namespace mbgen
