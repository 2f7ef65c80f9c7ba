// The runtime's own elementary functions against the C library's at long double, in units of the last place.

#include "mbgen/elementary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace mbgen {
namespace {

static_assert(std::numeric_limits<long double>::digits > 60, "the reference needs digits to spare");

/// |value - exact| in units of the last place of a double near `exact`.
double error_in_ulp(double value, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  const long double ulp = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / ulp);
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

/// Angles where reduction is hard and where it is not.
std::vector<double> angles() {
  std::mt19937_64 random(2012);
  std::vector<double> result = {0.0, 1e-320, 1e-300, 1e-20, 1e-8, 0x1p-27, kLargestAngle, 0.5, 1.0};
  for (const double range : {1e-3, 1.0, 3.2, 100.0, kLargestAngle}) {
    std::uniform_real_distribution<double> angle(-range, range);
    for (int i = 0; i < 100000; ++i) result.push_back(angle(random));
  }
  // The doubles beside every multiple of pi/4 of the range, where one of the two is near zero or near the other.
  constexpr long double kQuarter = 0.785398163397448309615660845819875721L;
  for (int k = 1; k * kQuarter < kLargestAngle; k += k < 1000 ? 1 : 7) {
    const double near = static_cast<double>(k * kQuarter);
    for (const double angle : {near, std::nextafter(near, 0.0), std::nextafter(near, 2 * near)}) {
      if (angle <= kLargestAngle) result.push_back(angle);
    }
  }
  return result;
}

TEST(SineAndCosine, areWithinOneUnitInTheLastPlace) {
  double largest_sine = 0, largest_cosine = 0;
  for (const double angle : angles()) {
    double s = 0, c = 0;
    sincos(angle, s, c);
    largest_sine = std::max(largest_sine, error_in_ulp(s, std::sin(static_cast<long double>(angle))));
    largest_cosine = std::max(largest_cosine, error_in_ulp(c, std::cos(static_cast<long double>(angle))));
  }
  std::printf("largest errors: sine %.3f ulp, cosine %.3f ulp\n", largest_sine, largest_cosine);
  EXPECT_LE(largest_sine, 1.0);
  EXPECT_LE(largest_cosine, 1.0);
}

/// A function of many arguments, of one.
template <class Function, class T>
T of_one(Function function, const T& argument) {
  const T arguments[1] = {argument};
  T values[1];
  function(arguments, values);
  return values[0];
}

template <class T>
T sine_alone(const T& angle) {
  return of_one([](const auto& angles, auto& values) { sines(angles, values); }, angle);
}
template <class T>
T cosine_alone(const T& angle) {
  return of_one([](const auto& angles, auto& values) { cosines(angles, values); }, angle);
}
template <class T>
T bounded_sine_alone(const T& angle) {
  return of_one([](const auto& angles, auto& values) { bounded_sines(angles, values); }, angle);
}
template <class T>
T bounded_cosine_alone(const T& angle) {
  return of_one([](const auto& angles, auto& values) { bounded_cosines(angles, values); }, angle);
}

TEST(SineOrCosineAlone, isWithinTwoAndAHalfUnitsInTheLastPlace) {
  double largest_sine = 0, largest_cosine = 0;
  for (const double angle : angles()) {
    const long double exact = angle;
    largest_sine = std::max(largest_sine, error_in_ulp(sine_alone(angle), std::sin(exact)));
    largest_cosine = std::max(largest_cosine, error_in_ulp(cosine_alone(angle), std::cos(exact)));
  }
  std::printf("largest errors: sine %.3f ulp, cosine %.3f ulp\n", largest_sine, largest_cosine);
  EXPECT_LE(largest_sine, 2.5);
  EXPECT_LE(largest_cosine, 2.5);
}

TEST(SineOrCosineAlone, ofABoundedAngleIsWithinTwoAndAHalfUnitsInTheLastPlace) {
  constexpr double kPi = 0x1.921fb54442d18p+1;
  typedef double Two __attribute__((vector_size(16)));
  double largest_sine = 0, largest_cosine = 0;
  std::vector<double> all = {kPi, -kPi, std::nextafter(kPi, 0.0), kPi / 2, std::nextafter(kPi / 2, 4.0)};
  for (const double angle : angles())
    if (std::abs(angle) <= kPi) all.push_back(angle);
  for (const double angle : all) {
    const double s = bounded_sine_alone(angle), c = bounded_cosine_alone(angle);
    const Two two = {0.5, angle};
    const double second_sine = bounded_sine_alone(two)[1], second_cosine = bounded_cosine_alone(two)[1];
    ASSERT_TRUE(same_bits(s, second_sine) && same_bits(c, second_cosine)) << angle;
    largest_sine = std::max(largest_sine, error_in_ulp(s, std::sin(static_cast<long double>(angle))));
    largest_cosine = std::max(largest_cosine, error_in_ulp(c, std::cos(static_cast<long double>(angle))));
  }
  std::printf("largest errors: sine %.3f ulp, cosine %.3f ulp\n", largest_sine, largest_cosine);
  EXPECT_LE(largest_sine, 2.5);
  EXPECT_LE(largest_cosine, 2.5);
}

TEST(SineOrCosineAlone, isTheLibrarysBeyondTheReduction) {
  for (const double angle : {std::nextafter(kLargestAngle, 1e9), -3e7, 1e22, 1e300}) {
    EXPECT_EQ(sine_alone(angle), std::sin(angle));
    EXPECT_EQ(cosine_alone(angle), std::cos(angle));
  }
  for (const double angle : {INFINITY, -INFINITY, NAN})
    EXPECT_TRUE(std::isnan(sine_alone(angle)) && std::isnan(cosine_alone(angle))) << angle;
}

TEST(SineAndCosine, areTheLibrarysBeyondTheReduction) {
  for (const double angle : {std::nextafter(kLargestAngle, 1e9), -3e7, 1e22, 1e300}) {
    double s = 0, c = 0;
    sincos(angle, s, c);
    EXPECT_EQ(s, std::sin(angle));
    EXPECT_EQ(c, std::cos(angle));
  }
  for (const double angle : {INFINITY, -INFINITY, NAN}) {
    double s = 0, c = 0;
    sincos(angle, s, c);
    EXPECT_TRUE(std::isnan(s) && std::isnan(c)) << angle;
  }
}

/// Bits of an array of N angles and of vectors of four against those of each angle alone.
template <std::size_t N>
void expect_same_bits_of(const std::vector<double>& all) {
  typedef double Four __attribute__((vector_size(32)));
  for (std::size_t first = 0; first + N <= all.size(); first += N) {
    double angle[N], sines[N], cosines[N];
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), N, angle);
    sincos(angle, sines, cosines);
    for (std::size_t i = 0; i < N; ++i) {
      double s = 0, c = 0;
      sincos(angle[i], s, c);
      ASSERT_TRUE(same_bits(s, sines[i]) && same_bits(c, cosines[i])) << angle[i] << " of " << N;
      ASSERT_TRUE(same_bits(s, sine(angle[i])) && same_bits(c, cosine(angle[i])));
      const Four four = {1, 2, angle[i], angle[0]};
      Four s4, c4;
      sincos(four, s4, c4);
      const double s2 = s4[2], c2 = c4[2];
      ASSERT_TRUE(same_bits(s, s2) && same_bits(c, c2)) << angle[i];
    }
  }
}

