#pragma once
// Numbers of force elements that share a law, side by side: vectors of the processor compute several elements at once.
// The result for an element does not depend on the others.

#include "mbgen/array_lanes.hpp"
#include "mbgen/lanes.hpp"

namespace mbgen {

/// Elements of so many that one vector holds.
constexpr int lanes_of_elements(int elements) noexcept {
  return static_cast<int>(array_detail::width_for<double>(static_cast<std::size_t>(elements)));
}

/// The numbers of the elements from this one on that one vector holds. Requires: there are so many.
template <int N>
[[gnu::always_inline]] inline auto lanes_of(const double (&numbers)[N], int first) noexcept ->
    typename LaneTypes<lanes_of_elements(N)>::Lanes {
  return *reinterpret_cast<const typename LaneTypes<lanes_of_elements(N)>::InArray*>(numbers + first);
}
/// The same as a place to write to.
template <int N>
[[gnu::always_inline]] inline auto lanes_at(double (&numbers)[N], int first) noexcept ->
    typename LaneTypes<lanes_of_elements(N)>::InArray& {
  return *reinterpret_cast<typename LaneTypes<lanes_of_elements(N)>::InArray*>(numbers + first);
}

}  // namespace mbgen
