#pragma once
// Integrators of fixed step: Runge-Kutta, and Adams-Bashforth-Moulton with two evaluations, both of order four.
//
// A System offers types and functions:
//   State       members z, zd, x (arrays of double or containers with size()) and double t
//   Derivative  members zdd, xd of the same sizes as zd, x
//   Status derivative(const State&, Derivative&) const noexcept    gives the result its size where it has none
//   Status project(State&) const noexcept                          closes loops, then makes velocities consistent
//   Status project_nearest(State&) const noexcept                  the same by the shortest corrections, near singular
//                                                                  positions
// They may give notices (status.hpp); near_singular and singular_met say how near a singular position the state is.
// Every step integrates all of z, zd and x, then projects. When anything fails the state and the history stay as they
// were. Steps allocate nothing but what copies of the System's own types allocate.

#include <cmath>

#include "mbgen/passage.hpp"
#include "mbgen/states.hpp"

namespace mbgen {

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

inline Status check_step(double h) noexcept {
  return h > 0 && std::isfinite(h) ? Status{} : Status{Code::step_invalid, -1};
}

template <class Care, class System>
Status finish(const System& system, double h, typename System::State& state) noexcept {
  const Status status = Care::check(state);
  return status.ok() ? Care::close(system, state, h) : status;
}

/// One Runge-Kutta step from `start`, whose rates are known, to `result`, a copy of it. The status may be a notice.
template <class Care, class System>
Status runge_kutta(const System& system, const typename System::State& start, const StateRates<System>& first, double h,
                   typename System::State& result) noexcept {
  StateRates<System> second, third, fourth;
  result.t = start.t + 0.5 * h;
  advance<System, 1>(start, {0.5 * h}, {&first}, result);
  Status status = Care::rates(system, result, h, second);
  Status met = status;
  if (!Care::goes_on(status)) return status;
  advance<System, 1>(start, {0.5 * h}, {&second}, result);
  status = Care::rates(system, result, h, third);
  met = more_telling(met, status);
  if (!Care::goes_on(status)) return status;
  result.t = start.t + h;
  advance<System, 1>(start, {h}, {&third}, result);
  status = Care::rates(system, result, h, fourth);
  met = more_telling(met, status);
  if (!Care::goes_on(status)) return status;
  advance<System, 4>(start, {h / 6, h / 3, h / 3, h / 6}, {&first, &second, &third, &fourth}, result);
  status = finish<Care>(system, h, result);
  return status.ok() ? more_telling(met, status) : status;
}

/// Adams-Bashforth from the history, one evaluation, Adams-Moulton. The status may be a notice.
template <class Care, class System>
Status predict_correct(const System& system, const typename System::State& start, const AbmHistory<System>& history,
                       double h, typename System::State& result) noexcept {
  const StateRates<System>* const r[] = {&history.rates[0], &history.rates[1], &history.rates[2], &history.rates[3]};
  const double c = h / 24;
  StateRates<System> predicted;
  result.t = start.t + h;
  advance<System, 4>(start, {55 * c, -59 * c, 37 * c, -9 * c}, r, result);
  const Status met = Care::rates(system, result, h, predicted);
  if (!Care::goes_on(met)) return met;
  advance<System, 4>(start, {9 * c, 19 * c, -5 * c, c}, {&predicted, r[0], r[1], r[2]}, result);
  const Status status = finish<Care>(system, h, result);
  return status.ok() ? more_telling(met, status) : status;
}

/// One step with four evaluations to `result`, a copy of the state.
template <class Care, class System>
Status try_rk4(const System& system, const typename System::State& state, double h,
               typename System::State& result) noexcept {
  StateRates<System> first;
  const Status met = Care::rates(system, state, h, first);
  if (!Care::goes_on(met)) return met;
  const Status status = runge_kutta<Care>(system, state, first, h, result);
  return status.ok() ? more_telling(met, status) : status;
}

/// Rates at both ends of a step.
template <class System>
struct Ends {
  StateRates<System> current, next;
};

/// One step with the history where it is full, else by Runge-Kutta, to `result`, a copy of the state. known: how many
/// rates the history has for this step.
template <class Care, class System>
Status try_abm4(const System& system, const typename System::State& state, const AbmHistory<System>& history, int known,
                double h, typename System::State& result, Ends<System>& ends) noexcept {
  Status met;
  if (known > 0) {
    copy_rates(history.rates[0], ends.current);
  } else {
    met = Care::rates(system, state, h, ends.current);
    if (!Care::goes_on(met)) return met;
  }
  Status status = known == 4 ? predict_correct<Care>(system, state, history, h, result)
                             : runge_kutta<Care>(system, state, ends.current, h, result);
  met = more_telling(met, status);
  if (!Care::goes_on(status)) return status;
  status = Care::rates(system, result, h, ends.next);
  return status.ok() ? more_telling(met, status) : status;
}

}  // namespace integrator_detail

