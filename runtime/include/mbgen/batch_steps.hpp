#pragma once
// Steps of several instances in lanes: the integrators of integrators.hpp over vectors. A lane in which anything but
// the plain way of a step is met is not good, and the caller takes its whole step again by the scalar solver.

#include "mbgen/integrators.hpp"
#include "mbgen/lanes/batch.hpp"
#include "mbgen/motion.hpp"

namespace mbgen {

namespace batch_detail {

/// A System of batch.hpp as an integrator sees it. Its functions always say ok; `good` loses the lanes that are not.
template <class System>
struct LaneDynamics {
  using State = typename System::State;
  using Derivative = typename System::Accelerations;  ///< with rates where the program puts them
  const ParametersOf<System>& parameters;
  const InputsOf<System>& inputs;
  const typename System::Row& start;  ///< s, time of the inputs
  typename System::Mask& good;

  Status derivative(const State& state, Derivative& derivative) const noexcept {
    good &= evaluate_lanes<System>(parameters, inputs_at(state.t), state, nullptr, kNearSingular<double>, derivative);
    return {};
  }
  Status project(State& state) const noexcept {
    good &= project_lanes_in_motion<System>(parameters, inputs_at(state.t), state);
    return {};
  }

  InputsOf<System> inputs_at(const typename System::Row& t) const noexcept {
    InputsOf<System> later;
    const typename System::Row dt = t - start;
    for (int g = 0; g < System::kGroups; ++g) later.group[g] = System::inputs_at(inputs.group[g], part_of(dt, g));
    return later;
  }
};

/// Plain stages; the mask holds the lanes that need the scalar solver.
struct LaneStages {
  static constexpr bool goes_on(Status) noexcept { return true; }

