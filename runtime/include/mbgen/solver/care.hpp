#pragma once
// How the stages of a step are taken: plainly, or with care near singular positions of loops. `System` is described in
// integrators.hpp. A generated solver whose loops may choose their coordinates again knows passages (passage.hpp), and
// has further functions:
//   Status project(State&, int& closures) const noexcept            with the evaluations of the closures that are left
//   Status project_nearest(State&, int& closures) const noexcept    to the step; they fail without any
//   Status project_crossing(State&, double& clearance, int& closures) const noexcept
//   Status rates_near(const State&, Derivative&) const noexcept     derivative without a look at singular positions
//   Status look_across(const State&, double h, Passage&) const noexcept
//   bool close_across(Passage&, State&) const noexcept              see solver/passing.hpp
//   Status rates_across(const Passage&, const State&, Derivative&) const noexcept

#include "mbgen/solver/regular.hpp"
#include "mbgen/solver/singular_step.hpp"

namespace mbgen {

/// Looks for a passage in one careful step of a System that knows its blocks: a second one for a stage beyond the
/// first.
constexpr int kLooks = 2;

namespace integrator_detail {

/// Where a singular position is not passed, it was only near.
constexpr Status as_near(Status status) noexcept {
  return status.code == Code::singular_met ? Status{Code::near_singular, status.index} : status;
}

/// Plain stages; any need for care ends the step. The rates of its first stage are kept then.
template <class System>
struct Plain {
  using State = typename System::State;
  using Real = WeightOf<decltype(State::z)>;
  /// Way of a short step, over the distance at which it is near a singular position.
  static constexpr double kEntry = 0.25;
  StateRates<System> first;      ///< of a step that needs care from its first stage on
  bool is_first = true;          ///< no rates are known so far
  bool keeps = false;            ///< `first` is known
  int closures = kStepClosures;  ///< evaluations of the closures that are left
  Status end;  ///< near_singular where the step began clear of singular positions and its end is not: if it
               ///< is short, that is no reason to take it again

  using Time = decltype(State::t);
  Time start;

  explicit Plain(Time of_start) noexcept : start(of_start) {}

  static constexpr bool goes_on(Status status) noexcept { return status.ok() && !asks_for_care(status); }
  static Status check(const State& result) noexcept { return check_finite(result); }

  Status rates(const System& system, const State& stage, [[maybe_unused]] double h,
               StateRates<System>& rates) noexcept {
    const Status status = evaluate(system, stage, rates);
    if constexpr (kLooksAcross<System>) {
      const bool began_clear = !is_first && status.code == Code::near_singular;
      keeps = is_first && stage.t == start && status.code == Code::near_singular;
      is_first = false;
      if (keeps) copy_rates(rates, first);
      if (began_clear && h * fastest_rate(stage) <= kEntry * static_cast<double>(kNearSingular<Real>)) {
        end = status;
        return {};
      }
    }
    return status;
  }
  Status close(const System& system, State& state, double /*h*/) noexcept {
    if constexpr (kLooksAcross<System>) {
      const Status status = system.project(state, closures);
      if (status.code != Code::near_singular) return status;
      end = status;
      return {};
    } else {
      return system.project(state);
    }
  }
};

/// Stages closed before they are evaluated, and singular positions passed: each by states around it.
template <class System, class = void>
struct Careful {
  using State = typename System::State;
  Careful(const Plain<System>& /*plain*/, Status /*of_plain*/) noexcept {}

  static constexpr bool goes_on(Status status) noexcept { return status.ok(); }
  static Status check(const State& result) noexcept { return check_finite(result); }
  static constexpr bool passes() noexcept { return false; }
  static constexpr int left() noexcept { return kStepClosures; }

  /// Closes a state; at a singular position it also has the rates.
  static Status close(const System& system, State& state, double h, StateRates<System>& rates) noexcept {
    State closed;
    copy_state(state, closed);
    const Status status = system.project_nearest(closed);
    if (is_singular(status) && pass_through(system, state, h, state, rates)) return {Code::singular_met, status.index};
    if (!status.ok()) return status;
    if (is_singular(status) && leaps_over(system, closed, h)) return {Code::loop_singular, status.index};
    copy_state(closed, state);
    return as_near(status);
  }

  static Status close(const System& system, State& state, double h) noexcept {
    StateRates<System> rates;
    return close(system, state, h, rates);
  }

  static Status rates(const System& system, const State& stage, double h, StateRates<System>& rates) noexcept {
    State closed;
    copy_state(stage, closed);
    const Status status = close(system, closed, h, rates);
    if (!status.ok() || status.code == Code::singular_met) return status;
    const Status evaluated = evaluate(system, closed, rates);
    return evaluated.ok() ? as_near(graver(status, evaluated)) : evaluated;
  }
};

/// The same by the passage of loop blocks, which one stage looks for and the others of the step use.
template <class System>
struct Careful<System, std::enable_if_t<kLooksAcross<System>>> {
  using State = typename System::State;
  const Plain<System>& plain;
  Status of_plain;  ///< of the step as it was taken plainly
  typename System::Passage passage;
  int looks = kLooks;       ///< that are left to this step
  bool keeps;               ///< the rates of the first stage are known from the plain step
  bool is_fresh = true;     ///< no state was closed so far
  bool is_across = false;   ///< the state that was closed last is on the passage
  bool was_across = false;  ///< some state was

  Careful(const Plain<System>& of, Status status) noexcept : plain(of), of_plain(status), keeps(of.keeps) {
    passage.closures = of.closures;
  }

