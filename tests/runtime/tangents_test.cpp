// Derivatives of the functions of mbgen/tangents.hpp against differences of their values.

#include "mbgen/tangents.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Number = mbgen::Tangents<8>;

/// The derivative by a difference of order four.
template <class Function>
double slope(const Function& f, double x) {
  const double h = 1e-3;
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

/// f of a number that moves in direction 3 by 1 and in direction 5 by -2.
template <class OfNumber, class OfDouble>
void expect_slope(const OfNumber& f, const OfDouble& plain, double x) {
  Number argument = Number::along(x, 3);
  argument.tangent[5] = -2;
  const Number result = f(argument);
  const double expected = slope(plain, x);
  EXPECT_DOUBLE_EQ(result.value, plain(x)) << x;
  EXPECT_NEAR(result.tangent[3], expected, 1e-9 * (1 + std::abs(expected))) << x;
  EXPECT_DOUBLE_EQ(result.tangent[5], -2 * result.tangent[3]) << x;
  EXPECT_EQ(result.tangent[0], 0) << x;
}

/// f, a function of numbers of any kind, in both arguments.
template <class Function>
void expect_slopes(const Function& f, double a, double b) {
  expect_slope([&](const Number& x) { return Number(f(x, b)); }, [&](double x) { return f(x, b); }, a);
  expect_slope([&](const Number& x) { return Number(f(a, x)); }, [&](double x) { return f(a, x); }, b);
  const Number both = f(Number::along(a, 0), Number::along(b, 1));
  EXPECT_NEAR(both.tangent[0], slope([&](double x) { return f(x, b); }, a), 1e-8);
  EXPECT_NEAR(both.tangent[1], slope([&](double x) { return f(a, x); }, b), 1e-8);
}

TEST(Tangents, FunctionsOfOneArgument) {
  for (const double x : {-0.8, -0.3, 0.2, 0.7}) {
    expect_slope([](auto v) { return mbgen::sine(v); }, [](double v) { return mbgen::sine(v); }, x);
    expect_slope([](auto v) { return mbgen::cosine(v); }, [](double v) { return mbgen::cosine(v); }, x);
    expect_slope([](auto v) { return mbgen::tangent(v); }, [](double v) { return mbgen::tangent(v); }, x);
    expect_slope([](auto v) { return mbgen::arc_sine(v); }, [](double v) { return mbgen::arc_sine(v); }, x);
    expect_slope([](auto v) { return mbgen::arc_cosine(v); }, [](double v) { return mbgen::arc_cosine(v); }, x);
    expect_slope([](auto v) { return mbgen::arc_tangent(v); }, [](double v) { return mbgen::arc_tangent(v); }, x);
    expect_slope([](auto v) { return mbgen::exponential(v); }, [](double v) { return mbgen::exponential(v); }, x);
    expect_slope([](auto v) { return mbgen::hyperbolic_tangent(v); },
                 [](double v) { return mbgen::hyperbolic_tangent(v); }, x);
    expect_slope([](auto v) { return mbgen::sqrt(v + 1.0); }, [](double v) { return std::sqrt(v + 1.0); }, x);
    expect_slope([](auto v) { return mbgen::logarithm(v + 2.0); }, [](double v) { return mbgen::logarithm(v + 2.0); },
                 x);
    expect_slope([](auto v) { return mbgen::abs(v); }, [](double v) { return mbgen::abs(v); }, x);
  }
}

TEST(Tangents, FunctionsOfSeveralArguments) {
  const auto sum = [](const auto& a, const auto& b) { return a + 2.0 * b - (a - 1.0) + (3.0 - b); };
  const auto product = [](const auto& a, const auto& b) { return a * b * a; };
  const auto quotient = [](const auto& a, const auto& b) { return a / b + 1.0 / b + a / 3.0; };
  const auto fused = [](const auto& a, const auto& b) { return mbgen::fma(a, b, a) - mbgen::fms(2.0, a, b); };
  const auto from = [](const auto& a, const auto& b) { return mbgen::fnma(a, b, 5.0) + mbgen::fnma(b, 0.5, a); };
  const auto power = [](const auto& a, const auto& b) { return mbgen::power(a, b); };
  const auto direction = [](const auto& a, const auto& b) { return mbgen::arc_tangent(a, b); };
  const auto chosen = [](const auto& a, const auto& b) {
    return mbgen::min(a, b) * mbgen::max(a, 0.5) + mbgen::select(a - 1.0, a * a, b * b);
  };
  for (const auto& [a, b] : {std::pair{0.7, 1.9}, {1.4, 0.6}, {2.2, 3.1}}) {
    expect_slopes(sum, a, b);
    expect_slopes(product, a, b);
    expect_slopes(quotient, a, b);
    expect_slopes(fused, a, b);
    expect_slopes(from, a, b);
    expect_slopes(power, a, b);
    expect_slopes(direction, a, b);
    expect_slopes(chosen, a, b);
  }
}

TEST(Tangents, ArraysAsOneByOne) {
  Number angles[5], sines[5], cosines[5];
  for (int i = 0; i < 5; ++i) angles[i] = Number::along(0.4 * i - 0.9, i);
  mbgen::sincos(angles, sines, cosines);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(sines[i].value, mbgen::sine(angles[i].value));
    EXPECT_EQ(sines[i].tangent[i], cosines[i].value);
    EXPECT_EQ(cosines[i].tangent[i], -sines[i].value);
  }
}

/// Where a slope has no bound, what rests gets no derivative, and what moves gets infinity.
TEST(Tangents, SlopesWithoutBoundCountWhereSomethingMoves) {
  const Number root = mbgen::sqrt(Number::along(0.0, 2));
  EXPECT_EQ(root.value, 0);
  EXPECT_EQ(root.tangent[0], 0);
  EXPECT_TRUE(std::isinf(root.tangent[2]));
  EXPECT_FALSE(mbgen::is_finite(root));
  EXPECT_TRUE(mbgen::is_finite(mbgen::sqrt(Number(0.0))));
  EXPECT_EQ(mbgen::power(Number::along(0.0, 1), 2.0).tangent[1], 0);
  EXPECT_EQ(mbgen::arc_tangent(Number(0.0), Number(0.0)).tangent[1], 0);
}

TEST(Tangents, NewtonStepsSettleDerivatives) {
  const Number coordinates[] = {Number::along(1.0, 0), Number(2.0)};
  const Number still[] = {Number(1e-12), Number(0.0)};
  const Number moving[] = {Number(0.0), Number::along(0.0, 4)};
  EXPECT_TRUE(mbgen::keeps_derivatives(still, coordinates, 2));
  EXPECT_FALSE(mbgen::keeps_derivatives(moving, coordinates, 2));
}

}  // namespace
