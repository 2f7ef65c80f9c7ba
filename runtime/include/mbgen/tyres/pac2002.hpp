#pragma once
// The magic formula PAC2002 (MF5.2) for pure and combined slip, over a scalar T without comparisons.
// Source: H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd edition, section 4.3.2, equations (4.E1) to (4.E78), without
// turn slip; the overturning moment with the factors of MF5.2.

#include "mbgen/tyres/magic_formula.hpp"

namespace mbgen {

/// The coefficients of PAC2002 (MF5.2), in the order of the members of Pac2002.
inline constexpr TyreField kPac2002Fields[] = {
    // unloaded radius, m; nominal load, N: both must be given, > 0
    {"UNLOADED_RADIUS", 0.0},
    {"FNOMIN", 0.0},
    // scaling factors
    {"LFZO", 1.0},
    {"LCX", 1.0},
    {"LMUX", 1.0},
    {"LEX", 1.0},
    {"LKX", 1.0},
    {"LHX", 1.0},
    {"LVX", 1.0},
    {"LCY", 1.0},
    {"LMUY", 1.0},
    {"LEY", 1.0},
    {"LKY", 1.0},
    {"LHY", 1.0},
    {"LVY", 1.0},
    {"LTR", 1.0},
    {"LRES", 1.0},
    {"LGAX", 1.0},
    {"LGAY", 1.0},
    {"LGAZ", 1.0},
    {"LXAL", 1.0},
    {"LYKA", 1.0},
    {"LVYKA", 1.0},
    {"LS", 1.0},
    {"LMX", 1.0},
    {"LVMX", 1.0},
    {"LMY", 1.0},
    // longitudinal force, pure and combined slip
    {"PCX1", 0.0},
    {"PDX1", 0.0},
    {"PDX2", 0.0},
    {"PDX3", 0.0},
    {"PEX1", 0.0},
    {"PEX2", 0.0},
    {"PEX3", 0.0},
    {"PEX4", 0.0},
    {"PKX1", 0.0},
    {"PKX2", 0.0},
    {"PKX3", 0.0},
    {"PHX1", 0.0},
    {"PHX2", 0.0},
    {"PVX1", 0.0},
    {"PVX2", 0.0},
    {"RBX1", 0.0},
    {"RBX2", 0.0},
    {"RCX1", 0.0},
    {"REX1", 0.0},
    {"REX2", 0.0},
    {"RHX1", 0.0},
    // lateral force, pure and combined slip
    {"PCY1", 0.0},
    {"PDY1", 0.0},
    {"PDY2", 0.0},
    {"PDY3", 0.0},
    {"PEY1", 0.0},
    {"PEY2", 0.0},
    {"PEY3", 0.0},
    {"PEY4", 0.0},
    {"PKY1", 0.0},
    {"PKY2", 0.0},
    {"PKY3", 0.0},
    {"PHY1", 0.0},
    {"PHY2", 0.0},
    {"PHY3", 0.0},
    {"PVY1", 0.0},
    {"PVY2", 0.0},
    {"PVY3", 0.0},
    {"PVY4", 0.0},
    {"RBY1", 0.0},
    {"RBY2", 0.0},
    {"RBY3", 0.0},
    {"RCY1", 0.0},
    {"REY1", 0.0},
    {"REY2", 0.0},
    {"RHY1", 0.0},
    {"RHY2", 0.0},
    {"RVY1", 0.0},
    {"RVY2", 0.0},
    {"RVY3", 0.0},
    {"RVY4", 0.0},
    {"RVY5", 0.0},
    {"RVY6", 0.0},
    // aligning moment, pure and combined slip
    {"QBZ1", 0.0},
    {"QBZ2", 0.0},
    {"QBZ3", 0.0},
    {"QBZ4", 0.0},
    {"QBZ5", 0.0},
    {"QBZ9", 0.0},
    {"QBZ10", 0.0},
    {"QCZ1", 0.0},
    {"QDZ1", 0.0},
    {"QDZ2", 0.0},
    {"QDZ3", 0.0},
    {"QDZ4", 0.0},
    {"QDZ6", 0.0},
    {"QDZ7", 0.0},
    {"QDZ8", 0.0},
    {"QDZ9", 0.0},
    {"QEZ1", 0.0},
    {"QEZ2", 0.0},
    {"QEZ3", 0.0},
    {"QEZ4", 0.0},
    {"QEZ5", 0.0},
    {"QHZ1", 0.0},
    {"QHZ2", 0.0},
    {"QHZ3", 0.0},
    {"QHZ4", 0.0},
    {"SSZ1", 0.0},
    {"SSZ2", 0.0},
    {"SSZ3", 0.0},
    {"SSZ4", 0.0},
    // overturning moment
    {"QSX1", 0.0},
    {"QSX2", 0.0},
    {"QSX3", 0.0},
    // relaxation lengths over load
    {"PTX1", 0.0},
    {"PTX2", 0.0},
    {"PTX3", 0.0},
    {"PTY1", 0.0},
    {"PTY2", 0.0},
    {"LSGKP", 1.0},
    {"LSGAL", 1.0},
};

/// Number of coefficients of a PAC2002 set.
inline constexpr std::size_t kPac2002Count = sizeof(kPac2002Fields) / sizeof(kPac2002Fields[0]);

/// Coefficients of a PAC2002 (MF5.2) set, in the order of kPac2002Fields; names as in .tir files.
template <class T>
struct Pac2002 {
  T unloaded_radius, fnomin;  ///< unloaded radius, m; nominal load, N: both must be given, > 0
  T lfzo, lcx, lmux, lex, lkx, lhx, lvx, lcy, lmuy, ley, lky, lhy, lvy, ltr, lres, lgax, lgay, lgaz, lxal, lyka, lvyka,
      ls, lmx, lvmx, lmy;  ///< scaling factors
  T pcx1, pdx1, pdx2, pdx3, pex1, pex2, pex3, pex4, pkx1, pkx2, pkx3, phx1, phx2, pvx1, pvx2, rbx1, rbx2, rcx1, rex1,
      rex2, rhx1;  ///< longitudinal force, pure and combined slip
  T pcy1, pdy1, pdy2, pdy3, pey1, pey2, pey3, pey4, pky1, pky2, pky3, phy1, phy2, phy3, pvy1, pvy2, pvy3, pvy4, rby1,
      rby2, rby3, rcy1, rey1, rey2, rhy1, rhy2, rvy1, rvy2, rvy3, rvy4, rvy5,
      rvy6;  ///< lateral force, pure and combined slip
  T qbz1, qbz2, qbz3, qbz4, qbz5, qbz9, qbz10, qcz1, qdz1, qdz2, qdz3, qdz4, qdz6, qdz7, qdz8, qdz9, qez1, qez2, qez3,
      qez4, qez5, qhz1, qhz2, qhz3, qhz4, ssz1, ssz2, ssz3,
      ssz4;                                      ///< aligning moment, pure and combined slip
  T qsx1, qsx2, qsx3;                            ///< overturning moment
  T ptx1, ptx2, ptx3, pty1, pty2, lsgkp, lsgal;  ///< relaxation lengths over load

