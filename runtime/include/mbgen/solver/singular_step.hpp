#pragma once
// Singular positions of loops, where branches of the motion cross: near them the stages of a step are closed one by
// one, and at them state and rates are interpolated between states on both sides. Both is done by the System's own
// functions, so that every engine has it; see integrators.hpp.
//
// Why: along a branch, positions, velocities and accelerations are smooth functions of time, but their equations
// divide by the smallest pivot, which goes through zero. At a distance d from the singular position, rounding of the
// positions is divided by d, of the velocities by d^2, of the accelerations by d^3; and a stage that violates the
// closures by the square of the step sees other Jacobians than those of the branch.

#include "mbgen/math/precision.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/passage.hpp"
#include "mbgen/solver/states.hpp"

namespace mbgen {

/// States on each side that the interpolation takes, at equal distances in time.
constexpr int kNodes = 4;
/// First distance of two nodes, over the step. It doubles until the innermost nodes are clear of the singular position.
constexpr double kFirstSpacing = 0.125;
constexpr int kSpacings = 20;
/// Halvings of a step that find the place where its loops change their side.
constexpr int kHalvings = 8;

/// Change of the velocities of a loop in a step, as part of them and of what the method bears, from which it turns
/// aside. Measured with `most` as its factor, see docs/use/numerical_trouble.md and tests/system/near_singular.
constexpr double kTurnsAside = 0.8;

/// How long the way of a loop in a step may be.
struct WayLimits {
  double most;                 ///< over the distance to the nearest singular position, where the loop turns aside
  double least;                ///< rad or m, shorter ways are not looked at
  double aside = kTurnsAside;  ///< change of velocities over `most` from which it does
};

/// The way of one loop in a step: largest rate of a coordinate, and squares of the velocities before and after, and of
/// their change. A singular position is as far as its smallest pivot over a typical one, about, in rad.
struct LoopWay {
  double fastest = 0, before = 0, after = 0, change = 0;

