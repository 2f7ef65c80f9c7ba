#pragma once
// Common parts of the functions of FMI 2 and 3: the values of one instance by their references, its evaluation and its
// steps. `Model` is the struct that mbgen emits into <model>_fmu.hpp. Nothing here allocates.
//
// Value references count through the groups of `Group` in their order.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error "an FMU looks for NaN and infinity in its inputs: compile it without -ffast-math and -ffinite-math-only"
#elif defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
// Macros of g++; clang++ has none for these options.
#error "an FMU gives the bits of its solver: compile it without -funsafe-math-optimizations and the options in it"
#endif

#include "mbgen/fmu/fmu_way.hpp"

namespace mbgen::fmu {

/// q, qd and qdd: of the states of loop blocks and balls, whatever their present independent coordinates and angles.
enum class Group : int { time, parameter, input, output, z, zd, zdd, x, xd, q, qd, qdd, start, indicator, none };

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
                           kFlowing<Model>,
                           Model::kChosenStates,
                           Model::kChosenStates,
                           Model::kChosenStates,
                           Model::kStartParameters,
                           Model::kIndicators};
  for (int g = 0; g < static_cast<int>(Group::none); ++g) {
    const auto size = static_cast<unsigned>(sizes[g]);
    if (reference < size) return {static_cast<Group>(g), static_cast<int>(reference)};
    reference -= size;
  }
  return {};
}

/// Value reference of the first input.
template <class Model>
constexpr unsigned kFirstInput = 1u + static_cast<unsigned>(Model::kParameters);

constexpr bool contains(const int* list, int size, int value) noexcept {
  for (int i = 0; i < size; ++i) {
    if (list[i] == value) return true;
  }
  return false;
}

/// Whether no motion decides the coordinate: its position has a start value or a guess.
template <class Model>
constexpr bool is_undriven(int coordinate) noexcept {
  return contains(Model::kUndriven, Model::kUndrivenCoordinates, coordinate);
}

/// Whether the coordinate is independent in the frozen partition, which the start has.
template <class Model>
constexpr bool is_independent(int coordinate) noexcept {
  return contains(Model::kVelocities, Model::kVelocityStates, coordinate);
}

template <class Model>
constexpr int kStates = 2 * Model::kVelocityStates + kFlowing<Model>;

/// Coordinate of a place in q, qd or qdd.
template <class Model>
int chosen_coordinate(const Run<Model>& run, int place) noexcept {
  return run.choice.coordinate[Model::kChosen[place]];
}

/// Whether `place` has a value that only a solution gives.
template <class Model>
bool asks_for_solution(const Run<Model>& run, Place place) noexcept {
  const bool is_given = run.is_closed || run.mode == kInstantiated;
  switch (place.group) {
    case Group::z:
      return !is_given || (run.mode == kInstantiated && !is_undriven<Model>(place.index));
    case Group::zd:
      return !is_given || (run.mode == kInstantiated && !is_independent<Model>(place.index));
    case Group::q:
    case Group::qd:
      return !run.is_closed && run.mode == kInitialization;
    case Group::output:
    case Group::zdd:
    case Group::xd:
    case Group::qdd:
    case Group::indicator:
      return true;
    default:
      return false;
  }
}

/// Position (order 0), velocity or acceleration of a coordinate as the model counts it. state: of a run, or solved.
template <class Model>
double motion_of(const Core<Model>& core, const typename Model::State& state, int order, int coordinate) noexcept {
  if (in_other_chart(state)) {
    typename Model::State users = state;
    typename Model::Derivative derivative = core.derivative;
    take_users_angles<Model>(users, derivative);
    return order == 0 ? users.z[coordinate] : order == 1 ? users.zd[coordinate] : derivative.zdd[coordinate];
  }
  return order == 0 ? state.z[coordinate] : order == 1 ? state.zd[coordinate] : core.derivative.zdd[coordinate];
}