TEST(SineOrCosineAlone, hasTheSameBitsInVectorsAndInArrays) {
  typedef double Eight __attribute__((vector_size(64)));
  std::vector<double> some = {1e7, 0.3, NAN, -2.0, INFINITY, 1e22, 0.7, -0.7, 2.5, 1e6, -1e7, 0.1};
  const std::vector<double> all = angles();
  for (std::size_t i = 0; i < all.size(); i += 101) some.push_back(all[i]);
  for (std::size_t first = 0; first + 9 <= some.size(); first += 7) {
    const double numbers[3] = {some[first], some[first + 1], some[first + 2]};
    Eight eight{};
    for (int lane = 0; lane < 8; ++lane) eight[lane] = some[first + static_cast<std::size_t>(lane) + 1];
    double s[3], c[3];
    sines(numbers, s);
    cosines(numbers, c);
    const Eight s8 = sine_alone(eight), c8 = cosine_alone(eight);
    for (int k = 0; k < 3; ++k)
      ASSERT_TRUE(same_bits(s[k], sine_alone(numbers[k])) && same_bits(c[k], cosine_alone(numbers[k]))) << numbers[k];
    for (int lane = 0; lane < 8; ++lane) {
      const double angle = eight[lane], s1 = s8[lane], c1 = c8[lane];
      ASSERT_TRUE(same_bits(s1, sine_alone(angle)) && same_bits(c1, cosine_alone(angle))) << angle;
    }
  }
}

