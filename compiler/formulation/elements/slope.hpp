#pragma once
// Forward differentiation: a value with its derivative along one direction, for force laws over their local
// coordinates, both numerical and symbolic.

#include <cmath>
#include <concepts>

#include "compiler/formulation/annotator.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// x and dx/ds. T: double or a symbolic Expr. Zero derivatives remain zero: 0 times infinity is 0 here.
template <class T>
struct Slope {
  T value{0.0}, slope{0.0};

  Slope() = default;
  template <class Number>
  requires std::convertible_to<Number, T> Slope(const Number& constant) : value(constant) {}
  Slope(const T& x, const T& dx) : value(x), slope(dx) {}

  /// f(x) by the chain rule. derivative(): f'(x), called only if dx/ds is not zero.
  template <class Derivative>
  static Slope chain(const Slope& x, const T& f, const Derivative& derivative) {
    return is_zero(x.slope) ? Slope(f) : Slope(f, derivative() * x.slope);
  }
  static T times(const T& a, const T& b) { return is_zero(a) || is_zero(b) ? T(0.0) : a * b; }

  friend Slope operator+(const Slope& a, const Slope& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Slope operator-(const Slope& a, const Slope& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Slope operator-(const Slope& a) { return {-a.value, -a.slope}; }
  friend Slope operator*(const Slope& a, const Slope& b) {
    return {a.value * b.value, times(a.slope, b.value) + times(a.value, b.slope)};
  }
  friend Slope operator/(const Slope& a, const Slope& b) {
    const T value = a.value / b.value;
    const T above = a.slope - times(value, b.slope);
    return is_zero(above) ? Slope(value) : Slope(value, above / b.value);
  }

  friend Slope sqrt(const Slope& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    return chain(x, root, [&] { return T(0.5) / root; });
  }
  friend Slope sin(const Slope& x) {
    using std::cos, std::sin;
    return chain(x, sin(x.value), [&] { return T(cos(x.value)); });
  }
  friend Slope cos(const Slope& x) {
    using std::cos, std::sin;
    return chain(x, cos(x.value), [&] { return -T(sin(x.value)); });
  }
  friend Slope tan(const Slope& x) {
    using std::tan;
    const T tangent = tan(x.value);
    return chain(x, tangent, [&] { return T(1.0) + tangent * tangent; });
  }
  friend Slope asin(const Slope& x) {
    using std::asin, std::sqrt;
    return chain(x, asin(x.value), [&] { return T(1.0) / T(sqrt(T(1.0) - x.value * x.value)); });
  }
  friend Slope acos(const Slope& x) {
    using std::acos, std::sqrt;
    return chain(x, acos(x.value), [&] { return T(-1.0) / T(sqrt(T(1.0) - x.value * x.value)); });
  }
  friend Slope atan(const Slope& x) {
    using std::atan;
    return chain(x, atan(x.value), [&] { return T(1.0) / (T(1.0) + x.value * x.value); });
  }
  friend Slope atan2(const Slope& y, const Slope& x) {
    using std::atan2;
    const T above = times(x.value, y.slope) - times(y.value, x.slope);
    const T angle = atan2(y.value, x.value);
    return is_zero(above) ? Slope(angle) : Slope(angle, above / (x.value * x.value + y.value * y.value));
  }
  friend Slope exp(const Slope& x) {
    using std::exp;
    const T value = exp(x.value);
    return chain(x, value, [&] { return value; });
  }
  friend Slope log(const Slope& x) {
    using std::log;
    return chain(x, log(x.value), [&] { return T(1.0) / x.value; });
  }
  friend Slope tanh(const Slope& x) {
    using std::tanh;
    const T value = tanh(x.value);
    return chain(x, value, [&] { return T(1.0) - value * value; });
  }
  /// x^y; requires x > 0 if y varies or is no whole number.
  friend Slope pow(const Slope& x, const Slope& y) {
    using std::log, std::pow;
    const T value = pow(x.value, y.value);
    const T by_base = is_zero(x.slope) ? T(0.0) : y.value * T(pow(x.value, y.value - T(1.0))) * x.slope;
    const T by_exponent = is_zero(y.slope) ? T(0.0) : value * T(log(x.value)) * y.slope;
    return {value, by_base + by_exponent};
  }

  /// a for condition >= 0, else b; the switch itself has no derivative.
  friend Slope select(const Slope& condition, const Slope& a, const Slope& b) {
    using mbgen::select;
    const bool stands = is_zero(a.slope) && is_zero(b.slope);
    return {select(condition.value, a.value, b.value), stands ? T(0.0) : T(select(condition.value, a.slope, b.slope))};
  }
  friend Slope floor(const Slope& x) {
    using std::floor;
    return {floor(x.value), T(0.0)};
  }
  friend Slope abs(const Slope& x) { return select(x, x, -x); }
  friend Slope min(const Slope& a, const Slope& b) { return select(b - a, a, b); }
  friend Slope max(const Slope& a, const Slope& b) { return select(a - b, a, b); }
};

}  // namespace mbgen
