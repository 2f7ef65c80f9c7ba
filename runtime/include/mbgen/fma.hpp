#pragma once
// Products in sums, rounded once where the processor can: code that calls these has the same bits from every compiler.
// Without such an instruction product and sum are rounded each. For double, float and, lane by lane, for vectors of
// double (the vector_size extension of GCC and clang), where plain numbers count for every lane. Names as in the
// instructions.

// The header of the intrinsics takes a compiler longer to read than all others of a solver together: builtins stand in
// for it where the compiler knows them.
#if defined(__AVX__) && defined(__FMA__)
#if defined(__AVX512F__) && !defined(__clang__) && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_vfmsubpd512_mask) && __has_builtin(__builtin_ia32_ptestmq512)
#define MBGEN_VECTOR_BUILTINS
#endif
#elif !defined(__AVX512F__) && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_vfmaddpd256) && __has_builtin(__builtin_ia32_sqrtpd256)
#define MBGEN_VECTOR_BUILTINS
#endif
#endif
#if !defined(MBGEN_VECTOR_BUILTINS)
#include <immintrin.h>
#endif
#endif

#if defined(__aarch64__)
#include <arm_neon.h>
#endif

// Vectors wider than the processor's have no fixed calling convention; nothing here is called across files.
#pragma GCC diagnostic ignored "-Wpsabi"

#include <type_traits>