  template <class State>
  static Status check(const State&) noexcept {
    return {};
  }
  template <class System>
  static Status rates(const System& system, const typename System::State& stage, double /*h*/,
                      StateRates<System>& rates) noexcept {
    return integrator_detail::evaluate(system, stage, rates);
  }
  template <class System>
  static Status close(const System& system, typename System::State& state, double /*h*/) noexcept {
    return system.project(state);
  }
};

/// Squares of the rates where `taken` (int coordinate -> bool), lane by lane.
template <class Row, int N, class Taken>
Row squares_of_rates(const Row (&zd)[N], const Taken& taken) noexcept {
  Row squares{};
  for (int i = 0; i < N; ++i) {
    if (taken(i)) squares = squares + zd[i] * zd[i];
  }
  return squares;
}

/// Steps that nobody looks at: of models without loops, or with loops that keep their frozen partition.
struct NoWays {
  template <class Mask, class State>
  Mask operator()(const Mask& good, const State& /*result*/) const noexcept {
    return good;
  }
};

}  // namespace batch_detail

/// The lanes of `good` that keep their step, as watch_way looks at it: those whose loops do not move by more than
/// `least`, and of the others those of which `keeps` (int lane -> bool) says so.
template <class System, class Keeps>
typename System::Mask look_at_ways(const typename System::Mask& good, const typename System::State& state,
                                   const typename System::State& result, double least, const Keeps& keeps) noexcept {
  static constexpr solver_detail::InLoops<System, double> kInLoops{};
  typename System::Row squares{};
  for (int i = 0; i < System::kCoordinates; ++i) {
    const typename System::Row way = result.z[i] - state.z[i];
    if (kInLoops.is[i] != 0) squares = squares + way * way;
  }
  const typename System::Mask far = good & (squares > least * least);
  typename System::Mask kept = good;
  for (int lane = 0; lane < System::kLanes && bits_of(far) != 0; ++lane) {
    if (far[lane] != 0 && !keeps(lane)) kept[lane] = 0;
  }
  return kept;
}

/// Statuses of a step of h seconds with the notice turned_far in the good lanes, as with_turns.
template <class System, int W, std::size_t N>
LaneStatuses<W> with_turns_of_lanes(LaneStatuses<W> statuses, const typename System::Mask& good,
                                    const typename System::State& result, const double (&turning)[N], double h,
                                    double largest) noexcept {
  const double rate = largest / h;
  const typename System::Row squares =
      batch_detail::squares_of_rates(result.zd, [&](int i) { return turning[i] != 0; });
  const typename System::Mask far = good & (squares > rate * rate);
  for (int lane = 0; lane < W && bits_of(far) != 0; ++lane) {
    if (far[lane] == 0) continue;
    double zd[N];
    for (std::size_t i = 0; i < N; ++i) zd[i] = result.zd[i][lane];
    statuses[lane] = with_turns(statuses[lane], zd, turning, h, largest);
  }
  return statuses;
}

/// True for a step size that a step takes.
inline bool is_step(double h) noexcept { return integrator_detail::check_step(h).ok(); }

/// One step by the classical Runge-Kutta method, as step_rk4. result: a copy of the state. look: (good lanes, result)
/// -> the lanes that stay, see look_at_ways. Result: the good lanes. Requires: is_step(h).
template <class System, class Look>
typename System::Mask step_lanes_rk4(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                     const typename System::State& state, double h, typename System::State& result,
                                     const Look& look) noexcept {
  typename System::Mask good = batch_detail::keeps_charts<System>(state);
  const batch_detail::LaneDynamics<System> dynamics{parameters, inputs, state.t, good};
  batch_detail::LaneStages stages;
  integrator_detail::try_rk4(stages, dynamics, state, h, result);
  return look(good, result);
}

namespace batch_detail {

template <class Row, int W, int N>
void load_rows(const double (&from)[N][W], Row (&to)[N]) noexcept {
  for (int i = 0; i < N; ++i) to[i] = load_row<Row>(from[i]);
}

/// Rows of the lanes in the mask.
template <class Mask, class Row, int W, int N>
void store_rows(const Mask& mask, const Row (&from)[N], double (&to)[N][W]) noexcept {
  if (bits_of(~mask) == 0) {
    for (int i = 0; i < N; ++i) store_row(from[i], to[i]);
    return;
  }
  for (int i = 0; i < N; ++i) store_row(choose(mask, from[i], load_row<Row>(to[i])), to[i]);
}

}  // namespace batch_detail

/// One step by Adams-Bashforth-Moulton, as step_abm4. Result: the good lanes, whose history has it. Lanes that know
/// fewer rates than others are not good. look: see step_lanes_rk4. Requires: is_step(h).
template <class System, class History, class Look>
typename System::Mask step_rows_abm4(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                     const typename System::State& state, History& history, double h,
                                     typename System::State& result, const Look& look) noexcept {
  using namespace batch_detail;
  using Dynamics = LaneDynamics<System>;
  StateRates<Dynamics> known_rates[4], start, next;
  for (int k = 0; k < 4; ++k) {
    load_rows(history.zd[k], known_rates[k].zd);
    load_rows(history.zdd[k], known_rates[k].derivative.zdd);
    load_rows(history.xd[k], known_rates[k].derivative.xd);
  }
  int known[System::kLanes], most = 0;
  for (int lane = 0; lane < System::kLanes; ++lane) {
    const bool is_next = std::abs(history.t[lane] - state.t[lane]) <= integrator_detail::kSameTime * h;
    const bool goes_on = history.h[lane] == h && is_next;
    known[lane] = goes_on ? history.count[lane] : 0;
    most = known[lane] > most ? known[lane] : most;
  }
  typename System::Mask good{};
  for (int lane = 0; lane < System::kLanes; ++lane) good[lane] = known[lane] == most ? -1 : 0;
  good &= keeps_charts<System>(state);
  const Dynamics dynamics{parameters, inputs, state.t, good};
  const integrator_detail::PastRates<Dynamics> past = {most > 0 ? &known_rates[0] : &start, &known_rates[1],
                                                       &known_rates[2], &known_rates[3]};
  LaneStages stages;
  integrator_detail::try_abm4(stages, dynamics, state, past, most, h, result, start, next);
  good = look(good, result);

  const StateRates<Dynamics>* const rates[] = {&next, past[0], past[1], past[2]};
  for (int k = 0; k < 4; ++k) {
    store_rows(good, rates[k]->zd, history.zd[k]);
    store_rows(good, rates[k]->derivative.zdd, history.zdd[k]);
    store_rows(good, rates[k]->derivative.xd, history.xd[k]);
  }
  if constexpr (kChartsOf < typename System::State >> 0) {
    typename System::Row older[2][System::kCoordinates];
    load_rows(history.z[1], older[0]);
    load_rows(history.z[2], older[1]);
    const typename System::Row(*const positions[])[System::kCoordinates] = {&result.z, &state.z, &older[0], &older[1]};
    for (int k = 0; k < 4; ++k) store_rows(good, *positions[k], history.z[k]);
  }
  for (int lane = 0; lane < System::kLanes; ++lane) {
    if (good[lane] == 0) continue;
    history.count[lane] = most < 1 ? 2 : most < 4 ? most + 1 : 4;
    history.h[lane] = h;
    history.t[lane] = result.t[lane];
  }
  return good;
}

}  // namespace mbgen