  void add(double from, double to) noexcept {
    const double size = magnitude(from) > magnitude(to) ? magnitude(from) : magnitude(to);
    fastest = size > fastest ? size : fastest;
    before += from * from;
    after += to * to;
    change += (to - from) * (to - from);
  }
  /// Whether the loop turns aside.
  bool turns(const WayLimits& limits) const noexcept {
    const double larger = before > after ? before : after, limit = limits.aside * limits.most;
    return change >= limit * limit * larger;
  }
};

namespace integrator_detail {

/// Weights of the nodes at 1, 2, 3, 4 distances, on both sides, for the value in the middle.
constexpr double kDegreeSeven[kNodes] = {0.8, -0.4, 4.0 / 35, -1.0 / 70};
constexpr double kDegreeFive[kNodes] = {0.75, -0.3, 0.05, 0};

/// The state that a straight motion of `time` seconds and a projection lead to.
template <class System>
Status node_at(const System& system, const typename System::State& state, double time,
               typename System::State& node) noexcept {
  copy_state(state, node);
  node.t = state.t + time;
  add(time, state.zd, node.z);
  return system.project_nearest(node);
}

constexpr bool is_singular(Status status) noexcept {
  return status.code == Code::singular_met || status.code == Code::loop_singular;
}

/// True for the status of a node that is clear of the singular position.
constexpr bool is_clear(Status status) noexcept { return status.ok() && !is_singular(status); }

/// Distance of the nodes in time, or 0 when there is none that works.
template <class System>
double spacing_of(const System& system, const typename System::State& state, double h) noexcept {
  typename System::State node;
  double spacing = kFirstSpacing * h;
  for (int k = 0; k < kSpacings; ++k, spacing *= 2) {
    const Status behind = node_at(system, state, -spacing, node), ahead = node_at(system, state, spacing, node);
    if (is_clear(behind) && is_clear(ahead)) return spacing;
    if (!is_clear(behind) && !is_singular(behind)) return 0;
    if (!is_clear(ahead) && !is_singular(ahead)) return 0;
  }
  return 0;
}

/// Sums over the nodes.
template <class System>
struct Interpolation {
  typename System::State state;                  ///< z and zd by degree seven; x and t of the middle
  decltype(System::State::z) correction;         ///< z by degree five less z by degree seven
  StateRates<System> rates;                      ///< by degree seven
  WeightOf<decltype(System::State::z)> way = 0;  ///< largest distance of a coordinate from the middle
};

template <class System>
void start_sums(const typename System::State& state, Interpolation<System>& sums) noexcept {
  copy_state(state, sums.state);
  copy(state.z, sums.correction);
  copy(state.zd, sums.rates.derivative.zdd);
  copy(state.x, sums.rates.derivative.xd);
  clear(sums.state.z);
  clear(sums.state.zd);
  clear(sums.correction);
  clear(sums.rates.derivative.zdd);
  clear(sums.rates.derivative.xd);
}

/// Adds what the node at `time` from the middle contributes. Result: false when there is no such node.
template <class System>
bool add_node(const System& system, const typename System::State& middle, double time, int place,
              Interpolation<System>& sums) noexcept {
  typename System::State node;
  StateRates<System> rates;
  const Status closed = node_at(system, middle, time, node);
  if (!is_clear(closed) || !evaluate(system, node, rates).ok()) return false;
  const double weight = kDegreeSeven[place];
  add(weight, node.z, sums.state.z);
  add(weight, node.zd, sums.state.zd);
  add(kDegreeFive[place] - weight, node.z, sums.correction);
  add(weight, rates.derivative.zdd, sums.rates.derivative.zdd);
  add(weight, rates.derivative.xd, sums.rates.derivative.xd);
  for (std::size_t i = 0; i < size_of(node.z); ++i) {
    const auto way = static_cast<decltype(sums.way)>(magnitude(node.z[i] - middle.z[i]));
    sums.way = way > sums.way ? way : sums.way;
  }
  return true;
}

/// Whether a System can distinguish a crossing from branches that only come close to each other.
template <class System, class = void>
inline constexpr bool kTellsCrossings = false;
template <class System>
inline constexpr bool kTellsCrossings<System, std::void_t<decltype(&System::project_crossing)>> = true;

/// State and rates at a singular position from the nodes around it. Result: false if the motion does not pass, or not
/// smoothly, or if branches only come close there, as in a four-bar that is nearly a parallelogram: the nodes are then
/// on both of them. `through` and `rates` are unchanged then.
template <class System>
bool pass_through(const System& system, const typename System::State& state, double h, typename System::State& through,
                  StateRates<System>& rates) noexcept {
  const double spacing = spacing_of(system, state, h);
  if (!(spacing > 0)) return false;
  Interpolation<System> sums;
  start_sums(state, sums);
  for (int place = 0; place < kNodes; ++place) {
    const double time = (place + 1) * spacing;
    if (!add_node(system, state, time, place, sums) || !add_node(system, state, -time, place, sums)) return false;
  }
  using Real = WeightOf<decltype(System::State::z)>;
  for (std::size_t i = 0; i < size_of(sums.correction); ++i) {
    if (!(magnitude(sums.correction[i]) <= kSmoothness<Real> * sums.way)) return false;
  }
  if constexpr (kTellsCrossings<System>) {
    double clearance = 0;
    if (!system.project_crossing(sums.state, clearance).ok()) return false;
  }
  copy_state(sums.state, through);
  copy(through.zd, sums.rates.zd);
  copy_rates(sums.rates, rates);
  return true;
}

/// The largest rate of a coordinate, rad/s or m/s.
template <class State>
double fastest_rate(const State& state) noexcept {
  double fastest = 0;
  for (std::size_t i = 0; i < size_of(state.zd); ++i) {
    const auto size = static_cast<double>(magnitude(state.zd[i]));
    fastest = size > fastest ? size : fastest;
  }
  return fastest;
}

/// Whether a System can determine the side of a singular position on which its loops are.
template <class System, class = void>
inline constexpr bool kTellsSides = false;
template <class System>
inline constexpr bool kTellsSides<System, std::void_t<decltype(&System::watch_way)>> = true;

/// Largest way of a loop in a step, over its distance from a singular position that it does not pass and where a stage
/// is. A longer step leaps from one branch to the other, or turns by more than Runge-Kutta follows.
constexpr double kMostOfClearance = 0.5;

/// Whether a step of h seconds is too long for a state near a singular position that it does not pass.
template <class System>
bool leaps_over([[maybe_unused]] const System& system, [[maybe_unused]] const typename System::State& closed,
                [[maybe_unused]] double h) noexcept {
  if constexpr (kTellsSides<System>) {
    return !system.watch_way(closed, closed, h, {kMostOfClearance, 0, 0}).ok();
  } else {
    return false;
  }
}

/// The state after `part` of a step of h seconds: by the cubics through positions and velocities of both ends.
template <class State>
void on_the_way(const State& from, const State& to, double h, double part, State& at) noexcept {
  using Real = WeightOf<decltype(State::z)>;
  const double rest = 1 - part;
  const auto start = static_cast<Real>((1 + 2 * part) * rest * rest),
             end = static_cast<Real>(part * part * (3 - 2 * part));
  const auto leave = static_cast<Real>(h * part * rest * rest), arrive = static_cast<Real>(-h * part * part * rest);
  const auto mean = static_cast<Real>(6 * part * rest / h), first = static_cast<Real>(rest * (1 - 3 * part)),
             last = static_cast<Real>(part * (3 * part - 2)), share = static_cast<Real>(part);
  copy_state(from, at);
  at.t = from.t + part * h;
  for (std::size_t i = 0; i < size_of(at.z); ++i) {
    at.z[i] = start * from.z[i] + leave * from.zd[i] + end * to.z[i] + arrive * to.zd[i];
    at.zd[i] = mean * (to.z[i] - from.z[i]) + first * from.zd[i] + last * to.zd[i];
  }
  for (std::size_t i = 0; i < size_of(at.x); ++i) at.x[i] += share * (to.x[i] - from.x[i]);
}

/// Whether a System knows the motion of its loop blocks through a singular position.
template <class System, class = void>
inline constexpr bool kLooksAcross = false;
template <class System>
inline constexpr bool kLooksAcross<System, std::void_t<decltype(&System::look_across)>> = true;

/// Limits of a method for steps that were taken with care or plainly, whose stages are all at distances of at least
/// kNearSingular.
template <class Real>
constexpr WayLimits way_limits(double most, bool careful) noexcept {
  return {most, careful ? 0 : most * static_cast<double>(kNearSingular<Real>)};
}

/// Longest way, rad or m, from which the distance of the first nodes is taken there.
constexpr double kLookedAt = 0.05;

/// Checks a step of h seconds whose stages were all clear of singular positions, and which may still have jumped across
/// one, or past one by more than its method bears. If its loops reach another side of it, branches must cross there:
/// singular_met. Fails: loop_singular if they come close and do not cross. closures: evaluations that are left.
template <class System>
Status check_way([[maybe_unused]] const System& system, [[maybe_unused]] const typename System::State& from,
                 [[maybe_unused]] const typename System::State& to, [[maybe_unused]] double h,
                 [[maybe_unused]] const WayLimits& limits, [[maybe_unused]] int closures = kStepClosures) noexcept {
  if constexpr (kTellsSides<System>) {
    const Status way = system.watch_way(from, to, h, limits);
    if (way.code != Code::singular_met) return way;
    const int block = way.index;
    typename System::State at, through;
    double low = 0, high = 1, clearance = 0;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      on_the_way(from, to, h, middle, at);
      (system.changed_side(from, at) < 0 ? low : high) = middle;
    }
    on_the_way(from, to, h, high, at);
    copy_state(at, through);
    if constexpr (kLooksAcross<System>) {
      int once = closures-- > 0 ? 1 : 0;  // the clearance alone is asked for
      static_cast<void>(system.project_crossing(through, clearance, once));
    } else {
      static_cast<void>(system.project_crossing(through, clearance));
    }
    // Far from singular positions the mechanism has turned by more than a right angle, in its coordinates.
    if (clearance >= static_cast<double>(kNearSingular<WeightOf<decltype(System::State::z)>>)) return {};
    StateRates<System> rates;
    const double look = h * fastest_rate(at) > kLookedAt ? kLookedAt / fastest_rate(at) : h;
    if constexpr (kLooksAcross<System>) {
      typename System::Passage passage;
      passage.closures = closures;
      if (system.look_across(at, look, passage).ok() && passage.spacing > 0) return {Code::singular_met, block};
    } else {
      if (pass_through(system, at, look, through, rates)) return {Code::singular_met, block};
    }
    return {Code::loop_singular, block};
  } else {
    return {};
  }
}

/// True when a step is to be taken again with closed stages.
constexpr bool asks_for_care(Status status) noexcept {
  return status.code == Code::loop_singular || status.code == Code::loop_not_closed ||
         status.code == Code::near_singular || status.code == Code::singular_met;
}

}  // namespace integrator_detail

}  // namespace mbgen
