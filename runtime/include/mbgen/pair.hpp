#pragma once
// Left and right of a mechanism, or two equal parts, in one vector of two doubles (the vector_size extension of GCC and
// clang).

#include "mbgen/fma.hpp"
#include "mbgen/lanes/array_lanes.hpp"

namespace mbgen {

/// A number of one side and the corresponding number of the other side in a mirror; or of a part and of its twin.
/// Operations are lane by lane; the result of one lane does not depend on the other.
using Pair = array_detail::LanesOf<2>;

/// Two numbers that stand one after the other.
[[gnu::always_inline]] inline Pair pair_at(const double* numbers) noexcept {
  return array_detail::lanes_at<2>(numbers);
}

/// Square roots, as std::sqrt.
[[gnu::always_inline]] inline Pair sqrt(const Pair& x) noexcept {
#if defined(__SSE2__)
  return __builtin_ia32_sqrtpd(x);
#else
  return Pair{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}

}  // namespace mbgen