  /// Takes kPac2002Count coefficients in the order of kPac2002Fields.
  static Pac2002 from_fields(const T* fields) {
    return magic::gathered<Pac2002>(fields, std::make_index_sequence<kPac2002Count>{});
  }
};

static_assert(sizeof(Pac2002<double>) == kPac2002Count * sizeof(double), "one entry in kPac2002Fields per member");

namespace magic {

template <class T>
PureLongitudinal<T> pac2002_longitudinal(const Pac2002<T>& set, const LoadTerms<T>& at, const T& kappa,
                                         const T& camber) {
  using std::exp;
  using std::sin;
  const T gamma = camber * set.lgax;
  const T friction = set.lmux * at.friction;
  const T sh = (set.phx1 + set.phx2 * at.dfz) * set.lhx * at.shifts;
  const T sv = at.load * (set.pvx1 + set.pvx2 * at.dfz) * set.lvx * friction * at.shifts;
  const T slip = kappa + sh;
  const T c = set.pcx1 * set.lcx;
  const T d = (set.pdx1 + set.pdx2 * at.dfz) * (1.0 - set.pdx3 * gamma * gamma) * friction * at.load;
  const T e = (set.pex1 + set.pex2 * at.dfz + set.pex3 * at.dfz * at.dfz) * (1.0 - set.pex4 * sign(slip)) * set.lex;
  const T stiffness = at.load * (set.pkx1 + set.pkx2 * at.dfz) * exp(set.pkx3 * at.dfz) * set.lkx;
  const T b = stiffness / away_from_zero<T>(c * d, 1e-9 * at.load);
  return {d * sin(angle<T>(b, c, curvature(e), slip)) + sv, stiffness, {b, c, d, curvature(e), slip, sv}};
}

template <class T>
PureLateral<T> pac2002_lateral(const Pac2002<T>& set, const LoadTerms<T>& at, const T& alpha, const T& camber) {
  using std::sin;
  const T gamma = camber * set.lgay;
  const T scale = set.lmuy * at.friction;
  const T sh = ((set.phy1 + set.phy2 * at.dfz) * set.lhy + set.phy3 * gamma) * at.shifts;
  const T thrust = (set.pvy1 + set.pvy2 * at.dfz) * set.lvy + (set.pvy3 + set.pvy4 * at.dfz) * gamma;
  const T sv = at.load * thrust * scale * at.shifts;
  const T slip = alpha + sh;
  const T c = set.pcy1 * set.lcy;
  const T friction = (set.pdy1 + set.pdy2 * at.dfz) * (1.0 - set.pdy3 * gamma * gamma) * scale;
  const T d = friction * at.load;
  const T e = (set.pey1 + set.pey2 * at.dfz) * (1.0 - (set.pey3 + set.pey4 * gamma) * sign(slip)) * set.ley;
  const T reach = away_from_zero<T>(set.pky2, T(1e-9));
  const T unguarded = set.pky1 * at.nominal * sin_of_double_arc<T>(at.load / (reach * at.nominal)) *
                      (1.0 - set.pky3 * abs(gamma)) * set.lky;
  const T stiffness = away_from_zero<T>(unguarded, 1e-9 * at.load);
  const T b = stiffness / away_from_zero<T>(c * d, 1e-9 * at.load);
  const PureCurve<T> curve{b, c, d, curvature(e), slip, sv};
  return {d * sin(angle<T>(b, c, curve.e, slip)) + sv, stiffness, sh + sv / stiffness, friction, curve};
}

/// Slip angle, rad, at which the trail is evaluated when there is no longitudinal slip.
template <class T>
T pac2002_trail_slip(const Pac2002<T>& set, const LoadTerms<T>& at, const T& alpha, const T& camber) {
  return alpha + set.qhz1 + set.qhz2 * at.dfz + (set.qhz3 + set.qhz4 * at.dfz) * camber * set.lgaz;
}

/// Pneumatic trail, m, before the factor cos alpha. alpha: rad, shift included; slip: rad, the same with the
/// longitudinal slip in it, of either sign. The curvature follows alpha alone, as in MF5.2.
template <class T>
T pac2002_trail(const Pac2002<T>& set, const LoadTerms<T>& at, const T& alpha, const T& slip, const T& camber) {
  using std::atan;
  using std::cos;
  const T gamma = camber * set.lgaz;
  const T b = (set.qbz1 + set.qbz2 * at.dfz + set.qbz3 * at.dfz * at.dfz) *
              (1.0 + set.qbz4 * gamma + set.qbz5 * abs(gamma)) * set.lky / (set.lmuy * at.friction);
  const T d = at.load * (set.qdz1 + set.qdz2 * at.dfz) * (1.0 + set.qdz3 * gamma + set.qdz4 * gamma * gamma) *
              (set.unloaded_radius / at.nominal) * set.ltr;
  const T e = (set.qez1 + set.qez2 * at.dfz + set.qez3 * at.dfz * at.dfz) *
              (1.0 + (set.qez4 + set.qez5 * gamma) * (2.0 / kPi) * atan(b * set.qcz1 * alpha));
  return d * cos(angle<T>(b, set.qcz1, curvature(e), slip));
}

/// Residual aligning moment, N m, at the slip angle `slip` (rad, shifts included, of either sign), before the factor
/// cos alpha.
template <class T>
T pac2002_residual_moment(const Pac2002<T>& set, const LoadTerms<T>& at, const PureLateral<T>& lateral, const T& slip,
                          const T& camber) {
  const T gamma = camber * set.lgaz;
  const T friction = set.lmuy * at.friction;
  const T b = set.qbz9 * set.lky / friction + set.qbz10 * lateral.curve.b * lateral.curve.c;
  const T d = at.load * set.unloaded_radius * friction *
              ((set.qdz6 + set.qdz7 * at.dfz) * set.lres + (set.qdz8 + set.qdz9 * at.dfz) * gamma);
  return d * cos_of_arc<T>(b * slip);
}

/// Relaxation lengths, m. Source: equation manual of MF-Tyre 5.2 (sigma_kappa and sigma_alpha).
template <class T>
T pac2002_relaxation_x(const Pac2002<T>& set, const LoadTerms<T>& at) {
  using std::exp;
  return abs(at.load / set.fnomin * (set.ptx1 + set.ptx2 * at.dfz) * exp(-set.ptx3 * at.dfz)) * set.unloaded_radius *
         set.lsgkp;
}
template <class T>
T pac2002_relaxation_y(const Pac2002<T>& set, const LoadTerms<T>& at, const T& camber) {
  const T reach = at.load / (away_from_zero<T>(set.pty2, T(1e-9)) * at.nominal);
  return abs(set.pty1 * sin_of_double_arc<T>(reach) * (1.0 - set.pky3 * abs(camber))) * set.unloaded_radius * set.lfzo *
         set.lsgal;
}

/// Overturning moment, N m, that goes with the lateral force fy.
template <class T>
T pac2002_overturning(const Pac2002<T>& set, const LoadTerms<T>& at, const T& fy, const T& camber) {
  return set.unloaded_radius * at.load *
         (set.qsx1 * set.lvmx + (set.qsx3 * fy / at.nominal - set.qsx2 * camber) * set.lmx);
}

}  // namespace magic

/// Forces of PAC2002 (MF5.2) for each slip alone: fx by kappa with alpha = 0, fy, mz and mx by alpha with kappa = 0.
/// Arguments and result as magic_formula_pac2002. Source: Pacejka, equations (4.E1) to (4.E49).
template <class T>
TyreForces<T> magic_formula_pac2002_pure(const Pac2002<T>& set, const T& fz, const T& kappa, const T& alpha,
                                         const T& gamma, const T& friction = T(1), const T& shifts = T(1)) {
  using std::cos;
  const magic::LoadTerms<T> at = magic::load_terms<T>(set.fnomin * set.lfzo, fz, friction, shifts);
  const T fx = magic::pac2002_longitudinal(set, at, kappa, gamma).force;
  const magic::PureLateral<T> lateral = magic::pac2002_lateral(set, at, alpha, gamma);
  const T trail_slip = magic::pac2002_trail_slip(set, at, alpha, gamma);
  const T trail = magic::pac2002_trail(set, at, trail_slip, trail_slip, gamma);
  const T residual = magic::pac2002_residual_moment<T>(set, at, lateral, alpha + lateral.slip_shift, gamma);
  const T mz = (residual - trail * lateral.force) * cos(alpha);
  const T mx = magic::pac2002_overturning(set, at, lateral.force, gamma);
  return {at.proportion * fx, at.proportion * lateral.force, at.proportion * mz, at.proportion * mx};
}

/// Forces of PAC2002 (MF5.2) for combined slip.
/// fz: N, vertical load; no load or less gives exactly zero. kappa: 1, longitudinal slip, positive when driving.
/// alpha: rad, tan alpha = lateral slip velocity over |forward velocity|. gamma: rad, camber. friction: 1, scales both
/// friction coefficients of the set, >= 0. shifts: 1, scales the forces at zero slip (conicity, ply steer, camber
/// thrust), which a standing tyre does not have. ellipse: combined slip by force_in_ellipse in place of the set's
/// coefficients of combined slip.
/// Result: N, N m in the set's axes; with p_Ky1 < 0 these are x forward, y left, z up, and fy opposes alpha.
/// Requires: fnomin > 0; pcx1, pcy1 not zero; lmux, lmuy > 0. Source: Pacejka, equations (4.E1) to (4.E78).
template <class T>
TyreForces<T> magic_formula_pac2002(const Pac2002<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                                    const T& friction = T(1), const T& shifts = T(1), bool ellipse = false) {
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const magic::LoadTerms<T> at = magic::load_terms<T>(set.fnomin * set.lfzo, fz, friction, shifts);
  const T dfz = at.dfz;
  const magic::PureLongitudinal<T> longitudinal = magic::pac2002_longitudinal(set, at, kappa, gamma);
  const magic::PureLateral<T> lateral = magic::pac2002_lateral(set, at, alpha, gamma);

  const T bx = set.rbx1 * magic::cos_of_arc<T>(set.rbx2 * kappa) * set.lxal;
  const T fx = ellipse
                   ? magic::force_in_ellipse(longitudinal.curve, lateral.curve)
                   : longitudinal.force * magic::weight<T>(bx, set.rcx1, set.rex1 + set.rex2 * dfz, set.rhx1, alpha);

  const T by = set.rby1 * magic::cos_of_arc<T>(set.rby2 * (alpha - set.rby3)) * set.lyka;
  const T y_weight = magic::weight<T>(by, set.rcy1, set.rey1 + set.rey2 * dfz, set.rhy1 + set.rhy2 * dfz, kappa);
  const T kappa_force = lateral.friction * at.load * (set.rvy1 + set.rvy2 * dfz + set.rvy3 * gamma) *
                        magic::cos_of_arc<T>(set.rvy4 * alpha) * sin(set.rvy5 * atan(set.rvy6 * kappa)) * set.lvyka;
  const T slip_force = ellipse ? magic::force_in_ellipse(lateral.curve, longitudinal.curve) : y_weight * lateral.force;
  const T fy = ellipse ? slip_force : slip_force + kappa_force;

  const T ratio = longitudinal.stiffness / lateral.stiffness * kappa;
  // Without the sign of the slip: trail and residual moment are even in it.
  const auto with_kappa = [&ratio](const T& slip) {
    const T tangent = sin(slip) / cos(slip);
    return atan(sqrt(tangent * tangent + ratio * ratio + magic::kRootFloor));
  };
  const T trail_slip = magic::pac2002_trail_slip(set, at, alpha, gamma);
  const T trail = magic::pac2002_trail<T>(set, at, trail_slip, with_kappa(trail_slip), gamma);
  const T residual = magic::pac2002_residual_moment<T>(set, at, lateral, with_kappa(alpha + lateral.slip_shift), gamma);
  const T arm =
      set.unloaded_radius * set.ls * (set.ssz1 + set.ssz2 * fy / at.nominal + (set.ssz3 + set.ssz4 * dfz) * gamma);
  const T mz = (residual - trail * slip_force) * cos(alpha) + arm * fx;
  const T mx = magic::pac2002_overturning(set, at, fy, gamma);
  return {at.proportion * fx, at.proportion * fy, at.proportion * mz, at.proportion * mx};
}

}  // namespace mbgen
