#pragma once
// The arc tangent of one and of two arguments without branches: for double, for vectors of double and for arrays of
// either. As in sincos.hpp each lane is computed as a double alone is. Method: the reciprocal of arguments above one,
// and one minimax polynomial on [0, 1] by docs/method/minimax.py.

#include "mbgen/sincos.hpp"

namespace mbgen {

namespace elementary_detail {

/// (atan x - x) / x^3 in powers of x^2 on [0, 1]; relative error of the function 2^-57.6.
constexpr double kArcTangent[20] = {
    -0x1.5555555555526p-2, 0x1.99999999955b1p-3,  -0x1.249249237f4aep-3, 0x1.c71c717fcc8a0p-4,   -0x1.745d11ae449dcp-4,
    0x1.3b13669828843p-4,  -0x1.110e51181bdd9p-4, 0x1.e1bba5cb709c0p-5,  -0x1.ae5e7036936fep-5,  0x1.82dacfc011cd8p-5,
    -0x1.59a3ec519fa3ep-5, 0x1.2c2e39980f1a1p-5,  -0x1.e9f9a6edc5ce2p-6, 0x1.683c551993452p-6,   -0x1.c78f027ef9045p-7,
    0x1.d7b81d7230aa7p-8,  -0x1.7a389c1ee4d06p-9, 0x1.b3f97ce2c59e9p-11, -0x1.3f353ebe9bc54p-13, 0x1.bbec0ab1795f7p-17};

constexpr double kHalfPiHigh = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;

/// first where the mask is set (all bits of a lane), else second.
template <class T>
inline void choose(const Bits<T>& mask, const T& first, const T& second, T& result) noexcept {
  result = __builtin_bit_cast(
      T, (__builtin_bit_cast(Bits<T>, first) & mask) | (__builtin_bit_cast(Bits<T>, second) & ~mask));
}

/// base minus or plus the angle whose tangent is t, 0 <= t <= 1: minus in the lanes whose sign bit is set in `flip`.
/// base: zero or at least t, and what it lacks.
template <class T>
inline void turn_from(const T& base, const T& base_rest, const T& t, const Bits<T>& flip, T& result) noexcept {
  const auto& p = kArcTangent;
  const T z = t * t, z2 = z * z, z4 = z2 * z2;
  const auto four = [&](int i) -> T { return fma(z2, fma(z, p[i + 3], p[i + 2]), fma(z, p[i + 1], p[i])); };
  const T polynomial = fma(z4, fma(z4, fma(z4, fma(z4, four(16), four(12)), four(8)), four(4)), four(0));
  const T turn = __builtin_bit_cast(T, __builtin_bit_cast(Bits<T>, t) ^ flip);
  const T cube = turn * z;
  const T sum = base + turn;
  const T rest = base_rest + ((base - sum) + turn);
  result = sum + fma(cube, polynomial, rest);
}

/// The angle whose tangent is x. T, here and above, by reference: see reduced_sincos.
template <class T>
inline void find_arc_tangent(const T& x, T& angle) noexcept {
  using B = Bits<T>;
  const T one = T() + 1.0, high = T() + kHalfPiHigh, low = T() + kHalfPiLow;
  const B sign = __builtin_bit_cast(B, x) & kSign, magnitude = __builtin_bit_cast(B, x) & kSignless;
  const T size = __builtin_bit_cast(T, magnitude);
  const B is_large = (__builtin_bit_cast(B, one) - magnitude) >> 63;  // all bits of the lanes above one
  T numerator, denominator, positive;
  choose(is_large, one, size, numerator);
  choose(is_large, size, one, denominator);
  const T base = __builtin_bit_cast(T, __builtin_bit_cast(B, high) & is_large);
  const T base_rest = __builtin_bit_cast(T, __builtin_bit_cast(B, low) & is_large);
  turn_from<T>(base, base_rest, numerator / denominator, is_large & kSign, positive);
  angle = __builtin_bit_cast(T, __builtin_bit_cast(B, positive) ^ sign);
}

/// The direction of (x, y); marks the lanes where both are zero or one is not finite.
template <class T>
inline void find_direction(const T& y, const T& x, T& angle, Bits<T>& marked) noexcept {
  using B = Bits<T>;
  const B y_bits = __builtin_bit_cast(B, y), x_bits = __builtin_bit_cast(B, x);
  const B y_size = y_bits & kSignless, x_size = x_bits & kSignless;
  const B is_steep = (x_size - y_size) >> 63;
  const B is_behind = x_bits >> 63;
  const B larger = (y_size & is_steep) | (x_size & ~is_steep), smaller = (x_size & is_steep) | (y_size & ~is_steep);
  marked |= (larger == 0) | (larger >= kInfinity);
  // Half a turn is exactly twice the quarter, in both parts.
  const T quarter = T() + kHalfPiHigh, quarter_rest = T() + kHalfPiLow;
  const T half = quarter + quarter, half_rest = quarter_rest + quarter_rest;
  T base, base_rest, positive;
  choose(is_steep, quarter, half, base);
  choose(is_steep, quarter_rest, half_rest, base_rest);
  const B has_base = is_steep | is_behind;
  base = __builtin_bit_cast(T, __builtin_bit_cast(B, base) & has_base);
  base_rest = __builtin_bit_cast(T, __builtin_bit_cast(B, base_rest) & has_base);
  const T t = __builtin_bit_cast(T, smaller) / __builtin_bit_cast(T, larger);
  turn_from<T>(base, base_rest, t, (is_steep ^ is_behind) & kSign, positive);
  angle = __builtin_bit_cast(T, __builtin_bit_cast(B, positive) | (y_bits & kSign));
}

}  // namespace elementary_detail

/// The angle (rad) whose tangent is x, within 1.5 ulp: pi/2 for infinity, NaN for NaN.
template <class T>
inline T arc_tangent(const T& x) noexcept {
  T angle;
  elementary_detail::find_arc_tangent(x, angle);
  return angle;
}

/// The direction (rad) of (x, y) within 2 ulp; where both are zero or one is not finite, as the C library.
template <class T>
inline T arc_tangent(const T& y, const T& x) noexcept {
  using namespace elementary_detail;
  T angle;
  Bits<T> marked = {};
  find_direction(y, x, angle, marked);
  if (__builtin_expect(any(marked), 0)) {
    replace_marked(
        marked, [](double a, double b) { return std::atan2(a, b); }, angle, y, x);
  }
  return angle;
}

/// The angle (rad) whose sine or cosine is x, within 3 ulp; NaN beyond one. root: sqrt((1 - x) (1 + x)).
template <class T>
inline T arc_sine(const T& x, const T& root) noexcept {
  return arc_tangent(x, root);
}
template <class T>
inline T arc_cosine(const T& x, const T& root) noexcept {
  return arc_tangent(root, x);
}
inline double arc_sine(double x) noexcept { return arc_sine(x, std::sqrt((1 - x) * (1 + x))); }
inline double arc_cosine(double x) noexcept { return arc_cosine(x, std::sqrt((1 - x) * (1 + x))); }

/// The angles (rad) whose tangents are given, as arc_tangent. The arrays must not overlap.
template <class T, std::size_t N>
inline void arc_tangents(const T (&tangents)[N], T (&angles)[N]) noexcept {
  elementary_detail::each_entry([](const auto& x, auto& angle) { elementary_detail::find_arc_tangent(x, angle); },
                                angles, tangents);
}

}  // namespace mbgen
