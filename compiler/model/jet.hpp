#pragma once
// A value with its first and second time derivatives, so that a motion gives position, velocity and acceleration at
// once.

#include <algorithm>

#include "compiler/model/curve.hpp"
#include "compiler/model/evaluate.hpp"
#include "compiler/model/model.hpp"

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
template <class T>
Jet<T> min(const Jet<T>& a, const Jet<T>& b) {
  return select(b - a, a, b);
}
template <class T>
Jet<T> max(const Jet<T>& a, const Jet<T>& b) {
  return select(a - b, a, b);
}

/// An environment of T seen by a motion: time runs, parameters stand still, and inputs move by the derivatives that the
/// model names for them.
template <class T, class Environment>
struct MotionEnvironment {
  const std::vector<Input>& inputs;  ///< of the model
  const Environment& environment;

  Jet<T> parameter(int index) const { return Jet<T>(environment.parameter(index)); }
  Jet<T> input(int index) const {
    const int rate = derivative_of(index);
    const int acceleration = rate < 0 ? -1 : derivative_of(rate);
    return {environment.input(index), value_or_zero(rate), value_or_zero(acceleration)};
  }
  Jet<T> time() const { return {environment.time(), T(1.0), T(0.0)}; }
  // read_model refuses coordinates and locals in a motion.
  Jet<T> position(const CoordinateReference&) const { return {}; }
  Jet<T> velocity(const CoordinateReference&) const { return {}; }
  Jet<T> local(int) const { return {}; }

 private:
  int derivative_of(int index) const { return inputs[static_cast<std::size_t>(index)].derivative; }
  T value_or_zero(int index) const { return index < 0 ? T(0.0) : environment.input(index); }
};

/// Coordinates that move as they are told while parameters stand still: what the relation of a coupling sees.
template <class T, class Environment>
struct RelationEnvironment {
  const std::vector<CoordinateReference>& coordinates;
  const std::vector<Jet<T>>& positions;  ///< of the coordinates, in their order
  const Environment& environment;        ///< of T: parameter(i)

  Jet<T> parameter(int index) const { return Jet<T>(environment.parameter(index)); }
  Jet<T> position(const CoordinateReference& c) const {
    return positions[static_cast<std::size_t>(std::ranges::find(coordinates, c) - coordinates.begin())];
  }
  // read_model refuses inputs, time, velocities and locals in a relation.
  Jet<T> input(int) const { return {}; }
  Jet<T> time() const { return {}; }
  Jet<T> velocity(const CoordinateReference&) const { return {}; }
  Jet<T> local(int) const { return {}; }
};

/// The relation of a coupling and its derivatives while its coordinates move. positions: in their order.
template <class T, class Environment>
Jet<T> evaluate_relation(const Model& model, const Coupling& coupling, const std::vector<Jet<T>>& positions,
                         const Environment& environment) {
  if (coupling.curve) {
    const CurvePoint<T> at = curve_at(*coupling.curve, positions[1].value);
    return positions[0] - chain(positions[1], at.value, at.slope, at.curvature);
  }
  return evaluate<Jet<T>>(coupling.relation, model.expressions,
                          RelationEnvironment<T, Environment>{coupling.coordinates, positions, environment});
}

/// Derivative of the relation by each of its coordinates, in their order.
template <class T, class Environment>
std::vector<T> relation_slopes(const Model& model, const Coupling& coupling, const std::vector<T>& positions,
                               const Environment& environment) {
  std::vector<Jet<T>> moving(positions.begin(), positions.end());
  std::vector<T> slopes;
  for (Jet<T>& position : moving) {
    position.first = T(1.0);
    slopes.push_back(evaluate_relation(model, coupling, moving, environment).first);
    position.first = T(0.0);
  }
  return slopes;
}

/// Position, velocity and acceleration that a motion prescribes. environment: of T, as for evaluate.
template <class T, class Environment>
Jet<T> evaluate_motion(const Model& model, const Motion& motion, const Environment& environment) {
  return evaluate<Jet<T>>(motion.position, model.expressions,
                          MotionEnvironment<T, Environment>{model.inputs, environment});
}

}  // namespace mbgen
