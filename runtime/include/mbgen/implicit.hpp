#pragma once
// The linear equations of an implicit step of a generated solver. `System` is described in blocks.hpp; for an implicit
// integrator it has two programs more: tangents and changes, the types StepSize and Tangents, and with states of the
// user's own kFirstOwnState.

#include "mbgen/solver.hpp"
#include "mbgen/solver/rosenbrock.hpp"

namespace mbgen {

/// Equations of a step, or none if the frozen partition is ill-conditioned: the step is then explicit, of the same
/// order.
template <class System>
struct StepTangents {
  typename System::Tangents values;
  bool are_known;
};

/// Auxiliary states with monitored pivots in an implicit step: user-defined states, from System::kFirstOwnState on.
template <class System, class = void>
inline constexpr int kWatchedStates = 0;
template <class System>
inline constexpr int kWatchedStates<System, std::void_t<decltype(System::kFirstOwnState)>> =
    static_cast<int>(std::extent_v<decltype(System::Tangents::state_pivot)>);

/// The equations at a state. g: s, the method's factor times the step. The status may be a notice: chosen_again.
/// Fails: not_a_number, implicit_singular, implicit_state_grows; loop_singular where a solver has the frozen
/// partition only.
template <class System>
Status solve_tangents(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, double g, StepTangents<System>& tangents) noexcept {
  using namespace solver_detail;
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  tangents.are_known = false;
  System::tangents(parameters, inputs, state, {static_cast<RealOf<System>>(g)}, tangents.values);
  if constexpr (System::kBlocks > 0) {
    for (int b = 0; b < System::kBlocks; ++b) {
      if (tangents.values.pivot[b] >= kPivotThreshold<RealOf<System>>) continue;
      if (!kChoosesAgain<System>) return {Code::loop_singular, b};
      return {Code::chosen_again, b};
    }
  }
  for (int q = 0; q < System::kFreeDirections; ++q) {
    if (!(tangents.values.inertia[q] > 0)) return {Code::implicit_singular, System::kFreeDirection[q].coordinate};
  }
  if constexpr (kWatchedStates < System >> 0) {
    for (int s = 0; s < kWatchedStates<System>; ++s)
      if (!(tangents.values.state_pivot[s] > 0)) return {Code::implicit_state_grows, System::kFirstOwnState + s};
  }
  tangents.are_known = true;
  return {};
}

/// Changes of velocities and auxiliary states that solve the equations for given rates of a state.
template <class System, class Rates>
void solve_changes(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   const StepTangents<System>& tangents, double g, const Rates& rates,
                   typename System::Derivative& change) noexcept {
  const auto factor = static_cast<RealOf<System>>(g);
  if (!tangents.are_known) {
    for (int i = 0; i < System::kCoordinates; ++i) change.zdd[i] = factor * rates.derivative.zdd[i];
    for (int i = 0; i < System::kAuxiliaryStates; ++i) change.xd[i] = factor * rates.derivative.xd[i];
  } else {
    typename System::State of_positions;
    copy_array(rates.zd, of_positions.zd);
    typename System::Changes values;
    System::changes(parameters, inputs, of_positions, rates.derivative, {factor}, tangents.values, values);
    solver_detail::copy(values.zdd, change.zdd, System::kCoordinates);
    solver_detail::copy(values.xd, change.xd, System::kAuxiliaryStates);
  }
  if constexpr (System::kAuxiliaryStates == 0) change.xd[0] = 0;
}

}  // namespace mbgen
