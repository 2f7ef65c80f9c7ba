#pragma once
// One instance of an FMU: the run that it is in, its independent coordinates, and how its loops are closed. `Model` is
// the struct that mbgen emits into <model>_fmu.hpp. Nothing here allocates.
//
// An importer of model exchange sees the independent coordinates alone. The dependent ones follow from the last state
// that it accepted: every evaluation starts there, so that its result depends on nothing that was tried in between.

#include <cmath>
#include <type_traits>

#include "mbgen/charts.hpp"
#include "mbgen/fmu/fmu_gaps.hpp"
#include "mbgen/solver/independent_limits.hpp"
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
  kTerminated = 32,
  kIntermediate = 64  ///< of FMI 3, between the inner steps of a communication step
};

enum class Interface : int { model_exchange, co_simulation };

/// Without derivatives of inputs: all inputs are used as given.
template <class Inputs>
struct GivenInputs {
  Inputs of_step(const Inputs& wanted, double /*h*/) const noexcept { return wanted; }
  Inputs now(const Inputs& wanted) const noexcept { return wanted; }
  bool moves(const Inputs& /*wanted*/) const noexcept { return false; }
};

/// Inputs and parameters with which the loops were closed.
template <class Model>
struct Closed {
  typename Model::State state{};
  typename Model::Inputs inputs;
  typename Model::Tuned parameters;
};

/// Loop blocks, at least one for arrays.
template <class Model>
inline constexpr int kBlocks = Model::kLoopBlocks > 0 ? Model::kLoopBlocks : 1;

/// Independent coordinates: of each state whose rate is an acceleration, and their condition in loop blocks.
template <class Model>
struct Choice {
  int coordinate[Model::kVelocityStates > 0 ? Model::kVelocityStates : 1] = {};
  double reference[kBlocks<Model>] = {};  ///< see choose_independent in mbgen/independent.hpp
};

/// Whether balls of the model have charts. Importers see the angles of the model; of model exchange the states q and qd
/// are the angles that a ball has now.
template <class Model>
inline constexpr bool kHasCharts = kChartsOf<typename Model::State> > 0;

/// Whether importers cannot integrate the model themselves.
template <class Model, class = void>
inline constexpr bool kCoSimulationAlone = false;
template <class Model>
inline constexpr bool kCoSimulationAlone<Model, std::void_t<decltype(Model::kCoSimulationAlone)>> = true;

/// How many of the last auxiliary states are values that are set at instants: no states that importers integrate.
template <class Model, class = void>
inline constexpr int kHeld = 0;
template <class Model>
inline constexpr int kHeld<Model, std::void_t<decltype(Model::kHeld)>> = Model::kHeld;

/// Auxiliary states that are continuous states.
template <class Model>
inline constexpr int kFlowing = Model::kAuxiliaryStates - kHeld<Model>;

/// The state in the angles of the model, with the accelerations that go with it.
template <class Model>
void take_users_angles([[maybe_unused]] typename Model::State& state,
                       [[maybe_unused]] typename Model::Derivative& derivative) noexcept {
  if constexpr (kHasCharts<Model>) {
    if (in_other_chart(state)) state = Model::in_users_angles(state, derivative);
  }
}

/// Everything that a run consists of: the content of an FMU state.
template <class Model>
struct Run {
  Interface interface {};
  unsigned mode = kInstantiated;
  bool is_closed = true;                        ///< whether the loops of `state` are closed; else those of `closed` are
  double start_time = 0, stop_time = HUGE_VAL;  ///< s
  typename Model::State state{};
  typename Model::Inputs inputs;
  typename Model::Tuned parameters;
  typename Model::History history{};
  Choice<Model> choice;
  typename Model::InputPaths paths{};                          ///< of inputs whose rates are not given
  double slope[Model::kInputs > 0 ? Model::kInputs : 1] = {};  ///< of inputs that go on by a rate that is no input
  Closed<Model> closed;             ///< the last state whose loops were, where those of `state` are not
  typename Model::Inputs accepted;  ///< of the last point of model exchange that was accepted, or of communication
  double accepted_time = 0;         ///< s, of the last communication point, or point of model exchange
  double dead_point[kBlocks<Model>] = {};  ///< s after it, where the motion there leads each block to
  double next_event = HUGE_VAL;            ///< s, of model exchange: instant at which sampled values are set next
  int contradictions[Model::kInputs > 0 ? Model::kInputs : 1] = {};  ///< steps in a row, see compare_rates
  double start[Model::kStartParameters + 1] = {};  ///< parameters that act at the start; the last one is none
};

/// Why a call was refused, or what an importer may want to know of one that went well, for a message:
/// [the variable] reason [limit][, got value].
struct Refusal {
  const char* reason = nullptr;
  bool has_variable = false, has_limit = false, has_value = false;
  unsigned variable = 0;  ///< value reference
  double limit = 0, value = 0;
  const char* subject = nullptr;  ///< in place of a variable

  static constexpr Refusal of_variable(unsigned variable, const char* reason) noexcept {
    return {reason, true, false, false, variable, 0, 0, nullptr};
  }
  static constexpr Refusal of_value(const char* reason, double value) noexcept {
    return {reason, false, false, true, 0, 0, value, nullptr};
  }
  static constexpr Refusal of_limit(const char* reason, double limit, double value) noexcept {
    return {reason, false, true, true, 0, limit, value, nullptr};
  }
};

