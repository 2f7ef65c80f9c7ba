#pragma once
// The discrete adjoint of a motion: derivatives of one number by everything that it follows from, from its end to its
// start. A step back takes the derivatives of the number by the state after a step and gives those by the state before
// it: the transpose of the step's own derivative, stage by stage and through the closed loops. Its cost does not grow
// with the number of parameters.
//
// A System offers types and functions of a generated solver, its programs transposed, and its solver with derivatives:
//   Parameters, Inputs, State, Derivative, Multipliers, Dynamics, Adjoints
//   kCoordinates, kAuxiliaryStates, kInputs, kParameters, kOutputs, kDerived, kBlocks, kHasClosure
//   kDriven         1 for driven coordinates
//   kAdvances       whether inputs go on in a step; then advance_inputs, kInputDerivative
//   dynamics(parameters, inputs, start)                           Dynamics of a step
//   kTakesMultipliers, kTakesRates                                of the outputs
//   accelerations(parameters, inputs, state, weights, result)     weights of zdd and xd
//   velocities, positions                                         of the closure at a closed state, weights of zd, dz
//   multipliers, outputs, derived
//   Directions      types and functions of the solver with derivatives, see solver/by_directions.hpp
// Source: A. Griewank, A. Walther, Evaluating Derivatives, 2008, chapters 3 and 4.

#include <cstddef>

#include "mbgen/blocks.hpp"
#include "mbgen/charts.hpp"
#include "mbgen/integrators.hpp"
#include "mbgen/solver/by_directions.hpp"

namespace mbgen {

/// Correction of a coordinate or a velocity by the projection of a step (rad or m, a second) above which a step in a
/// block whose frozen partition is only fair goes back by directions: its projection is the shortest one, whose
/// derivative differs by as much.
constexpr double kExactCorrection = 1e-11;

namespace adjoint_detail {

template <std::size_t N>
void add(const double (&from)[N], double (&to)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) to[i] += from[i];
}

/// Adds what a transposed program gives by constants and by inputs that went on for dt seconds: value + rate dt +
/// acceleration dt^2/2.
template <class System, class Result>
void add_constants(const Result& result, [[maybe_unused]] double dt, typename System::Adjoints& cost) noexcept {
  add(result.par, cost.parameters);
  add(result.derived, cost.derived);
  if constexpr (System::kAdvances) {
    for (int i = 0; i < System::kInputs; ++i) {
      double share = result.in[i];
      for (int of = i, order = 1; of >= 0; of = System::kInputDerivative[of], share *= dt / order++)
        cost.inputs[of] += share;
    }
  } else {
    add(result.in, cost.inputs);
  }
}

/// Inputs dt seconds after the start of a step.
template <class System>
decltype(auto) inputs_at(const typename System::Inputs& inputs, [[maybe_unused]] double dt) noexcept {
  if constexpr (System::kAdvances) {
    return System::advance_inputs(inputs, dt);
  } else {
    return (inputs);
  }
}

/// Stages of a step that is taken plainly, kept for the way back. Anything but ok ends it.
template <class System>
struct KeptStages {
  using State = typename System::State;
  using Dynamics = typename System::Dynamics;
  State stage[4];
  State open;  ///< the end before its projection
  int count = 0;

