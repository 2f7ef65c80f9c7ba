#pragma once
// Several doubles in one vector (the vector_size extension of GCC and clang), lane by lane: the functions that emitted
// programs call, each with the bits of its scalar sibling. In a call of several arguments plain numbers count for
// every lane.

#include <cmath>
#include <type_traits>

#include "mbgen/elementary.hpp"
#include "mbgen/fma.hpp"
#include "mbgen/math/vector_instructions.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// A vector of W doubles.
template <int W>
struct LaneTypes {
  typedef double Lanes __attribute__((vector_size(8 * W), may_alias));
  /// The same at the address of doubles, with their alignment.
  typedef double InArray __attribute__((vector_size(8 * W), aligned(8), may_alias));
};

/// One number in every lane.
template <class Lanes>
[[gnu::always_inline]] inline Lanes every_lane(double number) noexcept {
  return lanes_detail::all<Lanes>(number);
}

/// Result of a comparison of vectors: all bits of a lane where it holds, none elsewhere.
template <class Lanes>
using MaskOf = decltype(Lanes() < Lanes());

/// Lanes of `chosen` where the mask has them, of `other` elsewhere.
template <class Mask, class Lanes>
[[gnu::always_inline]] inline Lanes choose(const Mask& mask, const Lanes& chosen, const Lanes& other) noexcept {
  return mask ? chosen : other;
}

/// One bit per lane, the first the lowest.
template <class Mask>
[[gnu::always_inline]] inline unsigned bits_of(const Mask& mask) noexcept {
#if defined(__AVX512F__)
  if constexpr (sizeof(Mask) == 64 && kLanesOf<Mask> == 8) {
    typedef long long Eight __attribute__((vector_size(64)));
    const auto lanes = __builtin_bit_cast(Eight, mask);
#if defined(MBGEN_VECTOR_BUILTINS)
    return __builtin_ia32_ptestmq512(lanes, lanes, lanes_detail::kAllEight);
#else
    return _mm512_test_epi64_mask(lanes, lanes);
#endif
  }
#endif
#if defined(__AVX__) && defined(__FMA__)
  if constexpr (sizeof(Mask) == 32 && kLanesOf<Mask> == 4)
    return static_cast<unsigned>(__builtin_ia32_movmskpd256(__builtin_bit_cast(lanes_detail::Four, mask)));
#endif
  unsigned bits = 0;
  for (int lane = 0; lane < kLanesOf<Mask>; ++lane) bits |= mask[lane] != 0 ? 1u << lane : 0u;
  return bits;
}

/// Copies the lanes of the mask from `from` to `to`.
template <class Mask, class Lanes>
[[gnu::always_inline]] inline void take(const Mask& mask, const Lanes& from, Lanes& to) noexcept {
  to = choose(mask, from, to);
}

/// Stored values are read from there afterwards: compilers keep a second copy of it on the stack otherwise.
[[gnu::always_inline]] inline void read_back() noexcept { asm volatile("" : : : "memory"); }

namespace lanes_detail {

/// A function of the C library, lane after lane.
template <class Lanes, class Function>
[[gnu::always_inline]] inline Lanes each(const Lanes& x, Function function) noexcept {
  Lanes result{};
  for (int lane = 0; lane < kLanesOf<Lanes>; ++lane) result[lane] = function(static_cast<double>(x[lane]));
  return result;
}
}  // namespace lanes_detail

/// a where condition >= 0, else b (b for NaN).
template <class Lanes, class A, class B, class = std::enable_if_t<kIsVector<Lanes>>>
[[gnu::always_inline]] inline Lanes select(const Lanes& condition, const A& a, const B& b) noexcept {
  using namespace lanes_detail;
  return condition >= 0.0 ? all<Lanes>(a) : all<Lanes>(b);
}

/// The smaller of two; the first when they are equal or not comparable.
template <class A, class B, class Lanes = WidestOf<A, B>>
[[gnu::always_inline]] inline Lanes min(const A& a, const B& b) noexcept {
  const Lanes first = lanes_detail::all<Lanes>(a), second = lanes_detail::all<Lanes>(b);
  return smaller_of(first, second);
}

/// The larger of two; the first when they are equal or not comparable.
template <class A, class B, class Lanes = WidestOf<A, B>>
[[gnu::always_inline]] inline Lanes max(const A& a, const B& b) noexcept {
  const Lanes first = lanes_detail::all<Lanes>(a), second = lanes_detail::all<Lanes>(b);
  return larger_of(first, second);
}

/// Absolute value.
template <class Lanes>
[[gnu::always_inline]] inline Lanes abs(const Lanes& x) noexcept {
  using Bits = MaskOf<Lanes>;
  return __builtin_bit_cast(Lanes, __builtin_bit_cast(Bits, x) & 0x7fffffffffffffff);
}

template <class Lanes>
[[gnu::always_inline]] inline Lanes sqrt(const Lanes& x) noexcept {
#if defined(__AVX512F__)
#if defined(MBGEN_VECTOR_BUILTINS)
  if constexpr (kLanesOf<Lanes> == 8)
    return __builtin_ia32_sqrtpd512_mask(x, x, lanes_detail::kAllEight, lanes_detail::kRoundAsIs);
#else
  if constexpr (kLanesOf<Lanes> == 8)
    return _mm512_mask_sqrt_pd(x, 0xff, x);  // the plain one makes g++ 12 warn of itself
#endif
#endif
#if defined(__AVX__) && defined(__FMA__)
#if defined(MBGEN_VECTOR_BUILTINS)
  if constexpr (kLanesOf<Lanes> == 4) return __builtin_ia32_sqrtpd256(x);
#else
  if constexpr (kLanesOf<Lanes> == 4) return _mm256_sqrt_pd(x);
#endif
#endif
  return lanes_detail::each(x, [](double value) { return std::sqrt(value); });
}

/// The largest whole number not above it.
template <class Lanes>
[[gnu::always_inline]] inline Lanes floor(const Lanes& x) noexcept {
  return lanes_detail::each(x, [](double value) { return std::floor(value); });
}

/// Angles within 3 ulp, as arc_sine and arc_cosine of a double.
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes arc_sine(const Lanes& x) noexcept {
  return arc_sine<Lanes>(x, sqrt((1.0 - x) * (1.0 + x)));
}
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes arc_cosine(const Lanes& x) noexcept {
  return arc_cosine<Lanes>(x, sqrt((1.0 - x) * (1.0 + x)));
}

/// Functions of two arguments, one of which is the same for all lanes.
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes power(const Lanes& base, double exponent) noexcept {
  return power<Lanes>(base, lanes_detail::all<Lanes>(exponent));
}
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes power(double base, const Lanes& exponent) noexcept {
  return power<Lanes>(lanes_detail::all<Lanes>(base), exponent);
}
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes arc_tangent(const Lanes& y, double x) noexcept {
  return arc_tangent<Lanes>(y, lanes_detail::all<Lanes>(x));
}
template <class Lanes, class = std::enable_if_t<kIsVector<Lanes>>>
inline Lanes arc_tangent(double y, const Lanes& x) noexcept {
  return arc_tangent<Lanes>(lanes_detail::all<Lanes>(y), x);
}

}  // namespace mbgen
