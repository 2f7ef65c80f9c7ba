#pragma once
// Integrators of fixed step: Runge-Kutta, and Adams-Bashforth-Moulton with two evaluations, both of order four.
//
// A System offers types and functions:
//   State       members z, zd, x (arrays of double or containers with size()) and double t
//   Derivative  members zdd, xd of the same sizes as zd, x
//   Status derivative(const State&, Derivative&) const noexcept    gives the result its size where it has none
//   Status project(State&) const noexcept                          closes loops, then makes velocities consistent
//   bool leaves_charts(const State&) const noexcept                only where states have charts of balls (charts.hpp):
//   bool settle_charts(State&) const noexcept                      whether one does not suit its position; puts each
//                                                                  into the chart that does
//   void change_charts(const State& from, const State& to, z, zd, zdd) const noexcept
//                                                                  takes these numbers from the charts of one state to
//                                                                  those of another
//   Status sample(State&, double h, bool& any) const noexcept      only where states have sampled values: sets those
//                                                                  whose instant is at the start of a step of h
//                                                                  seconds, and says whether there are any
//   Status project_nearest(State&) const noexcept                  the same by the shortest corrections, near singular
//                                                                  positions
//   Status project_crossing(State&, double& clearance) const noexcept
//                                                                  only where loops can be singular: closes a state at
//                                                                  a singular position, and fails where branches come
//                                                                  close there and do not cross; see motion.hpp
//   int changed_side(const State& from, const State& to) const noexcept
//                                                                  only there: a loop block that is on another side of
//                                                                  a singular position than before, or -1
//   Status watch_way(const State& from, const State& to, double h, const WayLimits&) const noexcept
//                                                                  only there: ok, singular_met for a block that is on
//                                                                  another side, or loop_singular for one that turned
//                                                                  aside from a singular position within a step that is
//                                                                  too long for it
// They may give notices (status.hpp); near_singular and singular_met say how near a singular position the state is.
// Every step sets sampled values, settles charts, integrates all of z, zd and x, then projects. When anything fails the
// state and the history stay as they were. Steps allocate only by copies of the System's own types.

#include <type_traits>

#include "mbgen/number.hpp"
#include "mbgen/solver/care.hpp"
#include "mbgen/solver/regular.hpp"
#include "mbgen/solver/states.hpp"
#include "mbgen/turns.hpp"

