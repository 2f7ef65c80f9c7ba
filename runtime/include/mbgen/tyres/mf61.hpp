#pragma once
// The magic formula MF 6.1, and 6.2 as far as its equations are public, for combined slip and turn slip
// (mf61_turn_slip.hpp), over a scalar T without comparisons.
// Source: H. B. Pacejka, Tire and Vehicle Dynamics, 3rd edition, 2012, section 4.3.2, equations (4.E1) to (4.E78), with
// alpha* = tan alpha, and three readings of their authors' own programs: QBZ4 is there and QBZ6 is not (MF-Tyre 6.1.2);
// the square of (4.E69) is inside the arc tangent (I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka, Vehicle System
// Dynamics 48 (supplement), 2010, eq. 49); QSX12 to QSX14 are of MF-Tyre 6.2. Friction does not fall with the slip
// speed (LMUV of 4.E7 is 0). docs/use/tyres.md lists readings.

#include "mbgen/tyres/mf61_turn_slip.hpp"

namespace mbgen {

namespace magic {

/// N/m, that a length is divided by: far below any tyre's.
inline constexpr double kLeastCarcass = 1;

/// Load and pressure with their terms that every formula needs.
template <class T>
struct Mf61State : LoadTerms<T> {
  T dpi;  ///< 1, relative deviation from the nominal pressure
};

template <class T>
Mf61State<T> mf61_state(const MagicFormula61<T>& set, const T& fz, const T& pressure, const T& friction,
                        const T& shifts) {
  return {load_terms<T>(set.fnomin * set.lfzo, fz, friction, shifts), pressure / set.nompres - 1.0};
}

/// 1 + a x + b x^2.
template <class T>
T parabola(const T& a, const T& b, const T& x) {
  return 1.0 + (a + b * x) * x;
}

/// Factor of friction of the vertical shifts, which fade out later than friction does: (4.E8), A_mu = 10.
template <class T>
T digressive(const T& friction) {
  constexpr double kDigression = 10;
  return kDigression * friction / (1.0 + (kDigression - 1) * friction);
}

/// (4.E9) to (4.E18).
template <class T>
PureLongitudinal<T> mf61_longitudinal(const MagicFormula61<T>& set, const Mf61State<T>& at, const T& kappa,
                                      const T& gamma, const Mf61Turn<T>& turn = {}) {
  using std::exp;
  using std::sin;
  const T dfz = at.dfz;
  const T friction = set.lmux * at.friction, zeta_1 = mf61_zeta_1(set, dfz, kappa, turn);
  const T sh = (set.phx1 + set.phx2 * dfz) * set.lhx * at.shifts;
  const T sv = at.load * (set.pvx1 + set.pvx2 * dfz) * set.lvx * at.shifts * digressive(friction) * zeta_1;
  const T slip = kappa + sh;
  const T c = set.pcx1 * set.lcx;
  const T d = (set.pdx1 + set.pdx2 * dfz) * parabola<T>(set.ppx3, set.ppx4, at.dpi) * (1.0 - set.pdx3 * gamma * gamma) *
              friction * at.load * zeta_1;
  const T e = (set.pex1 + set.pex2 * dfz + set.pex3 * dfz * dfz) * (1.0 - set.pex4 * sign(slip)) * set.lex;
  const T stiffness =
      at.load * (set.pkx1 + set.pkx2 * dfz) * exp(set.pkx3 * dfz) * parabola<T>(set.ppx1, set.ppx2, at.dpi) * set.lkx;
  const T b = stiffness / away_from_zero<T>(c * d, 1e-9 * at.load);
  return {d * sin(angle<T>(b, c, curvature(e), slip)) + sv, stiffness, {b, c, d, curvature(e), slip, sv}};
}

/// K_yalpha without spin, N/rad: (4.E25), not held away from zero. sine: of the camber.
template <class T>
T mf61_cornering_stiffness(const MagicFormula61<T>& set, const Mf61State<T>& at, const T& sine) {
  using std::atan;
  using std::sin;
  const T reach = (set.pky2 + set.pky5 * (sine * sine)) * (1.0 + set.ppy2 * at.dpi);
  return set.pky1 * at.nominal * (1.0 + set.ppy1 * at.dpi) * (1.0 - set.pky3 * abs(sine)) *
         sin(set.pky4 * atan(at.load / (at.nominal * reach))) * set.lky;
}

/// (4.E19) to (4.E30), its slip_shift (4.E38). tangent: of the slip angle; sine: of the camber.
template <class T>
PureLateral<T> mf61_lateral(const MagicFormula61<T>& set, const Mf61State<T>& at, const T& tangent, const T& sine,
                            const Mf61Turn<T>& turn = {}) {
  using std::sin;
  const T dfz = at.dfz, square = sine * sine;
  const T scale = set.lmuy * at.friction, of_shift = digressive(scale);
  const T zeta_2 = mf61_zeta_2<T>(set, dfz, tangent, turn);
  const T stiffness =
      away_from_zero<T>(mf61_cornering_stiffness(set, at, sine) * mf61_zeta_3(set, turn), 1e-9 * at.load);
  const T camber_stiffness = at.load * (set.pky6 + set.pky7 * dfz) * (1.0 + set.ppy5 * at.dpi) * set.lkyc;
  const T thrust = at.load * (set.pvy3 + set.pvy4 * dfz) * sine * set.lkyc * of_shift * zeta_2;
  const T sv = (at.load * (set.pvy1 + set.pvy2 * dfz) * set.lvy * of_shift * zeta_2 + thrust) * at.shifts;
  const T of_camber = turn.acts ? mf61_spin_shift<T>(set, dfz, at.load, camber_stiffness,
                                                     mf61_cornering_stiffness(set, at, T(0)), turn) -
                                      thrust / stiffness
                                : (camber_stiffness * sine - thrust) / stiffness;
  const T sh = ((set.phy1 + set.phy2 * dfz) * set.lhy + of_camber) * at.shifts;
  const T slip = tangent + sh;
  const T c = set.pcy1 * set.lcy;
  const T friction =
      (set.pdy1 + set.pdy2 * dfz) * parabola<T>(set.ppy3, set.ppy4, at.dpi) * (1.0 - set.pdy3 * square) * scale;
  const T d = friction * at.load * zeta_2;
  const T e =
      (set.pey1 + set.pey2 * dfz) * (1.0 + set.pey5 * square - (set.pey3 + set.pey4 * sine) * sign(slip)) * set.ley;
  const T b = stiffness / away_from_zero<T>(c * d, 1e-9 * at.load);
  const PureCurve<T> curve{b, c, d, curvature(e), slip, sv};
  return {d * sin(angle<T>(b, c, curve.e, slip)) + sv, stiffness, sh + sv / stiffness, friction, curve};
}

/// Pneumatic trail, m, before the factor cos alpha: (4.E33) to (4.E35), (4.E40) to (4.E44). tangent: of the slip angle,
/// shift included; slip: the same with the longitudinal slip in it, of either sign.
template <class T>
T mf61_trail(const MagicFormula61<T>& set, const Mf61State<T>& at, const T& tangent, const T& slip, const T& sine) {
  using std::atan;
  using std::cos;
  const T dfz = at.dfz;
  const T b = (set.qbz1 + set.qbz2 * dfz + set.qbz3 * dfz * dfz) * (1.0 + set.qbz4 * sine + set.qbz5 * abs(sine)) *
              set.lky / (set.lmuy * at.friction);
  const T d = at.load * (set.unloaded_radius / at.nominal) * (set.qdz1 + set.qdz2 * dfz) * (1.0 - set.ppz1 * at.dpi) *
              (1.0 + set.qdz3 * abs(sine) + set.qdz4 * sine * sine) * set.ltr;
  const T e = (set.qez1 + set.qez2 * dfz + set.qez3 * dfz * dfz) *
              (1.0 + (set.qez4 + set.qez5 * sine) * (2.0 / kPi) * atan(b * set.qcz1 * tangent));
  return d * cos(angle<T>(b, set.qcz1, curvature(e), slip));
}

/// Residual aligning moment, N m.
template <class T>
struct ResidualMoment {
  T aligning;  ///< before its factor cos alpha
  T turning;   ///< of spin
};

/// (4.E45) to (4.E47) where turn slip acts. slip: as in mf61_residual_moment; weight: G_ykappa.
template <class T>
ResidualMoment<T> mf61_residual_of_spin(const MagicFormula61<T>& set, const Mf61State<T>& at,
                                        const PureLateral<T>& lateral, const T& slip, const T& sine, const T& zeta_2,
                                        const T& weight, const Mf61Turn<T>& turn) {
  using std::atan;
  using std::cos;
  const T friction = set.lmuy * at.friction;
  const T zeta_6 = cos_of_arc<T>(set.qbrp1 * turn.spin);
  const T b = (set.qbz9 * set.lky / friction + set.qbz10 * lateral.curve.b * lateral.curve.c) * zeta_6;
  const T moment = mf61_turn_moment<T>(set, at.dfz, at.load, sine, turn);
  const T shape = cos(mf61_zeta_7<T>(set, moment, weight, turn) * atan(b * slip));
  return {at.load * set.unloaded_radius * friction * (set.qdz6 + set.qdz7 * at.dfz) * set.lres * zeta_2 * shape,
          -moment * shape};
}

/// Residual aligning moment, N m, before its factor cos alpha: (4.E36), (4.E45) to (4.E47). slip: tangent of the slip
/// angle, shifts and longitudinal slip included, of either sign.
template <class T>
T mf61_residual_moment(const MagicFormula61<T>& set, const Mf61State<T>& at, const PureLateral<T>& lateral,
                       const T& slip, const T& sine) {
  const T friction = set.lmuy * at.friction;
  const T b = set.qbz9 * set.lky / friction + set.qbz10 * lateral.curve.b * lateral.curve.c;
  const T of_camber =
      (set.qdz8 + set.qdz9 * at.dfz) * (1.0 + set.ppz2 * at.dpi) + (set.qdz10 + set.qdz11 * at.dfz) * abs(sine);
  const T d = at.load * set.unloaded_radius * friction *
              ((set.qdz6 + set.qdz7 * at.dfz) * set.lres + of_camber * sine * set.lkzc);
  return d * cos_of_arc<T>(b * slip);
}

/// Overturning moment, N m, that goes with the lateral force fy: (4.E69) with its square inside the arc tangent, and
/// the terms of MF-Tyre 6.2.
template <class T>
T mf61_overturning(const MagicFormula61<T>& set, const Mf61State<T>& at, const T& fy, const T& gamma) {
  using std::atan;
  using std::cos;
  using std::sin;
  const T load = at.load / set.fnomin, side = fy / set.fnomin;
  const T reach = set.qsx6 * load;
  const T of_side =
      set.qsx4 * cos(set.qsx5 * atan(reach * reach)) * sin(set.qsx7 * gamma + set.qsx8 * atan(set.qsx9 * side));
  const T of_camber =
      set.qsx10 * atan(set.qsx11 * load) - set.qsx2 * (1.0 + set.ppmx1 * at.dpi) - set.qsx12 * abs(gamma);
  return set.unloaded_radius * set.lmx *
         (at.load * (set.qsx1 * set.lvmx + of_camber * gamma + set.qsx3 * side + of_side) +
          fy * (set.qsx13 + set.qsx14 * abs(gamma)));
}

/// Relaxation lengths, m, of an upright tyre: slip stiffness over carcass stiffness. Source: I. J. M. Besselink, A. J.
/// C. Schmeitz, H. B. Pacejka, "An improved Magic Formula/Swift tyre model that can handle inflation pressure changes",
/// Vehicle System Dynamics 48 (supplement), 2010.
template <class T>
T mf61_relaxation_x(const MagicFormula61<T>& set, const Mf61State<T>& at) {
  const T carcass = set.longitudinal_stiffness * parabola<T>(set.pcfx1, set.pcfx2, at.dfz) * (1.0 + set.pcfx3 * at.dpi);
  return abs(mf61_longitudinal<T>(set, at, T(0), T(0)).stiffness) / max(carcass, T(kLeastCarcass));
}
template <class T>
T mf61_relaxation_y(const MagicFormula61<T>& set, const Mf61State<T>& at) {
  const T carcass = set.lateral_stiffness * parabola<T>(set.pcfy1, set.pcfy2, at.dfz) * (1.0 + set.pcfy3 * at.dpi);
  return abs(mf61_lateral<T>(set, at, T(0), T(0)).stiffness) / max(carcass, T(kLeastCarcass));
}

/// A motion under load in the axes of MF 6.1: arguments of magic_formula_61 that go together.
template <class T>
struct Mf61Slips {
  T kappa, alpha, gamma;  ///< 1, rad, rad
};

}  // namespace magic

/// Forces of MF 6.1, and of them the moment of spin, N m, which is not in `forces`.
template <class T>
struct Mf61Forces {
  TyreForces<T> forces;
  T turning;
};

/// Forces of MF 6.1 for combined slip and turn slip.
/// fz: N, vertical load; no load or less gives exactly zero. slips: kappa positive when driving; alpha below pi/2, its
/// tangent is the lateral slip velocity over |forward velocity|; gamma: camber. pressure: Pa. friction, shifts and the
/// result as in magic_formula_pac2002, ellipse too; the aligning moment holds for rolling forward, the moment of
/// spin for either direction. Requires: unloaded_radius, fnomin, nompres > 0; pcx1, pcy1, pky2 not zero; lmux, lmuy
/// positive; where turn slip acts phyp1, phyp2, qdrp1 not zero. Source: Pacejka (2012), equations (4.E1) to (4.E78),
/// with the readings at the head of this file.
template <class T>
Mf61Forces<T> mf61_forces(const MagicFormula61<T>& set, const T& fz, const magic::Mf61Slips<T>& slips,
                          const T& pressure, const T& friction, const T& shifts, const magic::Mf61Turn<T>& turn,
                          bool ellipse = false) {
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const magic::Mf61State<T> at = magic::mf61_state<T>(set, fz, pressure, friction, shifts);
  const T dfz = at.dfz, kappa = slips.kappa;
  const T sine = sin(slips.gamma), cosine = cos(slips.alpha), tangent = sin(slips.alpha) / cosine;
  const magic::PureLongitudinal<T> longitudinal = magic::mf61_longitudinal<T>(set, at, kappa, slips.gamma, turn);
  const magic::PureLateral<T> lateral = magic::mf61_lateral<T>(set, at, tangent, sine, turn);
  const T zeta_2 = magic::mf61_zeta_2<T>(set, dfz, tangent, turn);

  const T bx = (set.rbx1 + set.rbx3 * sine * sine) * magic::cos_of_arc<T>(set.rbx2 * kappa) * set.lxal;
  const T fx = ellipse
                   ? magic::force_in_ellipse(longitudinal.curve, lateral.curve)
                   : longitudinal.force * magic::weight<T>(bx, set.rcx1, set.rex1 + set.rex2 * dfz, set.rhx1, tangent);

  const auto y_weight = [&](const T& square) {
    const T b = (set.rby1 + set.rby4 * square) * magic::cos_of_arc<T>(set.rby2 * (tangent - set.rby3)) * set.lyka;
    return magic::weight<T>(b, set.rcy1, set.rey1 + set.rey2 * dfz, set.rhy1 + set.rhy2 * dfz, kappa);
  };
  const T kappa_force = lateral.friction * at.load * (set.rvy1 + set.rvy2 * dfz + set.rvy3 * sine) *
                        magic::cos_of_arc<T>(set.rvy4 * tangent) * sin(set.rvy5 * atan(set.rvy6 * kappa)) * set.lvyka *
                        zeta_2;
  const T fy = ellipse ? magic::force_in_ellipse(lateral.curve, longitudinal.curve)
                       : y_weight(sine * sine) * lateral.force + kappa_force;

  // The trail meets the side force of an upright wheel without spin: (4.E74).
  const magic::PureLateral<T> upright = magic::mf61_lateral<T>(set, at, tangent, T(0));
  const T ratio = longitudinal.stiffness / lateral.stiffness * kappa;
  const auto with_kappa = [&ratio](const T& slip) { return sqrt(slip * slip + ratio * ratio + magic::kRootFloor); };
  const T trail_slip = tangent + set.qhz1 + set.qhz2 * dfz + (set.qhz3 + set.qhz4 * dfz) * sine;
  const T trail =
      magic::mf61_trail<T>(set, at, trail_slip, with_kappa(trail_slip), sine) * magic::mf61_zeta_5(set, turn);
  const T residual_slip = with_kappa(tangent + lateral.slip_shift);
  magic::ResidualMoment<T> residual{T(0), T(0)};
  if (turn.acts)
    residual =
        magic::mf61_residual_of_spin<T>(set, at, lateral, residual_slip, sine, zeta_2, y_weight(sine * sine), turn);
  else
    residual.aligning = magic::mf61_residual_moment<T>(set, at, lateral, residual_slip, sine);
  const T arm =
      set.unloaded_radius * set.ls * (set.ssz1 + set.ssz2 * fy / at.nominal + (set.ssz3 + set.ssz4 * dfz) * sine);
  const T of_trail = ellipse ? trail * magic::force_in_ellipse(upright.curve, longitudinal.curve)
                             : trail * y_weight(T(0)) * upright.force;
  const T mz = (residual.aligning - of_trail) * cosine + arm * fx;
  const T mx = magic::mf61_overturning<T>(set, at, fy, slips.gamma);
  return {{at.proportion * fx, at.proportion * fy, at.proportion * mz, at.proportion * mx},
          at.proportion * residual.turning};
}

/// The same without turn slip.
template <class T>
TyreForces<T> magic_formula_61(const MagicFormula61<T>& set, const T& fz, const magic::Mf61Slips<T>& slips,
                               const T& pressure, const T& friction = T(1), const T& shifts = T(1),
                               bool ellipse = false) {
  return mf61_forces<T>(set, fz, slips, pressure, friction, shifts, magic::Mf61Turn<T>{}, ellipse).forces;
}

/// Rolling resistance moment of MF 6.1, N m, against the rolling, >= 0 in the range of a fit; (4.E70).
/// fx: N, longitudinal force; vx: m/s, forward velocity. Load, pressure and camber as in magic_formula_61.
template <class T>
T mf61_rolling_resistance(const MagicFormula61<T>& set, const T& fz, const T& fx, const T& vx, const T& gamma,
                          const T& pressure) {
  using std::pow;
  const T load = max(fz, magic::kLeastLoad * set.fnomin), over = load / set.fnomin;
  const T speed = abs(vx) / set.longvl, square = speed * speed;
  const T share = set.qsy1 + set.qsy2 * fx / set.fnomin + set.qsy3 * speed + set.qsy4 * square * square +
                  (set.qsy5 + set.qsy6 * over) * gamma * gamma;
  return max(fz, T(0)) * set.unloaded_radius * share * pow(over, set.qsy7) * pow(T(pressure / set.nompres), set.qsy8) *
         set.lmy;
}

}  // namespace mbgen
