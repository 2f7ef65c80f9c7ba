#pragma once
// A value with its first and second time derivatives, so that a motion gives position, velocity and acceleration at
// once.

#include "compiler/expressions/evaluate.hpp"

namespace mbgen {

/// x(t), dx/dt and d2x/dt2 at one instant. T: double or a symbolic Expr.
template <class T>
struct Jet {
  T value, first, second;
  Jet() : value(0.0), first(0.0), second(0.0) {}
  Jet(T constant) : value(constant), first(0.0), second(0.0) {}
  Jet(T x, T dx, T ddx) : value(x), first(dx), second(ddx) {}
};

template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return {a.value - b.value, a.first - b.first, a.second - b.second};
}
template <class T>
Jet<T> operator-(const Jet<T>& a) {
  return {-a.value, -a.first, -a.second};
}
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + T(2.0) * (a.first * b.first) + a.value * b.second};
}
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
  const T value = a.value / b.value;
  const T first = (a.first - value * b.first) / b.value;
  return {value, first, (a.second - T(2.0) * (first * b.first) - value * b.second) / b.value};
}

// Constants, as curves by points have them.
template <class T>
Jet<T> operator+(const Jet<T>& a, double b) {
  return {a.value + b, a.first, a.second};
}
template <class T>
Jet<T> operator+(double a, const Jet<T>& b) {
  return b + a;
}
template <class T>
Jet<T> operator-(const Jet<T>& a, double b) {
  return {a.value - b, a.first, a.second};
}
template <class T>
Jet<T> operator*(double a, const Jet<T>& b) {
  return {a * b.value, a * b.first, a * b.second};
}
template <class T>
Jet<T> operator*(const Jet<T>& a, double b) {
  return b * a;
}

/// f(x(t)) from f, f' and f'' at x.
template <class T>
Jet<T> chain(const Jet<T>& x, const T& f, const T& df, const T& ddf) {
  return {f, df * x.first, ddf * (x.first * x.first) + df * x.second};
}

template <class T>
Jet<T> sqrt(const Jet<T>& x) {
  using std::sqrt;
  const T root = sqrt(x.value);
  const T slope = T(0.5) / root;
  return chain(x, root, slope, -slope / (T(2.0) * x.value));
}
template <class T>
Jet<T> sin(const Jet<T>& x) {
  using std::cos, std::sin;
  const T sine = sin(x.value);
  return chain(x, sine, T(cos(x.value)), -sine);
}
template <class T>
Jet<T> cos(const Jet<T>& x) {
  using std::cos, std::sin;
  const T cosine = cos(x.value);
  return chain(x, cosine, -sin(x.value), -cosine);
}
template <class T>
Jet<T> tan(const Jet<T>& x) {
  using std::tan;
  const T tangent = tan(x.value);
  const T slope = T(1.0) + tangent * tangent;
  return chain(x, tangent, slope, T(2.0) * tangent * slope);
}
template <class T>
Jet<T> asin(const Jet<T>& x) {
  using std::asin, std::sqrt;
  const T square = T(1.0) - x.value * x.value;
  const T slope = T(1.0) / sqrt(square);
  return chain(x, T(asin(x.value)), slope, x.value * slope / square);
}
template <class T>
Jet<T> acos(const Jet<T>& x) {
  using std::acos, std::sqrt;
  const T square = T(1.0) - x.value * x.value;
  const T slope = T(-1.0) / sqrt(square);
  return chain(x, T(acos(x.value)), slope, x.value * slope / square);
}
template <class T>
Jet<T> atan(const Jet<T>& x) {
  using std::atan;
  const T slope = T(1.0) / (T(1.0) + x.value * x.value);
  return chain(x, T(atan(x.value)), slope, T(-2.0) * x.value * (slope * slope));
}
template <class T>
Jet<T> atan2(const Jet<T>& y, const Jet<T>& x) {
  using std::atan2;
  const T square = x.value * x.value + y.value * y.value;
  const T first = (x.value * y.first - y.value * x.first) / square;
  const T half_square_rate = x.value * x.first + y.value * y.first;
  const T second = (x.value * y.second - y.value * x.second - T(2.0) * (half_square_rate * first)) / square;
  return {atan2(y.value, x.value), first, second};
}
template <class T>
Jet<T> exp(const Jet<T>& x) {
  using std::exp;
  const T value = exp(x.value);
  return chain(x, value, value, value);
}
template <class T>
Jet<T> log(const Jet<T>& x) {
  using std::log;
  const T slope = T(1.0) / x.value;
  return chain(x, T(log(x.value)), slope, -(slope * slope));
}
template <class T>
Jet<T> tanh(const Jet<T>& x) {
  using std::tanh;
  const T value = tanh(x.value);
  const T slope = T(1.0) - value * value;
  return chain(x, value, slope, T(-2.0) * value * slope);
}

/// x^exponent for a constant exponent, without a logarithm: holds for whole exponents of negative x, too.
template <class T>
Jet<T> pow(const Jet<T>& x, double exponent) {
  return chain(x, power_by_constant(x.value, exponent), T(exponent) * power_by_constant(x.value, exponent - 1),
               T(exponent * (exponent - 1)) * power_by_constant(x.value, exponent - 2));
}
/// x^y for x > 0.
template <class T>
Jet<T> pow(const Jet<T>& x, const Jet<T>& y) {
  return exp(y * log(x));
}

/// a where condition >= 0, else b; the switch itself contributes no derivative.
template <class T>
Jet<T> select(const Jet<T>& condition, const Jet<T>& a, const Jet<T>& b) {
  using mbgen::select;
  return {select(condition.value, a.value, b.value), select(condition.value, a.first, b.first),
          select(condition.value, a.second, b.second)};
}
template <class T>
Jet<T> abs(const Jet<T>& x) {
  return select(x, x, -x);
}
/// The largest whole number not above x; its jumps contribute no derivative.
template <class T>
Jet<T> floor(const Jet<T>& x) {
  using std::floor;
  return {floor(x.value), T(0.0), T(0.0)};
}
template <class T>
Jet<T> min(const Jet<T>& a, const Jet<T>& b) {
  return select(b - a, a, b);
}
template <class T>
Jet<T> max(const Jet<T>& a, const Jet<T>& b) {
  return select(a - b, a, b);
}

}  // namespace mbgen
