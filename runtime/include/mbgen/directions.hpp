#pragma once
// Derivatives in several directions at once, one a lane: the functions that programs of derivatives call
// beside those of fma.hpp. Their other arguments are plain numbers, the slopes of values.

#include "mbgen/fma.hpp"
#include "mbgen/math/tangent_numbers.hpp"

namespace mbgen {

/// Derivatives in as many directions as an emitted solver has.
using Directions = DirectionTypes<8>::Vector;

namespace directions_detail {

[[gnu::always_inline]] inline Directions in_all(double number) noexcept {
  return lanes_detail::all<Directions>(number);
}

}  // namespace directions_detail

[[gnu::always_inline]] inline Directions abs(const Directions& x) noexcept { return x < 0 ? -x : x; }

/// a where condition >= 0, else b (b for NaN); 0 is a derivative too.
[[gnu::always_inline]] inline Directions select(double condition, const Directions& a, const Directions& b) noexcept {
  return condition >= 0 ? a : b;
}
[[gnu::always_inline]] inline Directions select(double condition, double a, const Directions& b) noexcept {
  return condition >= 0 ? directions_detail::in_all(a) : b;
}
[[gnu::always_inline]] inline Directions select(double condition, const Directions& a, double b) noexcept {
  return condition >= 0 ? a : directions_detail::in_all(b);
}
/// Direction by direction.
[[gnu::always_inline]] inline Directions select(const Directions& condition, double a, const Directions& b) noexcept {
  return condition >= 0 ? directions_detail::in_all(a) : b;
}

}  // namespace mbgen
