#pragma once
// Statuses of solver calls. No exceptions, no strings at run time beyond literals.

namespace mbgen {

/// Failures, and from kFirstNotice on notices, in increasing importance: the call succeeded, and the caller may want to
/// know how. Only steps give notices. Functions that fail with not_a_number may also fail with the four codes after it.
enum class Code : int {
  actuators_singular = -5,  ///< actuators hardly move a free direction at this position; index: direction
  rope_lost = -4,  ///< a taut rope lifts off a pulley, or has no way; index: place of a rope (-1 to -3: bounds.hpp)
  ok = 0,
  not_a_number,            ///< something of a coordinate is not finite; index: coordinate, or -1
  input_not_a_number,      ///< an input is not finite; index: input
  parameter_not_a_number,  ///< a tunable parameter is not finite; index: parameter
  auxiliary_not_a_number,  ///< an auxiliary state or its rate is not finite; index: auxiliary state
  time_not_a_number,       ///< the time is not finite; index: -1
  loop_not_closed,         ///< Newton did not close a loop block; index: block
  loop_singular,           ///< a loop block lost rank at this position; index: block
  no_inertia,              ///< a free direction has no inertia; index: coordinate
  no_equilibrium,          ///< no static equilibrium was found from the start position; index: -1
  step_invalid,            ///< the step size is not positive and finite; index: -1
  sample_inside_step,      ///< a sampled value may be due within a step; index: auxiliary state
  implicit_singular,       ///< the equations of an implicit step do not determine a free direction; index: coordinate
  implicit_state_grows,    ///< a state of the user's own, by itself, within an implicit step; index: auxiliary state
  chosen_again,            ///< the pivoting LU served a loop block with another choice of coordinates; index: block
  near_singular,           ///< a loop block came near a singular position; index: block
  singular_met,            ///< a loop block met a singular position, and passed it; index: block
  turned_far               ///< nothing of these, but a body turns farther in a step than the method bears, and forces
                           ///< turn with it; index: coordinate
};

constexpr Code kFirstNotice = Code::chosen_again;

/// An element does not hold at one of its places; index: place.
constexpr Code kNotHeld = Code::rope_lost;
constexpr const char* kNotHeldName = "rope_lost";

/// Result of every call. `index` counts the object of the code (see Code), -1 for none.
struct Status {
  Code code = Code::ok;
  int index = -1;
  constexpr bool ok() const noexcept { return code == Code::ok || code >= kFirstNotice; }
};

/// The meaning of a code, for messages.
constexpr const char* text(Code code) noexcept {
  switch (code) {
    case Code::rope_lost:
      return "taut rope lifts off a pulley, or has no way";
    case Code::ok:
      return "ok";
    case Code::not_a_number:
      return "not a number";
    case Code::input_not_a_number:
      return "input not a number";
    case Code::parameter_not_a_number:
      return "parameter not a number";
    case Code::auxiliary_not_a_number:
      return "auxiliary state not a number";
    case Code::time_not_a_number:
      return "time not a number";
    case Code::loop_not_closed:
      return "loop not closed";
    case Code::loop_singular:
      return "loop singular";
    case Code::no_inertia:
      return "no inertia";
    case Code::no_equilibrium:
      return "no equilibrium";
    case Code::step_invalid:
      return "step invalid";
    case Code::sample_inside_step:
      return "period is no multiple of the step, or the time is not";
    case Code::implicit_singular:
      return "implicit equations singular";
    case Code::implicit_state_grows:
      return "state grows too fast for an implicit step";
    case Code::actuators_singular:
      return "actuators near a singular position";
    case Code::chosen_again:
      return "coordinates chosen again";
    case Code::near_singular:
      return "near a singular position";
    case Code::singular_met:
      return "singular position met";
    case Code::turned_far:
      return "turns too far within a step";
  }
  return "unknown";
}

/// Kind of object that the index of a code counts.
enum class Subject { coordinate, loop_block, input, parameter, auxiliary_state, hold, free_direction };

constexpr Subject subject_of(Code code) noexcept {
  switch (code) {
    case Code::loop_not_closed:
    case Code::loop_singular:
    case Code::chosen_again:
    case Code::near_singular:
    case Code::singular_met:
      return Subject::loop_block;
    case Code::rope_lost:
      return Subject::hold;
    case Code::input_not_a_number:
      return Subject::input;
    case Code::parameter_not_a_number:
      return Subject::parameter;
    case Code::auxiliary_not_a_number:
    case Code::sample_inside_step:
    case Code::implicit_state_grows:
      return Subject::auxiliary_state;
    case Code::actuators_singular:
      return Subject::free_direction;
    default:
      return Subject::coordinate;
  }
}

/// A table of names.
struct Names {
  const char* const* names;
  int count;
};

/// Name of the object of a status, "" for none and for a free direction, which a solver with actuators names itself.
constexpr const char* name_of(Status status, Names coordinates, Names loop_blocks, Names inputs, Names parameters,
                              Names auxiliary_states, Names holds = {nullptr, 0}) noexcept {
  const Names tables[] = {coordinates, loop_blocks, inputs, parameters, auxiliary_states, holds, {nullptr, 0}};
  const Names table = tables[static_cast<int>(subject_of(status.code))];
  return status.index < 0 || status.index >= table.count ? "" : table.names[status.index];
}

/// The first place at which an element does not hold. hold: per place, negative or NaN there.
template <class Number>
constexpr Status status_of_holds(const Number* hold, int places) noexcept {
  for (int place = 0; place < places; ++place)
    if (!(hold[place] >= 0)) return {kNotHeld, place};
  return {};
}

/// The status without its notice: a failure, or ok.
constexpr Status without_notice(Status status) noexcept { return status.ok() ? Status{} : status; }

/// Of two calls that went well, the more telling status; the first of equals.
constexpr Status graver(Status first, Status second) noexcept { return second.code > first.code ? second : first; }

}  // namespace mbgen
