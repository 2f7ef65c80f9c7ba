#pragma once
// The elementary functions of emitted code in single precision, without branches on the argument but for the C library
// beyond their ranges. Methods as in sincos.hpp, arc_tangent.hpp, exponential.hpp and logarithm.hpp, with polynomials
// for floats by docs/method/minimax.py; nothing is computed in double, which small processors do in software. Arrays
// are computed one by one: the same bits as alone.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mbgen/fma.hpp"

namespace mbgen {

/// Largest |angle| (rad) of the reduction, 5200 revolutions. Beyond it the C library takes over.
constexpr float kLargestSingleAngle = 0x1p15f;
/// Largest |y log x| up to which powers are ours.
constexpr float kLargestSinglePower = 16.0f;

namespace single_detail {

constexpr float kTwoOverPi = 0x1.45f306p-1f;
/// 1.5 * 2^23: adding it rounds to a whole number and leaves that in the low bits.
constexpr float kRounding = 0x1.8p23f;
/// pi/2 in parts of 9 bits, the last of 24: products with a multiple below 2^15 are exact.
constexpr float kHalfPi[4] = {0x1.92p+0f, 0x1.fbp-12f, 0x1.51p-22f, 0x1.0b4612p-34f};
/// (sin x - x) / x^3 and (cos x - 1 + x^2/2) / x^4 in powers of x^2; error of the functions 2^-32.5 and 2^-33.0.
constexpr float kSine[4] = {-0x1.555556p-3f, 0x1.111174p-7f, -0x1.a05954p-13f, 0x1.7c2c4ep-19f};
constexpr float kCosine[3] = {0x1.55554ap-5f, -0x1.6c0c28p-10f, 0x1.99e80cp-16f};
/// (atan x - x) / x^3 in powers of x^2 on [0, 1]; error of the function 2^-28.5.
constexpr float kArcTangent[9] = {-0x1.55553ep-2f, 0x1.9991e4p-3f,  -0x1.242086p-3f, 0x1.c08c48p-4f,  -0x1.5808e2p-4f,
                                  0x1.da2858p-5f,  -0x1.fd77f8p-6f, 0x1.641a78p-7f,  -0x1.d33f4ap-10f};
constexpr float kHalfPiHigh = 0x1.921fb6p+0f, kHalfPiLow = -0x1.777a5cp-25f;
constexpr float kLog2E = 0x1.715476p+0f;
constexpr float kLog2High = 0x1.62ep-1f, kLog2Low = 0x1.0bfbe8p-15f;
/// (cosh r - 1) / r^2 and (sinh r - r) / r^3 in powers of r^2; error of e^r - 1 over r 2^-31.2 for |r| <= log(2) / 2.
constexpr float kEvenPowers[3] = {0x1p-1f, 0x1.5554f2p-5f, 0x1.6d413cp-10f};
constexpr float kOddPowers[3] = {0x1.555556p-3f, 0x1.110fbep-7f, 0x1.a2e2f8p-13f};
/// (2 artanh u - 2u) / u^3 in powers of u^2, |u| <= (sqrt 2 - 1) / (sqrt 2 + 1); error of the function 2^-36.7.
constexpr float kLogarithm[5] = {0x1.555556p-1f, 0x1.9997ep-2f, 0x1.2543fap-2f, 0x1.8e978ep-3f, 0x1.25e932p-1f};
/// Beyond these e^x is 0 and infinity; below the third (-2|x|) the hyperbolic tangent is one.
constexpr float kLeastExponent = -105, kLargestExponent = 89, kFlatExponent = -40;
constexpr std::uint32_t kSign = 0x80000000, kInfinity = 0x7f800000, kLeastNormal = 0x00800000;
constexpr std::uint32_t kOne = 0x3f800000, kRootOfHalf = 0x3f3504f3;
/// The first 12 digits of a float: products of two such are exact.
constexpr std::uint32_t kUpperHalf = 0xfffff000;

inline std::uint32_t bits_of(float x) noexcept { return __builtin_bit_cast(std::uint32_t, x); }
inline float number_of(std::uint32_t bits) noexcept { return __builtin_bit_cast(float, bits); }
inline float size_of(float x) noexcept { return number_of(bits_of(x) & ~kSign); }
inline float with_sign_of(float sign, float size) noexcept {
  return number_of(bits_of(size) ^ (bits_of(sign) & kSign));
}
inline float upper_half(float x) noexcept { return number_of(bits_of(x) & kUpperHalf); }

/// Sine and cosine by reduction, for |angle| up to kLargestSingleAngle.
inline void reduced_sincos(float angle, float& sine, float& cosine) noexcept {
  const float rounded = mbgen::fma(angle, kTwoOverPi, kRounding);
  const float multiple = rounded - kRounding;
  const float first = mbgen::fnma(multiple, kHalfPi[0], angle);  // exact
  const float second = mbgen::fnma(multiple, kHalfPi[1], first);
  const float third = mbgen::fnma(multiple, kHalfPi[2], second);
  const float lost =
      mbgen::fnma(multiple, kHalfPi[1], first - second) + mbgen::fnma(multiple, kHalfPi[2], second - third);
  const float low = mbgen::fnma(multiple, kHalfPi[3], lost);
  // The part of large angles is many units of x: only below one unit is the first power of `rest` enough.
  const float x = third + low;
  const float rest = (third - x) + low;

  const float z = x * x, zz = z * z, half = 0.5f * z, cube = z * x;
  const auto& a = kSine;
  const auto& b = kCosine;
  const float s = mbgen::fma(zz, mbgen::fma(z, a[3], a[2]), mbgen::fma(z, a[1], a[0]));
  const float c = mbgen::fma(zz, b[2], mbgen::fma(z, b[1], b[0]));
  const float near_one = 1.0f - half;
  const float small_sine = x + mbgen::fma(cube, s, mbgen::fnma(half, rest, rest));
  const float small_cosine = near_one + mbgen::fma(zz, c, mbgen::fnma(x, rest, (1.0f - near_one) - half));

  const std::uint32_t quarter = bits_of(rounded);
  const bool is_odd = (quarter & 1) != 0;
  sine = number_of(bits_of(is_odd ? small_cosine : small_sine) ^ ((quarter & 2) << 30));
  cosine = number_of(bits_of(is_odd ? small_sine : small_cosine) ^ (((quarter + 1) & 2) << 30));
}

/// base + turn t, where t is the tangent of an angle of at most pi/4, turn its sign.
inline float turned_from(float base, float base_rest, float t) noexcept {
  const auto& p = kArcTangent;
  const float z = t * t, zz = z * z;
  const auto two = [&](int i) { return mbgen::fma(z, p[i + 1], p[i]); };
  const float upper = mbgen::fma(zz, mbgen::fma(zz, p[8], two(6)), two(4));
  const float polynomial = mbgen::fma(zz, mbgen::fma(zz, upper, two(2)), two(0));
  const float sum = base + t;
  const float rest = base_rest + ((base - sum) + t);
  return sum + mbgen::fma(t * z, polynomial, rest);
}

/// e^(x + x_rest) = 2^n e^r with |r| <= log(2) / 2, n in the low bits of `rounded`; e^r = 1 + r + more.
inline void reduce_exponential(float x, float x_rest, float& rounded, float& r, float& more) noexcept {
  rounded = mbgen::fma(x, kLog2E, kRounding);
  const float multiple = rounded - kRounding;
  const float high = mbgen::fnma(multiple, kLog2High, x);  // exact
  r = mbgen::fnma(multiple, kLog2Low, high);
  const float rest = mbgen::fnma(multiple, kLog2Low, high - r) + x_rest;
  const float z = r * r;
  const auto& e = kEvenPowers;
  const auto& o = kOddPowers;
  const float even = mbgen::fma(z, mbgen::fma(z, e[2], e[1]), e[0]);
  const float odd = mbgen::fma(z, mbgen::fma(z, o[2], o[1]), o[0]);
  more = mbgen::fma(z, mbgen::fma(r, odd, even), mbgen::fma(r, rest, rest));
}

/// 2^n. Requires: -126 <= n <= 127.
inline float power_of_two(std::uint32_t n) noexcept { return number_of((n + 127) << 23); }

/// e^(x + x_rest), 0 and infinity beyond the range of floats.
inline float exponential_of(float x, float x_rest) noexcept {
  const float above = x < kLeastExponent ? kLeastExponent : x;  // NaN stays
  const float within = above > kLargestExponent ? kLargestExponent : above;
  float rounded, r, more;
  reduce_exponential(within, x_rest, rounded, r, more);
  const float sum = 1.0f + r;
  const float value = sum + (((1.0f - sum) + r) + more);
  // In two steps, for results that are nearly infinite or have lost digits.
  const float half = mbgen::fma(rounded - kRounding, 0.5f, kRounding);
  const float first = power_of_two(bits_of(half) - bits_of(kRounding));
  return value * first * power_of_two(bits_of(rounded) - bits_of(half));
}

/// log x = high + low, high of 12 digits. Requires: x a positive normal number.
inline void find_logarithm(float x, float& high, float& low) noexcept {
  const std::uint32_t exponent = (bits_of(x) + (kOne - kRootOfHalf)) >> 23;  // k + 127
  const float k = static_cast<float>(static_cast<std::int32_t>(exponent) - 127);
  const float m = number_of(bits_of(x) - (exponent << 23) + kOne);
  const float f = m - 1.0f, d = m + 1.0f;
  const float d_rest = m - (d - 1.0f);
  const float quotient = f / d;
  const float u = upper_half(quotient), d_upper = upper_half(d);
  const float d_lower = (d - d_upper) + d_rest;
  const float u_rest = mbgen::fnma(u, d_lower, mbgen::fnma(u, d_upper, f)) / d;  // the first product is exact
  const auto& p = kLogarithm;
  const float z = quotient * quotient, zz = z * z;
  const float polynomial = mbgen::fma(zz, mbgen::fma(zz, p[4], mbgen::fma(z, p[3], p[2])), mbgen::fma(z, p[1], p[0]));
  const float of_m = mbgen::fma(quotient * z, polynomial, u_rest + u_rest);
  const float of_power = k * kLog2High, twice = u + u;  // exact
  const float sum = of_power + twice;
  const float rest = ((of_power - sum) + twice) + mbgen::fma(k, kLog2Low, of_m);
  const float total = sum + rest;
  high = upper_half(total);
  low = (sum - high) + rest;
}

/// Zero, negative, subnormal or not finite.
inline bool has_no_logarithm(float x) noexcept { return !(x >= number_of(kLeastNormal) && x < number_of(kInfinity)); }

}  // namespace single_detail

/// Sine and cosine of an angle (rad) within 1 ulp, of numbers below 2^-9: of 2^-33; NaN for an angle that is not
/// finite.
inline void sincos(const float& angle, float& sine, float& cosine) noexcept {
  const float kept = angle;  // the results may take its place
  single_detail::reduced_sincos(kept, sine, cosine);
  if (__builtin_expect(!(single_detail::size_of(kept) <= kLargestSingleAngle), 0)) {
    sine = std::sin(kept);
    cosine = std::cos(kept);
  }
}
inline float sine(const float& angle) noexcept {
  float s, c;
  sincos(angle, s, c);
  return s;
}
inline float cosine(const float& angle) noexcept {
  float s, c;
  sincos(angle, s, c);
  return c;
}
inline float tangent(const float& angle) noexcept {
  float s, c;
  sincos(angle, s, c);
  return s / c;
}

/// The angle (rad) whose tangent is x, within 2 ulp: pi/2 for infinity, NaN for NaN.
inline float arc_tangent(const float& x) noexcept {
  using namespace single_detail;
  const float size = size_of(x);
  const bool is_large = size > 1.0f;
  const float quotient = (is_large ? -1.0f : size) / (is_large ? size : 1.0f);
  return with_sign_of(x, turned_from(is_large ? kHalfPiHigh : 0.0f, is_large ? kHalfPiLow : 0.0f, quotient));
}

/// The direction (rad) of (x, y) within 2 ulp; where both are zero or one is not finite, as the C library.
inline float arc_tangent(const float& y, const float& x) noexcept {
  using namespace single_detail;
  const float x_size = size_of(x), y_size = size_of(y);
  const bool is_steep = x_size < y_size, is_behind = (bits_of(x) & kSign) != 0;
  const float larger = is_steep ? y_size : x_size, smaller = is_steep ? x_size : y_size;
  if (__builtin_expect(!(larger > 0 && larger < number_of(kInfinity)) || !(smaller >= 0), 0)) return std::atan2(y, x);
  const float quarters = is_steep ? 1.0f : is_behind ? 2.0f : 0.0f;
  const float quotient = smaller / larger;
  const float turn = is_steep != is_behind ? -quotient : quotient;
  return with_sign_of(y, turned_from(quarters * kHalfPiHigh, quarters * kHalfPiLow, turn));
}

/// The angle (rad) whose sine or cosine is x, within 4 ulp; NaN beyond one.
inline float arc_sine(float x) noexcept { return arc_tangent(x, std::sqrt((1.0f - x) * (1.0f + x))); }
inline float arc_cosine(float x) noexcept { return arc_tangent(std::sqrt((1.0f - x) * (1.0f + x)), x); }

/// e^x within 1 ulp (of a subnormal: of the least number); 0 and infinity beyond the range of floats, NaN for NaN.
inline float exponential(const float& x) noexcept { return single_detail::exponential_of(x, 0.0f); }

/// tanh x within 2 ulp; NaN for NaN.
inline float hyperbolic_tangent(const float& x) noexcept {
  using namespace single_detail;
  const float minus_twice = -2.0f * size_of(x);
  const float within = minus_twice < kFlatExponent ? kFlatExponent : minus_twice;
  float rounded, r, more;
  reduce_exponential(within, 0.0f, rounded, r, more);
  const float power = power_of_two(bits_of(rounded) - bits_of(kRounding));
  // d = e^within - 1 = (power - 1) + power r + power more, in two parts; tanh |x| = -d / (2 + d)
  const float base = power - 1.0f;
  const float sum = mbgen::fma(power, r, base);
  const float tail = mbgen::fma(power, more, mbgen::fma(power, r, base - sum));
  const float d = sum + tail;
  const float d_rest = (sum - d) + tail;
  const float divisor = 2.0f + d;
  const float divisor_rest = (d - (divisor - 2.0f)) + d_rest;
  const float quotient = d / divisor;
  const float positive = -(quotient + mbgen::fnma(quotient, divisor_rest, d_rest) / divisor);
  return number_of((bits_of(positive) & ~kSign) | (bits_of(x) & kSign));
}

/// log x within 1 ulp for positive normal x; for others as the C library.
inline float logarithm(const float& x) noexcept {
  if (__builtin_expect(single_detail::has_no_logarithm(x), 0)) return std::log(x);
  float high, low;
  single_detail::find_logarithm(x, high, low);
  return high + low;
}

/// x^y within 2 ulp for positive normal x and |y log x| <= kLargestSinglePower; else as the C library.
inline float power(const float& x, const float& y) noexcept {
  using namespace single_detail;
  float high, low;
  find_logarithm(x, high, low);
  const float y_upper = upper_half(y);
  const float y_lower = y - y_upper;
  const float product = y_upper * high;                  // exact, as is y_lower * high
  const float sum = mbgen::fma(y_lower, high, product);  // y high, rounded
  const float rest = mbgen::fma(y, low, mbgen::fma(y_lower, high, product - sum));
  const float total = sum + rest;
  if (__builtin_expect(has_no_logarithm(x) || !(size_of(total) <= kLargestSinglePower), 0)) return std::pow(x, y);
  return exponential_of(total, (sum - total) + rest);
}

/// The same of many arguments. The arrays must not overlap.
template <std::size_t N>
inline void sincos(const float (&angles)[N], float (&sines)[N], float (&cosines)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) sincos(angles[i], sines[i], cosines[i]);
}
template <std::size_t N>
inline void arc_tangents(const float (&tangents)[N], float (&angles)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) angles[i] = arc_tangent(tangents[i]);
}
template <std::size_t N>
inline void exponentials(const float (&arguments)[N], float (&values)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) values[i] = exponential(arguments[i]);
}
template <std::size_t N>
inline void hyperbolic_tangents(const float (&arguments)[N], float (&values)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) values[i] = hyperbolic_tangent(arguments[i]);
}
template <std::size_t N>
inline void powers(const float (&bases)[N], const float (&exponents)[N], float (&values)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) values[i] = power(bases[i], exponents[i]);
}

}  // namespace mbgen
