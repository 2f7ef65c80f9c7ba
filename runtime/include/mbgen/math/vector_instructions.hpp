#pragma once
// Vector instructions (the vector_size extension of GCC and clang) that compilers do not generate from plain code, or
// only in several steps. The plain code is here too, for numbers and other processors, with the same bits.

#include <cstdint>

#include "mbgen/fma.hpp"

namespace mbgen {

/// The smaller of two; the first where they are equal or not comparable.
template <class T>
[[gnu::always_inline]] inline T smaller_of(const T& first, const T& second) noexcept {
#if defined(__AVX512F__) && defined(__FMA__)
#if defined(MBGEN_VECTOR_BUILTINS)
  if constexpr (sizeof(T) == 64)
    return __builtin_ia32_minpd512_mask(second, first, first, lanes_detail::kAllEight, lanes_detail::kRoundAsIs);
#else
  if constexpr (sizeof(T) == 64) return _mm512_mask_min_pd(first, 0xff, second, first);
#endif
#endif
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return __builtin_ia32_minpd256(second, first);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return __builtin_ia32_minpd(second, first);
#endif
  return second < first ? second : first;
}

/// The larger of two; the first where they are equal or not comparable.
template <class T>
[[gnu::always_inline]] inline T larger_of(const T& first, const T& second) noexcept {
#if defined(__AVX512F__) && defined(__FMA__)
#if defined(MBGEN_VECTOR_BUILTINS)
  if constexpr (sizeof(T) == 64)
    return __builtin_ia32_maxpd512_mask(second, first, first, lanes_detail::kAllEight, lanes_detail::kRoundAsIs);
#else
  if constexpr (sizeof(T) == 64) return _mm512_mask_max_pd(first, 0xff, second, first);
#endif
#endif
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return __builtin_ia32_maxpd256(second, first);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return __builtin_ia32_maxpd(second, first);
#endif
  return first < second ? second : first;
}

/// Whether a bit is set in any lane.
inline bool any(std::int64_t bits) noexcept { return bits != 0; }
template <class Words>
[[gnu::always_inline]] inline bool any(const Words& words) noexcept {
#if defined(__AVX512F__) && defined(__FMA__)
  if constexpr (sizeof(Words) == 64) {
    typedef long long Eight __attribute__((vector_size(64)));
    const auto bits = __builtin_bit_cast(Eight, words);
#if defined(MBGEN_VECTOR_BUILTINS)
    return __builtin_ia32_ptestmq512(bits, bits, lanes_detail::kAllEight) != 0;
#else
    return _mm512_test_epi64_mask(bits, bits) != 0;
#endif
  }
#endif
#if defined(__AVX__)
  if constexpr (sizeof(Words) == 32) {
    typedef long long Four __attribute__((vector_size(32)));
    const auto bits = __builtin_bit_cast(Four, words);
    return __builtin_ia32_ptestz256(bits, bits) == 0;
  }
#endif
  std::int64_t found = 0;
  for (int i = 0; i < static_cast<int>(sizeof(Words) / sizeof found); ++i) found |= words[i];
  return found != 0;
}

}  // namespace mbgen
