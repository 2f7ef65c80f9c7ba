#pragma once
// Numbers with their derivatives along the inputs of a rig.

#include "compiler/formulation/gradient.hpp"
#include "compiler/model/vectors.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {

using mbgen::cross, mbgen::dot;  // of plain vectors, beside those below

using Dual = Gradient<kRigInputs>;
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