namespace mbgen {

/// Positions at which the rates of a history are: with them its rates go over to other charts of balls. None where
/// states have no charts. Places as AbmHistory::rates.
template <class System, class = void>
struct PastPositions {};
template <class System>
struct PastPositions<System, std::void_t<decltype(System::State::charts)>> {
  decltype(System::State::z) past_z[5];
};

/// Rates that step_abm4 remembers. Start with a value-initialised one: `AbmHistory<System> history{};`.
/// Empty it the same way when the state or an input was changed from outside.
template <class System>
struct AbmHistory : PastPositions<System> {  // NOLINT(bugprone-reserved-identifier): of the compiler, where it copies
  static constexpr int kRing = 5;            ///< four that are known, and room for those of the next step
  StateRates<System> rates[kRing];           ///< see past_rates
  int newest = 0;  ///< place of the rates at the state that the last step left; then backwards in time
  int count = 0;   ///< how many of them are known
  double h = 0;    ///< s, the step between them
  double t = 0;    ///< s, the time of the newest
};

/// Rates of `history`, k = 0 at the state that the last step left, then backwards in time; k < 4.
template <class System>
const StateRates<System>& past_rates(const AbmHistory<System>& history, int k) noexcept {
  return history.rates[(history.newest + k) % history.kRing];
}

namespace integrator_detail {

/// Relative difference in a step below which times are equal: callers may keep the time as a multiple of the step.
constexpr double kSameTime = 1e-6;

/// Whether states of a System have balls with charts.
template <class System, class = void>
inline constexpr bool kHasCharts = false;
template <class System>
inline constexpr bool kHasCharts<System, std::void_t<decltype(&System::settle_charts)>> = true;

/// Whether states of a System have values that are set at instants.
template <class System, class = void>
inline constexpr bool kHasSamples = false;
template <class System>
inline constexpr bool kHasSamples<System, std::void_t<decltype(&System::sample)>> = true;

inline Status check_step(double h) noexcept {
  return h > 0 && is_finite(h) ? Status{} : Status{Code::step_invalid, -1};
}

template <class Care, class System>
Status finish(Care& care, const System& system, double h, typename System::State& state) noexcept {
  const Status status = Care::check(state);
  return status.ok() ? care.close(system, state, h) : status;
}

/// One Runge-Kutta step from `start`, whose rates are known, to `result`, a copy of it. The status may be a notice.
template <class Care, class System>
Status runge_kutta(Care& care, const System& system, const typename System::State& start,
                   const StateRates<System>& first, double h, typename System::State& result) noexcept {
  StateRates<System> second, third, fourth;
  result.t = start.t + 0.5 * h;
  advance<System>(start, {0.5 * h}, {&first}, result);
  Status status = care.rates(system, result, h, second);
  Status met = status;
  if (!Care::goes_on(status)) return status;
  advance<System>(start, {0.5 * h}, {&second}, result);
  status = care.rates(system, result, h, third);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  result.t = start.t + h;
  advance<System>(start, {h}, {&third}, result);
  status = care.rates(system, result, h, fourth);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  advance<System>(start, {h / 6, h / 3, h / 3, h / 6}, {&first, &second, &third, &fourth}, result);
  status = finish(care, system, h, result);
  return status.ok() ? graver(met, status) : status;
}

/// The last four rates, the newest first.
template <class System>
using PastRates = const StateRates<System>* [4];

/// Adams-Bashforth from the past rates, one evaluation, Adams-Moulton. The status may be a notice.
template <class Care, class System>
Status predict_correct(Care& care, const System& system, const typename System::State& start,
                       const PastRates<System>& r, double h, typename System::State& result) noexcept {
  const double c = h / 24;
  StateRates<System> predicted;
  result.t = start.t + h;
  advance<System>(start, {55 * c, -59 * c, 37 * c, -9 * c}, {r[0], r[1], r[2], r[3]}, result);
  const Status met = care.rates(system, result, h, predicted);
  if (!Care::goes_on(met)) return met;
  advance<System>(start, {9 * c, 19 * c, -5 * c, c}, {&predicted, r[0], r[1], r[2]}, result);
  const Status status = finish(care, system, h, result);
  return status.ok() ? graver(met, status) : status;
}

/// One step with four evaluations to `result`, a copy of the state.
template <class Care, class System>
Status try_rk4(Care& care, const System& system, const typename System::State& state, double h,
               typename System::State& result) noexcept {
  StateRates<System> first;
  const Status met = care.rates(system, state, h, first);
  if (!Care::goes_on(met)) return met;
  const Status status = runge_kutta(care, system, state, first, h, result);
  return status.ok() ? graver(met, status) : status;
}

/// One step from four known past rates, else by Runge-Kutta, to `result`, a copy of the state. known: number of past
/// rates; if 0, the rates at the state are written to `current`, which is past[0]. next: rates at the result.
template <class Care, class System>
Status try_abm4(Care& care, const System& system, const typename System::State& state, const PastRates<System>& past,
                int known, double h, typename System::State& result, StateRates<System>& current,
                StateRates<System>& next) noexcept {
  Status met;
  if (known == 0) {
    met = care.rates(system, state, h, current);
    if (!Care::goes_on(met)) return met;
  }
  Status status = known == 4 ? predict_correct(care, system, state, past, h, result)
                             : runge_kutta(care, system, state, *past[0], h, result);
  met = graver(met, status);
  if (!Care::goes_on(status)) return status;
  status = care.rates(system, result, h, next);
  return status.ok() ? graver(met, status) : status;
}

/// Takes a step by `step` from the state with its charts settled; the state keeps its charts if the step fails.
/// take_over: converts the history of the step from the charts of one state to those of another; its result is a
/// function that restores the history.
template <class System, class Step, class TakeOver>
Status with_settled_charts(const System& system, typename System::State& state, const Step& step,
                           const TakeOver& take_over) noexcept {
  if constexpr (kHasCharts<System>) {
    if (!system.leaves_charts(state)) return step(state);
    typename System::State settled;
    copy_state(state, settled);
    system.settle_charts(settled);
    const auto put_back = take_over(state, settled);
    const Status status = step(settled);
    if (status.ok()) {
      copy_state(settled, state);
    } else {
      put_back();
    }
    return status;
  } else {
    return step(state);
  }
}

/// Takes a step of h seconds by `step` (state, whether values were set) after setting the values that are due at its
/// start; the state keeps them if the step fails.
template <class System, class Step>
Status with_samples(const System& system, typename System::State& state, double h, const Step& step) noexcept {
  if constexpr (kHasSamples<System>) {
    bool any = false;
    typename System::State sampled;
    copy_state(state, sampled);
    Status status = system.sample(sampled, h, any);
    if (!status.ok()) return status;
    if (!any) return step(state, false);
    status = step(sampled, true);
    if (status.ok()) copy_state(sampled, state);
    return status;
  } else {
    return step(state, false);
  }
}

/// One step of h seconds by a method without history. most, attempt(care, start, result): see plainly_or_carefully.
template <class System, class Attempt>
Status one_step(const System& system, typename System::State& state, double h, double most,
                const Attempt& attempt) noexcept {
  using State = typename System::State;
  const Status status = check_step(h);
  if (!status.ok()) return status;
  const auto from_settled = [&](State& start) {
    State result;
    const Status stepped = plainly_or_carefully(system, start, h, most, result,
                                                [&](auto& care, State& to) { return attempt(care, start, to); });
    if (stepped.ok()) copy_state(result, start);
    return stepped;
  };
  return with_samples(system, state, h, [&](State& sampled, bool) {
    return with_settled_charts(system, sampled, from_settled, [](const State&, const State&) { return [] {}; });
  });
}

}  // namespace integrator_detail

/// One step of h seconds by the classical Runge-Kutta method, four evaluations, then projection. A step that comes near
/// a singular position of a loop is taken with closed stages, see singular_step.hpp.
/// Gives the most telling notice of the System's functions; singular_met when a singular position was passed.
/// Fails: step_invalid; not_a_number when the result overflows; and as the system's functions.
/// Source: W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
template <class System>
Status step_rk4(const System& system, typename System::State& state, double h) noexcept {
  using State = typename System::State;
  return integrator_detail::one_step(system, state, h, kRk4Turn, [&](auto& care, const State& start, State& result) {
    return integrator_detail::try_rk4(care, system, start, h, result);
  });
}

namespace integrator_detail {

/// One step by Adams-Bashforth-Moulton from a state with settled charts.
template <class System>
Status settled_abm4(const System& system, typename System::State& state, AbmHistory<System>& history,
                    double h) noexcept {
  const bool goes_on = history.h == h && magnitude(history.t - state.t) <= kSameTime * h;
  const int known = goes_on ? history.count : 0;
  typename System::State result;
  StateRates<System> start;  // not in the ring: a step that fails leaves all of it
  PastRates<System> past;
  for (int k = 0; k < 4; ++k) past[k] = &past_rates(history, k);
  if (known == 0) past[0] = &start;
  const int next = (history.newest + history.kRing - 1) % history.kRing;
  const Status status =
      plainly_or_carefully(system, state, h, kAbm4Turn, result, [&](auto& care, typename System::State& to) {
        return try_abm4(care, system, state, past, known, h, to, start, history.rates[next]);
      });
  if (!status.ok()) return status;

  if (known == 0) copy_rates(start, history.rates[history.newest]);
  if constexpr (kHasCharts<System>) {
    if (known == 0) copy(state.z, history.past_z[history.newest]);
    copy(result.z, history.past_z[next]);
  }
  history.newest = next;
  history.count = known < 1 ? 2 : known < 4 ? known + 1 : 4;
  history.h = h;
  history.t = result.t;
  copy_state(result, state);
  return status;
}

/// Rates of a history before a change of charts: a way back by the charts would lose bits, and find the other angles of
/// a turn whose second angle is beyond a quarter. Places as past_rates.
template <class System>
struct HistoryBefore {
  AbmHistory<System>& history;
  decltype(System::State::z) z[4];
  decltype(System::State::zd) zd[4];
  decltype(System::Derivative::zdd) zdd[4];

