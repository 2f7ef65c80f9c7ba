#pragma once
// Numbers of force elements that share a law, side by side: vectors of the processor compute several elements at once.
// The result for an element does not depend on the others.

#include "mbgen/lanes.hpp"
#include "mbgen/lanes/array_lanes.hpp"

namespace mbgen {

/// Elements of so many that one vector holds.
constexpr int lanes_of_elements(int elements) noexcept {
  return static_cast<int>(array_detail::width_for<double>(static_cast<std::size_t>(elements)));
}

/// So many elements in one vector. Not LaneTypes of lanes.hpp: g++ takes vectors that may alias for other ones where
/// templates meet both, and elementary functions of many arguments take these.
template <int W>
using ElementLanes = array_detail::LanesOf<W>;

/// The numbers of the elements from this one on that one vector holds. Requires: there are so many.
template <int N>
[[gnu::always_inline]] inline ElementLanes<lanes_of_elements(N)> lanes_of(const double (&numbers)[N],
                                                                          int first) noexcept {
  return array_detail::lanes_at<lanes_of_elements(N)>(numbers + first);
}
/// The same as a place to write to. No reference: it would be aligned as a vector is.
template <int W>
class ElementPlace {
 public:
  explicit ElementPlace(double* numbers) noexcept : numbers_(numbers) {}
  [[gnu::always_inline]] void operator=(const ElementLanes<W>& lanes) noexcept {
    array_detail::put_lanes(lanes, numbers_);
  }

 private:
  double* numbers_;
};
template <int N>
[[gnu::always_inline]] inline ElementPlace<lanes_of_elements(N)> lanes_at(double (&numbers)[N], int first) noexcept {
  return ElementPlace<lanes_of_elements(N)>(numbers + first);
}

}  // namespace mbgen
