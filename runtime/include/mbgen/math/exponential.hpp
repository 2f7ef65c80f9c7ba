#pragma once
// Exponential function and hyperbolic tangent without branches: for double, for vectors of double and for arrays of
// either. As in sincos.hpp each lane is computed as a double alone is. Method: reduction by a multiple of log 2 whose
// first part has 32 bits (Cody, Waite), minimax polynomials of the even and of the odd powers by
// docs/method/minimax.py.

#include "mbgen/math/sincos.hpp"

namespace mbgen {

namespace elementary_detail {

constexpr double kLog2E = 0x1.71547652b82fep+0;
constexpr double kLog2High = 0x1.62e42fee00000p-1, kLog2Low = 0x1.a39ef35793c76p-33;
/// (cosh r - 1) / r^2 and (sinh r - r) / r^3 in powers of r^2; error of e^r - 1 over r 2^-61.7 for |r| <= log(2) / 2.
constexpr double kEvenPowers[6] = {0x1.0000000000000p-1,  0x1.5555555555557p-5,  0x1.6c16c16c15778p-10,
                                   0x1.a01a01ab16632p-16, 0x1.27e4d13d3ce5fp-22, 0x1.1f83edb7e9a53p-29};
constexpr double kOddPowers[5] = {0x1.5555555555559p-3, 0x1.111111110f62ap-7, 0x1.a01a01b02050fp-13,
                                  0x1.71ddf7afd471ap-19, 0x1.af5ff385eaa25p-26};
/// Beyond these e^x is 0 and infinity.
constexpr double kLeastExponent = -746, kLargestExponent = 710;
/// Below this (-2|x|) the hyperbolic tangent is one.
constexpr double kFlatExponent = -80;

/// e^x = 2^n e^r with |r| <= log(2) / 2, n in the low bits of `rounded`; e^r = 1 + r + more. Requires: |x| < 2^19.
template <class T>
inline void reduce_exponential(const T& x, T& rounded, T& r, T& more) noexcept {
  rounded = fma(x, kLog2E, kRounding);
  const T multiple = rounded - kRounding;
  const T high = fnma(multiple, kLog2High, x);  // exact
  r = fnma(multiple, kLog2Low, high);
  const T rest = fnma(multiple, kLog2Low, high - r);
  const T z = r * r, zz = z * z;
  const auto& e = kEvenPowers;
  const auto& o = kOddPowers;
  const T even = fma(zz, fma(zz, fma(z, e[5], e[4]), fma(z, e[3], e[2])), fma(z, e[1], e[0]));
  const T odd = fma(zz, fma(zz, o[4], fma(z, o[3], o[2])), fma(z, o[1], o[0]));
  more = fma(z, fma(r, odd, even), fma(r, rest, rest));
}

/// 2^n, n in the low bits. Requires: -1022 <= n <= 1023.
template <class T>
inline void power_of_two(const Bits<T>& low_bits, T& power) noexcept {
  power = __builtin_bit_cast(T, shifted_left(low_bits + 1023, 52));
}

/// 1 + r + more.
template <class T>
inline void sum_of_exponential(const T& r, const T& more, T& value) noexcept {
  const T one = T() + 1.0, sum = one + r;
  value = sum + (((one - sum) + r) + more);
}

/// e^(x + x_rest). Requires: |x| up to 700 (others give some number), x_rest up to its last place.
template <class T>
inline void find_moderate_exponential(const T& x, const T& x_rest, T& result) noexcept {
  T rounded, r, more, value, power;
  reduce_exponential(x, rounded, r, more);
  sum_of_exponential<T>(r, fma(x_rest, (1.0 + r) + more, more), value);
  power_of_two<T>(__builtin_bit_cast(Bits<T>, rounded), power);
  result = value * power;
}

/// e^x, 0 and infinity beyond the range of doubles.
template <class T>
inline void find_exponential(const T& x, T& result) noexcept {
  const T least = T() + kLeastExponent, largest = T() + kLargestExponent;
  const T within = smaller_of(larger_of(x, least), largest);  // NaN stays
  T rounded, r, more, value, first, second;
  reduce_exponential(within, rounded, r, more);
  sum_of_exponential(r, more, value);
  // In two steps, for results that are nearly infinite or have lost digits.
  const T half = fma(rounded - kRounding, 0.5, kRounding);
  power_of_two<T>(__builtin_bit_cast(Bits<T>, half), first);
  power_of_two<T>(__builtin_bit_cast(Bits<T>, rounded) - __builtin_bit_cast(Bits<T>, half), second);
  result = value * first * second;
}

template <class T>
inline void find_hyperbolic_tangent(const T& x, T& result) noexcept {
  using B = Bits<T>;
  const B sign = __builtin_bit_cast(B, x) & kSign;
  const T minus_twice = -2.0 * __builtin_bit_cast(T, __builtin_bit_cast(B, x) & kSignless);
  const T least = T() + kFlatExponent;
  const T within = larger_of(minus_twice, least);
  T rounded, r, more, power;
  reduce_exponential(within, rounded, r, more);
  power_of_two<T>(__builtin_bit_cast(B, rounded), power);
  // d = e^within - 1 = (power - 1) + power r + power more, in two parts; tanh |x| = -d / (2 + d)
  const T base = power - 1.0;
  const T sum = fma(power, r, base);
  const T tail = fma(power, more, fma(power, r, base - sum));
  const T d = sum + tail;
  const T d_rest = (sum - d) + tail;
  const T divisor = 2.0 + d;
  const T divisor_rest = (d - (divisor - 2.0)) + d_rest;
  const T quotient = d / divisor;
  const T reciprocal = fnma(0.5, quotient, 0.5);  // 1 / (2 + d) = (1 - d / (2 + d)) / 2
  const T positive = -fma(fnma(quotient, divisor_rest, d_rest), reciprocal, quotient);
  result = __builtin_bit_cast(T, (__builtin_bit_cast(B, positive) & kSignless) | sign);
}

}  // namespace elementary_detail

/// e^x within 1 ulp (of a subnormal: of the least number); 0 and infinity beyond the range of doubles, NaN for NaN.
template <class T>
inline T exponential(const T& x) noexcept {
  T result;
  elementary_detail::find_exponential(x, result);
  return result;
}

/// tanh x within 1.5 ulp; NaN for NaN.
template <class T>
inline T hyperbolic_tangent(const T& x) noexcept {
  T result;
  elementary_detail::find_hyperbolic_tangent(x, result);
  return result;
}

/// The same of many arguments. The arrays must not overlap.
template <class T, std::size_t N>
inline void exponentials(const T (&arguments)[N], T (&values)[N]) noexcept {
  elementary_detail::each_entry([](const auto& x, auto& value) { elementary_detail::find_exponential(x, value); },
                                values, arguments);
}
template <class T, std::size_t N>
inline void hyperbolic_tangents(const T (&arguments)[N], T (&values)[N]) noexcept {
  elementary_detail::each_entry(
      [](const auto& x, auto& value) { elementary_detail::find_hyperbolic_tangent(x, value); }, values, arguments);
}

}  // namespace mbgen
