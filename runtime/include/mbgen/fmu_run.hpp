#pragma once
// The life of an instance of FMI 2 or 3: its modes, steps, continuous states and saved runs. See fmu.hpp.

#include <cstring>

#include "mbgen/fmu.hpp"
#include "mbgen/fmu/fmu_instants.hpp"
#include "mbgen/fmu/fmu_turns.hpp"
#include "mbgen/solver/step_time.hpp"

namespace mbgen::fmu {

/// Times of the experiment. Answer: error for times that are none.
template <class Model>
Answer set_times(Core<Model>& core, double start, bool has_stop, double stop) noexcept {
  if (!std::isfinite(start)) return refuse(core, Refusal::of_value("the start time must be finite", start));
  if (has_stop && !(stop > start))
    return refuse(core, Refusal::of_limit("the stop time must be after the start time", start, stop));
  if (start != core.run.state.t) open_loops(core.run);
  core.run.start_time = core.run.state.t = start;
  core.run.stop_time = has_stop ? stop : HUGE_VAL;
  core.is_solved = false;
  return Answer::ok;
}

/// Chooses other independent coordinates if those of a loop block are ill-conditioned. Requires: closed. Result:
/// whether any changed.
template <class Model>
bool choose_coordinates(Core<Model>& core) noexcept {
  Run<Model>& run = core.run;
  if (run.interface == Interface::co_simulation) return false;
  core.has_service = false;
  return choose({run.state, run.inputs, run.parameters}, run.choice, kWornAtEvent);
}

/// Stores the reference for later points: the inputs, the time, and the times of dead points. Requires: closed and
/// solved.
template <class Model>
void keep_point(Core<Model>& core) noexcept {
  Run<Model>& run = core.run;
  run.accepted = run.inputs;
  run.accepted_time = run.state.t;
  core.evaluations.begin(run.state.t, run.state.zd);
  if (Model::kIndicators > 0 && run.interface == Interface::model_exchange) find_dead_points(core, 1, run.dead_point);
}

/// Closes the loops and enters event mode (model exchange) or step mode. Answer: error if they cannot be closed.
template <class Model>
Answer leave_initialization(Core<Model>& core) noexcept {
  core.is_solved = false;
  if (!solve(core)) return Answer::error;
  commit(core);
  core.run.history = {};
  if (kHeld<Model> != 0) core.run.next_event = core.run.state.t;  // its event may be an instant
  choose_coordinates(core);
  keep_point(core);
  core.run.mode = core.run.interface == Interface::model_exchange ? kEvent : kStep;
  return Answer::ok;
}

/// How far a communication point may lie from the end of the last step: of the shorter of the model's and this step,
/// and of the time, which importers sum over up to 1e7 steps.
constexpr double kSamePoint = 1e-3, kSummedTime = 1e-9;

/// Inner steps of a communication step at most: more would be a call that does not come back.
constexpr double kMostInnerSteps = 1e9;

/// Inputs with slopes, dt later.
template <class Model>
typename Model::Inputs gone_on(const Run<Model>& run, typename Model::Inputs inputs, double dt) noexcept {
  for (int i = 0; i < Model::kInputs; ++i) {
    if (run.slope[i] != 0) inputs.*Model::kInputMember[i] += run.slope[i] * dt;
  }
  return inputs;
}

/// One step of the integrator, and inputs at its end. Result: whether it went well; else the run is as before.
template <class Model>
bool take_step(Core<Model>& core, double size) noexcept {
  if (is_impossible(core)) return false;
  Run<Model>& run = core.run;
  // An input that goes on by a rate which the model does not know has its middle value during the step.
  const typename Model::Inputs middle = gone_on(run, run.inputs, 0.5 * size);
  if (run.paths.moves(middle)) run.history = {};
  typename Model::InputPaths paths = run.paths;
  const typename Model::Inputs inputs = paths.of_step(middle, size);
  core.status = Model::step(run.parameters, inputs, run.state, run.history, size);
  if (!core.status.ok()) return false;
  // Steps that are cut at instants have many sizes: whole numbers of them are no times to go back to.
  if (kHeld<Model> == 0 || size == Model::kStep) run.state.t = at_whole_steps(run.start_time, run.state.t, size);
  run.paths = paths;
  run.inputs = gone_on(run, Model::advanced(run.inputs, size), size);
  core.is_solved = false;
  return true;
}

/// Whether an input stands still, as all its derivatives say.
template <class Model>
bool has_no_rates(const typename Model::Inputs& inputs, int input) noexcept {
  for (int rate = Model::kInputDerivative[input]; rate >= 0; rate = Model::kInputDerivative[rate]) {
    if (inputs.*Model::kInputMember[rate] != 0) return false;
  }
  return true;
}

/// Between two communication points, of the largest rate there: the trapezoidal rule is off by 0.19 at four steps a
/// period of a sine. A curve that sets in, or an input that jumps, is off for a step or two.
constexpr double kRateGap = 0.2;
constexpr int kContradictions = 4;

/// Reports, once, an input that changes differently from its given rates. now: the inputs at a communication point from
/// which a step was taken; refused steps are not compared.
template <class Model>
void compare_rates(Core<Model>& core, double point, const typename Model::Inputs& now) noexcept {
  Run<Model>& run = core.run;
  const typename Model::Inputs before = run.accepted;
  const double width = point - run.accepted_time;
  run.accepted = now;
  run.accepted_time = point;
  if (core.has_warned || !(width > 0)) return;
  for (int i = 0; i < Model::kInputs; ++i) {
    const int rate = Model::kInputDerivative[i];
    if (rate < 0 || (has_no_rates<Model>(before, i) && has_no_rates<Model>(now, i))) continue;
    const double from = before.*Model::kInputMember[rate], to = now.*Model::kInputMember[rate];
    const double change = now.*Model::kInputMember[i] - before.*Model::kInputMember[i];
    const double of_rates = width * (from + to) / 2;
    const double largest = std::fmax(std::abs(change), width * std::fmax(std::abs(from), std::abs(to)));
    run.contradictions[i] = std::abs(change - of_rates) > kRateGap * largest ? run.contradictions[i] + 1 : 0;
    if (run.contradictions[i] < kContradictions) continue;
    core.has_warned = true;
    core.refusal = {"must change as its derivative says, over the last communication step by",
                    true,
                    true,
                    true,
                    kFirstInput<Model> + static_cast<unsigned>(i),
                    of_rates,
                    change};
    return;
  }
}

/// Answer: warning as compare_turns; rates that contradict their values are told beside an ok. size: s, of the steps
/// inside.
template <class Model>
Answer compare_step(Core<Model>& core, double point, const typename Model::Inputs& now, double size) noexcept {
  compare_rates(core, point, now);
  return compare_turns(core, size);
}

/// Inner steps of one size over so many seconds. at_point: see do_step. Result: whether all went well.
template <class Model, class AtPoint>
bool take_steps(Core<Model>& core, double width, bool is_last, const AtPoint& at_point) noexcept {
  const double begin = core.run.state.t;
  const Steps division = steps_in(width, Model::kStep);
  for (double i = 0; i < division.count; ++i) {
    if (!take_step(core, division.size)) return false;
    core.run.state.t = not_beyond_instant<Model>(begin, core.run.state.t);
    at_point(is_last && i + 1 == division.count);
  }
  return true;
}

/// Steps from a communication point to the next. Loops that parameters have opened are closed first. at_point is called
/// at the end of every inner step, with whether it is the last one; inputs that it sets act from there on.
/// Answer: error for a point or size that cannot be; discard where the solver fails or the loops cannot be closed, the
/// run is then as before; warning as compare_turns.
template <class Model, class AtPoint>
Answer do_step(Core<Model>& core, double point, double size, const AtPoint& at_point) noexcept {
  const double t = core.run.state.t, stop = core.run.stop_time;
  if (!std::isfinite(size) || !(size > 0))
    return refuse(core, Refusal::of_value("the communication step size must be positive and finite", size));
  const double slack = kSamePoint * std::fmin(size, Model::kStep) + kSummedTime * std::abs(t);
  if (!(std::abs(point - t) <= slack))
    return refuse(core, Refusal::of_limit("the communication point must be where the last step ended,", t, point));
  if (point + size > stop + slack)
    return refuse(core, Refusal::of_limit("the step must not end after the stop time", stop, point + size));
  const Steps division = steps_in(size, Model::kStep);
  if (!(division.count <= kMostInnerSteps))
    return refuse(
        core, Refusal::of_limit("the communication step size must be at most", kMostInnerSteps * Model::kStep, size));
  const typename Model::Inputs now = core.run.inputs;
  double width = until_instant<Model>(t, size);
  if (core.run.is_closed && division.count == 1 && width == size) {  // needs no way back
    if (!take_step(core, division.size)) return Answer::discard;
    at_point(true);
    return compare_step(core, point, now, division.size);
  }
  const Run<Model> before = core.run;
  if (!core.run.is_closed) {
    if (!solve(core)) return Answer::discard;
    commit(core);
  }
  for (double left = size; left > 0; left = width == left ? 0 : t + size - core.run.state.t) {
    width = until_instant<Model>(core.run.state.t, left);
    if (take_steps(core, width, width == left, at_point)) continue;
    core.run = before;
    core.is_solved = false;
    return Answer::discard;
  }
  return compare_step(core, point, now, division.size);
}

/// Continuous states in their order: positions and velocities of the independent coordinates, auxiliary states.
template <class Model>
double& continuous_state(Run<Model>& run, int index) noexcept {
  if (index < Model::kVelocityStates) return run.state.z[run.choice.coordinate[index]];
  index -= Model::kVelocityStates;
  if (index < Model::kVelocityStates) return run.state.zd[run.choice.coordinate[index]];
  return run.state.x[index - Model::kVelocityStates];
}

template <class Model>
Answer get_states(Core<Model>& core, double* states, unsigned long count) noexcept {
  if (count != kStates<Model> || !is_array(states, states, count)) return Answer::error;
  for (int i = 0; i < kStates<Model>; ++i) states[i] = continuous_state(core.run, i);
  return Answer::ok;
}

template <class Model>
Answer set_states(Core<Model>& core, const double* states, unsigned long count) noexcept {
  if (count != kStates<Model> || !is_array(states, states, count)) return Answer::error;
  for (int i = 0; i < kStates<Model>; ++i) {
    if (std::isfinite(states[i])) continue;
    core.refusal.reason = "a state is not finite: a smaller step may help";
    return Answer::discard;
  }
  for (int i = 0; i < kStates<Model>; ++i) {
    if (continuous_state(core.run, i) == states[i]) continue;
    open_loops(core.run);
    continuous_state(core.run, i) = states[i];
    core.is_solved = false;
  }
  return Answer::ok;
}

template <class Model>
Answer get_derivatives(Core<Model>& core, double* rates, unsigned long count) noexcept {
  if (count != kStates<Model> || !is_array(rates, rates, count)) return Answer::error;
  if (!solve(core)) return Answer::discard;
  const int* coordinate = core.run.choice.coordinate;
  for (int i = 0; i < Model::kVelocityStates; ++i) *rates++ = core.solved.zd[coordinate[i]];
  for (int i = 0; i < Model::kVelocityStates; ++i) *rates++ = core.derivative.zdd[coordinate[i]];
  for (int i = 0; i < kFlowing<Model>; ++i) *rates++ = core.derivative.xd[i];
  return Answer::ok;
}

template <class Model>
Answer get_nominals(double* nominals, unsigned long count) noexcept {
  if (count != kStates<Model> || !is_array(nominals, nominals, count)) return Answer::error;
  for (int i = 0; i < kStates<Model>; ++i) nominals[i] = Model::kNominal[i];
  return Answer::ok;
}

/// Event indicators: the condition of the independent coordinates of each loop block minus the limit for other
/// coordinates. If a loop cannot be followed, its indicator has the value of a dead point: root finding then finds the
/// event.
template <class Model>
Answer get_indicators(Core<Model>& core, double* indicators, unsigned long count) noexcept {
  if (count != Model::kIndicators || !is_array(indicators, indicators, count)) return Answer::error;
  if (count == 0) return Answer::ok;
  const bool is_solved = solve(core);
  const bool is_lost = core.status.code == Code::loop_not_closed || core.status.code == Code::loop_singular;
  if (!is_solved && !is_lost && core.refusal.reason == nullptr) return Answer::discard;
  for (int k = 0; k < Model::kIndicators; ++k) {
    const int block = Model::kIndicatorBlock[k];
    const bool is_here = is_lost ? core.status.index == block
                                 : core.refusal.variable == kFirstIndicator<Model> + static_cast<unsigned>(k);
    if (is_solved) service_of(core);
    indicators[k] = is_solved ? indicator_of(core, k) : (is_here ? 0 : 1) - kWornPivot;
  }
  core.status = {};
  core.refusal = {};
  return Answer::ok;
}

/// Answer: error for a time before the last accepted point, from which loops are followed, or after the stop time.
template <class Model>
Answer set_time(Core<Model>& core, double time) noexcept {
  if (!std::isfinite(time)) return refuse(core, Refusal::of_value("the time must be finite", time));
  const double slack = same_instant(time);
  if (time < core.run.accepted_time - slack)
    return refuse(core, Refusal::of_limit("the time must not go back beyond the last completed step or event, at",
                                          core.run.accepted_time, time));
  if (time > core.run.stop_time + slack)
    return refuse(core, Refusal::of_limit("the time must not be after the stop time,", core.run.stop_time, time));
  if (core.run.state.t == time) return Answer::ok;
  open_loops(core.run);
  core.run.state.t = time;
  core.is_solved = false;
  return Answer::ok;
}

/// Reports, once, an input that changed between accepted points without rates at both: the bodies that it drives jump
/// then and feel no acceleration.
template <class Model>
void compare_inputs(Core<Model>& core) noexcept {
  const typename Model::Inputs &before = core.run.accepted, &now = core.run.inputs;
  for (int i = 0; i < Model::kInputs && !core.has_warned; ++i) {
    const double change = now.*Model::kInputMember[i] - before.*Model::kInputMember[i];
    if (Model::kInputDerivative[i] < 0 || change == 0) continue;
    if (!has_no_rates<Model>(before, i) || !has_no_rates<Model>(now, i)) continue;
    core.has_warned = true;
    core.refusal = {"moves, but its derivatives are inputs too and were left at zero: set them with it; it moved by",
                    true,
                    true,
                    false,
                    kFirstInput<Model> + static_cast<unsigned>(i),
                    change,
                    0};
  }
}

/// Accepts the step that an integrator has completed. asks_for_event: other independent coordinates, or other angles of
/// a ball, are better conditioned.
template <class Model>
Answer accept_step(Core<Model>& core, bool& asks_for_event) noexcept {
  asks_for_event = false;
  if (const Answer answer = check_event(core); answer != Answer::ok) return answer;
  if (!solve(core)) return Answer::discard;
  commit(core);
  Choice<Model> choice = core.run.choice;
  asks_for_event = choose({core.run.state, core.run.inputs, core.run.parameters}, choice);
  if (!asks_for_event) core.run.choice = choice;
  asks_for_event = leaves_charts(core.run, core.run.state) || is_at_event(core.run) || asks_for_event;
  compare_inputs(core);
  if (core.refusal.reason == nullptr) compare_gaps(core);
  keep_point(core);
  return Answer::ok;
}

/// Gives every ball the angles that suit its position. Requires: closed. Result: whether any changed.
template <class Model>
bool settle_charts([[maybe_unused]] Core<Model>& core) noexcept {
  if constexpr (kHasCharts<Model>) {
    Run<Model>& run = core.run;
    if (run.interface == Interface::co_simulation || !leaves_charts(run, run.state)) return false;
    Model::settle_charts(run.parameters, run.inputs, run.state);
    core.is_solved = false;
    return true;
  } else {
    return false;
  }
}

/// Whether the rates of continuous states differ. Of derivatives at one state.
template <class Model>
bool rates_differ(const typename Model::Derivative& a, const typename Model::Derivative& b) noexcept {
  for (int i = 0; i < Model::kCoordinates; ++i) {
    if (a.zdd[i] != b.zdd[i]) return true;
  }
  for (int i = 0; i < kFlowing<Model>; ++i) {
    if (a.xd[i] != b.xd[i]) return true;
  }
  return false;
}

/// Accepts the values set in an event; on failure the run is unchanged. has_changed: the states now belong to other
/// coordinates, or are other angles, or their rates have jumped with sampled values: integrators restart.
template <class Model>
Answer end_event(Core<Model>& core, bool& has_changed) noexcept {
  has_changed = false;
  if (const Answer answer = check_event(core); answer != Answer::ok) return answer;
  if (!solve(core)) return Answer::discard;
  const typename Model::Derivative rates = core.derivative;
  const Run<Model> before = core.run;
  commit(core);
  bool goes_well = take_samples(core) && solve(core);
  has_changed = goes_well && rates_differ<Model>(rates, core.derivative);
  if (goes_well) {
    has_changed = settle_charts(core) || has_changed;
    has_changed = choose_coordinates(core) || has_changed;
    goes_well = solve(core);
  }
  if (!goes_well) {
    core.run = before;
    core.is_solved = false;
    has_changed = false;
    return Answer::discard;
  }
  keep_point(core);
  return Answer::ok;
}

}  // namespace mbgen::fmu
