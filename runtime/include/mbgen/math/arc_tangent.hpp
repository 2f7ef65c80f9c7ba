#pragma once
// The arc tangent of one and of two arguments without branches: for double, for vectors of double and for arrays of
// either. As in sincos.hpp each lane is computed as a double alone is. Method: the reciprocal of arguments above one;
// for quotients a / b above a half the angle pi/4 + atan((a - b) / (a + b)), whose difference is exact; one minimax
// polynomial on [0, 1/2] by docs/method/minimax.py.

#include "mbgen/math/sincos.hpp"

namespace mbgen {

namespace elementary_detail {

/// (atan x - x) / x^3 in powers of x^2 on [0, 1/2]; relative error of the function 2^-57.8.
constexpr double kArcTangent[12] = {-0x1.5555555555516p-2, 0x1.999999999113bp-3,  -0x1.249249215da9dp-3,
                                    0x1.c71c7090d1600p-4,  -0x1.745cf4c8ab164p-4, 0x1.3b113d967ddf1p-4,
                                    -0x1.10f31d534faf3p-4, 0x1.dfe95eb16b396p-5,  -0x1.a397f265f0f3ap-5,
                                    0x1.56f477ff08135p-5,  -0x1.c17b86567f83bp-6, 0x1.4b7de8f174f56p-7};

constexpr double kQuarterPi = 0x1.921fb54442d18p-1;
/// Rest of a multiple of pi/4 beyond its double, divided by the double.
constexpr double kPiRest = 0x1.678afae35cdd1p-55;

/// t with atan(a / b) = atan t, or pi/4 + atan t where is_middle has all bits of a lane. Requires: 0 <= a <= b, b > 0.
template <class T>
inline void reduce_quotient(const T& a, const T& b, T& t, Bits<T>& is_middle) noexcept {
  is_middle = mask_of_less(b, a + a);
  t = chosen(is_middle, a - b, a) / chosen(is_middle, a + b, b);
}

/// base + rest minus or plus the angle whose tangent is t, |t| <= 1/2: minus in the lanes whose sign bit is set in
/// `flip`. base: zero or larger than |t|.
template <class T>
inline void turn_from(const T& base, const T& rest, const T& t, const Bits<T>& flip, T& result) noexcept {
  const auto& p = kArcTangent;
  const T z = t * t, z2 = z * z, z4 = z2 * z2;
  const auto four = [&](int i) -> T { return fma(z2, fma(z, p[i + 3], p[i + 2]), fma(z, p[i + 1], p[i])); };
  const T polynomial = fma(z4, fma(z4, four(8), four(4)), four(0));
  const T turn = __builtin_bit_cast(T, __builtin_bit_cast(Bits<T>, t) ^ flip);
  result = base + (turn + fma(turn * z, polynomial, rest));
}

/// The angle whose tangent is x. T, here and above, by reference: see take_off_quarters.
template <class T>
inline void find_arc_tangent(const T& x, T& angle) noexcept {
  using B = Bits<T>;
  const T one = T() + 1.0;
  const B sign = __builtin_bit_cast(B, x) & kSign, magnitude = __builtin_bit_cast(B, x) & kSignless;
  const T size = __builtin_bit_cast(T, magnitude);
  const B is_large = (__builtin_bit_cast(B, one) - magnitude) >> 63;  // all bits of the lanes above one
  const B flip = is_large & kSign;
  T t, positive;
  B is_middle;
  reduce_quotient<T>(smaller_of(size, one), larger_of(one, size), t, is_middle);                     // NaN stays
  const T base = masked<T>(is_large, 2 * kQuarterPi, B{}) + masked<T>(is_middle, kQuarterPi, flip);  // exact
  turn_from<T>(base, kPiRest * base, t, flip, positive);
  angle = __builtin_bit_cast(T, __builtin_bit_cast(B, positive) | sign);
}

/// The direction of (x, y); marks the lanes where both are zero or one is not finite, or nearly so.
template <class T>
inline void find_direction(const T& y, const T& x, T& angle, Bits<T>& marked) noexcept {
  using B = Bits<T>;
  const B y_bits = __builtin_bit_cast(B, y), x_bits = __builtin_bit_cast(B, x);
  const B y_size = y_bits & kSignless, x_size = x_bits & kSignless;
  const B is_steep = (x_size - y_size) >> 63;
  const B is_behind = x_bits >> 63;
  const B larger = (y_size & is_steep) | (x_size & ~is_steep), smaller = (x_size & is_steep) | (y_size & ~is_steep);
  constexpr std::int64_t largest = __builtin_bit_cast(std::int64_t, 0x1p1022);
  marked |= (larger == 0) | (larger >= largest);
  const B flip = (is_steep ^ is_behind) & kSign;
  T t, positive;
  B is_middle;
  reduce_quotient<T>(__builtin_bit_cast(T, smaller), __builtin_bit_cast(T, larger), t, is_middle);
  const T half_turns = masked<T>(is_steep, 2 * kQuarterPi, B{}) + masked<T>(is_behind & ~is_steep, 4 * kQuarterPi, B{});
  const T quarter = masked<T>(is_middle, kQuarterPi, flip);
  const T base = half_turns + quarter;
  turn_from<T>(base, fma(kPiRest, base, (half_turns - base) + quarter), t, flip, positive);
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
