#pragma once
// Linearly implicit steps of several instances in lanes, see batch_steps.hpp. `System` is as in batch.hpp, with the
// programs tangents and changes, and StepSize, a struct of the row `step`.

#include "mbgen/batch_steps.hpp"
#include "mbgen/implicit.hpp"

namespace mbgen {

namespace batch_detail {

/// A System for an implicit integrator. A lane whose equations cannot be used is not good.
template <class System>
struct ImplicitLaneDynamics : LaneDynamics<System> {
  using State = typename System::State;
  using Derivative = typename System::Derivative;
  using Tangents = typename System::Tangents;

  Status derivative(const State& state, Derivative& derivative) const noexcept {
    typename System::Accelerations values;
    LaneDynamics<System>::derivative(state, values);
    integrator_detail::copy(values.zdd, derivative.zdd);
    integrator_detail::copy(values.xd, derivative.xd);
    return {};
  }
  Status tangents(const State& state, double g, Tangents& values) const noexcept {
    run_groups(System::tangents, values, this->parameters, this->inputs_at(state.t), state, size_of_step(g));
    this->good &= pivots_reach<System>(values.pivot, kPivotThreshold<double>);
    for (int q = 0; q < System::kFreeDirections; ++q) this->good &= values.inertia[q] > 0.0;
    if constexpr (kWatchedStates < System >> 0)
      for (int s = 0; s < kWatchedStates<System>; ++s) this->good &= values.state_pivot[s] > 0.0;
    return {};
  }
  void solve(const Tangents& tangents, double g, const StateRates<ImplicitLaneDynamics>& rates,
             Derivative& change) const noexcept {
    using Row = typename System::Row;
    // The program reads velocities only. The others are copied too: clang would call memset for rows of zeros.
    State of_positions;
    for (int i = 0; i < System::kCoordinates; ++i) of_positions.z[i] = rates.zd[i];
    for (int i = 0; i < System::kCoordinates; ++i) of_positions.zd[i] = rates.zd[i];
    for (int i = 0; i < System::kAuxiliaryStates; ++i) of_positions.x[i] = rates.derivative.xd[i];
    if constexpr (System::kAuxiliaryStates == 0) of_positions.x[0] = Row{};
    of_positions.t = Row{};
    if constexpr ((kChartsOf<State>) > 0)
      for (Row& chart : of_positions.charts) chart = Row{};
    typename System::Changes values;
    run_groups(System::changes, values, this->parameters, this->inputs, of_positions, rates.derivative, size_of_step(g),
               tangents);
    for (int i = 0; i < System::kCoordinates; ++i) change.zdd[i] = values.zdd[i];
    for (int i = 0; i < System::kAuxiliaryStates; ++i) change.xd[i] = values.xd[i];
    if constexpr (System::kAuxiliaryStates == 0) change.xd[0] = typename System::Row{};
  }

 private:
  static typename System::StepSize size_of_step(double g) noexcept { return {typename System::Row{} + g}; }
};

}  // namespace batch_detail

/// One linearly implicit step, as step_rosenbrock. result: a copy of the state. look: see step_lanes_rk4. Result: the
/// good lanes. Requires: is_step(h).
template <class System, class Look>
typename System::Mask step_lanes_rosenbrock(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                            const typename System::State& state, double h,
                                            typename System::State& result, const Look& look) noexcept {
  typename System::Mask good = batch_detail::keeps_charts<System>(state);
  const batch_detail::ImplicitLaneDynamics<System> dynamics{{parameters, inputs, state.t, good}};
  batch_detail::LaneStages stages;
  integrator_detail::try_rosenbrock(stages, dynamics, state, h, result);
  return look(good, result);
}

}  // namespace mbgen