  static constexpr bool goes_on(Status status) noexcept { return status.code == Code::ok; }
  static Status check(const State& result) noexcept { return integrator_detail::check_finite(result); }
  Status rates(const Dynamics& dynamics, const State& at, double /*h*/, StateRates<Dynamics>& rates) noexcept {
    integrator_detail::copy_state(at, stage[count++]);
    return integrator_detail::evaluate(dynamics, at, rates);
  }
  Status close(const Dynamics& dynamics, State& state, double /*h*/) noexcept {
    integrator_detail::copy_state(state, open);
    return dynamics.project(state);
  }
};

/// Whether every ball is in its first chart and stays there in a step from this state.
template <class System, class Dynamics>
bool is_in_first_charts([[maybe_unused]] const Dynamics& dynamics,
                        [[maybe_unused]] const typename System::State& state) noexcept {
  if constexpr (System::kBalls > 0) {
    return !in_other_chart(state) && !dynamics.leaves_charts(state);
  } else {
    return true;
  }
}

/// Whether a step begins at an instant of sampled values, or cannot tell.
template <class Dynamics>
bool sets_values([[maybe_unused]] const Dynamics& dynamics, [[maybe_unused]] const typename Dynamics::State& state,
                 [[maybe_unused]] double h) noexcept {
  if constexpr (integrator_detail::kHasSamples<Dynamics>) {
    typename Dynamics::State sampled;
    integrator_detail::copy_state(state, sampled);
    bool any = false;
    return !dynamics.sample(sampled, h, any).ok() || any;
  } else {
    return false;
  }
}

/// Whether a step is projected by the frozen partition, or by so little that the way does not count.
template <class System>
bool is_projected_plainly(const typename System::State& open, const typename System::State& closed,
                          const double* pivot) noexcept {
  double least = 1;
  for (int b = 0; b < System::kBlocks; ++b) least = pivot[b] < least ? pivot[b] : least;
  if (least >= kFairPivot<double>) return true;
  bool is_slight = least >= kPivotThreshold<double>;
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] != 0) continue;
    is_slight = is_slight && magnitude(closed.z[i] - open.z[i]) <= kExactCorrection &&
                magnitude(closed.zd[i] - open.zd[i]) <= kExactCorrection;
  }
  return is_slight;
}

/// From the end of a step to that before its projection. z' = z + dz, where the Newton step dz at a closed position
/// does not depend on the dependent coordinates; zd' by the closed position. Result: whether it is plain.
template <class System>
bool open_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs, double h,
               const typename System::State& open, const typename System::State& closed,
               typename System::Adjoints& cost) noexcept {
  if constexpr (System::kHasClosure) {
    const auto& now = inputs_at<System>(inputs, h);
    typename System::VelocitiesAdjoint velocities;
    System::velocities(parameters, now, closed, cost.zd, velocities);
    if (!is_projected_plainly<System>(open, closed, velocities.pivot)) return false;
    add(velocities.z, cost.z);
    integrator_detail::copy(velocities.zd, cost.zd);
    add_constants<System>(velocities, h, cost);
    typename System::PositionsAdjoint positions;
    System::positions(parameters, now, closed, cost.z, positions);
    add(positions.z, cost.z);
    add_constants<System>(positions, h, cost);
  }
  return true;
}

/// Derivatives by a stage dt seconds after the start, of weights of its rates. The rate of z is zd.
template <class System>
void stage_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs, double dt,
                const typename System::State& stage, const double (&weight_of_zd)[System::kCoordinates],
                const typename System::Derivative& weights, typename System::AccelerationsAdjoint& of,
                typename System::Adjoints& cost) noexcept {
  System::accelerations(parameters, inputs_at<System>(inputs, dt), stage, weights, of);
  add(weight_of_zd, of.zd);
  add_constants<System>(of, dt, cost);
}

/// weights of the rates of a stage = share of the step's result + share of the next stage.
template <std::size_t N>
void weigh(double of_end, const double (&end)[N], double of_next, const double (&next)[N],
           double (&weights)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) weights[i] = of_end * end[i] + of_next * next[i];
}

