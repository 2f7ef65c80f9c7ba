#pragma once
// A linearly implicit integrator of fixed step: Runge-Kutta-Rosenbrock with an approximate matrix, of order three.
//
// Beside what integrators.hpp asks of a System it offers
//   Tangents                                                          matrix of a step, factorised
//   Status tangents(const State&, double g, Tangents&) const noexcept           at a state; g: s, kRosenbrockFactor h
//   void solve(const Tangents&, double g, const StateRates<System>&, Derivative&) const noexcept
//                                                                     the changes of zd and x for given rates
// Source: J. Rang, L. Angermann, "New Rosenbrock W-methods of order 3 for partial differential algebraic equations of
// index 1", BIT Numerical Mathematics 45 (2005) 761-787: ROS34PW2, here with stages that are changes of the state.

#include "mbgen/integrators.hpp"

namespace mbgen {

/// Factor of the step in the matrix.
constexpr double kRosenbrockFactor = 0.435866521508459;

namespace integrator_detail {

/// Stages 2, 3 and 4: their state is the start with these weights of the changes before, at these parts of the step,
/// and their rates take these weights of the changes before, over the step. The result adds the last change to the
/// state of the last stage.
constexpr double kStage2[] = {2.0};
constexpr double kStage3[] = {1.4192173174557647, -0.2592322116729697};
constexpr double kStage4[] = {4.18476048231916, -0.28519201735549593, 2.294280360279042};
constexpr double kStageTime[] = {0.0, 0.871733043016918, 0.7315799577888524, 1.0};
constexpr double kCoupling2[] = {-4.588560720558084};
constexpr double kCoupling3[] = {-4.18476048231916, 0.28519201735549593};
constexpr double kCoupling4[] = {-6.368179200128358, -6.795620944466837, 2.870098604331056};

/// rates += sum of weights[k] / h changes[k].
template <class System, std::size_t K>
void add_changes(const double (&weights)[K], double h, const StateRates<System>* const (&changes)[K],
                 StateRates<System>& rates) noexcept {
  WeightOf<decltype(System::State::z)> factors[K];
  const decltype(System::State::z)* z[K];
  const decltype(System::State::zd)* zd[K];
  const decltype(System::State::x)* x[K];
  for (std::size_t k = 0; k < K; ++k) {
    factors[k] = static_cast<WeightOf<decltype(System::State::z)>>(weights[k] / h);
    z[k] = &changes[k]->zd;
    zd[k] = &changes[k]->derivative.zdd;
    x[k] = &changes[k]->derivative.xd;
  }
  // Entry by entry: combine() reads overlapping parts of arrays, which must differ from the arrays that it writes.
  const auto add = [&](auto& to, const auto& values) {
    for (std::size_t i = 0; i < size_of(to); ++i) combine_entry(to, factors, values, i, to);
  };
  add(rates.zd, z);
  add(rates.derivative.zdd, zd);
  add(rates.derivative.xd, x);
}

/// The change of the state, in place of rates: it solves (1 / g - A) change = rates, A the matrix of the tangents.
template <class System>
void solve_stage(const System& system, const typename System::Tangents& tangents, double g,
                 StateRates<System>& rates) noexcept {
  typename System::Derivative change;
  system.solve(tangents, g, rates, change);
  const auto factor = static_cast<WeightOf<decltype(System::State::z)>>(g);
  for (std::size_t i = 0; i < size_of(rates.zd); ++i) {
    rates.derivative.zdd[i] = change.zdd[i];
    rates.zd[i] = factor * (rates.zd[i] + change.zdd[i]);
  }
  for (std::size_t i = 0; i < size_of(rates.derivative.xd); ++i) {
    rates.derivative.xd[i] = change.xd[i];
  }
}

/// One stage: its state from the changes before, in `stage`, and its own change. The status may be a notice.
template <class Care, class System, std::size_t K>
Status implicit_stage(Care& care, const System& system, const typename System::Tangents& tangents,
                      const typename System::State& start, const double (&weights)[K], const double (&coupling)[K],
                      const StateRates<System>* const (&before)[K], double h, typename System::State& stage,
                      StateRates<System>& change) noexcept {
  stage.t = start.t + kStageTime[K] * h;
  advance<System>(start, weights, before, stage);
  const Status status = care.rates(system, stage, h, change);
  if (!Care::goes_on(status)) return status;
  add_changes<System>(coupling, h, before, change);
  solve_stage(system, tangents, kRosenbrockFactor * h, change);
  return status;
}

/// One step to `result`, a copy of the state. The status may be a notice.
template <class Care, class System>
Status try_rosenbrock(Care& care, const System& system, const typename System::State& start, double h,
                      typename System::State& result) noexcept {
  typename System::Tangents tangents;
  Status met = system.tangents(start, kRosenbrockFactor * h, tangents);
  if (!Care::goes_on(met)) return met;
  StateRates<System> first, second, third, fourth;
  Status status = care.rates(system, start, h, first);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  solve_stage(system, tangents, kRosenbrockFactor * h, first);
  status = implicit_stage(care, system, tangents, start, kStage2, kCoupling2, {&first}, h, result, second);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  status = implicit_stage(care, system, tangents, start, kStage3, kCoupling3, {&first, &second}, h, result, third);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  status =
      implicit_stage(care, system, tangents, start, kStage4, kCoupling4, {&first, &second, &third}, h, result, fourth);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  typename System::State last;
  copy_state(result, last);
  advance<System>(last, {1.0}, {&fourth}, result);
  status = finish(care, system, h, result);
  return status.ok() ? graver(met, status) : status;
}

}  // namespace integrator_detail

/// One step of h seconds: the matrix once, four evaluations, four solutions, no iteration, then projection. Of order
/// three for any matrix; L-stable for the terms that the matrix contains. Gives notices as step_rk4. Fails: as
/// step_rk4, implicit_singular and implicit_state_grows.
template <class System>
Status step_rosenbrock(const System& system, typename System::State& state, double h) noexcept {
  using State = typename System::State;
  return integrator_detail::one_step(system, state, h, kRosenbrockTurn,
                                     [&](auto& care, const State& start, State& result) {
                                       return integrator_detail::try_rosenbrock(care, system, start, h, result);
                                     });
}

}  // namespace mbgen
