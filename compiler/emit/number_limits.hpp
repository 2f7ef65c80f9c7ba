#pragma once
// Limits of numbers as a solver's precision has them.

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/emit/scalar.hpp"

namespace mbgen {

/// A limit as a number of the solver's type that is no zero, where the limit is none, and is finite: a least value
/// above zero stays above it.
inline double limit_in(double limit, Scalar scalar) {
  if (scalar != Scalar::floats) return limit;
  constexpr double largest = std::numeric_limits<float>::max(), smallest = std::numeric_limits<float>::min();
  if (limit != 0 && std::abs(limit) < smallest) return std::copysign(smallest, limit);
  return static_cast<float>(std::clamp(limit, -largest, largest));
}

}  // namespace mbgen
