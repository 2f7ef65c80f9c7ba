#pragma once
// Numbers that the reader refuses, while a solver runs: their bounds, and the codes of a call that got such ones.

#include "mbgen/status.hpp"

namespace mbgen {

/// Failures beside those of Code, with the same numbers as in the C interface: a parameter or an input beyond its min
/// or max, index: parameter, input; a number of the model that parameters and inputs make and that no model may have,
/// index: into kQuantityNames of the solver.
constexpr Code kParameterOutOfRange = static_cast<Code>(-1), kInputOutOfRange = static_cast<Code>(-2),
               kQuantityOutOfRange = static_cast<Code>(-3);

/// The meaning of any code, for messages.
constexpr const char* text_of_any(Code code) noexcept {
  if (code == kParameterOutOfRange) return "parameter out of its range";
  if (code == kInputOutOfRange) return "input out of its range";
  if (code == kQuantityOutOfRange) return "parameters make what no model may have";
  return text(code);
}

/// Largest magnitude of a number of a model.
constexpr double kLargestBounded = 1e15;

/// Whether a number is in its bounds; NaN is in none.
constexpr bool is_positive(double x) noexcept { return x > 0 && x <= kLargestBounded; }
constexpr bool is_not_negative(double x) noexcept { return x >= 0 && x <= kLargestBounded; }
constexpr bool is_share(double x) noexcept { return x >= 0 && x < 1; }

}  // namespace mbgen
