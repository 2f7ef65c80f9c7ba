#pragma once
// Numbers with their derivatives along the inputs of a rig.

#include <cmath>

#include "compiler/model/vectors.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {

using mbgen::cross, mbgen::dot;  // of plain vectors, beside those below

struct Dual {
  double value = 0;
  RigInputs slope{};
  Dual() = default;
  Dual(double constant) : value(constant) {}
};

/// f(a, b) with its derivatives along a and b.
inline Dual chained(double value, const Dual& a, double along_a, const Dual& b = {}, double along_b = 0) {
  Dual result(value);
  for (std::size_t i = 0; i < result.slope.size(); ++i) result.slope[i] = along_a * a.slope[i] + along_b * b.slope[i];
  return result;
}

inline Dual operator+(const Dual& a, const Dual& b) { return chained(a.value + b.value, a, 1, b, 1); }
inline Dual operator-(const Dual& a, const Dual& b) { return chained(a.value - b.value, a, 1, b, -1); }
inline Dual operator-(const Dual& a) { return chained(-a.value, a, -1); }
inline Dual operator*(const Dual& a, const Dual& b) { return chained(a.value * b.value, a, b.value, b, a.value); }
inline Dual operator/(const Dual& a, const Dual& b) {
  const double ratio = a.value / b.value;
  return chained(ratio, a, 1 / b.value, b, -ratio / b.value);
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return chained(root, a, 0.5 / root);
}
inline Dual atan2(const Dual& y, const Dual& x) {
  const double square = x.value * x.value + y.value * y.value;
  return chained(std::atan2(y.value, x.value), y, x.value / square, x, -y.value / square);
}

using DualVector = std::array<Dual, 3>;

inline DualVector operator+(const DualVector& a, const DualVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline DualVector operator-(const DualVector& a, const DualVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline DualVector operator*(const Dual& factor, const DualVector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline Dual dot(const DualVector& a, const DualVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline DualVector cross(const DualVector& a, const DualVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline DualVector unit(const DualVector& a) { return (Dual(1) / sqrt(dot(a, a))) * a; }

/// Derivative along a combination of the rig's inputs.
inline double along(const Dual& a, const RigInputs& direction) {
  double sum = 0;
  for (std::size_t i = 0; i < direction.size(); ++i) sum += a.slope[i] * direction[i];
  return sum;
}
inline Vector3 along(const DualVector& a, const RigInputs& direction) {
  return {along(a[0], direction), along(a[1], direction), along(a[2], direction)};
}
inline Vector3 value_of(const DualVector& a) { return {a[0].value, a[1].value, a[2].value}; }

}  // namespace mbgen::kc