namespace mbgen {

/// Whether the functions below round once. clang 14 does not define the macro that g++ has for this.
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
constexpr bool kFusesProducts = true;
#else
constexpr bool kFusesProducts = false;
#endif

/// a b + c.
inline double fma(double a, double b, double c) noexcept {
  if constexpr (kFusesProducts)
    return __builtin_fma(a, b, c);
  else
    return a * b + c;
}

inline float fma(float a, float b, float c) noexcept {
#if defined(__FP_FAST_FMAF) || defined(__FMA__) || defined(__aarch64__)
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}

/// a b - c.
inline double fms(double a, double b, double c) noexcept { return mbgen::fma(a, b, -c); }
inline float fms(float a, float b, float c) noexcept { return mbgen::fma(a, b, -c); }

/// c - a b.
inline double fnma(double a, double b, double c) noexcept { return mbgen::fma(-a, b, c); }
inline float fnma(float a, float b, float c) noexcept { return mbgen::fma(-a, b, c); }

/// Number of lanes of a vector.
template <class Lanes>
inline constexpr int kLanesOf = static_cast<int>(sizeof(Lanes) / sizeof(double));

/// Whether a type is a vector: numbers with derivatives (tangents.hpp) have functions of their own.
template <class T>
inline constexpr bool kIsVector = !std::is_arithmetic_v<T> && !std::is_class_v<T>;

/// The vector among the types of arguments.
template <class... Arguments>
using WidestOf = std::enable_if_t<kIsVector<decltype((Arguments() + ...))>, decltype((Arguments() + ...))>;

namespace lanes_detail {

/// A number in every lane. The difference keeps the sign of zero.
template <class Lanes>
[[gnu::always_inline]] inline Lanes all(double value) noexcept {
  return value - Lanes{};
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes all(const Lanes& value) noexcept {
  return value;
}

/// a b + c, and the same with the sign of the product or of c turned. Each is one instruction of its own: g++ negates
/// an operand that several of them share beforehand.
template <class Lanes>
[[gnu::always_inline]] inline Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  Lanes result{};
  for (int lane = 0; lane < kLanesOf<Lanes>; ++lane) result[lane] = mbgen::fma(a[lane], b[lane], c[lane]);
  return result;
#else
  return a * b + c;
#endif
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes fused_less(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
  return fused(a, b, -c);
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes fused_from(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
  return fused(-a, b, c);
}

#if defined(__aarch64__)
typedef double Two __attribute__((vector_size(16), may_alias));
[[gnu::always_inline]] inline Two fused(const Two& a, const Two& b, const Two& c) noexcept {
  return vfmaq_f64(c, a, b);
}
[[gnu::always_inline]] inline Two fused_less(const Two& a, const Two& b, const Two& c) noexcept {
  return vfmaq_f64(-c, a, b);
}
[[gnu::always_inline]] inline Two fused_from(const Two& a, const Two& b, const Two& c) noexcept {
  return vfmsq_f64(c, a, b);
}
#endif

#if defined(__AVX__) && defined(__FMA__)
typedef double Two __attribute__((vector_size(16), may_alias));
typedef double Four __attribute__((vector_size(32), may_alias));
[[gnu::always_inline]] inline Two fused(const Two& a, const Two& b, const Two& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS)
  return __builtin_ia32_vfmaddpd(a, b, c);
#else
  return _mm_fmadd_pd(a, b, c);
#endif
}
// clang makes one instruction of it with the sign, and has no builtins for these.
[[gnu::always_inline]] inline Two fused_less(const Two& a, const Two& b, const Two& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS) && !defined(__clang__)
  return __builtin_ia32_vfmsubpd(a, b, c);
#elif defined(MBGEN_VECTOR_BUILTINS)
  return fused(a, b, -c);
#else
  return _mm_fmsub_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Two fused_from(const Two& a, const Two& b, const Two& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS) && !defined(__clang__)
  return __builtin_ia32_vfnmaddpd(a, b, c);
#elif defined(MBGEN_VECTOR_BUILTINS)
  return fused(-a, b, c);
#else
  return _mm_fnmadd_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Four fused(const Four& a, const Four& b, const Four& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS)
  return __builtin_ia32_vfmaddpd256(a, b, c);
#else
  return _mm256_fmadd_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Four fused_less(const Four& a, const Four& b, const Four& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS) && !defined(__clang__)
  return __builtin_ia32_vfmsubpd256(a, b, c);
#elif defined(MBGEN_VECTOR_BUILTINS)
  return fused(a, b, -c);
#else
  return _mm256_fmsub_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Four fused_from(const Four& a, const Four& b, const Four& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS) && !defined(__clang__)
  return __builtin_ia32_vfnmaddpd256(a, b, c);
#elif defined(MBGEN_VECTOR_BUILTINS)
  return fused(-a, b, c);
#else
  return _mm256_fnmadd_pd(a, b, c);
#endif
}
#if defined(__AVX512F__)
typedef double Eight __attribute__((vector_size(64), may_alias));
constexpr unsigned char kAllEight = 0xff;  // a bit for each lane
constexpr int kRoundAsIs = 4;              // in the direction that the processor is set to
[[gnu::always_inline]] inline Eight fused(const Eight& a, const Eight& b, const Eight& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS)
  return __builtin_ia32_vfmaddpd512_mask(a, b, c, kAllEight, kRoundAsIs);
#else
  return _mm512_fmadd_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Eight fused_less(const Eight& a, const Eight& b, const Eight& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS)
  return __builtin_ia32_vfmsubpd512_mask(a, b, c, kAllEight, kRoundAsIs);
#else
  return _mm512_fmsub_pd(a, b, c);
#endif
}
[[gnu::always_inline]] inline Eight fused_from(const Eight& a, const Eight& b, const Eight& c) noexcept {
#if defined(MBGEN_VECTOR_BUILTINS)
  return __builtin_ia32_vfnmaddpd512_mask(a, b, c, kAllEight, kRoundAsIs);
#else
  return _mm512_fnmadd_pd(a, b, c);
#endif
}
#else
typedef double Eight __attribute__((vector_size(64)));
[[gnu::always_inline]] inline Eight fused(const Eight& a, const Eight& b, const Eight& c) noexcept {
  const Four low = fused(__builtin_shufflevector(a, a, 0, 1, 2, 3), __builtin_shufflevector(b, b, 0, 1, 2, 3),
                         __builtin_shufflevector(c, c, 0, 1, 2, 3));
  const Four high = fused(__builtin_shufflevector(a, a, 4, 5, 6, 7), __builtin_shufflevector(b, b, 4, 5, 6, 7),
                          __builtin_shufflevector(c, c, 4, 5, 6, 7));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
#endif
#endif

}  // namespace lanes_detail

template <class A, class B, class C, class Lanes = WidestOf<A, B, C>>
[[gnu::always_inline]] inline Lanes fma(const A& a, const B& b, const C& c) noexcept {
  using namespace lanes_detail;
  return fused(all<Lanes>(a), all<Lanes>(b), all<Lanes>(c));
}

template <class A, class B, class C, class Lanes = WidestOf<A, B, C>>
[[gnu::always_inline]] inline Lanes fms(const A& a, const B& b, const C& c) noexcept {
  using namespace lanes_detail;
  return fused_less(all<Lanes>(a), all<Lanes>(b), all<Lanes>(c));
}

template <class A, class B, class C, class Lanes = WidestOf<A, B, C>>
[[gnu::always_inline]] inline Lanes fnma(const A& a, const B& b, const C& c) noexcept {
  using namespace lanes_detail;
  return fused_from(all<Lanes>(a), all<Lanes>(b), all<Lanes>(c));
}

}  // namespace mbgen
