#pragma once
// Numbers of a table by their place in it, for scalars and lanes.

#include <cstddef>
#include <type_traits>

namespace mbgen {

/// samples[index], a whole number: the first one for smaller indices and NaN, the last one for larger indices. Index:
/// double, float or a vector of double.
template <class Index, std::size_t N>
[[gnu::always_inline]] inline Index sample(const double (&samples)[N], const Index& index) noexcept {
  if constexpr (std::is_arithmetic_v<Index>) {
    constexpr Index last = static_cast<Index>(N - 1);
    const Index inside = index >= 0 ? (index < last ? index : last) : Index(0);
    return static_cast<Index>(samples[static_cast<std::size_t>(inside)]);
  } else {
    Index result{};
    for (std::size_t lane = 0; lane < sizeof(Index) / sizeof(double); ++lane)
      result[lane] = sample(samples, static_cast<double>(index[lane]));
    return result;
  }
}

}  // namespace mbgen
