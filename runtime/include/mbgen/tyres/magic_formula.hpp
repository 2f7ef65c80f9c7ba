#pragma once
// Common parts of the forms of Pacejka's magic formula: the table of a set, the result, the shape of the curve.
// Written over a scalar T (double, or the compiler's symbolic scalar): no comparisons on T.
// Source: H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd edition, section 4.3.

#include <cmath>
#include <cstddef>
#include <utility>

#include "mbgen/scalar.hpp"

namespace mbgen {

/// Forces on the wheel, in the axes of the coefficient set.
template <class T>
struct TyreForces {
  T fx, fy;  ///< N, along and across the wheel's heading
  T mz, mx;  ///< N m, about the road's normal and about the heading
};

/// One coefficient of a tyre set: its name in .tir files and the value it has when the set does not give it.
struct TyreField {
  const char* name;
  double default_value;
};

namespace magic {

/// A set whose members are all T, from as many numbers in the order of its members.
template <class Set, class T, std::size_t... I>
Set gathered(const T* fields, std::index_sequence<I...>) {
  return Set{fields[I]...};
}

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

/// Curvature factors above 1 would fold a curve back.
template <class T>
T curvature(const T& e) {
  return min(e, T(1));
}

/// W(x + shift) / W(shift), W = cos(angle): the weight by which the other slip reduces a force; 1 at x = 0.
template <class T>
T weight(const T& b, const T& c, const T& unlimited, const T& shift, const T& x) {
  using std::cos;
  const T e = curvature(unlimited);
  return cos(angle<T>(b, c, e, x + shift)) / away_from_zero<T>(cos(angle<T>(b, c, e, shift)), T(1e-9));
}

/// A load with its terms that every formula needs.
template <class T>
struct LoadTerms {
  T nominal;     ///< N, scaled nominal load
  T load;        ///< N, held above kLeastLoad of the nominal load
  T proportion;  ///< 1, actual load over `load`: factor of the results, 1 in the range of the formulas
  T dfz;         ///< 1, relative deviation from the nominal load
  T friction;    ///< 1, factor of the measured friction, held above kLeastFriction
  T shifts;      ///< 1, factor of the shifts of the pure forces
};

template <class T>
LoadTerms<T> load_terms(const T& nominal, const T& fz, const T& friction, const T& shifts) {
  const T load = max(fz, kLeastLoad * nominal);
  return {nominal, load, max(fz, T(0)) / load, (load - nominal) / nominal, max(friction, T(kLeastFriction)), shifts};
}

/// The curve behind a force of pure slip: d sin(angle(b, c, e, slip)) + shift.
template <class T>
struct PureCurve {
  T b, c, d, e;  ///< d: N; e: limited
  T slip;        ///< 1 or rad, with its shift
  T shift;       ///< N
};

/// Force of pure longitudinal slip, N, and its slope at zero slip, N per unit of slip.
template <class T>
struct PureLongitudinal {
  T force, stiffness;
  PureCurve<T> curve;
};

/// Lateral force of pure slip, N, with its terms that the aligning moment and combined slip need.
template <class T>
struct PureLateral {
  T force, stiffness;  ///< N, N/rad; the stiffness is held away from zero
  T slip_shift;        ///< rad, S_Hy + S_Vy / K_y: the slip angle of zero side force, with its sign changed
  T friction;          ///< 1, mu_y
  PureCurve<T> curve;
};

/// Force of a curve, N, where another slip acts too, by a friction ellipse: each slip is measured by its peak force
/// over its stiffness, both curves are followed at the resultant, and the force is shared in proportion to the slips.
/// Beside the shifts, the resultant force stays in the ellipse with the half axes d. Without the other slip the curve
/// itself. Source: as in magic_formula_pac89.
template <class T>
T force_in_ellipse(const PureCurve<T>& own, const PureCurve<T>& other) {
  using std::sin;
  using std::sqrt;
  const T as_own = other.slip * (other.b * other.c) / away_from_zero<T>(own.b * own.c, T(1e-9));
  const T resultant = sqrt(own.slip * own.slip + as_own * as_own + kRootFloor);
  return own.slip / resultant * own.d * sin(angle<T>(own.b, own.c, own.e, resultant)) + own.shift;
}

}  // namespace magic

}  // namespace mbgen