TEST(SineAndCosine, haveTheSameBitsAloneInLanesAndInArrays) {
  std::vector<double> some = {1e7, 0.3, NAN, -2.0, INFINITY, 1e22, 0.7, -0.7, 2.5, 1e6, -1e7};
  const std::vector<double> all = angles();
  for (std::size_t i = 0; i < all.size(); i += 101) some.push_back(all[i]);
  expect_same_bits_of<1>(some);
  expect_same_bits_of<3>(some);
  expect_same_bits_of<8>(some);
  expect_same_bits_of<13>(some);
  expect_same_bits_of<64>(some);
}

/// Tangents of all sizes, and around one, where the two branches of the method meet.
std::vector<double> tangents() {
  std::mt19937_64 random(2012);
  std::vector<double> result = {1e-320, 1e-300, 1e-9, 0x1p-27, 0.5, 1.0, 2.0, 1e9, 1e300};
  for (const double range : {1e-3, 1.0, 2.0, 10.0, 1e3}) {
    std::uniform_real_distribution<double> tangent(-range, range);
    for (int i = 0; i < 100000; ++i) result.push_back(tangent(random));
  }
  for (int i = 1; i < 1000; ++i) {
    result.push_back(1.0 + i * 0x1p-52);
    result.push_back(1.0 - i * 0x1p-53);
  }
  return result;
}

TEST(ArcTangent, isWithinOneAndAHalfUnitsInTheLastPlace) {
  double largest = 0;
  for (const double tangent : tangents()) {
    largest = std::max(largest, error_in_ulp(arc_tangent(tangent), std::atan(static_cast<long double>(tangent))));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 1.5);
}

TEST(ArcTangent, keepsSignsAndMeetsInfinityAndNaN) {
  EXPECT_EQ(arc_tangent<double>(INFINITY), std::acos(0.0));
  EXPECT_EQ(arc_tangent<double>(-INFINITY), -std::acos(0.0));
  EXPECT_TRUE(std::isnan(arc_tangent<double>(NAN)));
  EXPECT_TRUE(same_bits(arc_tangent(0.0), 0.0));
  EXPECT_TRUE(same_bits(arc_tangent(-0.0), -0.0));
}

TEST(ArcTangent, hasTheSameBitsAloneAndInArrays) {
  const std::vector<double> all = tangents();
  double some[13], angles[13];
  for (std::size_t i = 0; i + 13 * 29 < all.size(); i += 13 * 29) {
    for (std::size_t k = 0; k < 13; ++k) some[k] = all[i + 29 * k];
    arc_tangents(some, angles);
    for (std::size_t k = 0; k < 13; ++k) ASSERT_TRUE(same_bits(angles[k], arc_tangent(some[k]))) << some[k];
  }
}

