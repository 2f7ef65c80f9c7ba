#pragma once
// Natural logarithm and powers without branches: for double, for vectors of double and for arrays of either. As in
// sincos.hpp each lane is computed as a double alone is.
// Method: x = 2^k m with m between the square roots of 1/2 and 2, log m = 2 artanh((m - 1) / (m + 1)) with the quotient
// and the sum in two doubles each, a minimax polynomial by docs/method/minimax.py; for powers the product with the
// exponent in two doubles, then the exponential function.

#include "mbgen/math/exponential.hpp"

namespace mbgen {

/// Largest |y log x| up to which powers are ours. Beyond it the C library takes over.
constexpr double kLargestPower = 32;

namespace elementary_detail {

/// (2 artanh u - 2u) / u^3 in powers of u^2, |u| <= (sqrt 2 - 1) / (sqrt 2 + 1); error of the function 2^-66.6.
constexpr double kLogarithm[8] = {0x1.5555555555555p-1, 0x1.9999999999d10p-2, 0x1.24924924399bep-2,
                                  0x1.c71c724b41256p-3, 0x1.745ce1d52c8e0p-3, 0x1.3b20225a5220fp-3,
                                  0x1.0f677496b8b3bp-3, 0x1.0f0c1ff9a6234p-3};
constexpr std::int64_t kLeastNormal = 0x0010000000000000;
constexpr std::uint64_t kOne = 0x3ff0000000000000, kRootOfHalf = 0x3fe6a09e667f3bcd;
/// Bits of 2^52: with a small whole number in the low bits the double 2^52 plus that.
constexpr std::uint64_t kWholeNumber = 0x4330000000000000;
/// The first 26 digits of a double: products of two such are exact.
constexpr std::int64_t kUpperHalf = -(std::int64_t{1} << 27);

template <class T>
inline void upper_half(const T& x, T& upper) noexcept {
  upper = __builtin_bit_cast(T, __builtin_bit_cast(Bits<T>, x) & kUpperHalf);
}

/// Integers without sign as wide as T: their shift to the right is one instruction everywhere.
template <class T>
struct UnsignedOf {
  typedef std::uint64_t Type __attribute__((vector_size(sizeof(T))));
};
template <>
struct UnsignedOf<double> {
  using Type = std::uint64_t;
};

/// (m - 1) / (m + 1) = u + u_rest, m + 1 rounded to d; quotient: the same in one double.
template <class T>
inline void divide_for_logarithm(const T& m, T& quotient, T& u, T& u_rest) noexcept {
  const T f = m - 1.0, d = m + 1.0;
  const T d_rest = m - (d - 1.0);
  quotient = f / d;
  const T reciprocal = fnma(0.5, quotient, 0.5);  // 1 / (m + 1) = (1 - (m - 1) / (m + 1)) / 2
  if constexpr (kFusesProducts) {
    u = quotient;
    u_rest = fnma(u, d_rest, fnma(u, d, f)) * reciprocal;  // the second product is exact
  } else {
    T d_upper;
    upper_half(quotient, u);
    upper_half(d, d_upper);
    const T d_lower = (d - d_upper) + d_rest;
    u_rest = fnma(u, d_lower, fnma(u, d_upper, f)) * reciprocal;  // the second product is exact
  }
}

/// log x = total + low, low: rounding error of total. Requires: x a positive normal number (others give an undefined
/// number).
template <class T>
inline void find_logarithm(const T& x, T& total, T& low) noexcept {
  using Word = typename UnsignedOf<T>::Type;
  const Word bits = __builtin_bit_cast(Word, x);
  const Word exponent = (bits + (kOne - kRootOfHalf)) >> 52;  // k + 1023
  const T k = __builtin_bit_cast(T, exponent | kWholeNumber) - (0x1p52 + 1023);
  const T m = __builtin_bit_cast(T, bits - (exponent << 52) + kOne);
  T quotient, u, u_rest;
  divide_for_logarithm(m, quotient, u, u_rest);

  const auto& p = kLogarithm;
  const T z = quotient * quotient, zz = z * z;
  const T first_half = fma(zz, fma(z, p[3], p[2]), fma(z, p[1], p[0]));
  const T second_half = fma(zz, fma(z, p[7], p[6]), fma(z, p[5], p[4]));
  const T polynomial = fma(zz * zz, second_half, first_half);
  const T cube = quotient * z;
  const T of_m = fma(cube, polynomial, u_rest + u_rest);
  const T of_power = k * kLog2High, twice = u + u;  // exact
  const T sum = of_power + twice;
  const T rest = ((of_power - sum) + twice) + fma(k, kLog2Low, of_m);
  total = sum + rest;
  low = (sum - total) + rest;
}

/// y (total + low) = product + rest.
template <class T>
inline void multiply_exactly(const T& y, const T& total, const T& low, T& product, T& rest) noexcept {
  if constexpr (kFusesProducts) {
    product = y * total;
    rest = fma(y, low, fms(y, total, product));
  } else {
    T high, y_upper;
    upper_half(total, high);
    upper_half(y, y_upper);
    const T y_lower = y - y_upper, high_rest = (total - high) + low;
    const T upper = y_upper * high;  // exact, as is y_lower * high
    const T sum = fma(y_lower, high, upper);
    const T sum_rest = fma(y, high_rest, fma(y_lower, high, upper - sum));
    product = sum + sum_rest;
    rest = (sum - product) + sum_rest;
  }
}

/// Marks the lanes whose logarithm is not ours: zero, negative, subnormal or not finite.
template <class T>
inline void mark_no_logarithm(const T& x, Bits<T>& marked) noexcept {
  const Bits<T> bits = __builtin_bit_cast(Bits<T>, x);
  marked |= (bits < kLeastNormal) | (bits >= kInfinity);
}

/// x^y, by the C library where it is not ours.
template <class T>
inline void find_power(const T& x, const T& y, T& result) noexcept {
  T total, low, product, rest;
  find_logarithm(x, total, low);
  multiply_exactly(y, total, low, product, rest);
  constexpr std::int64_t largest = __builtin_bit_cast(std::int64_t, kLargestPower);
  Bits<T> marked = {};
  mark_no_logarithm(x, marked);
  marked |= (__builtin_bit_cast(Bits<T>, product) & kSignless) > largest;
  const T kept_x = x, kept_y = y;  // the result may take their place
  find_moderate_exponential<T>(product, rest, result);
  if (__builtin_expect(any(marked), 0)) {
    replace_marked(
        marked, [](double a, double b) { return std::pow(a, b); }, result, kept_x, kept_y);
  }
}

}  // namespace elementary_detail

/// log x within 1 ulp for positive normal x; for others as the C library.
template <class T>
inline T logarithm(const T& x) noexcept {
  using namespace elementary_detail;
  T result, low;
  Bits<T> marked = {};
  find_logarithm(x, result, low);
  mark_no_logarithm(x, marked);
  if (__builtin_expect(any(marked), 0))
    replace_marked(
        marked, [](double a) { return std::log(a); }, result, x);
  return result;
}

/// x^y within 2 ulp for positive normal x and |y log x| <= kLargestPower; else as the C library.
template <class T>
inline T power(const T& x, const T& y) noexcept {
  T result;
  elementary_detail::find_power(x, y, result);
  return result;
}

/// The same of many arguments. The arrays must not overlap.
template <class T, std::size_t N>
inline void powers(const T (&bases)[N], const T (&exponents)[N], T (&values)[N]) noexcept {
  elementary_detail::each_entry(
      [](const auto& x, const auto& y, auto& value) { elementary_detail::find_power(x, y, value); }, values, bases,
      exponents);
}

}  // namespace mbgen
