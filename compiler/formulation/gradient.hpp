#pragma once
// Forward differentiation of numbers along several directions at once: of the equations as a whole, and of geometry.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compiler/expressions/sample.hpp"
#include "compiler/formulation/annotator.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// A number with its derivatives along `directions`. Zero derivatives remain zero: 0 times infinity is 0 here. At a
/// kink the derivative is the mean of both sides, as a central difference has it.
template <std::size_t directions>
struct Gradient {
  double value = 0;
  std::array<double, directions> slope{};

  Gradient() = default;
  Gradient(double constant) : value(constant) {}

  /// f(a) by its derivative.
  static Gradient chained(double value, const Gradient& a, double along_a) {
    Gradient result(value);
    if (std::isfinite(along_a)) {
      for (std::size_t i = 0; i < directions; ++i) result.slope[i] = along_a * a.slope[i];
    } else {
      for (std::size_t i = 0; i < directions; ++i) result.slope[i] = a.slope[i] == 0 ? 0 : along_a * a.slope[i];
    }
    return result;
  }
  /// f(a, b) by its derivatives.
  static Gradient chained(double value, const Gradient& a, double along_a, const Gradient& b, double along_b) {
    if (!std::isfinite(along_a) || !std::isfinite(along_b))
      return with_value(value, chained(0, a, along_a) + chained(0, b, along_b));
    Gradient result(value);
    for (std::size_t i = 0; i < directions; ++i) result.slope[i] = along_a * a.slope[i] + along_b * b.slope[i];
    return result;
  }
  static Gradient with_value(double value, Gradient a) {
    a.value = value;
    return a;
  }

  friend Gradient operator+(const Gradient& a, const Gradient& b) {
    Gradient result(a.value + b.value);
    for (std::size_t i = 0; i < directions; ++i) result.slope[i] = a.slope[i] + b.slope[i];
    return result;
  }
  friend Gradient operator-(const Gradient& a, const Gradient& b) {
    Gradient result(a.value - b.value);
    for (std::size_t i = 0; i < directions; ++i) result.slope[i] = a.slope[i] - b.slope[i];
    return result;
  }
  friend Gradient operator-(const Gradient& a) {
    Gradient result(-a.value);
    for (std::size_t i = 0; i < directions; ++i) result.slope[i] = -a.slope[i];
    return result;
  }
  friend Gradient operator*(const Gradient& a, const Gradient& b) {
    Gradient result(a.value * b.value);
    for (std::size_t i = 0; i < directions; ++i) result.slope[i] = b.value * a.slope[i] + a.value * b.slope[i];
    return result;
  }
  friend Gradient operator/(const Gradient& a, const Gradient& b) {
    const double ratio = a.value / b.value;
    return chained(ratio, a, 1 / b.value, b, -ratio / b.value);
  }

  friend Gradient sqrt(const Gradient& a) {
    const double root = std::sqrt(a.value);
    return chained(root, a, 0.5 / root);
  }
  friend Gradient sin(const Gradient& a) { return chained(std::sin(a.value), a, std::cos(a.value)); }
  friend Gradient cos(const Gradient& a) { return chained(std::cos(a.value), a, -std::sin(a.value)); }
  friend Gradient tan(const Gradient& a) {
    const double tangent = std::tan(a.value);
    return chained(tangent, a, 1 + tangent * tangent);
  }
  friend Gradient asin(const Gradient& a) {
    return chained(std::asin(a.value), a, 1 / std::sqrt(1 - a.value * a.value));
  }
  friend Gradient acos(const Gradient& a) {
    return chained(std::acos(a.value), a, -1 / std::sqrt(1 - a.value * a.value));
  }
  friend Gradient atan(const Gradient& a) { return chained(std::atan(a.value), a, 1 / (1 + a.value * a.value)); }
  friend Gradient atan2(const Gradient& y, const Gradient& x) {
    const double square = x.value * x.value + y.value * y.value;
    return chained(std::atan2(y.value, x.value), y, x.value / square, x, -y.value / square);
  }
  friend Gradient exp(const Gradient& a) {
    const double power = std::exp(a.value);
    return chained(power, a, power);
  }
  friend Gradient log(const Gradient& a) { return chained(std::log(a.value), a, 1 / a.value); }
  friend Gradient tanh(const Gradient& a) {
    const double tangent = std::tanh(a.value);
    return chained(tangent, a, 1 - tangent * tangent);
  }
  /// x^y; requires x > 0 if y varies or is no whole number.
  friend Gradient pow(const Gradient& x, const Gradient& y) {
    const double power = std::pow(x.value, y.value);
    const double by_base = y.value == 0 ? 0 : y.value * std::pow(x.value, y.value - 1);
    const bool is_varied = std::any_of(y.slope.begin(), y.slope.end(), [](double slope) { return slope != 0; });
    return chained(power, x, by_base, y, is_varied ? power * std::log(x.value) : 0);
  }
  friend Gradient floor(const Gradient& a) { return std::floor(a.value); }
  friend Gradient sample(const std::vector<double>& samples, const Gradient& index) {
    return mbgen::sample(samples, index.value);
  }

  /// a for condition >= 0, else b.
  friend Gradient select(const Gradient& condition, const Gradient& a, const Gradient& b) {
    if (condition.value == 0 && a.value == b.value) return chained(a.value, a, 0.5, b, 0.5);
    return condition.value >= 0 ? a : b;
  }
  friend Gradient abs(const Gradient& a) { return with_value(std::abs(a.value), select(a, a, -a)); }
  friend Gradient min(const Gradient& a, const Gradient& b) { return select(b - a, a, b); }
  friend Gradient max(const Gradient& a, const Gradient& b) { return select(a - b, a, b); }

  friend bool is_zero(const Gradient& a) {
    return a.value == 0 && std::all_of(a.slope.begin(), a.slope.end(), [](double slope) { return slope == 0; });
  }
  friend double known_size(const Gradient& a) { return std::abs(a.value); }
};

}  // namespace mbgen
