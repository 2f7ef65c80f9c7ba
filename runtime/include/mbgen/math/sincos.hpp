#pragma once
// Sine and cosine of an angle together, without branches on it: for double, for vectors of double (the vector_size
// extension of GCC and clang), and for arrays of either.
//
// Every function computes each angle by the same operations, so that scalar code, lanes and arrays have the same bits.
// Products in sums are fused by name (fma.hpp), none is left to the compiler: g++ and clang++ give the same bits, one
// set on processors with fused multiply-add, another on those without.
//
// Method: reduction by a multiple of pi/2 in parts, so short that products with a multiple below 2^20 are exact (W. J.
// Cody, W. Waite, Software Manual for the Elementary Functions, 1980); rounding errors of the differences are carried
// along. A fused product is exact at any length as long as the difference is: there the first part has all bits.
// Minimax polynomials by docs/method/minimax.py: on [-pi/4, pi/4] of relative error 2^-57.9 for the sine and 2^-63.9
// for the cosine, on [-pi/2, pi/2] 2^-61.5 for the sine alone.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "mbgen/fma.hpp"
#include "mbgen/lanes/array_lanes.hpp"
#include "mbgen/math/vector_instructions.hpp"

namespace mbgen {

/// Largest |angle| (rad) of the reduction, 167 000 revolutions. Beyond it the C library takes over.
constexpr double kLargestAngle = 0x1p20;

namespace elementary_detail {

/// Integers as wide as T, lane by lane: the type of comparisons of vectors.
template <class T>
using Bits = std::conditional_t<std::is_same_v<T, double>, std::int64_t, decltype(T() < T())>;

constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
/// 1.5 * 2^52: adding it rounds to a whole number and leaves that in the low bits.
constexpr double kRounding = 0x1.8p52;
/// The same for even numbers, and half of them in the low bits.
constexpr double kRoundingToEven = 0x1.8p53;
/// pi/2 in parts of 33 bits, the last of 53; and in parts of 53, 33 and 53 bits for fused products.
constexpr double kHalfPi[4] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
constexpr double kHalfPiFused[3] = {0x1.921fb54442d18p+0, 0x1.1a626331p-54, 0x1.1701b839a252p-88};
/// (sin x - x) / x^3 and (cos x - 1 + x^2/2) / x^4 in powers of x^2.
constexpr double kSine[6] = {-0x1.5555555555548p-3, 0x1.111111110f730p-7,   -0x1.a01a019be9217p-13,
                             0x1.71de35552b52cp-19, -0x1.ae5e4b83e46f4p-26, 0x1.5d8b559495e22p-33};
constexpr double kCosine[6] = {0x1.555555555554bp-5,   -0x1.6c16c16c15015p-10, 0x1.a01a019c8f254p-16,
                               -0x1.27e4f7f19148bp-22, 0x1.1ee9dbcefbdc4p-29,  -0x1.8fa684873cb97p-37};
constexpr double kSineOfHalfTurn[8] = {-0x1.5555555555555p-3,  0x1.11111111110c8p-7,   -0x1.a01a01a014d6fp-13,
                                       0x1.71de3a52a0b16p-19,  -0x1.ae6454d474683p-26, 0x1.6123cd0749583p-33,
                                       -0x1.ae4384744a182p-41, 0x1.8832a85611f80p-49};
constexpr std::int64_t kSignless = 0x7fffffffffffffff, kSign = -0x7fffffffffffffff - 1;
constexpr std::int64_t kInfinity = 0x7ff0000000000000;

/// Left shift without the undefined cases of signed integers.
[[gnu::always_inline]] inline std::int64_t shifted_left(std::int64_t bits, int places) noexcept {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(bits) << places);
}
template <class B, class = std::enable_if_t<!std::is_integral_v<B>>>
[[gnu::always_inline]] inline B shifted_left(const B& bits, int places) noexcept {
  return bits << places;
}

/// angle - multiple pi/2 = x + rest, rest small next to x. Requires: a whole multiple up to 2^20.
/// References here and below, not values: vectors wider than the processor's have no settled way to be passed.
template <class T>
inline void take_off_quarters(const T& angle, const T& multiple, T& x, T& rest) noexcept {
  if constexpr (kFusesProducts) {
    const auto& part = kHalfPiFused;
    const T first = fnma(multiple, part[0], angle);  // exact
    x = fnma(multiple, part[1], first);
    rest = fnma(multiple, part[2], fnma(multiple, part[1], first - x));
  } else {
    const T first = fnma(multiple, kHalfPi[0], angle);  // exact
    const T second = fnma(multiple, kHalfPi[1], first);
    x = fnma(multiple, kHalfPi[2], second);
    const T lost = fnma(multiple, kHalfPi[1], first - second) + fnma(multiple, kHalfPi[2], second - x);
    rest = fnma(multiple, kHalfPi[3], lost);
  }
}

/// Sine and cosine by reduction, for |angle| up to kLargestAngle.
template <class T>
inline void reduced_sincos(const T& angle, T& sine, T& cosine) noexcept {
  using B = Bits<T>;
  const T rounded = fma(angle, kTwoOverPi, kRounding);
  T x, rest;
  take_off_quarters<T>(angle, rounded - kRounding, x, rest);

  const T z = x * x, zz = z * z, half = 0.5 * z, cube = z * x;
  const auto& a = kSine;
  const auto& b = kCosine;
  const T s = fma(zz, fma(zz, fma(z, a[5], a[4]), fma(z, a[3], a[2])), fma(z, a[1], a[0]));
  const T c = fma(zz, fma(zz, fma(z, b[5], b[4]), fma(z, b[3], b[2])), fma(z, b[1], b[0]));
  const T near_one = 1.0 - half;
  const T small_sine = x + fma(cube, s, fnma(half, rest, rest));
  const T small_cosine = near_one + fma(zz, c, fnma(x, rest, (1.0 - near_one) - half));

  const B quarter = __builtin_bit_cast(B, rounded);
  const B odd = -(quarter & 1);
  const B sine_bits = __builtin_bit_cast(B, small_sine), cosine_bits = __builtin_bit_cast(B, small_cosine);
  const B exchange = (sine_bits ^ cosine_bits) & odd;
  sine = __builtin_bit_cast(T, (sine_bits ^ exchange) ^ ((quarter & 2) << 62));
  cosine = __builtin_bit_cast(T, (cosine_bits ^ exchange) ^ (((quarter + 1) & 2) << 62));
}

/// Sine of x + rest, |x| <= pi/2, its sign turned where `flip` has the sign bit.
template <class T>
inline void sine_of_half_turn(const T& x, const T& rest, const Bits<T>& flip, T& sine) noexcept {
  const auto& a = kSineOfHalfTurn;
  const T z = x * x, z2 = z * z, z4 = z2 * z2;
  const T high = fma(z4, fma(z, a[7], a[6]), fma(z2, fma(z, a[5], a[4]), fma(z, a[3], a[2])));
  const T s = fma(z, fma(z, high, a[1]), a[0]);
  const T positive = x + fma(x, z * s, fnma(0.5 * z, rest, rest));
  sine = __builtin_bit_cast(T, __builtin_bit_cast(Bits<T>, positive) ^ flip);
}

/// The sine alone: of the angle less an even number of quarters, with a sign.
template <class T>
inline void reduced_sine(const T& angle, T& sine) noexcept {
  const T rounded = fma(angle, kTwoOverPi, kRoundingToEven);
  T x, rest;
  take_off_quarters<T>(angle, rounded - kRoundingToEven, x, rest);
  sine_of_half_turn<T>(x, rest, shifted_left(__builtin_bit_cast(Bits<T>, rounded), 63), sine);
}

/// The cosine alone: the sine less an odd number of quarters. Of small angles that difference is rounded, where the
/// sine is flat.
template <class T>
inline void reduced_cosine(const T& angle, T& cosine) noexcept {
  const T rounded = fma(angle, kTwoOverPi, -1.0) + kRoundingToEven;
  T x, rest;
  take_off_quarters<T>(angle, (rounded - kRoundingToEven) + 1.0, x, rest);
  sine_of_half_turn<T>(x, rest, shifted_left(~__builtin_bit_cast(Bits<T>, rounded), 63), cosine);
}

/// first where the mask is set (all bits of a lane), else second.
inline double chosen(std::int64_t mask, double first, double second) noexcept {
  return __builtin_bit_cast(
      double, (__builtin_bit_cast(std::int64_t, first) & mask) | (__builtin_bit_cast(std::int64_t, second) & ~mask));
}
template <class B, class T>
[[gnu::always_inline]] inline T chosen(const B& mask, const T& first, const T& second) noexcept {
  return mask ? first : second;
}

/// All bits of the lanes in which a is less than b.
inline std::int64_t mask_of_less(double a, double b) noexcept { return -static_cast<std::int64_t>(a < b); }
template <class T>
[[gnu::always_inline]] inline Bits<T> mask_of_less(const T& a, const T& b) noexcept {
  return a < b;
}

/// number where the mask is set, else zero; its sign turned where `flip` has the sign bit.
template <class T>
[[gnu::always_inline]] inline T masked(const Bits<T>& mask, double number, const Bits<T>& flip) noexcept {
  return __builtin_bit_cast(T, (__builtin_bit_cast(Bits<T>, T() + number) & mask) ^ flip);
}

/// The sine alone for |angle| <= pi: of the angle, or of pi less it.
template <class T>
inline void bounded_sine(const T& angle, T& sine) noexcept {
  using B = Bits<T>;
  const auto& part = kHalfPiFused;
  const B bits = __builtin_bit_cast(B, angle);
  const T size = __builtin_bit_cast(T, bits & kSignless), other = 2 * part[0] - size;
  const B is_over = mask_of_less(other, size);
  sine_of_half_turn<T>(chosen(is_over, other, size), masked<T>(is_over, 2 * (part[1] + part[2]), B{}), bits & kSign,
                       sine);
}

/// The cosine alone for |angle| <= pi: the sine of pi/2 less it.
template <class T>
inline void bounded_cosine(const T& angle, T& cosine) noexcept {
  const auto& part = kHalfPiFused;
  const T size = __builtin_bit_cast(T, __builtin_bit_cast(Bits<T>, angle) & kSignless);
  const T x = part[0] - size;
  sine_of_half_turn<T>(x, ((part[0] - x) - size) + (part[1] + part[2]), Bits<T>{}, cosine);
}

/// Marks the lanes whose angle is beyond the reduction, or no number.
template <class T>
inline void mark_beyond(const T& angle, Bits<T>& beyond) noexcept {
  constexpr std::int64_t largest = __builtin_bit_cast(std::int64_t, kLargestAngle);
  beyond |= (__builtin_bit_cast(Bits<T>, angle) & kSignless) > largest;
}

/// Calls the C library for the marked lanes: result = function(x) or function(x, y).
template <class Function, class... Doubles>
inline void replace_marked(std::int64_t marked, Function function, double& result, Doubles... arguments) noexcept {
  if (marked != 0) result = function(arguments...);
}
template <class B, class T, class Function, class... Arguments, class = std::enable_if_t<!std::is_integral_v<B>>>
inline void replace_marked(const B& marked, Function function, T& result, const Arguments&... arguments) noexcept {
  for (int lane = 0; lane < kLanesOf<T>; ++lane) {
    if (marked[lane] != 0) result[lane] = function(static_cast<double>(arguments[lane])...);
  }
}

/// The C library's, where the angle is beyond the reduction.
template <class T, class Library>
inline void replace_beyond(Library library, const T& angle, T& value) noexcept {
  Bits<T> beyond = {};
  mark_beyond(angle, beyond);
  replace_marked(beyond, library, value, angle);
}

/// The functions of the C library, for the sine and the cosine alone and for both.
constexpr auto kLibrarySine = [](double x) { return std::sin(x); };
constexpr auto kLibraryCosine = [](double x) { return std::cos(x); };
template <class T>
inline void replace_beyond(const T& angle, T& sine, T& cosine) noexcept {
  replace_beyond(kLibrarySine, angle, sine);
  replace_beyond(kLibraryCosine, angle, cosine);
}

using array_detail::lanes_at;
using array_detail::LanesOf;
using array_detail::put_lanes;
using array_detail::width_for;

/// values[i] = function of the i-th entries of the arguments, for doubles in lanes. function(arguments..., result).
template <class T, std::size_t N, class Function, class... Arguments>
inline void each_entry(Function function, T (&values)[N], const Arguments&... arguments) noexcept {
  const auto one = [&](std::size_t i) { function(arguments[i]..., values[i]); };
  if constexpr (std::is_same_v<T, double>) {
    const auto several = [&](std::size_t i) {
      constexpr int width = width_for(N);
      LanesOf<width> value;
      function(lanes_at<width>(arguments + i)..., value);
      put_lanes(value, values + i);
    };
    array_detail::for_all<N>(several, one);
  } else {
    for (std::size_t i = 0; i < N; ++i) one(i);
  }
}

/// values[i] by one of the functions alone; `library` where an angle is beyond the reduction.
template <class T, std::size_t N, class Function, class Library>
inline void each_angle(Function function, Library library, const T (&angles)[N], T (&values)[N]) noexcept {
  Bits<T> beyond = {};
  for (std::size_t i = 0; i < N; ++i) {
    function(angles[i], values[i]);
    mark_beyond(angles[i], beyond);
  }
  if (__builtin_expect(any(beyond), 0)) {
    for (std::size_t i = 0; i < N; ++i) replace_beyond(library, angles[i], values[i]);
  }
}

}  // namespace elementary_detail