/// Values that a variable is meant to have.
struct Range {
  unsigned variable;  ///< value reference
  double least, most;
};

/// An instance: a run, and values that follow from it.
template <class Model>
struct Core {
  Run<Model> run;
  unsigned modes_of_states = kContinuous;  ///< in which states may be set as variables
  bool is_solved = false;                  ///< whether the rest belongs to the run as it is
  typename Model::State solved{};          ///< loops closed
  typename Model::Derivative derivative{};
  typename Model::Outputs outputs{};
  bool has_service = false;                    ///< whether the next one belongs to `solved`
  double service[kBlocks<Model>] = {};         ///< see independent_condition in mbgen/independent.hpp
  double service_on_way[kBlocks<Model>] = {};  ///< the least on the way there from the last closed state
  Status status;                               ///< of the solver's last call
  Refusal refusal;          ///< of the last call of the importer's that was refused, or was told something
  bool has_warned = false;  ///< of rates that were left out or contradict their values
  bool has_warned_of_turns = false;
  unsigned turned = 0;                           ///< turns that were too far for the method, see compare_turns
  Evaluations<Model::kCoordinates> evaluations;  ///< of model exchange, see compare_gaps
};

template <class Model>
Answer refuse(Core<Model>& core, const Refusal& refusal) noexcept {
  core.refusal = refusal;
  return Answer::error;
}

/// Whether parameters of a model make masses and inertias together.
template <class Model, class = void>
constexpr bool kHasQuantities = false;
template <class Model>
constexpr bool kHasQuantities<Model, decltype(static_cast<void>(&Model::impossible))> = true;

/// Refuses parameters that give an impossible mass or inertia. Result: whether they do.
template <class Model>
bool is_impossible(Core<Model>& core) noexcept {
  if constexpr (kHasQuantities<Model>) {
    if (const char* name = Model::impossible(core.run.parameters, core.run.inputs)) {
      core.refusal = Refusal::of_variable(0, "is what no model may have: set other parameters or inputs");
      core.refusal.has_variable = false;
      core.refusal.subject = name;
      core.status = {};
      return true;
    }
  }
  return false;
}

/// The coordinates that the solver's frozen partition has.
template <class Model>
Choice<Model> frozen_choice() noexcept {
  Choice<Model> choice;
  for (int i = 0; i < Model::kVelocityStates; ++i) choice.coordinate[i] = Model::kVelocities[i];
  return choice;
}

/// Whether the solver has the independent coordinates of the frozen partition.
template <class Model>
bool is_frozen_choice(const Choice<Model>& choice) noexcept {
  for (int i = 0; i < Model::kVelocityStates; ++i) {
    if (choice.coordinate[i] != Model::kVelocities[i]) return false;
  }
  return true;
}

/// Marks the independent coordinates. independent: Model::kCoordinates of them.
template <class Model>
void mark(const Choice<Model>& choice, unsigned char* independent) noexcept {
  for (int i = 0; i < Model::kCoordinates; ++i) independent[i] = 0;
  for (int i = 0; i < Model::kVelocityStates; ++i) independent[choice.coordinate[i]] = 1;
}

/// Chooses other coordinates if those of a loop block are ill-conditioned at a closed state. Result: whether any
/// changed.
template <class Model>
bool choose(const Closed<Model>& at, Choice<Model>& choice, double worn = kWornPivot) noexcept {
  unsigned char independent[Model::kCoordinates];
  mark(choice, independent);
  if (!Model::choose(at.parameters, at.inputs, at.state, independent, choice.reference, worn)) return false;
  int next[kBlocks<Model>] = {};  // coordinate of each block to look at
  for (int i = 0; i < Model::kVelocityStates; ++i) {
    const int block = Model::kBlockOf[choice.coordinate[i]];
    if (block < 0) continue;
    int& place = next[block];
    while (Model::kBlockOf[place] != block || independent[place] == 0) ++place;
    choice.coordinate[i] = place++;
  }
  return true;
}

/// The present inputs: between steps at the end of the last one.
template <class Model>
typename Model::Inputs current_inputs(const Run<Model>& run) noexcept {
  return (run.mode & (kStep | kIntermediate | kTerminated)) != 0 ? run.paths.now(run.inputs) : run.inputs;
}

/// To be called before anything changes that the loops depend on.
template <class Model>
void open_loops(Run<Model>& run) noexcept {
  if (!run.is_closed) return;
  run.closed = {run.state, current_inputs(run), run.parameters};
  run.is_closed = false;
  // Only an importer with continuous states must keep its coordinates.
  if (run.interface == Interface::co_simulation) choose(run.closed, run.choice);
}

/// Back to the start values, in mode `instantiated`.
template <class Model>
void restart(Core<Model>& core) noexcept {
  const Interface interface = core.run.interface;
  core.run = {};
  core.run.interface = interface;
  core.run.choice = frozen_choice<Model>();
  core.run.state = Model::initial_state();
  for (int i = 0; i < Model::kStartParameters; ++i) core.run.start[i] = Model::kStartParameter[i];
  core.is_solved = false;
}

}  // namespace mbgen::fmu
