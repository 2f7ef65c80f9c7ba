#pragma once
// What a solver call found. No exceptions, no strings at run time beyond literals.

namespace mbgen {

/// Failures, and from kFirstNotice on notices, the more telling ones last: the call did what it was asked, and the
/// caller may want to know how. Only steps give notices.
enum class Code : int {
  ok = 0,
  not_a_number,     ///< a state, input or parameter is not finite; index: coordinate, or -1
  loop_not_closed,  ///< Newton did not close a loop block; index: block
  loop_singular,    ///< a loop block lost rank at this position; index: block
  no_inertia,       ///< a free direction has no inertia; index: coordinate
  no_equilibrium,   ///< no static equilibrium was found from the start position; index: -1
  step_invalid,     ///< the step size is not positive and finite; index: -1
  chosen_again,     ///< the pivoting LU served a loop block with another choice of coordinates; index: block
  near_singular,    ///< a loop block came near a singular position; index: block
  singular_met      ///< a loop block met a singular position, and passed it; index: block
};

constexpr Code kFirstNotice = Code::chosen_again;

/// Result of every call. `index` names the loop block or coordinate (see Code), -1 when nothing is to name.
struct Status {
  Code code = Code::ok;
  int index = -1;
  constexpr bool ok() const noexcept { return code == Code::ok || code >= kFirstNotice; }
};

/// The meaning of a code, for messages.
constexpr const char* text(Code code) noexcept {
  switch (code) {
    case Code::ok:
      return "ok";
    case Code::not_a_number:
      return "not a number";
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
    case Code::chosen_again:
      return "coordinates chosen again";
    case Code::near_singular:
      return "near a singular position";
    case Code::singular_met:
      return "singular position met";
  }
  return "unknown";
}

/// True when the index of a code is that of a loop block, not of a coordinate.
constexpr bool names_block(Code code) noexcept {
  return code == Code::loop_not_closed || code == Code::loop_singular || code >= kFirstNotice;
}

/// The status without its notice: a failure, or ok.
constexpr Status without_notice(Status status) noexcept { return status.ok() ? Status{} : status; }

/// Of two calls that went well, the more telling status; the first of equals.
constexpr Status more_telling(Status first, Status second) noexcept {
  return second.code > first.code ? second : first;
}

}  // namespace mbgen