/// Sine and cosine of an angle (rad) within 1 ulp; NaN for an angle that is not finite. The sign of a zero sine is not
/// kept. T: double or a vector of double.
template <class T>
inline void sincos(const T& angle, T& sine, T& cosine) noexcept {
  using namespace elementary_detail;
  const T kept = angle;  // the results may take its place
  Bits<T> beyond = {};
  mark_beyond(kept, beyond);
  reduced_sincos(kept, sine, cosine);
  if (__builtin_expect(any(beyond), 0)) replace_beyond(kept, sine, cosine);
}

/// One of the two.
template <class T>
inline T sine(const T& angle) noexcept {
  T s, c;
  sincos(angle, s, c);
  return s;
}
template <class T>
inline T cosine(const T& angle) noexcept {
  T s, c;
  sincos(angle, s, c);
  return c;
}

/// Their quotient, within 2.5 ulp.
template <class T>
inline T tangent(const T& angle) noexcept {
  T s, c;
  sincos(angle, s, c);
  return s / c;
}

/// Sines and cosines of many angles (rad), as sincos. The arrays must not overlap.
template <class T, std::size_t N>
inline void sincos(const T (&angles)[N], T (&sines)[N], T (&cosines)[N]) noexcept {
  using namespace elementary_detail;
  Bits<T> beyond = {};
  for (std::size_t i = 0; i < N; ++i) {
    reduced_sincos(angles[i], sines[i], cosines[i]);
    mark_beyond(angles[i], beyond);
  }
  if (__builtin_expect(any(beyond), 0)) {
    for (std::size_t i = 0; i < N; ++i) replace_beyond(angles[i], sines[i], cosines[i]);
  }
}