/// One step of h seconds by the classical Runge-Kutta method, four evaluations, then projection. A step that comes near
/// a singular position of a loop is taken with closed stages, see passage.hpp.
/// Gives the most telling notice of the System's functions; singular_met when a singular position was passed.
/// Fails: step_invalid; not_a_number when the result overflows; and as the system's functions.
/// Source: W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
template <class System>
Status step_rk4(const System& system, typename System::State& state, double h) noexcept {
  using namespace integrator_detail;
  Status status = check_step(h);
  if (!status.ok()) return status;
  typename System::State result;
  copy_state(state, result);
  status = try_rk4<Plain>(system, state, h, result);
  if (asks_for_care(status)) {
    copy_state(state, result);
    status = try_rk4<Careful>(system, state, h, result);
  }
  if (status.ok()) copy_state(result, state);
  return status;
}

/// One step of h seconds by Adams-Bashforth-Moulton of order four, evaluated at the predicted and at the projected
/// state: two evaluations a step. The first three steps, and those after a change of h or a jump of t, are by
/// Runge-Kutta.
/// Gives notices and fails as step_rk4.
/// Source: L. F. Shampine, M. K. Gordon, Computer Solution of Ordinary Differential Equations, 1975 (PECE).
template <class System>
Status step_abm4(const System& system, typename System::State& state, AbmHistory<System>& history, double h) noexcept {
  using namespace integrator_detail;
  Status status = check_step(h);
  if (!status.ok()) return status;
  const int known = history.h == h && history.t == state.t ? history.count : 0;
  typename System::State result;
  Ends<System> ends;
  copy_state(state, result);
  status = try_abm4<Plain>(system, state, history, known, h, result, ends);
  if (asks_for_care(status)) {
    copy_state(state, result);
    status = try_abm4<Careful>(system, state, history, known, h, result, ends);
  }
  if (!status.ok()) return status;

  for (int k = 3; k > 1; --k) copy_rates(history.rates[k - 1], history.rates[k]);
  copy_rates(ends.current, history.rates[1]);
  copy_rates(ends.next, history.rates[0]);
  history.count = known < 1 ? 2 : known < 4 ? known + 1 : 4;
  history.h = h;
  history.t = result.t;
  copy_state(result, state);
  return status;
}

/// Rates of a moving state, for outputs: at a singular position as the steps of h seconds see them.
/// Fails: as the system's functions.
template <class System>
Status rates_in_motion(const System& system, const typename System::State& state, double h,
                       typename System::Derivative& derivative) noexcept {
  using namespace integrator_detail;
  StateRates<System> rates;
  Status status = Plain::rates(system, state, h, rates);
  if (status.code == Code::singular_met || status.code == Code::loop_singular) {
    status = Careful::rates(system, state, h, rates);
  }
  if (!status.ok()) return status;
  copy(rates.derivative.zdd, derivative.zdd);
  copy(rates.derivative.xd, derivative.xd);
  return status;
}

}  // namespace mbgen