template <class Model>
double value_at(const Core<Model>& core, Place place) noexcept {
  const Run<Model>& run = core.run;
  const bool is_solution = asks_for_solution(run, place);
  const auto& state = is_solution ? core.solved : run.state;
  switch (place.group) {
    case Group::parameter:
      return run.parameters.*Model::kParameterMember[place.index];
    case Group::input:
      return run.inputs.*Model::kInputMember[place.index];
    case Group::output:
      return core.outputs.*Model::kOutputMember[place.index];
    case Group::z:
      return motion_of(core, state, 0, place.index);
    case Group::zd:
      return motion_of(core, state, 1, place.index);
    case Group::zdd:
      return motion_of(core, core.solved, 2, place.index);
    case Group::x:
      return run.state.x[place.index];
    case Group::xd:
      return core.derivative.xd[place.index];
    case Group::start:
      return run.start[place.index];
    case Group::q:
      return state.z[chosen_coordinate(run, place.index)];
    case Group::qd:
      return state.zd[chosen_coordinate(run, place.index)];
    case Group::qdd:
      return core.derivative.zdd[chosen_coordinate(run, place.index)];
    case Group::indicator:
      return indicator_of(core, place.index);
    default:
      return run.state.t;
  }
}

/// Values of any variables. Answer: error for an unknown reference, and before the initialisation for a variable
/// without start value; discard where the model has no solution, or the value is not finite.
template <class Model>
Answer get_values(Core<Model>& core, const unsigned* references, unsigned long count, double* values) noexcept {
  for (unsigned long i = 0; i < count; ++i) {
    const Place place = place_of<Model>(references[i]);
    if (place.group == Group::none) return refuse(core, Refusal::of_variable(references[i], "does not exist"));
    if (!asks_for_solution(core.run, place)) continue;
    if (core.run.mode == kInstantiated)
      return refuse(core, Refusal::of_variable(references[i], "has no value before the initialization mode"));
    if (!solve(core)) return Answer::discard;
    if (place.group == Group::indicator) service_of(core);
  }
  for (unsigned long i = 0; i < count; ++i) {
    values[i] = value_at(core, place_of<Model>(references[i]));
    if (std::isfinite(values[i])) continue;
    core.refusal = Refusal::of_variable(references[i], "is not a finite number here");
    return Answer::discard;
  }
  return Answer::ok;
}

/// Whether a velocity at the start follows from parameters that act there.
template <class Model>
constexpr bool follows_at_start(int coordinate) noexcept {
  for (int i = 0; i < Model::kStartParameters; ++i) {
    if (Model::kStartRate[i * Model::kCoordinates + coordinate] != 0) return true;
  }
  return false;
}

/// Whether the coordinate itself is a state: outside the loop blocks and of no ball, or where no others are chosen.
template <class Model>
bool is_state(int coordinate) noexcept {
  for (int i = 0; i < Model::kChosenStates; ++i) {
    if (Model::kVelocities[Model::kChosen[i]] == coordinate) return false;
  }
  return is_independent<Model>(coordinate) && Model::kBlockOf[coordinate] < 0;
}

/// Whether a variable may be set in the mode of the run.
template <class Model>
bool may_be_set(const Core<Model>& core, Place place) noexcept {
  const unsigned mode = core.run.mode;
  const bool is_start = (mode & (kInstantiated | kInitialization)) != 0,
             is_state_time = (mode & core.modes_of_states) != 0;
  switch (place.group) {
    case Group::parameter:
      return is_start || (mode & (kEvent | kStep)) != 0;
    case Group::input:
      return mode != kTerminated;
    case Group::z:
      if (is_start && is_independent<Model>(place.index)) return true;
      return mode == kInstantiated ? is_undriven<Model>(place.index) : is_state_time && is_state<Model>(place.index);
    case Group::zd:
      if (is_start && follows_at_start<Model>(place.index)) return false;
      return is_start ? is_independent<Model>(place.index) : is_state_time && is_state<Model>(place.index);
    case Group::start:
      return is_start;
    case Group::x:
      return is_start || (is_state_time && place.index < kFlowing<Model>);
    case Group::q:
    case Group::qd:
      return is_state_time;
    default:
      return false;
  }
}

/// Whether a variable may be set in no mode.
template <class Model>
constexpr bool is_computed(Place place) noexcept {
  return place.group == Group::time || place.group == Group::output || place.group == Group::zdd ||
         place.group == Group::xd || place.group == Group::qdd || place.group == Group::indicator ||
         (place.group == Group::z && !is_undriven<Model>(place.index)) ||
         (place.group == Group::zd && (!is_independent<Model>(place.index) || follows_at_start<Model>(place.index)));
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
    case Group::start:
      return run.start[place.index];
    case Group::q:
      return run.state.z[chosen_coordinate(run, place.index)];
    case Group::qd:
      return run.state.zd[chosen_coordinate(run, place.index)];
    default:
      return run.state.x[place.index];
  }
}

