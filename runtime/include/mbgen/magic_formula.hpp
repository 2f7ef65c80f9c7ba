#pragma once
// Common parts of the two forms of Pacejka's magic formula: the result and the shape of the curve.
// Written over a scalar T (double, or the compiler's symbolic scalar): no comparisons on T.
// Source: H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd edition, section 4.3.

#include <cmath>
#include <cstddef>

#include "mbgen/scalar.hpp"

namespace mbgen {

/// Forces on the wheel, in the axes of the coefficient set.
template <class T>
struct TyreForces {
  T fx, fy;  ///< N, along and across the wheel's heading
  T mz, mx;  ///< N m, about the road's normal and about the heading
};

namespace magic {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegrees = 180.0 / kPi;  ///< degrees in a radian
/// The load below which forces simply fall in proportion to it, over the nominal load: no formula divides by less.
inline constexpr double kLeastLoad = 1e-6;
/// Least friction that the formulas divide by, as a factor of the measured friction.
inline constexpr double kLeastFriction = 1e-6;
/// Added under square roots of squared slips (rad^2 or 1), so that their slope stays finite at zero.
inline constexpr double kRootFloor = 1e-30;

/// sgn x with sgn 0 = +1.
template <class T>
T sign(const T& x) {
  return select(x, T(1), T(-1));
}

/// x, moved away from zero to at least `least` with its sign kept: a safe divisor. Requires: least > 0.
template <class T>
T away_from_zero(const T& x, const T& least) {
  return select(x, max(x, least), min(x, -least));
}

/// cos(atan x). Requires: |x| < 1e150.
template <class T>
T cos_of_arc(const T& x) {
  using std::sqrt;
  return 1.0 / sqrt(1.0 + x * x);
}

/// sin(2 atan x). Requires: |x| < 1e150.
template <class T>
T sin_of_double_arc(const T& x) {
  return 2.0 * x / (1.0 + x * x);
}

/// The angle C atan(B x - E (B x - atan(B x))) behind every curve.
template <class T>
T angle(const T& b, const T& c, const T& e, const T& x) {
  using std::atan;
  const T bx = b * x;
  return c * atan(bx - e * (bx - atan(bx)));
}

}  // namespace magic

}  // namespace mbgen
