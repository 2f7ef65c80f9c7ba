#pragma once
// What the functions of FMI 2 and 3 share: the values of one instance by their references, its evaluation and its
// steps. `Model` is the struct that mbgen emits into <model>_fmu.hpp. Nothing here allocates or calls the C library.
//
// Value references count through the groups of `Group` in their order.

#include <cmath>

#include "mbgen/status.hpp"

namespace mbgen::fmu {

/// Same numbers as fmi2Status and fmi3Status.
enum class Answer : int { ok, warning, discard, error, fatal };

/// Modes of the standard's state machines; bits, for sets of them.
enum Mode : unsigned {
  kInstantiated = 1,
  kInitialization = 2,
  kEvent = 4,
  kContinuous = 8,
  kStep = 16,
  kTerminated = 32
};

enum class Interface : int { model_exchange, co_simulation };

/// How far a dependent position that an importer integrates may lie from the closed loop (rad or m) before the FMU asks
/// for an event in which it is put back.
constexpr double kLargestDrift = 1e-6;

/// Steps whose number is whole up to this (of a step) take the model's own step.
constexpr double kWholeSteps = 1e-6;

enum class Group : int { time, parameter, input, output, z, zd, zdd, x, xd, none };

struct Place {
  Group group = Group::none;
  int index = 0;
};

template <class Model>
constexpr Place place_of(unsigned reference) noexcept {
  constexpr int sizes[] = {1,
                           Model::kParameters,
                           Model::kInputs,
                           Model::kOutputs,
                           Model::kCoordinates,
                           Model::kCoordinates,
                           Model::kCoordinates,
                           Model::kAuxiliaryStates,
                           Model::kAuxiliaryStates};
  for (int g = 0; g < static_cast<int>(Group::none); ++g) {
    const auto size = static_cast<unsigned>(sizes[g]);
    if (reference < size) return {static_cast<Group>(g), static_cast<int>(reference)};
    reference -= size;
  }
  return {};
}

/// Everything that a run consists of: what an FMU state keeps.
template <class Model>
struct Run {
  Interface interface {};
  unsigned mode = kInstantiated;
  bool is_start = true;                         ///< whether nothing was set since the start, whose loops are closed
  double start_time = 0, stop_time = HUGE_VAL;  ///< s
  typename Model::State state{};
  typename Model::Inputs inputs;
  typename Model::Tuned parameters;
  typename Model::History history{};
};

/// An instance: a run, and what follows from it.
template <class Model>
struct Core {
  Run<Model> run;
  bool is_solved = false;          ///< whether the rest belongs to the run as it is
  typename Model::State solved{};  ///< loops closed
  typename Model::Derivative derivative{};
  typename Model::Outputs outputs{};
  Status status;  ///< of the solver's last call
};

constexpr bool contains(const int* list, int size, int value) noexcept {
  for (int i = 0; i < size; ++i) {
    if (list[i] == value) return true;
  }
  return false;
}

template <class Model>
constexpr bool position_is_state(int coordinate) noexcept {
  return contains(Model::kPositions, Model::kPositionStates, coordinate);
}

template <class Model>
constexpr bool is_independent(int coordinate) noexcept {
  return contains(Model::kVelocities, Model::kVelocityStates, coordinate);
}

template <class Model>
constexpr int kStates = Model::kPositionStates + Model::kVelocityStates + Model::kAuxiliaryStates;

/// Back to the start values, in mode `instantiated`.
template <class Model>
void restart(Core<Model>& core) noexcept {
  const Interface interface = core.run.interface;
  core.run = {};
  core.run.interface = interface;
  for (int i = 0; i < Model::kCoordinates; ++i) {
    core.run.state.z[i] = Model::kInitialZ[i];
    core.run.state.zd[i] = Model::kInitialZd[i];
  }
  for (int i = 0; i < Model::kAuxiliaryStates; ++i) core.run.state.x[i] = Model::kInitialX[i];
  core.is_solved = false;
}

/// Closes the loops, where the run is not one of steps that have closed them, and finds accelerations and outputs.
template <class Model>
bool solve(Core<Model>& core) noexcept {
  if (core.is_solved) return true;
  Run<Model>& run = core.run;
  core.solved = run.state;
  const bool has_stepped = run.interface == Interface::co_simulation && (run.mode & (kStep | kTerminated)) != 0;
  const bool is_closed = run.is_start || has_stepped;
  core.status = is_closed ? Status{} : Model::assemble(run.parameters, run.inputs, core.solved);
  if (core.status.ok()) core.status = Model::derivative(run.parameters, run.inputs, core.solved, core.derivative);
  if (core.status.ok()) {
    core.status = Model::outputs(run.parameters, run.inputs, core.solved, core.derivative, core.outputs);
  }
  if (!core.status.ok()) return false;
  // What is no state of the importer's is the guess of the next solution; so are dependent positions at the start.
  for (int i = 0; i < Model::kCoordinates; ++i) {
    if (!position_is_state<Model>(i) || run.mode == kInitialization) run.state.z[i] = core.solved.z[i];
    if (!is_independent<Model>(i)) run.state.zd[i] = core.solved.zd[i];
  }
  core.is_solved = true;
  return true;
}

/// Whether `place` has a value that only a solution gives.
template <class Model>
bool asks_for_solution(const Run<Model>& run, Place place) noexcept {
  if (place.group == Group::z) return !position_is_state<Model>(place.index) || run.mode == kInitialization;
  if (place.group == Group::zd) return !is_independent<Model>(place.index);
  return place.group == Group::output || place.group == Group::zdd || place.group == Group::xd;
}

template <class Model>
double value_at(const Core<Model>& core, Place place) noexcept {
  const Run<Model>& run = core.run;
  switch (place.group) {
    case Group::parameter:
      return run.parameters.*Model::kParameterMember[place.index];
    case Group::input:
      return run.inputs.*Model::kInputMember[place.index];
    case Group::output:
      return core.outputs.*Model::kOutputMember[place.index];
    case Group::z:
      return run.state.z[place.index];
    case Group::zd:
      return run.state.zd[place.index];
    case Group::zdd:
      return core.derivative.zdd[place.index];
    case Group::x:
      return run.state.x[place.index];
    case Group::xd:
      return core.derivative.xd[place.index];
    default:
      return run.state.t;
  }
}

/// Values of any variables. Answer: error for an unknown reference, and before the initialisation for what has no start
/// value; discard where the model has no solution.
template <class Model>
Answer get_values(Core<Model>& core, const unsigned* references, unsigned long count, double* values) noexcept {
  for (unsigned long i = 0; i < count; ++i) {
    const Place place = place_of<Model>(references[i]);
    if (place.group == Group::none) return Answer::error;
    if (!asks_for_solution(core.run, place)) continue;
    if (core.run.mode == kInstantiated) return Answer::error;
    if (!solve(core)) return Answer::discard;
  }
  for (unsigned long i = 0; i < count; ++i) values[i] = value_at(core, place_of<Model>(references[i]));
  return Answer::ok;
}

/// Whether a variable may be set in the mode of the run.
template <class Model>
bool may_be_set(const Run<Model>& run, Place place) noexcept {
  switch (place.group) {
    case Group::parameter:
      return (run.mode & (kInstantiated | kInitialization | kEvent | kStep)) != 0;
    case Group::input:
      return run.mode != kTerminated;
    case Group::z:
      return is_independent<Model>(place.index) ? (run.mode & (kInstantiated | kInitialization)) != 0
                                                : position_is_state<Model>(place.index) && run.mode == kInstantiated;
    case Group::zd:
      return is_independent<Model>(place.index) && (run.mode & (kInstantiated | kInitialization)) != 0;
    case Group::x:
      return (run.mode & (kInstantiated | kInitialization)) != 0;
    default:
      return false;
  }
}

template <class Model>
double& place_to_set(Run<Model>& run, Place place) noexcept {
  switch (place.group) {
    case Group::parameter:
      return run.parameters.*Model::kParameterMember[place.index];
    case Group::input:
      return run.inputs.*Model::kInputMember[place.index];
    case Group::z:
      return run.state.z[place.index];
    case Group::zd:
      return run.state.zd[place.index];
    default:
      return run.state.x[place.index];
  }
}

/// Sets variables, all or none. Answer: error where one of them may not be set now, or is not finite.
template <class Model>
Answer set_values(Core<Model>& core, const unsigned* references, unsigned long count, const double* values) noexcept {
  for (unsigned long i = 0; i < count; ++i) {
    if (!may_be_set(core.run, place_of<Model>(references[i])) || !std::isfinite(values[i])) return Answer::error;
  }
  bool is_tuned = false;
  for (unsigned long i = 0; i < count; ++i) {
    const Place place = place_of<Model>(references[i]);
    double& value = place_to_set(core.run, place);
    if (value == values[i]) continue;
    value = values[i];
    is_tuned = is_tuned || place.group == Group::parameter;
    core.is_solved = core.run.is_start = false;
    core.run.history = {};
  }
  // The constants that follow from the parameters are worked out anew.
  if (is_tuned) core.run.parameters = typename Model::Parameters(core.run.parameters);
  return Answer::ok;
}

/// References and values that may be given: none, or an array.
constexpr bool is_array(const void* references, const void* values, unsigned long count) noexcept {
  return count == 0 || (references != nullptr && values != nullptr);
}

}  // namespace mbgen::fmu