  explicit HistoryBefore(AbmHistory<System>& of) noexcept : history(of) {}  // rows of zeros would be a call of memset
  /// Puts it back.
  void operator()() const noexcept {
    for (int k = 0; k < history.count; ++k) {
      const int place = (history.newest + k) % history.kRing;
      copy(z[k], history.past_z[place]);
      copy(zd[k], history.rates[place].zd);
      copy(zdd[k], history.rates[place].derivative.zdd);
    }
  }
};

/// Converts the rates of a history from the charts of one state to those of another. Result: their former values.
template <class System>
auto change_history([[maybe_unused]] const System& system, [[maybe_unused]] const typename System::State& from,
                    [[maybe_unused]] const typename System::State& to,
                    [[maybe_unused]] AbmHistory<System>& history) noexcept {
  if constexpr (kHasCharts<System>) {
    HistoryBefore<System> before(history);
    for (int k = 0; k < history.count; ++k) {
      const int place = (history.newest + k) % history.kRing;
      StateRates<System>& rates = history.rates[place];
      copy(history.past_z[place], before.z[k]);
      copy(rates.zd, before.zd[k]);
      copy(rates.derivative.zdd, before.zdd[k]);
      system.change_charts(from, to, history.past_z[place], rates.zd, rates.derivative.zdd);
    }
    return before;
  } else {
    return [] {};
  }
}

}  // namespace integrator_detail

/// One step of h seconds by Adams-Bashforth-Moulton of order four, evaluated at the predicted and at the projected
/// state: two evaluations a step. The first three steps, and those after a change of h, a jump of t or an instant of a
/// sampled value, are by Runge-Kutta. A change of charts takes the history over. Gives notices and fails as step_rk4.
/// Source: L. F. Shampine, M. K. Gordon, Computer Solution of Ordinary Differential Equations, 1975 (PECE).
template <class System>
Status step_abm4(const System& system, typename System::State& state, AbmHistory<System>& history, double h) noexcept {
  using namespace integrator_detail;
  const Status status = check_step(h);
  if (!status.ok()) return status;
  using State = typename System::State;
  const int known = history.count;
  const Status stepped = with_samples(system, state, h, [&](State& sampled, bool any) {
    if (any) history.count = 0;  // rates jump with the values
    return with_settled_charts(
        system, sampled, [&](State& settled) { return settled_abm4(system, settled, history, h); },
        [&](const State& from, const State& to) { return change_history(system, from, to, history); });
  });
  if (!stepped.ok()) history.count = known;
  return stepped;
}

/// Rates of a moving state, for outputs: at a singular position as the steps of h seconds see them.
/// Fails: as the system's functions.
template <class System>
Status rates_in_motion(const System& system, const typename System::State& state, double h,
                       typename System::Derivative& derivative) noexcept {
  using namespace integrator_detail;
  StateRates<System> rates;
  Plain<System> plain(state.t);
  Status status = plain.rates(system, state, h, rates);
  if (status.code == Code::singular_met || status.code == Code::loop_singular) {
    if constexpr (kRegularOnly<System>) {
      return {kNotRegular, -1};
    } else {
      status = Careful<System>(plain, status).rates(system, state, h, rates);
    }
  }
  if (!status.ok()) return status;
  copy(rates.derivative.zdd, derivative.zdd);
  copy(rates.derivative.xd, derivative.xd);
  return status;
}

}  // namespace mbgen