  static constexpr bool goes_on(Status status) noexcept { return status.ok(); }
  static Status check(const State& result) noexcept { return check_finite(result); }
  /// Whether a stage was on a passage.
  bool passes() const noexcept { return was_across; }
  /// Evaluations of the closures that are left.
  int left() const noexcept { return passage.closures; }

  /// Closes the end of a step; singular_met if it is on a passage through a singular position. Its polynomial is off
  /// by the sixth power of the spacing, less than the rounding of single precision.
  Status close(const System& system, State& state, double h) noexcept {
    const Status status = close_stage(system, state, h);
    if (!status.ok() || !is_across || std::is_same_v<RealOf<System>, float>) return status;
    double clearance = 0;
    const Status closed = system.project_crossing(state, clearance, passage.closures);
    return closed.ok() ? status : closed;
  }

  /// The same of a stage, as near as the passage is.
  Status close_stage(const System& system, State& state, double h) noexcept {
    if (is_fresh) look(system, state, h);
    is_fresh = false;
    if (goes_across(system, state)) return met();
    State closed;
    copy_state(state, closed);
    const Status status = system.project_nearest(closed, passage.closures);
    if (is_singular(status)) {
      look(system, state, h);
      if (goes_across(system, state)) return met();
    }
    if (!status.ok()) return status;
    if (is_singular(status) && leaps_over(system, closed, h)) return {Code::loop_singular, status.index};
    copy_state(closed, state);
    return as_near(status);
  }

  Status rates(const System& system, const State& stage, double h, StateRates<System>& rates) noexcept {
    if (keeps) {
      keeps = false;
      copy_rates(plain.first, rates);
      return of_plain;
    }
    State closed;
    copy_state(stage, closed);
    const Status status = close_stage(system, closed, h);
    if (!status.ok()) return status;
    if (is_across) {
      copy(closed.zd, rates.zd);
      const Status across = system.rates_across(passage, closed, rates.derivative);
      return across.ok() ? status : across;
    }
    copy(closed.zd, rates.zd);
    const Status evaluated = system.rates_near(closed, rates.derivative);
    return evaluated.ok() ? as_near(graver(status, evaluated)) : evaluated;
  }

 private:
  void look(const System& system, const State& state, double h) noexcept {
    if (looks == 0) return;
    looks = system.look_across(state, h, passage).ok() ? looks - 1 : 0;
  }
  bool goes_across(const System& system, State& state) noexcept {
    is_across = system.close_across(passage, state);
    was_across = was_across || is_across;
    return is_across;
  }
  Status met() const noexcept {
    int block = 0;
    while (passage.crosses[block] == 0) ++block;
    const bool is_met = passage.is_met || is_singular(of_plain);
    return {is_met ? Code::singular_met : Code::near_singular, block};
  }
};

/// Status of a step with stages on a passage: singular_met if it reaches the other side of the singular position.
template <class System>
Status passed(const System& system, const typename System::State& state, double h, double most,
              const typename System::State& result, Status status) noexcept {
  if constexpr (kTellsSides<System>) {
    if (status.code == Code::singular_met) return status;
    const Status way = system.watch_way(state, result, h, {most, 0});
    if (way.code == Code::singular_met) return way;
  }
  return status;
}

/// The status of a plain step in a solver of regular positions alone: kNotRegular where another one would look closer.
template <class System>
Status regularly(const System& system, const typename System::State& state, double most,
                 const typename System::State& result, Status status) noexcept {
  using Real = WeightOf<decltype(System::State::z)>;
  if (asks_for_care(status)) return {kNotRegular, -1};
  if (status.ok() && system.moves_far(state, result, way_limits<Real>(most, false).least)) return {kNotRegular, -1};
  return status;
}

/// The end of a step that was taken plainly, with this status: it is taken again with care if required, and its way is
/// watched. See plainly_or_carefully.
template <class System, class Attempt>
Status closely(const System& system, const typename System::State& state, double h, double most,
               typename System::State& result, const Attempt& attempt, const Plain<System>& plain,
               Status status) noexcept {
  int left = plain.closures;
  if (asks_for_care(status)) {
    copy_state(state, result);
    Careful<System> care(plain, status);
    const Status careful = attempt(care, result);
    const bool was_near = kLooksAcross<System> && careful.ok() && status.ok();
    status = was_near ? graver(as_near(status), careful) : careful;
    left = care.left();
    if (status.ok() && care.passes()) return passed(system, state, h, most, result, status);
  }
  if (!status.ok() || status.code == Code::singular_met) return status;
  using Real = WeightOf<decltype(System::State::z)>;
  status = graver(status, plain.end);
  const Status way = check_way(system, state, result, h, way_limits<Real>(most, asks_for_care(status)), left);
  return way.ok() ? graver(status, way) : way;
}

/// Takes a step of h seconds to `result` by attempt(care, result), which gets a copy of the state: first plainly, then
/// carefully if required. A step that passed no singular position is checked for a jump across one. most: see
/// WayLimits.
template <class System, class Attempt>
Status plainly_or_carefully(const System& system, const typename System::State& state, double h, double most,
                            typename System::State& result, const Attempt& attempt) noexcept {
  copy_state(state, result);
  Plain<System> plain(state.t);
  const Status status = attempt(plain, result);
  if constexpr (kRegularOnly<System>) {
    return regularly(system, state, most, result, status);
  } else {
    return closely(system, state, h, most, result, attempt, plain, status);
  }
}

}  // namespace integrator_detail

}  // namespace mbgen
