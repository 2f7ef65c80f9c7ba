#pragma once
// Turn slip of MF 6.1: the factors zeta_1 to zeta_8 by which the spin of a rolling contact changes forces and moments.
// Source: H. B. Pacejka, Tire and Vehicle Dynamics, 3rd edition, 2012, section 4.3.3, equations (4.76) to (4.106), with
// the signs of the equation manual of MF-Tyre 6.2 (ISO axes: spin is -(d psi/dt + (1 - eps_gamma) Omega sin gamma) / V)
// and its K_yalpha0 without zeta_3. zeta_0, the factor of what camber does beside its spin, is 0 where turn slip acts.

#include "mbgen/tyres/mf61_set.hpp"

namespace mbgen {
namespace magic {

/// Spin of a contact, over the unloaded radius. A contact on which turn slip does not act has zeta_0 to zeta_8 of 1.
template <class T>
struct Mf61Turn {
  T spin = T(0), turn = T(0);  ///< 1: of turning and camber, and of turning alone
  T travel = T(1);             ///< 1 when rolling forward, -1 backward
  T limit = T(0);              ///< N m, M_zphi_inf (4.95): the largest moment of a contact that turns on the spot
  bool acts = false;
};

/// eps_r of (4.104), over M_zphi_inf: below it the shape of the residual moment goes back to that without spin.
inline constexpr double kLeastTurnMoment = 1e-3;
/// Largest argument of the arc cosine of (4.104), short of 1, where its slope is infinite; also in single precision.
inline constexpr double kLargestCosine = 1 - 1e-6;

/// |x| with a slope of zero at zero.
template <class T>
T round_absolute(const T& x) {
  using std::sqrt;
  return sqrt(x * x + kRootFloor);
}

/// 1 - eps_gamma, held away from zero: the share of camber in spin; (4.90). dfz: 1, relative deviation from the nominal
/// load.
template <class T>
T mf61_camber_share(const MagicFormula61<T>& set, const T& dfz) {
  return away_from_zero<T>(1.0 - set.pecp1 * (1.0 + set.pecp2 * dfz), T(1e-3));
}

/// Factor of the longitudinal peak: (4.105), (4.106).
template <class T>
T mf61_zeta_1(const MagicFormula61<T>& set, const T& dfz, const T& kappa, const Mf61Turn<T>& turn) {
  if (!turn.acts) return T(1);
  return cos_of_arc<T>(set.pdxp1 * (1.0 + set.pdxp2 * dfz) * cos_of_arc<T>(set.pdxp3 * kappa) * turn.spin);
}

/// Factor of the lateral peak: (4.77), (4.78). tangent: of the slip angle.
template <class T>
T mf61_zeta_2(const MagicFormula61<T>& set, const T& dfz, const T& tangent, const Mf61Turn<T>& turn) {
  using std::sqrt;
  if (!turn.acts) return T(1);
  const T b = set.pdyp1 * (1.0 + set.pdyp2 * dfz) * cos_of_arc<T>(set.pdyp3 * tangent);
  const T spin = round_absolute(turn.spin);
  return cos_of_arc<T>(b * (spin + set.pdyp4 * sqrt(spin)));
}

/// Factor of the cornering stiffness: (4.79).
template <class T>
T mf61_zeta_3(const MagicFormula61<T>& set, const Mf61Turn<T>& turn) {
  if (!turn.acts) return T(1);
  return cos_of_arc<T>(set.pkyp1 * turn.spin * turn.spin);
}

/// S_Hyphi, rad: the shift of the slip angle by spin; (4.80), (4.85) to (4.89). camber_stiffness: N/rad; stiffness:
/// N/rad, of the slip of an upright tyre without spin; load: N, > 0.
template <class T>
T mf61_spin_shift(const MagicFormula61<T>& set, const T& dfz, const T& load, const T& camber_stiffness,
                  const T& stiffness, const Mf61Turn<T>& turn) {
  using std::sin;
  const T d = set.phyp2 + set.phyp3 * dfz;
  const T slope = camber_stiffness / mf61_camber_share(set, dfz);
  const T b = -slope / away_from_zero<T>(set.phyp1 * d * stiffness, 1e-9 * load);
  return turn.travel * d * sin(angle<T>(b, set.phyp1, curvature(set.phyp4), turn.spin));
}

/// Factor of the trail: (4.91).
template <class T>
T mf61_zeta_5(const MagicFormula61<T>& set, const Mf61Turn<T>& turn) {
  if (!turn.acts) return T(1);
  return cos_of_arc<T>(set.qdtp1 * turn.spin);
}

/// D_rphi, N m, the peak of the moment against turning: (4.93) to (4.99). load: N; camber: sine of it.
template <class T>
T mf61_turn_moment(const MagicFormula61<T>& set, const T& dfz, const T& load, const T& camber,
                   const Mf61Turn<T>& turn) {
  using std::sin;
  const T d = turn.limit / away_from_zero<T>(sin(0.5 * kPi * set.qdrp1), T(1e-3));
  const T slope = load * set.unloaded_radius *
                  (set.qdz8 + set.qdz9 * dfz + (set.qdz10 + set.qdz11 * dfz) * abs(camber)) * set.lkzc /
                  mf61_camber_share(set, dfz);
  const T b = slope / away_from_zero<T>(set.qdrp1 * d, 1e-9 * load * set.unloaded_radius);
  return d * sin(angle<T>(b, set.qdrp1, curvature(set.qdrp2), turn.spin));
}

/// zeta_7, the shape of the residual moment: (4.103), (4.104). moment: D_rphi, N m; weight: G_ykappa.
template <class T>
T mf61_zeta_7(const MagicFormula61<T>& set, const T& moment, const T& weight, const Mf61Turn<T>& turn) {
  using std::acos;
  using std::atan;
  const T sideways = turn.limit * (2.0 / kPi) * atan(set.qcrp2 * round_absolute(turn.turn)) * weight;
  const T peak = round_absolute(moment) + kLeastTurnMoment * turn.limit;
  const T share = sideways / max(peak, T(kRootFloor));
  return (2.0 / kPi) * acos(min(max(share, T(-kLargestCosine)), T(kLargestCosine)));
}

}  // namespace magic
}  // namespace mbgen
