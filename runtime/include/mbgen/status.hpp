#pragma once
// What a solver call found. No exceptions, no strings at run time beyond literals.

namespace mbgen {

enum class Code : int {
  ok = 0,
  not_a_number,     ///< a state, input or parameter is not finite; index: coordinate, or -1
  loop_not_closed,  ///< Newton did not close a loop block; index: block
  loop_singular,    ///< a loop block lost rank at this position; index: block
  no_inertia,       ///< a free direction has no inertia; index: coordinate
  no_equilibrium,   ///< no static equilibrium was found from the start position; index: -1
  step_invalid      ///< the step size is not positive and finite; index: -1
};

/// Result of every call. `index` names the loop block or coordinate (see Code), -1 when nothing is to name.
struct Status {
  Code code = Code::ok;
  int index = -1;
  constexpr bool ok() const noexcept { return code == Code::ok; }
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
  }
  return "unknown";
}

}  // namespace mbgen