/// The same of doubles, in lanes.
template <std::size_t N>
inline void sincos(const double (&angles)[N], double (&sines)[N], double (&cosines)[N]) noexcept {
  using namespace elementary_detail;
  constexpr int width = width_for(N);
  if constexpr (width == 1) {
    sincos(angles[0], sines[0], cosines[0]);
  } else {
    using Angles = LanesOf<width>;
    Bits<Angles> beyond = {};
    const auto several = [&](std::size_t i) {
      const Angles angle = lanes_at<width>(angles + i);
      Angles sine, cosine;
      reduced_sincos(angle, sine, cosine);
      put_lanes(sine, sines + i);
      put_lanes(cosine, cosines + i);
      mark_beyond(angle, beyond);
    };
    array_detail::for_all<N>(several, [](std::size_t) {});
    if (__builtin_expect(any(beyond), 0)) {
      for (std::size_t i = 0; i < N; ++i) replace_beyond(angles[i], sines[i], cosines[i]);
    }
  }
}

/// Sines of angles (rad) whose cosines nobody needs, or the other way round: within 2.5 ulp, in half the operations.
/// NaN for an angle that is not finite. T: double or a vector of double. The arrays must not overlap.
template <class T, std::size_t N>
inline void sines(const T (&angles)[N], T (&values)[N]) noexcept {
  using namespace elementary_detail;
  each_angle([](const T& angle, T& value) { reduced_sine(angle, value); }, kLibrarySine, angles, values);
}
template <class T, std::size_t N>
inline void cosines(const T (&angles)[N], T (&values)[N]) noexcept {
  using namespace elementary_detail;
  each_angle([](const T& angle, T& value) { reduced_cosine(angle, value); }, kLibraryCosine, angles, values);
}

/// The same of angles up to pi either way, in fewer operations.
template <class T, std::size_t N>
inline void bounded_sines(const T (&angles)[N], T (&values)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) elementary_detail::bounded_sine(angles[i], values[i]);
}
template <class T, std::size_t N>
inline void bounded_cosines(const T (&angles)[N], T (&values)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) elementary_detail::bounded_cosine(angles[i], values[i]);
}

}  // namespace mbgen
