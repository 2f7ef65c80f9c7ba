#pragma once
// Types of the numbers that emitted code computes with.

namespace mbgen {

enum class Scalar {
  doubles,
  floats,
  pairs,      ///< left and right, or twins, in two lanes: mbgen/pair.hpp
  lanes,      ///< of a batch: an instance in each lane
  elements,   ///< of a shared law: an element in each lane; each law has a type of its own
  tangents,   ///< a double with derivatives: mbgen/tangents.hpp
  directions  ///< derivatives alone, one a lane: mbgen/directions.hpp
};

/// Whether values are numbers one by one.
constexpr bool is_number(Scalar scalar) {
  return scalar == Scalar::doubles || scalar == Scalar::floats || scalar == Scalar::tangents;
}

/// Numbers without derivatives in place of those with some.
constexpr Scalar plain(Scalar scalar) { return scalar == Scalar::tangents ? Scalar::doubles : scalar; }

/// Name of the type in emitted code; the first part of it for elements.
constexpr const char* name_of(Scalar scalar) {
  return scalar == Scalar::doubles      ? "double"
         : scalar == Scalar::floats     ? "float"
         : scalar == Scalar::pairs      ? "Pair"
         : scalar == Scalar::tangents   ? "Real"
         : scalar == Scalar::directions ? "Directions"
                                        : "Lanes";
}

}  // namespace mbgen
