#pragma once
// The life of an instance of FMI 2 or 3: its modes, steps, continuous states and saved runs. See fmu.hpp.

#include "mbgen/fmu.hpp"

namespace mbgen::fmu {

/// Times of the experiment. Answer: error for times that are none.
template <class Model>
Answer set_times(Core<Model>& core, double start, bool has_stop, double stop) noexcept {
  if (!std::isfinite(start) || (has_stop && !(stop > start))) return Answer::error;
  if (start != core.run.state.t) open_loops(core.run);
  core.run.start_time = core.run.state.t = start;
  core.run.stop_time = has_stop ? stop : HUGE_VAL;
  core.is_solved = false;
  return Answer::ok;
}

/// Chooses other independent coordinates where those of a loop block serve badly. Requires: closed. Result: whether any
/// changed.
template <class Model>
bool choose_coordinates(Run<Model>& run) noexcept {
  if (run.interface == Interface::co_simulation) return false;
  return choose({run.state, run.inputs, run.parameters}, run.choice);
}

/// Closes the loops and goes on to event mode (model exchange) or step mode. Answer: error where they do not close.
template <class Model>
Answer leave_initialization(Core<Model>& core) noexcept {
  core.is_solved = false;
  if (!solve(core)) return Answer::error;
  commit(core);
  core.run.history = {};
  choose_coordinates(core.run);
  core.run.mode = core.run.interface == Interface::model_exchange ? kEvent : kStep;
  return Answer::ok;
}

/// Steps of the model's size where a whole number of them fits, else of the next smaller equal ones.
struct Division {
  double count, size;
};
inline Division divided(double interval, double step) noexcept {
  const double nearest = std::floor(interval / step + 0.5);
  if (nearest >= 1 && std::abs(interval - nearest * step) <= kWholeSteps * step) return {nearest, step};
  const double count = std::floor(interval / step) + 1;
  return {count, interval / count};
}

/// Inputs with slopes, dt later.
template <class Model>
typename Model::Inputs gone_on(const Run<Model>& run, typename Model::Inputs inputs, double dt) noexcept {
  for (int i = 0; i < Model::kInputs; ++i) {
    if (run.slope[i] != 0) inputs.*Model::kInputMember[i] += run.slope[i] * dt;
  }
  return inputs;
}

/// The time after a step: k steps from the start, not the sum of k steps, where it is that but for rounding.
inline double whole_steps(double start, double t, double step) noexcept {
  const double whole = start + std::floor((t - start) / step + 0.5) * step;
  return std::abs(whole - t) <= kWholeSteps * step ? whole : t;
}

/// One step of the integrator, and inputs at its end. Result: whether it went well; else the run is as before.
template <class Model>
bool take_step(Core<Model>& core, double size) noexcept {
  Run<Model>& run = core.run;
  // An input that goes on by a rate which the model does not know has its middle value during the step.
  const typename Model::Inputs middle = gone_on(run, run.inputs, 0.5 * size);
  if (run.paths.moves(middle)) run.history = {};
  typename Model::InputPaths paths = run.paths;
  const typename Model::Inputs inputs = paths.of_step(middle, size);
  core.status = Model::step(run.parameters, inputs, run.state, run.history, size);
  if (!core.status.ok()) return false;
  run.state.t = whole_steps(run.start_time, run.state.t, size);
  run.paths = paths;
  run.inputs = gone_on(run, Model::advanced(run.inputs, size), size);
  core.is_solved = false;
  return true;
}

/// Steps from a communication point to the next. Loops that parameters have opened are closed first.
/// Answer: error for a point or size that cannot be; discard where the solver fails or the loops cannot be closed, the
/// run is then as before.
template <class Model>
Answer do_step(Core<Model>& core, double point, double size) noexcept {
  if (!std::isfinite(point) || !std::isfinite(size) || !(size > 0)) return Answer::error;
  if (!(std::abs(point - core.run.state.t) <= 0.5 * Model::kStep)) return Answer::error;
  if (point + size > core.run.stop_time + 0.5 * Model::kStep) return Answer::error;
  if (!core.run.is_closed) {
    if (!solve(core)) return Answer::discard;
    commit(core);
  }
  const Division division = divided(size, Model::kStep);
  if (division.count == 1) return take_step(core, division.size) ? Answer::ok : Answer::discard;
  const Run<Model> before = core.run;
  for (double i = 0; i < division.count; ++i) {
    if (take_step(core, division.size)) continue;
    core.run = before;
    core.is_solved = false;
    return Answer::discard;
  }
  return Answer::ok;
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
    if (!std::isfinite(states[i])) return Answer::discard;  // the importer's step was too large
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
  for (int i = 0; i < Model::kAuxiliaryStates; ++i) *rates++ = core.derivative.xd[i];
  return Answer::ok;
}

template <class Model>
Answer get_nominals(double* nominals, unsigned long count) noexcept {
  if (count != kStates<Model> || !is_array(nominals, nominals, count)) return Answer::error;
  for (int i = 0; i < kStates<Model>; ++i) nominals[i] = 1;
  return Answer::ok;
}

template <class Model>
Answer set_time(Core<Model>& core, double time) noexcept {
  if (!std::isfinite(time)) return Answer::error;
  if (core.run.state.t == time) return Answer::ok;
  open_loops(core.run);
  core.run.state.t = time;
  core.is_solved = false;
  return Answer::ok;
}

/// Accepts the step that an integrator has completed. asks_for_event: other independent coordinates would serve better.
template <class Model>
Answer accept_step(Core<Model>& core, bool& asks_for_event) noexcept {
  asks_for_event = false;
  if (!solve(core)) return Answer::discard;
  commit(core);
  Choice<Model> choice = core.run.choice;
  asks_for_event = choose({core.run.state, core.run.inputs, core.run.parameters}, choice);
  if (!asks_for_event) core.run.choice = choice;
  return Answer::ok;
}

/// Accepts what an event has set. has_changed: states are those of other coordinates now.
template <class Model>
Answer settle(Core<Model>& core, bool& has_changed) noexcept {
  has_changed = false;
  if (!solve(core)) return Answer::discard;
  commit(core);
  has_changed = choose_coordinates(core.run);
  return Answer::ok;
}

/// Takes over a saved run. Answer: error for one of the other interface.
template <class Model>
Answer restore(const Run<Model>& saved, Core<Model>& core) noexcept {
  if (saved.interface != core.run.interface) return Answer::error;
  core.run = saved;
  core.is_solved = false;
  return Answer::ok;
}

/// Bytes of a saved run: the model's token, then the run.
template <class Model>
constexpr unsigned long kSerialisedSize = sizeof(Model::kToken) + sizeof(Run<Model>);

template <class Model, class Byte>
Answer serialise(const Run<Model>& saved, Byte* bytes, unsigned long size) noexcept {
  static_assert(sizeof(Byte) == 1);
  if (bytes == nullptr || size < kSerialisedSize<Model>) return Answer::error;
  for (const char c : Model::kToken) *bytes++ = static_cast<Byte>(c);
  const auto* source = reinterpret_cast<const unsigned char*>(&saved);
  for (unsigned long i = 0; i < sizeof(saved); ++i) bytes[i] = static_cast<Byte>(source[i]);
  return Answer::ok;
}

/// Answer: error for bytes that are no run of this model.
template <class Model, class Byte>
Answer deserialise(const Byte* bytes, unsigned long size, Run<Model>& saved) noexcept {
  if (bytes == nullptr || size != kSerialisedSize<Model>) return Answer::error;
  for (const char c : Model::kToken) {
    if (*bytes++ != static_cast<Byte>(c)) return Answer::error;
  }
  auto* target = reinterpret_cast<unsigned char*>(&saved);
  for (unsigned long i = 0; i < sizeof(saved); ++i) target[i] = static_cast<unsigned char>(bytes[i]);
  return Answer::ok;
}

}  // namespace mbgen::fmu