/// The refusal of a value outside of the variable's range, none within.
template <class Model>
Refusal out_of_range(unsigned variable, double value) noexcept {
  for (int i = 0; i < Model::kRanges; ++i) {
    const Range& range = Model::kRange[i];
    if (range.variable != variable || (value >= range.least && value <= range.most)) continue;
    const bool is_less = value < range.least;
    return {is_less ? "must be at least" : "must be at most",
            true,
            true,
            true,
            variable,
            is_less ? range.least : range.most,
            value,
            nullptr};
  }
  return {};
}

/// Changes the velocities at the start with a parameter that acts there.
template <class Model>
void start_otherwise(Run<Model>& run, int parameter, double change) noexcept {
  for (int i = 0; i < Model::kCoordinates; ++i)
    run.state.zd[i] += Model::kStartRate[parameter * Model::kCoordinates + i] * change;
}

/// Sets variables, all or none. Answer: error where one of them may not be set now, or is not finite.
template <class Model>
Answer set_values(Core<Model>& core, const unsigned* references, unsigned long count, const double* values) noexcept {
  for (unsigned long i = 0; i < count; ++i) {
    const Place place = place_of<Model>(references[i]);
    Refusal refusal = Refusal::of_variable(references[i], nullptr);
    if (place.group == Group::none) {
      refusal.reason = "does not exist";
    } else if (!may_be_set(core, place)) {
      refusal.reason = is_computed<Model>(place) ? "is computed and cannot be set" : "cannot be set in this mode";
    } else if (!std::isfinite(values[i])) {
      refusal.reason = "must be finite";
    }
    if (refusal.reason == nullptr) refusal = out_of_range<Model>(references[i], values[i]);
    if (refusal.reason != nullptr) return refuse(core, refusal);
  }
  bool is_tuned = false;
  for (unsigned long i = 0; i < count; ++i) {
    const Place place = place_of<Model>(references[i]);
    double& value = place_to_set(core.run, place);
    if (place.group == Group::input) core.run.slope[place.index] = 0;
    if (value == values[i]) continue;
    if (place.group == Group::start) {
      start_otherwise(core.run, place.index, values[i] - value);
    } else if ((core.run.mode & (kStep | kIntermediate)) == 0 || place.group != Group::input) {
      // A step follows the inputs itself.
      open_loops(core.run);
    }
    value = values[i];
    is_tuned = is_tuned || place.group == Group::parameter;
    core.is_solved = false;
    core.run.history = {};
  }
  // Recomputes the constants that depend on the parameters.
  if (is_tuned) core.run.parameters = typename Model::Parameters(core.run.parameters);
  return Answer::ok;
}

/// Sets derivatives of inputs, all or none: of inputs whose derivative is an input, and the first derivative of the
/// last one of a chain. Answer: error for a variable that is not an input, an order that the input does not have, or a
/// value that is not finite.
template <class Model>
Answer set_input_derivatives(Core<Model>& core, const unsigned* references, unsigned long count, const int* orders,
                             const double* values) noexcept {
  const auto last_of = [&](unsigned long i) {
    int input = place_of<Model>(references[i]).index;
    for (int order = 1; order < orders[i] && input >= 0; ++order) input = Model::kInputDerivative[input];
    return input;
  };
  for (unsigned long i = 0; i < count; ++i) {
    Refusal refusal = Refusal::of_variable(references[i], nullptr);
    if (place_of<Model>(references[i]).group != Group::input) {
      refusal.reason = "is no input";
    } else if (orders[i] < 1 || last_of(i) < 0) {
      refusal.reason = "has no derivative of this order";
    } else if (!std::isfinite(values[i])) {
      refusal.reason = "must have a finite derivative";
    }
    if (refusal.reason != nullptr) return refuse(core, refusal);
  }
  for (unsigned long i = 0; i < count; ++i) {
    const int input = last_of(i), rate = Model::kInputDerivative[input];
    if (rate >= 0) {
      core.run.inputs.*Model::kInputMember[rate] = values[i];
    } else {
      core.run.slope[input] = values[i];
    }
    core.is_solved = false;
    core.run.history = {};
  }
  return Answer::ok;
}

/// References and values that may be given: none, or an array.
constexpr bool is_array(const void* references, const void* values, unsigned long count) noexcept {
  return count == 0 || (references != nullptr && values != nullptr);
}

}  // namespace mbgen::fmu
