#pragma once
// The adjoint of what a solver does, by its solver with derivatives: a pass for every eight numbers that the result
// follows from. Exact whichever way a step was taken. `System` is described in adjoint.hpp; its Directions are the
// solver with derivatives: Real, kDirections, Parameters, Inputs, Tuned, State, Derivative, Outputs, kParameterMember,
// kInputMember, kOutputMember, step_rk4, accelerations, outputs, start.

#include <cstddef>

#include "mbgen/integrators.hpp"
#include "mbgen/tangents.hpp"

namespace mbgen {

namespace adjoint_detail {

template <class Adjoints>
bool is_finite_sum(const Adjoints& cost) noexcept {
  double sum = 0;
  for (const double value : cost.z) sum += value;
  for (const double value : cost.zd) sum += value;
  for (const double value : cost.x) sum += value;
  for (const double value : cost.inputs) sum += value;
  for (const double value : cost.parameters) sum += value;
  for (const double value : cost.derived) sum += value;
  return is_finite(sum);
}

/// The number at a place, in the order z, zd, x, inputs, parameters. state: has the first three.
template <class System, class State, class Input, class Parameter>
auto& number_at(State& state, int place, const Input& input, const Parameter& parameter) noexcept {
  if (place < System::kCoordinates) return state.z[place];
  place -= System::kCoordinates;
  if (place < System::kCoordinates) return state.zd[place];
  place -= System::kCoordinates;
  if (place < System::kAuxiliaryStates) return state.x[place];
  place -= System::kAuxiliaryStates;
  return place < System::kInputs ? input(place) : parameter(place - System::kInputs);
}

/// Values of a solver with derivatives at a state, and a seed of 1 for one number a direction, see number_at.
template <class System>
struct Seeded {
  using Directions = typename System::Directions;
  static constexpr int kLanes = Directions::kDirections;
  static constexpr int kNumbers =
      2 * System::kCoordinates + System::kAuxiliaryStates + System::kInputs + System::kParameters;
  typename Directions::Parameters parameters;
  typename Directions::Inputs inputs;
  typename Directions::State state;

  Seeded(const typename System::Parameters& of_parameters, const typename System::Inputs& of_inputs,
         const typename System::State& at, int first) noexcept {
    for (int i = 0; i < System::kParameters; ++i)
      parameters.*Directions::kParameterMember[i] = of_parameters.*System::kParameterMember[i];
    for (int i = 0; i < System::kInputs; ++i) inputs.*Directions::kInputMember[i] = of_inputs.*System::kInputMember[i];
    for (int i = 0; i < System::kCoordinates; ++i) {
      state.z[i] = at.z[i];
      state.zd[i] = at.zd[i];
    }
    for (std::size_t i = 0; i < integrator_detail::size_of(at.x); ++i) state.x[i] = at.x[i];
    state.t = at.t;
    if constexpr (System::kBalls > 0)
      for (int i = 0; i < System::kBalls; ++i) state.charts[i] = at.charts[i];
    for (int lane = 0; lane < kLanes && first + lane < kNumbers; ++lane) number(first + lane).tangent[lane] = 1;
  }

  typename Directions::Real& number(int place) noexcept {
    const auto input = [this](int i) -> auto& { return inputs.*Directions::kInputMember[i]; };
    const auto parameter = [this](int i) -> auto& { return parameters.*Directions::kParameterMember[i]; };
    return number_at<System>(state, place, input, parameter);
  }
};

/// The entry of the adjoints for a number of Seeded.
template <class System>
double& entry(typename System::Adjoints& cost, int place) noexcept {
  const auto input = [&](int i) -> double& { return cost.inputs[i]; };
  const auto parameter = [&](int i) -> double& { return cost.parameters[i]; };
  return number_at<System>(cost, place, input, parameter);
}

/// Adds to `cost` the derivatives of weighted results by the numbers from `first_number` on, eight of them in each
/// call of run(seeded, sums), which gives the sums of the results' derivatives.
template <class System, class Run>
Status add_by_directions(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                         const typename System::State& state, int first_number, typename System::Adjoints& cost,
                         const Run& run) noexcept {
  using At = Seeded<System>;
  Status met;
  for (int first = first_number; first < At::kNumbers; first += At::kLanes) {
    At seeded(parameters, inputs, state, first);
    typename System::Directions::Real::Vector sums{};
    const Status status = run(seeded, sums);
    if (!status.ok()) return status;
    met = graver(met, status);
    for (int lane = 0; lane < At::kLanes && first + lane < At::kNumbers; ++lane)
      entry<System>(cost, first + lane) += sums[lane];
  }
  if (!is_finite_sum(cost)) return {Code::not_a_number, -1};
  return met;
}

/// Sum of the derivatives of a state, weighted.
template <class System>
void add_state(const typename System::Directions::State& state, const typename System::Adjoints& weights,
               typename System::Directions::Real::Vector& sums) noexcept {
  for (int i = 0; i < System::kCoordinates; ++i)
    sums += weights.z[i] * state.z[i].tangent + weights.zd[i] * state.zd[i].tangent;
  for (int i = 0; i < System::kAuxiliaryStates; ++i) sums += weights.x[i] * state.x[i].tangent;
}

/// From the derivatives by a state that move(tuned, inputs, state) makes of `before` to those by it.
template <class System, class Move>
Status back_by_directions(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& before, typename System::Adjoints& cost,
                          const Move& move) noexcept {
  typename System::Adjoints back = cost;
  for (double& value : back.z) value = 0;
  for (double& value : back.zd) value = 0;
  for (double& value : back.x) value = 0;
  const Status status =
      add_by_directions<System>(parameters, inputs, before, 0, back, [&](Seeded<System>& seeded, auto& sums) {
        const typename System::Directions::Tuned tuned(seeded.parameters);
        const Status moved = move(tuned, seeded.inputs, seeded.state);
        if (moved.ok()) add_state<System>(seeded.state, cost, sums);
        return moved;
      });
  if (status.ok()) cost = back;
  return status;
}

/// A step back by directions: exact for every step, whichever way it was taken.
template <class System>
Status step_by_directions(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& before, double h, typename System::Adjoints& cost) noexcept {
  return back_by_directions<System>(parameters, inputs, before, cost, [h](auto& tuned, auto& now, auto& state) {
    return System::Directions::step_rk4(tuned, now, state, h);
  });
}

/// Outputs back by directions.
template <class System>
Status outputs_by_directions(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                             const typename System::State& state, const double (&weights)[System::kOutputSize],
                             typename System::Adjoints& cost) noexcept {
  using Directions = typename System::Directions;
  typename System::Adjoints back = cost;
  const Status status =
      add_by_directions<System>(parameters, inputs, state, 0, back, [&](Seeded<System>& seeded, auto& sums) {
        const typename Directions::Tuned tuned(seeded.parameters);
        const typename Directions::Real tau[System::kCoordinates] = {};
        typename Directions::Derivative rates{};
        typename Directions::Outputs values{};
        Status given = Directions::accelerations(tuned, seeded.inputs, seeded.state, tau, rates);
        if (given.ok()) given = Directions::outputs(tuned, seeded.inputs, seeded.state, tau, rates, values);
        for (int i = 0; given.ok() && i < System::kOutputs; ++i)
          sums += weights[i] * (values.*Directions::kOutputMember[i]).tangent;
        return given;
      });
  if (status.ok()) cost = back;
  return status;
}

}  // namespace adjoint_detail

}  // namespace mbgen
