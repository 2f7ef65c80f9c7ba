#pragma once
// The magic formula of 1989 for pure and combined slip, over a scalar T without comparisons.
// Source: E. Bakker, H. B. Pacejka, L. Lidner, "A New Tire Model with an Application in Vehicle Dynamics Studies",
// SAE 890087, 1989.

#include "mbgen/tyres/magic_formula.hpp"

namespace mbgen {

/// Numbers of coefficients of the formula of 1989: lateral force, longitudinal force, aligning moment.
inline constexpr int kPac89ACount = 14;
inline constexpr int kPac89BCount = 11;
inline constexpr int kPac89CCount = 18;

/// Coefficients of the formula of 1989, in its own units (kN, degrees, per cent).
template <class T>
struct Pac89 {
  T a[kPac89ACount];  ///< lateral force
  T b[kPac89BCount];  ///< longitudinal force
  T c[kPac89CCount];  ///< aligning moment

  /// Takes the coefficients a, then b, then c: 43 values.
  static Pac89 from_fields(const T* fields) {
    Pac89 set{};
    for (int i = 0; i < kPac89ACount; ++i) set.a[i] = fields[i];
    for (int i = 0; i < kPac89BCount; ++i) set.b[i] = fields[kPac89ACount + i];
    for (int i = 0; i < kPac89CCount; ++i) set.c[i] = fields[kPac89ACount + kPac89BCount + i];
    return set;
  }
};

namespace magic {

/// One curve of the formula of 1989: shift_y + d sin(angle(b, c, e, x + shift_x)).
template <class T>
struct Pac89Curve {
  T b, c, d, e, stiffness, shift_x, shift_y;
};

template <class T>
Pac89Curve<T> pac89_curve(const T& c, const T& d, const T& stiffness, const T& e, const T& shift_x, const T& shift_y) {
  return {stiffness / away_from_zero<T>(c * d, T(1e-9)), c, d, e, stiffness, shift_x, shift_y};
}

/// The three curves at a load in kN and a camber in degrees; slips in per cent and degrees.
template <class T>
struct Pac89Curves {
  Pac89Curve<T> x, y, z;
};

template <class T>
Pac89Curves<T> pac89_curves(const Pac89<T>& set, const T& load, const T& gamma, const T& friction, const T& shifts) {
  using std::exp;
  const T* a = set.a;
  const T* b = set.b;
  const T* c = set.c;
  const T square = load * load;
  const T tilt = abs(gamma);
  return {
      pac89_curve<T>(b[0], (b[1] * square + b[2] * load) * friction, (b[3] * square + b[4] * load) * exp(-b[5] * load),
                     b[6] * square + b[7] * load + b[8], (b[9] * load + b[10]) * shifts, T(0)),
      pac89_curve<T>(a[0], (a[1] * square + a[2] * load) * friction,
                     a[3] * sin_of_double_arc<T>(load / a[4]) * (1.0 - a[5] * tilt), a[6] * load + a[7],
                     (a[8] * gamma + a[9] * load + a[10]) * shifts,
                     (a[11] * load * gamma + a[12] * load + a[13]) * shifts),
      pac89_curve<T>(c[0], (c[1] * square + c[2] * load) * friction,
                     (c[3] * square + c[4] * load) * (1.0 - c[6] * tilt) * exp(-c[5] * load),
                     (c[7] * square + c[8] * load + c[9]) * (1.0 - c[10] * tilt),
                     (c[11] * gamma + c[12] * load + c[13]) * shifts,
                     ((c[14] * square + c[15] * load) * gamma + c[16] * load + c[17]) * shifts)};
}

/// Value of a curve at slip x when another slip acts too. other: that slip expressed as the x of equal normalised slip;
/// the curve is followed at the resultant of both and the force shared in proportion. other = 0 is pure slip.
template <class T>
T pac89_value(const Pac89Curve<T>& curve, const T& x, const T& other) {
  using std::sin;
  using std::sqrt;
  const T shifted = x + curve.shift_x;
  const T resultant = sqrt(shifted * shifted + other * other + kRootFloor);
  return shifted / resultant * curve.d * sin(angle(curve.b, curve.c, curve.e, resultant)) + curve.shift_y;
}

}  // namespace magic

/// Forces of the formula of 1989 for each slip alone. Arguments and result as magic_formula_pac89.
/// Source: Bakker, Pacejka, Lidner (1989).
template <class T>
TyreForces<T> magic_formula_pac89_pure(const Pac89<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                                       const T& friction = T(1), const T& shifts = T(1)) {
  const T load = max(1e-3 * fz, T(magic::kLeastLoad));
  const T proportion = max(1e-3 * fz, T(0)) / load;
  const magic::Pac89Curves<T> curves =
      magic::pac89_curves<T>(set, load, magic::kDegrees * gamma, max(friction, T(magic::kLeastFriction)), shifts);
  return {proportion * magic::pac89_value<T>(curves.x, 100.0 * kappa, T(0)),
          proportion * magic::pac89_value<T>(curves.y, magic::kDegrees * alpha, T(0)),
          proportion * magic::pac89_value<T>(curves.z, magic::kDegrees * alpha, T(0)), T(0)};
}

/// Forces of the formula of 1989 for combined slip by a friction ellipse: each slip is normalised by its peak force
/// over its stiffness, both curves are followed at the resultant, and the force is shared in proportion to the slips.
/// Pure slip in either direction gives the formula itself.
/// Arguments in SI as magic_formula_pac2002 (N, 1, rad, rad); the set's kN, per cent and degrees stay inside.
/// Result: N, N m in the paper's axes, y right, z down: positive alpha gives positive fy; mx is zero.
/// Source: Bakker, Pacejka, Lidner (1989), its combined slip with the peak slip D/BCD in place of the exact one.
template <class T>
TyreForces<T> magic_formula_pac89(const Pac89<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                                  const T& friction = T(1), const T& shifts = T(1)) {
  const T load = max(1e-3 * fz, T(magic::kLeastLoad));
  const T proportion = max(1e-3 * fz, T(0)) / load;
  const magic::Pac89Curves<T> curves =
      magic::pac89_curves<T>(set, load, magic::kDegrees * gamma, max(friction, T(magic::kLeastFriction)), shifts);
  const T x = 100.0 * kappa;
  const T y = magic::kDegrees * alpha;
  const T x_peak = curves.x.d / magic::away_from_zero<T>(curves.x.stiffness, T(1e-9));
  const T y_peak = curves.y.d / magic::away_from_zero<T>(curves.y.stiffness, T(1e-9));
  const T y_as_x = y / magic::away_from_zero<T>(y_peak, T(1e-9)) * x_peak;
  const T x_as_y = x / magic::away_from_zero<T>(x_peak, T(1e-9)) * y_peak;
  return {proportion * magic::pac89_value<T>(curves.x, x, y_as_x),
          proportion * magic::pac89_value<T>(curves.y, y, x_as_y),
          proportion * magic::pac89_value<T>(curves.z, y, x_as_y), T(0)};
}

}  // namespace mbgen