/// One step of Runge-Kutta back where it was taken plainly. is_plain: whether it was; else `cost` is as it was.
template <class System>
Status plain_step_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& before, double h, typename System::Adjoints& cost,
                       bool& is_plain) noexcept {
  using State = typename System::State;
  const auto dynamics = System::dynamics(parameters, inputs, before.t);
  is_plain = is_in_first_charts<System>(dynamics, before) && !sets_values(dynamics, before, h);
  if (!is_plain) return {};
  KeptStages<System> kept;
  State after;
  integrator_detail::copy_state(before, after);
  const Status status = integrator_detail::try_rk4(kept, dynamics, before, h, after);
  is_plain = status.code == Code::ok;
  if (!is_plain) return status;
  typename System::Adjoints back = cost;
  is_plain = open_back<System>(parameters, inputs, h, kept.open, after, back);
  if (!is_plain) return status;

  // y' = y + h/6 k1 + h/3 k2 + h/3 k3 + h/6 k4; stages at y, y + h/2 k1, y + h/2 k2, y + h k3.
  constexpr double kOfEnd[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, kOfNext[] = {0.5, 0.5, 1, 0};
  typename System::AccelerationsAdjoint next{}, stage;
  State end;
  integrator_detail::copy(back.z, end.z);
  integrator_detail::copy(back.zd, end.zd);
  integrator_detail::copy(back.x, end.x);
  for (int k = 4; k-- > 0;) {
    typename System::Derivative weights;
    double of_zd[System::kCoordinates];
    const double of_end = h * kOfEnd[k], of_next = h * kOfNext[k];
    weigh(of_end, end.z, of_next, next.z, of_zd);
    weigh(of_end, end.zd, of_next, next.zd, weights.zdd);
    weigh(of_end, end.x, of_next, next.x, weights.xd);
    stage_back<System>(parameters, inputs, kept.stage[k].t - before.t, kept.stage[k], of_zd, weights, stage, back);
    next = stage;
    add(stage.z, back.z);
    add(stage.zd, back.zd);
    add(stage.x, back.x);
  }
  is_plain = is_finite_sum(back);
  if (is_plain) cost = back;
  return status;
}

/// Outputs back by the transposed programs, where the frozen partition serves. Result: whether it does.
template <class System>
bool plain_outputs_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        const typename System::State& state, const double (&weights)[System::kOutputSize],
                        typename System::Adjoints& cost) noexcept {
  typename System::Adjoints back = cost;
  typename System::Derivative rates{}, of_rates{};
  typename System::Multipliers forces{};
  if constexpr (System::kTakesRates) {
    const auto dynamics = System::dynamics(parameters, inputs, state.t);
    if (!is_in_first_charts<System>(dynamics, state)) return false;
    if (dynamics.derivative(state, rates).code != Code::ok) return false;
  }
  if constexpr (System::kTakesMultipliers) {
    const double tau[System::kCoordinates] = {};
    if (!System::solve_multipliers(parameters, inputs, state, tau, rates, forces).ok()) return false;
  }
  typename System::OutputsAdjoint outputs;
  System::outputs(parameters, inputs, state, rates, forces, weights, outputs);
  add(outputs.z, back.z);
  add(outputs.zd, back.zd);
  add(outputs.x, back.x);
  add_constants<System>(outputs, 0, back);
  if constexpr (System::kTakesRates) {
    integrator_detail::copy(outputs.zdd, of_rates.zdd);
    if constexpr (System::kTakesMultipliers) {
      typename System::MultipliersAdjoint of_forces;
      integrator_detail::copy(outputs.lambda, forces.lambda);
      integrator_detail::copy(outputs.drive, forces.drive);
      System::multipliers(parameters, inputs, state, rates, forces, of_forces);
      for (int b = 0; b < System::kBlocks; ++b)
        if (!(of_forces.pivot[b] >= kPivotThreshold<double>)) return false;
      add(of_forces.zdd, of_rates.zdd);
      add(of_forces.z, back.z);
      add(of_forces.zd, back.zd);
      add(of_forces.x, back.x);
      add_constants<System>(of_forces, 0, back);
    }
    typename System::AccelerationsAdjoint of_accelerations;
    System::accelerations(parameters, inputs, state, of_rates, of_accelerations);
    add(of_accelerations.z, back.z);
    add(of_accelerations.zd, back.zd);
    add(of_accelerations.x, back.x);
    add_constants<System>(of_accelerations, 0, back);
  }
  if (!is_finite_sum(back)) return false;
  cost = back;
  return true;
}

}  // namespace adjoint_detail

