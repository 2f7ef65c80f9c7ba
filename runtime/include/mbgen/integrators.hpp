#pragma once
// Integrators of fixed step: Runge-Kutta, and Adams-Bashforth-Moulton with two evaluations, both of order four.
//
// A System offers types and functions:
//   State       members z, zd, x (arrays of double or containers with size()) and double t
//   Derivative  members zdd, xd of the same sizes as zd, x
//   Status derivative(const State&, Derivative&) const noexcept    gives the result its size where it has none
//   Status project(State&) const noexcept                          closes loops, then makes velocities consistent
// Every step integrates all of z, zd and x, then projects. When anything fails the state and the history stay as they
// were. Steps allocate nothing but what copies of the System's own types allocate.

#include <cmath>
#include <cstddef>

#include "mbgen/status.hpp"

namespace mbgen {

/// Rates of a whole state: of z, and of zd and x.
template <class System>
struct StateRates {
  decltype(System::State::zd) zd;
  typename System::Derivative derivative;
};

/// Rates that step_abm4 remembers. Start with a value-initialised one: `AbmHistory<System> history{};`.
/// Empty it the same way when the state or an input was changed from outside.
template <class System>
struct AbmHistory {
  StateRates<System> rates[4];  ///< [0] at the state that the last step left, then backwards
  int count = 0;                ///< how many of them are known
  double h = 0;                 ///< s, the step between them
  double t = 0;                 ///< s, the time of [0]
};

namespace integrator_detail {

template <std::size_t N>
constexpr std::size_t size_of(const double (&)[N]) noexcept {
  return N;
}
template <class Container>
std::size_t size_of(const Container& values) noexcept {
  return values.size();
}

template <std::size_t N>
void copy(const double (&from)[N], double (&to)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) to[i] = from[i];
}
template <class Container>
void copy(const Container& from, Container& to) noexcept {
  to = from;
}

/// Member by member: the copy of a large struct would be a call of memcpy, which a bare target may not have.
template <class State>
void copy_state(const State& from, State& to) noexcept {
  copy(from.z, to.z);
  copy(from.zd, to.zd);
  copy(from.x, to.x);
  to.t = from.t;
}

template <class System>
void copy_rates(const StateRates<System>& from, StateRates<System>& to) noexcept {
  copy(from.zd, to.zd);
  copy(from.derivative.zdd, to.derivative.zdd);
  copy(from.derivative.xd, to.derivative.xd);
}

template <class System>
Status evaluate(const System& system, const typename System::State& state, StateRates<System>& rates) noexcept {
  copy(state.zd, rates.zd);
  return system.derivative(state, rates.derivative);
}

/// state = start + sum of weights[k] rates[k]; the time is the caller's. weights: s.
template <class System, int N>
void advance(const typename System::State& start, const double (&weights)[N],
             const StateRates<System>* const (&rates)[N], typename System::State& state) noexcept {
  for (std::size_t i = 0; i < size_of(start.z); ++i) {
    double dz = 0, dzd = 0;
    for (int k = 0; k < N; ++k) {
      dz += weights[k] * rates[k]->zd[i];
      dzd += weights[k] * rates[k]->derivative.zdd[i];
    }
    state.z[i] = start.z[i] + dz;
    state.zd[i] = start.zd[i] + dzd;
  }
  for (std::size_t i = 0; i < size_of(start.x); ++i) {
    double dx = 0;
    for (int k = 0; k < N; ++k) dx += weights[k] * rates[k]->derivative.xd[i];
    state.x[i] = start.x[i] + dx;
  }
}

/// not_a_number when a coordinate, velocity or auxiliary state is not finite.
template <class State>
Status check_finite(const State& state) noexcept {
  for (std::size_t i = 0; i < size_of(state.z); ++i) {
    if (!std::isfinite(state.z[i]) || !std::isfinite(state.zd[i])) return {Code::not_a_number, static_cast<int>(i)};
  }
  for (std::size_t i = 0; i < size_of(state.x); ++i) {
    if (!std::isfinite(state.x[i])) return {Code::not_a_number, -1};
  }
  return {};
}

inline Status check_step(double h) noexcept {
  return h > 0 && std::isfinite(h) ? Status{} : Status{Code::step_invalid, -1};
}

template <class System>
Status finish(const System& system, typename System::State& state) noexcept {
  const Status status = check_finite(state);
  return status.ok() ? system.project(state) : status;
}

/// One Runge-Kutta step from `start`, whose rates are known, to `result`, a copy of it.
template <class System>
Status runge_kutta(const System& system, const typename System::State& start, const StateRates<System>& first, double h,
                   typename System::State& result) noexcept {
  StateRates<System> second, third, fourth;
  result.t = start.t + 0.5 * h;
  advance<System, 1>(start, {0.5 * h}, {&first}, result);
  Status status = evaluate(system, result, second);
  if (!status.ok()) return status;
  advance<System, 1>(start, {0.5 * h}, {&second}, result);
  status = evaluate(system, result, third);
  if (!status.ok()) return status;
  result.t = start.t + h;
  advance<System, 1>(start, {h}, {&third}, result);
  status = evaluate(system, result, fourth);
  if (!status.ok()) return status;
  advance<System, 4>(start, {h / 6, h / 3, h / 3, h / 6}, {&first, &second, &third, &fourth}, result);
  return finish(system, result);
}

/// Adams-Bashforth from the history, one evaluation, Adams-Moulton.
template <class System>
Status predict_correct(const System& system, const typename System::State& start, const AbmHistory<System>& history,
                       double h, typename System::State& result) noexcept {
  const StateRates<System>* const r[] = {&history.rates[0], &history.rates[1], &history.rates[2], &history.rates[3]};
  const double c = h / 24;
  StateRates<System> predicted;
  result.t = start.t + h;
  advance<System, 4>(start, {55 * c, -59 * c, 37 * c, -9 * c}, r, result);
  const Status status = evaluate(system, result, predicted);
  if (!status.ok()) return status;
  advance<System, 4>(start, {9 * c, 19 * c, -5 * c, c}, {&predicted, r[0], r[1], r[2]}, result);
  return finish(system, result);
}

}  // namespace integrator_detail