/// Numbers of all sizes, evenly among those of a size and among sizes.
std::vector<double> numbers(double least, double largest, int count) {
  std::mt19937_64 random(2012);
  std::uniform_real_distribution<double> even(least, largest), size(-40, std::log(std::max(-least, largest)));
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(even(random));
    const double scaled = std::exp(size(random));
    result.push_back(least < 0 && i % 2 == 0 ? std::max(-scaled, least) : std::min(scaled, largest));
  }
  return result;
}

TEST(Exponential, isWithinOneUnitInTheLastPlaceOnTheWholeRange) {
  double largest = 0;
  for (const double x : numbers(-745, 709.7, 300000)) {
    largest = std::max(largest, error_in_ulp(exponential(x), std::exp(static_cast<long double>(x))));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 1.0);
}

TEST(Exponential, endsInZeroAndInfinity) {
  for (const double x : {-745.2, -800.0, -1e300, -HUGE_VAL}) EXPECT_EQ(exponential(x), 0.0) << x;
  for (const double x : {709.79, 800.0, 1e300, HUGE_VAL}) EXPECT_EQ(exponential(x), HUGE_VAL) << x;
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-0.0), 1.0);
  EXPECT_TRUE(std::isnan(exponential<double>(NAN)));
}

TEST(HyperbolicTangent, isWithinOneAndAHalfUnitsInTheLastPlace) {
  double largest = 0;
  for (const double x : numbers(-25, 25, 300000)) {
    largest = std::max(largest, error_in_ulp(hyperbolic_tangent(x), std::tanh(static_cast<long double>(x))));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 1.5);
}

TEST(HyperbolicTangent, keepsSignsAndMeetsInfinityAndNaN) {
  EXPECT_EQ(hyperbolic_tangent(HUGE_VAL), 1.0);
  EXPECT_EQ(hyperbolic_tangent(-HUGE_VAL), -1.0);
  EXPECT_EQ(hyperbolic_tangent(1e-310), 1e-310);
  EXPECT_TRUE(same_bits(hyperbolic_tangent(0.0), 0.0));
  EXPECT_TRUE(same_bits(hyperbolic_tangent(-0.0), -0.0));
  EXPECT_TRUE(std::isnan(hyperbolic_tangent<double>(NAN)));
}

TEST(Logarithm, isWithinOneUnitInTheLastPlace) {
  double largest = 0;
  for (const double x : numbers(-700, 700, 200000)) {
    for (const double argument : {std::exp(x), 1 + x / 700, 1 + x * 1e-12}) {
      if (!(argument >= 0x1p-1022)) continue;
      largest = std::max(largest, error_in_ulp(logarithm(argument), std::log(static_cast<long double>(argument))));
    }
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 1.0);
}

TEST(Logarithm, isTheLibrarysWhereItIsNotOurs) {
  for (const double x : {0.0, -0.0, 1e-310, HUGE_VAL, -1.0, static_cast<double>(NAN)}) {
    EXPECT_TRUE(same_bits(logarithm(x), std::log(x))) << x;
  }
}

TEST(Power, isWithinTwoUnitsInTheLastPlaceOnItsRange) {
  double largest = 0;
  const std::vector<double> exponents = numbers(-40, 40, 200000), logarithms = numbers(-20, 20, 200000);
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const double y = exponents[i], x = std::exp(logarithms[exponents.size() - 1 - i]);
    if (std::abs(y * std::log(x)) > kLargestPower) continue;
    largest = std::max(largest, error_in_ulp(power(x, y), std::pow(static_cast<long double>(x), y)));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 2.0);
}

TEST(Power, isTheLibrarysBeyondItsRange) {
  const double pairs[][2] = {{0.0, 2.0},    {-2.0, 3.0}, {-2.0, 0.5}, {1.0, HUGE_VAL}, {2.0, 100.0},    {1e-310, 1.5},
                             {HUGE_VAL, 2}, {NAN, 0.0},  {3.0, NAN},  {0.0, 0.0},      {2.0, -HUGE_VAL}};
  for (const auto& [x, y] : pairs) EXPECT_TRUE(same_bits(power(x, y), std::pow(x, y))) << x << "^" << y;
}