/// From the derivatives of a number by the state after a step of Runge-Kutta (step_rk4) to those by the state before
/// it; adds those by inputs and parameters. Steps by the frozen partition go back by the transposed programs; steps
/// that choose coordinates again, come near a singular position or jump go back by directions, whose cost grows with
/// the numbers of the state. Fails: as step_rk4, not_a_number for derivatives that are not finite; `cost` is then as it
/// was.
template <class System>
Status step_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& before, double h, typename System::Adjoints& cost) noexcept {
  const Status valid = integrator_detail::check_step(h);
  if (!valid.ok()) return valid;
  if (!adjoint_detail::is_finite_sum(cost)) return {Code::not_a_number, -1};
  bool is_plain = false;
  const Status status = adjoint_detail::plain_step_back<System>(parameters, inputs, before, h, cost, is_plain);
  if (is_plain) return status;
  return adjoint_detail::step_by_directions<System>(parameters, inputs, before, h, cost);
}

/// Adds the derivatives of weighted outputs at a state. Fails: as accelerations and outputs, not_a_number for weights
/// and derivatives that are not finite; `cost` is then as it was.
template <class System>
Status outputs_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                    const typename System::State& state, const double (&weights)[System::kOutputSize],
                    typename System::Adjoints& cost) noexcept {
  if (adjoint_detail::plain_outputs_back<System>(parameters, inputs, state, weights, cost)) return {};
  return adjoint_detail::outputs_by_directions<System>(parameters, inputs, state, weights, cost);
}

/// Adds what constants that follow from parameters owe these; their own entries are 0 then.
template <class System>
void constants_back(const typename System::Parameters& parameters, typename System::Adjoints& cost) noexcept {
  if constexpr (System::kDerived > 0) {
    typename System::DerivedAdjoint of;
    System::derived(parameters, cost.derived, of);
    adjoint_detail::add(of.par, cost.parameters);
    for (double& value : cost.derived) value = 0;
  }
}

/// The start of the model at these parameters and inputs. Fails: as in the solver with derivatives.
template <class System>
Status start_of(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                typename System::State& state) noexcept {
  constexpr int kNone = adjoint_detail::Seeded<System>::kNumbers;
  adjoint_detail::Seeded<System> at(parameters, inputs, System::initial_state(), kNone);
  const typename System::Directions::Tuned tuned(at.parameters);
  const Status started = System::Directions::start(tuned, at.inputs, at.state);
  if (!started.ok()) return started;
  state = System::initial_state();
  for (int i = 0; i < System::kCoordinates; ++i) {
    state.z[i] = at.state.z[i].value;
    state.zd[i] = at.state.zd[i].value;
  }
  for (int i = 0; i < System::kAuxiliaryStates; ++i) state.x[i] = at.state.x[i].value;
  return started;
}

/// From the derivatives by an assembled state to those by the state before. Fails: as assemble.
template <class System>
Status assemble_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                     const typename System::State& before, typename System::Adjoints& cost) noexcept {
  return adjoint_detail::back_by_directions<System>(
      parameters, inputs, before, cost,
      [](auto& tuned, auto& now, auto& state) { return System::Directions::assemble(tuned, now, state); });
}

/// constants_back and the derivatives of the start by inputs and parameters. Fails: as the start.
template <class System>
Status start_back(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                  typename System::Adjoints& cost) noexcept {
  constexpr int kFirst = 2 * System::kCoordinates + System::kAuxiliaryStates;
  typename System::Adjoints back = cost;
  const Status status = adjoint_detail::add_by_directions<System>(
      parameters, inputs, System::initial_state(), kFirst, back,
      [&](adjoint_detail::Seeded<System>& seeded, auto& sums) {
        const typename System::Directions::Tuned tuned(seeded.parameters);
        const Status started = System::Directions::start(tuned, seeded.inputs, seeded.state);
        if (started.ok()) adjoint_detail::add_state<System>(seeded.state, cost, sums);
        return started;
      });
  if (!status.ok()) return status;
  cost = back;
  constants_back<System>(parameters, cost);
  return status;
}

}  // namespace mbgen