/// One step of h seconds by the classical Runge-Kutta method, four evaluations, then projection.
/// Fails: step_invalid; not_a_number when the result overflows; and as the system's functions.
/// Source: W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
template <class System>
Status step_rk4(const System& system, typename System::State& state, double h) noexcept {
  Status status = integrator_detail::check_step(h);
  if (!status.ok()) return status;
  StateRates<System> first;
  status = integrator_detail::evaluate(system, state, first);
  if (!status.ok()) return status;
  typename System::State result;
  integrator_detail::copy_state(state, result);
  status = integrator_detail::runge_kutta(system, state, first, h, result);
  if (status.ok()) integrator_detail::copy_state(result, state);
  return status;
}

/// One step of h seconds by Adams-Bashforth-Moulton of order four, evaluated at the predicted and at the projected
/// state: two evaluations a step. The first three steps, and those after a change of h or a jump of t, are by
/// Runge-Kutta.
/// Fails: as step_rk4.
/// Source: L. F. Shampine, M. K. Gordon, Computer Solution of Ordinary Differential Equations, 1975 (PECE).
template <class System>
Status step_abm4(const System& system, typename System::State& state, AbmHistory<System>& history, double h) noexcept {
  using namespace integrator_detail;
  Status status = check_step(h);
  if (!status.ok()) return status;
  const bool goes_on = history.count > 0 && history.h == h && history.t == state.t;
  const int known = goes_on ? history.count : 1;
  StateRates<System> current;
  if (goes_on) {
    copy_rates(history.rates[0], current);
  } else {
    status = evaluate(system, state, current);
    if (!status.ok()) return status;
  }
  typename System::State result;
  copy_state(state, result);
  status =
      known == 4 ? predict_correct(system, state, history, h, result) : runge_kutta(system, state, current, h, result);
  if (!status.ok()) return status;
  StateRates<System> next;
  status = evaluate(system, result, next);
  if (!status.ok()) return status;

  for (int k = 3; k > 1; --k) copy_rates(history.rates[k - 1], history.rates[k]);
  copy_rates(current, history.rates[1]);
  copy_rates(next, history.rates[0]);
  history.count = known < 4 ? known + 1 : 4;
  history.h = h;
  history.t = result.t;
  copy_state(result, state);
  return status;
}

}  // namespace mbgen