TEST(ArcTangentOfTwo, isWithinTwoUnitsInTheLastPlace) {
  double largest = 0;
  const std::vector<double> all = numbers(-10, 10, 200000);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double y = all[i - 1], x = all[i];
    largest = std::max(largest, error_in_ulp(arc_tangent(y, x), std::atan2(static_cast<long double>(y), x)));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 2.0);
}

TEST(ArcTangentOfTwo, isTheLibrarysAtZeroAndInfinity) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
      EXPECT_TRUE(same_bits(arc_tangent(y, x), std::atan2(y, x))) << y << " " << x;
    }
  }
}

TEST(InverseSineAndCosine, areWithinThreeUnitsInTheLastPlace) {
  double largest = 0;
  for (const double x : numbers(-1, 1, 200000)) {
    largest = std::max(largest, error_in_ulp(arc_sine(x), std::asin(static_cast<long double>(x))));
    largest = std::max(largest, error_in_ulp(arc_cosine(x), std::acos(static_cast<long double>(x))));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 3.0);
  EXPECT_TRUE(std::isnan(arc_sine(1.5)) && std::isnan(arc_cosine(-1.5)));
}

TEST(Tangent, isWithinTwoAndAHalfUnitsInTheLastPlace) {
  double largest = 0;
  for (const double angle : angles()) {
    largest = std::max(largest, error_in_ulp(tangent(angle), std::tan(static_cast<long double>(angle))));
  }
  std::printf("largest error: %.3f ulp\n", largest);
  EXPECT_LE(largest, 2.5);
}

/// Bits of arrays of N and of vectors of two against those of each argument alone.
template <std::size_t N>
void expect_same_bits_in_arrays(const std::vector<double>& all) {
  typedef double Two __attribute__((vector_size(16)));
  for (std::size_t first = 0; first + N <= all.size(); first += N) {
    double x[N], y[N], exponential_of[N], tangent_of[N], power_of[N];
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), N, x);
    for (std::size_t i = 0; i < N; ++i) y[i] = x[N - 1 - i];
    exponentials(x, exponential_of);
    hyperbolic_tangents(x, tangent_of);
    powers(x, y, power_of);
    for (std::size_t i = 0; i < N; ++i) {
      ASSERT_TRUE(same_bits(exponential_of[i], exponential(x[i]))) << x[i];
      ASSERT_TRUE(same_bits(tangent_of[i], hyperbolic_tangent(x[i]))) << x[i];
      ASSERT_TRUE(same_bits(power_of[i], power(x[i], y[i]))) << x[i] << " " << y[i];
      const Two two = {x[0], x[i]}, other = {y[0], y[i]};
      const double alone[] = {logarithm(x[i]), power(x[i], y[i]), arc_tangent(x[i], y[i])};
      const Two lanes[] = {logarithm(two), power(two, other), arc_tangent(two, other)};
      for (int k = 0; k < 3; ++k) {
        const double lane = lanes[k][1];
        ASSERT_TRUE(same_bits(alone[k], lane)) << x[i] << " " << y[i] << " " << k;
      }
    }
  }
}

TEST(ExponentialsAndPowers, haveTheSameBitsAloneInLanesAndInArrays) {
  std::vector<double> some = {0.0, -0.0, 1.0, -1.0, 1e-310, 1e300, -1e300, INFINITY, -INFINITY, NAN, 0.5, 2.0, 33.0};
  for (const double x : numbers(-30, 30, 4000)) some.push_back(x);
  expect_same_bits_in_arrays<1>(some);
  expect_same_bits_in_arrays<2>(some);
  expect_same_bits_in_arrays<6>(some);
  expect_same_bits_in_arrays<13>(some);
}

}  // namespace
}  // namespace mbgen
