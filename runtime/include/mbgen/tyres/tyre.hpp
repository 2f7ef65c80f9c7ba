#pragma once
// A tyre on a flat road: load, slips with relaxation down to rest, turning, forces and moments at the contact point.

#include "mbgen/tyres/mf61.hpp"
#include "mbgen/tyres/pac2002.hpp"
#include "mbgen/tyres/pac89.hpp"

namespace mbgen {

/// Moment about the road's normal: none, of a patch, or of a patch at rest and turn slip at speed (MF 6.1 only).
enum class Turning { none, patch, turn_slip };

/// Properties of a mounted tyre. Units as stated, of one tyre.
template <class T>
struct TyreProperties {
  T radius;                      ///< m, unloaded, > 0
  T stiffness, damping;          ///< N/m and N s/m, vertical
  T friction;                    ///< scales the friction of the coefficient set, 1 is the measured one, >= 0
  T rolling_resistance;          ///< 1, moment over load and radius
  T relaxation_x, relaxation_y;  ///< m, relaxation lengths, > 0
  T low_speed;                   ///< m/s, > 0: below it slip is damped, and the moments of rolling fade out
  T side = T(1);                 ///< -1 mirrors the coefficient set (tyre measured on the other side), else 1
  T count = T(1);                ///< tyres side by side; forces, moments and load times count
  T pressure = T(0);             ///< Pa, of inflation; of MF 6.1 alone
  /// 1: the set gives this relaxation length over load, the property is it at the nominal load; else 0
  T over_load_x = T(0), over_load_y = T(0);
  T turn_stiffness = T(0);  ///< N m/rad, of the patch against turning under turn_load, > 0 unless turning is none
  T turn_radius = T(0);     ///< m, moment of a patch that turns over its friction under turn_load, likewise
  T turn_load = T(0);       ///< N, likewise
  Turning turning = Turning::none;
  bool ellipse = false;  ///< combined slip of Pac2002 and MF 6.1 by force_in_ellipse, not by the set
};

/// Motion of the wheel in its contact frame: origin at the contact point, x along the wheel's heading on the road,
/// y to the left, z the road's normal (up).
template <class T>
struct TyreContact {
  T deflection;        ///< m, unloaded radius less the distance of the wheel centre from the contact point
  T deflection_rate;   ///< m/s, its time derivative
  T vx;                ///< m/s, velocity of the wheel centre along x
  T vy;                ///< m/s, velocity of the contact point (moving with the wheel, without its spin) along y
  T spin;              ///< rad/s, about the wheel's axis (the one to the left), positive when rolling forward
  T camber;            ///< rad, rotation of the wheel plane from upright about x, top to the right positive
  T u, v;              ///< m, deflection states along x and y, see TyreResult
  T turn_rate = T(0);  ///< rad/s, of the heading about z
  T turn = T(0);       ///< rad, deflection state about z, of a tyre with turning
};

/// Force and moment of a tyre on its wheel, at the contact point in contact axes; rates of its deflection states.
template <class T>
struct TyreResult {
  T load, fx, fy;  ///< N: along z, x, y; load >= 0
  T mx, my, mz;    ///< N m: overturning, about the wheel's axis, aligning
  T du, dv;        ///< m/s, rates of u and v
  T kappa, alpha;  ///< slips behind the forces: 1, driving positive; rad, sliding left positive
  T dturn = T(0);  ///< rad/s, rate of the turn
};

namespace tyre_law {

/// Slip per slip velocity, s/m, that damps a standing contact: a damping ratio of about 0.2 for a vehicle that rocks on
/// its tyres, and within reach of explicit steps of 1 ms for a truck's wheel that rocks by its own inertia (900 1/s).
inline constexpr double kSlipDamping = 0.06;
/// Deflection over relaxation length at which a standing contact slides: about friction over stiffness.
inline constexpr double kSlidingDeflection = 0.1;
/// The same at speed, where the memory of the contact no longer matters but the rates of a fast slip do.
inline constexpr double kSlidingDeflectionAtSpeed = 0.5;
/// Limits of a relaxation length that follows the load, over that at nominal load.
inline constexpr double kShortestRelaxation = 0.2, kLongestRelaxation = 5;
/// Largest resultant slip as an argument of the formulas, which are fitted to measurements below it.
inline constexpr double kLargestSlip = 1.5;
/// s, by which a standing patch that turns is damped: a ratio of about 0.3 for a wheel that swings about its kingpin.
inline constexpr double kTurnDamping = 0.02;
/// Least friction of a patch that turns: below it stiffness falls with friction, in place of the angle of sliding.
inline constexpr double kLeastTurnFriction = 0.05;
/// Largest spin as an argument of the formulas, over the unloaded radius; the tightest tests have about 1.
inline constexpr double kLargestSpin = 30;

/// Growth of the radius of an unloaded tyre with its spin, m.
/// Source: Pacejka (2012), section 4.3.4 (R_Omega).
template <class T>
T growth(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  const T speed = contact.spin * tyre.radius / set.longvl;
  return tyre.radius * (set.q_re0 - 1.0 + set.q_v1 * speed * speed);
}

/// Force of the vertical spring, N, >= 0.
template <class Set, class T>
T spring(const Set&, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  return max(tyre.stiffness * contact.deflection, T(0));
}

/// `stiffness` is the slope at nominal load and pressure, at rest and upright. Without the influence of the horizontal
/// forces, which depend on the load themselves. Source: Pacejka (2012), equation (4.E68), its q_Fz1 from the slope.
template <class T>
T spring(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  using std::sqrt;
  const T pressed = max(contact.deflection + growth(set, tyre, contact), T(0)) / tyre.radius;
  const T slope = tyre.stiffness * tyre.radius / set.fnomin;
  const T linear = sqrt(max(slope * slope - 4.0 * set.q_fz2, T(0))) + set.q_fz3 * contact.camber * contact.camber;
  const T by_speed = 1.0 + set.q_v2 * abs(contact.spin) * tyre.radius / set.longvl;
  const T by_pressure = 1.0 + set.pfz1 * (tyre.pressure / set.nompres - 1.0);
  return set.fnomin * max((linear + set.q_fz2 * pressed) * pressed, T(0)) * by_speed * by_pressure;
}

/// Vertical load of one tyre, N: spring and damper without adhesion. The damper's compression force is limited to the
/// spring's force, so that the load grows from zero at touchdown at any speed.
template <class Set, class T>
T load(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  const T force = spring(set, tyre, contact);
  return max(force + min(tyre.damping * contact.deflection_rate, force), T(0));
}

/// Effective rolling radius, m: a third of the deflection below the unloaded radius.
/// Source: G. Rill, Road Vehicle Dynamics, section 3.2 (r_D = 2/3 r_0 + 1/3 r_S).
template <class Set, class T>
T rolling_radius(const Set&, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  return tyre.radius - max(contact.deflection, T(0)) * (1.0 / 3.0);
}

/// Source: Pacejka (2012), section 4.3.4 (r_e over the load); FREFF = 1/3 alone is Rill's.
template <class T>
T rolling_radius(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  using std::atan;
  const T share = spring(set, tyre, contact) / set.fnomin;
  const T stiffness = tyre.stiffness * (1.0 + set.pfz1 * (tyre.pressure / set.nompres - 1.0));
  return tyre.radius + growth(set, tyre, contact) -
         set.fnomin / stiffness * (set.dreff * atan(set.breff * share) + set.freff * share);
}

/// Relaxation lengths, m.
template <class T>
struct Relaxation {
  T x, y;
};

template <class T>
Relaxation<T> relaxation(const Pac89<T>&, const TyreProperties<T>& tyre, const TyreContact<T>&) {
  return {tyre.relaxation_x, tyre.relaxation_y};
}

/// Over the load where the set gives it, within limits: a tyre that lifts off would ask for ever smaller steps.
template <class T>
Relaxation<T> over_load(const TyreProperties<T>& tyre, const Relaxation<T>& of_set) {
  const auto chosen = [](const T& flag, const T& property, const T& over) {
    const T limited = min(max(over, kShortestRelaxation * property), kLongestRelaxation * property);
    return property + flag * (limited - property);
  };
  return {chosen(tyre.over_load_x, tyre.relaxation_x, of_set.x), chosen(tyre.over_load_y, tyre.relaxation_y, of_set.y)};
}

template <class T>
Relaxation<T> relaxation(const Pac2002<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  const magic::LoadTerms<T> at =
      magic::load_terms<T>(set.fnomin * set.lfzo, load(set, tyre, contact), tyre.friction, T(1));
  return over_load<T>(tyre,
                      {magic::pac2002_relaxation_x(set, at), magic::pac2002_relaxation_y<T>(set, at, contact.camber)});
}

template <class T>
Relaxation<T> relaxation(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  const magic::Mf61State<T> at =
      magic::mf61_state<T>(set, load(set, tyre, contact), tyre.pressure, tyre.friction, T(1));
  return over_load<T>(tyre, {magic::mf61_relaxation_x(set, at), magic::mf61_relaxation_y(set, at)});
}

/// Slips that the forces follow, and the rates of the deflection states.
template <class T>
struct Slip {
  T kappa, alpha;  ///< 1, rad
  T du, dv;        ///< m/s
  T rolling;       ///< 1, 0 for a standing tyre, 1 from low_speed on
};

/// Slips with relaxation, valid down to rest.
///
///   du/dt = -Vsx - (|Vx| + |Vs| / r) u / sigma_x        q = (u / sigma_x, v / sigma_y),  Vsx = Vx - Omega R_e
///   dv/dt = -Vsy - (|Vx| + |Vs| / r) v / sigma_y        kappa = q_x / (1 - |q| / r),  tan alpha = -q_y / (1 - |q| / r)
///
/// A standing contact deflects by at most r sigma, then slides. In steady rolling, at any resultant slip up to
/// kLargestSlip, kappa = -Vsx / |Vx| and tan alpha = Vsy / |Vx| exactly, whatever r; small slips relax over sigma as in
/// the linear law. The limit r = kSlidingDeflection (1 + (|Vx| + |Vs|) / low_speed), at most kSlidingDeflectionAtSpeed,
/// widens with speed, so that a spinning or locked wheel does not ask for small steps.
/// Below low_speed a term in Vs that fades out with the speed, and where the contact slides, damps it.
/// Source: Pacejka, sections 8.3 and 8.6 (linear relaxation, low-speed damping); the limit is the transport form of
/// P. R. Dahl's friction, "Solid Friction Damping of Mechanical Vibrations", AIAA Journal 14(12), 1976.
template <class Set, class T>
Slip<T> slip(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  using std::atan;
  using std::cos;
  using std::sqrt;
  const T vsx = contact.vx - contact.spin * rolling_radius(set, tyre, contact);
  const T vsy = contact.vy;
  const T speed = abs(contact.vx);
  const T slip_speed = sqrt(vsx * vsx + vsy * vsy + magic::kRootFloor);
  const T limit = min(kSlidingDeflection * (1.0 + (speed + slip_speed) / tyre.low_speed), T(kSlidingDeflectionAtSpeed));
  const Relaxation<T> sigma = relaxation(set, tyre, contact);
  const T qx = contact.u / sigma.x;
  const T qy = contact.v / sigma.y;
  const T q = sqrt(qx * qx + qy * qy + magic::kRootFloor);
  const T transport = speed + slip_speed / limit;
  const T sticking = 1.0 - q / limit;
  const T growth = 1.0 / max(sticking, q * (1.0 / kLargestSlip));
  const T fade = 0.5 + 0.5 * cos(magic::kPi * min(speed / tyre.low_speed, T(1)));
  const T damping = kSlipDamping * fade * max(sticking, T(0));
  return {qx * growth - damping * vsx, atan(damping * vsy - qy * growth), -vsx - transport * qx, -vsy - transport * qy,
          1.0 - fade};
}

/// Friction of the lateral peak, 1, >= 0.
template <class T>
T peak_friction(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                const T& load) {
  using std::sin;
  const magic::Mf61State<T> at = magic::mf61_state<T>(set, load, tyre.pressure, tyre.friction, T(1));
  return abs(magic::mf61_lateral<T>(set, at, T(0), sin(contact.camber)).friction);
}
template <class T>
T peak_friction(const Pac2002<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact, const T& load) {
  const magic::LoadTerms<T> at = magic::load_terms<T>(set.fnomin * set.lfzo, load, tyre.friction, T(1));
  return abs(magic::pac2002_lateral<T>(set, at, T(0), contact.camber).friction);
}
template <class T>
T peak_friction(const Pac89<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>&, const T& load) {
  return abs(1e-3 * (set.a[1] * (1e-3 * load) + set.a[2])) * tyre.friction;
}

/// A patch that turns about the road's normal.
template <class T>
struct TurningPatch {
  T limit;   ///< N m, its moment when it turns on the spot
  T share;   ///< 1, its deflection over that at which it slides
  T moment;  ///< N m, of the deflection and its damping
  T speed;   ///< m/s, V_c, of its centre
  T spin;    ///< 1/m, -(d psi/dt) / V_c in steady rolling
  T rate;    ///< rad/s, of the deflection
};

/// The patch as P. R. Dahl's friction about the road's normal, which rolling carries away:
///
///   d turn/dt = -d psi/dt - (V_c / length + |d psi/dt| / angle) turn,    moment = limit turn / angle
///
/// At rest the moment grows by limit / angle = turn_stiffness (Fz / turn_load)^(3/2) and reaches limit = turn_radius
/// mu Fz sqrt(Fz / turn_load); in steady rolling turn / (1 - |turn| / angle) / length = -(d psi/dt) / V_c exactly. The
/// length is about half the patch's under turn_load. Below low_speed a term in d psi/dt that fades out with the
/// speed, and where the patch slides, damps it. load: N, of one tyre; rolling: 1, see Slip.
/// Source: Pacejka (2012), equation (4.95) for the limit over the load (a patch whose length grows with the root of its
/// load has the same exponent), (4.76) for the spin; Dahl as in `slip`.
template <class Set, class T>
TurningPatch<T> turning_patch(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                              const T& load, const T& rolling) {
  using std::sqrt;
  const T friction = peak_friction(set, tyre, contact, load);
  const T angle = max(friction, T(kLeastTurnFriction)) * tyre.turn_radius * tyre.turn_load / tyre.turn_stiffness;
  const T length = sqrt(tyre.radius * tyre.turn_load / tyre.stiffness);
  TurningPatch<T> patch;
  patch.limit = tyre.turn_radius * friction * load * sqrt(max(load / tyre.turn_load, T(magic::kLeastLoad)));
  patch.share = contact.turn / angle;
  const T damping = kTurnDamping * (1.0 - rolling) * max(1.0 - abs(patch.share), T(0));
  patch.moment = patch.limit * (patch.share - damping * contact.turn_rate / angle);
  patch.speed = sqrt(contact.vx * contact.vx + contact.vy * contact.vy + magic::kRootFloor);
  const T along = contact.turn / length;
  patch.spin = along / max(1.0 - abs(patch.share), abs(along) * (tyre.radius / kLargestSpin));
  patch.rate = -contact.turn_rate - (patch.speed / length + abs(contact.turn_rate) / angle) * contact.turn;
  return patch;
}

/// Spin for the formulas of MF 6.1, whose axes are mirrored for side -1; it fades in with the speed, as the shifts do.
/// Camber spins a wheel by its own rolling: (4.75).
template <class T>
magic::Mf61Turn<T> spin_of(const MagicFormula61<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                           const T& load, const T& rolling, const TurningPatch<T>& patch) {
  using std::sin;
  constexpr double kLeastSpeed = 0.05;  // of low_speed
  const T nominal = set.fnomin * set.lfzo, sine = sin(contact.camber);
  const T share = magic::mf61_camber_share<T>(set, (load - nominal) / nominal);
  const T speed = max(patch.speed, kLeastSpeed * tyre.low_speed);
  const T of_camber = -share * (contact.spin - contact.turn_rate * sine) * sine / speed;
  const T scale = tyre.side * rolling * set.unloaded_radius;
  return {scale * (patch.spin + of_camber), scale * patch.spin, magic::sign(contact.vx), patch.limit, true};
}

/// Forces of the set in contact axes (x forward, y left, z up). shifts: see magic_formula_pac2002.
template <class T>
TyreForces<T> formula(const Pac2002<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                      const TyreProperties<T>& tyre, const T& shifts) {
  return magic_formula_pac2002(set, fz, kappa, alpha, gamma, tyre.friction, shifts, tyre.ellipse);
}

template <class T>
TyreForces<T> formula(const MagicFormula61<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                      const TyreProperties<T>& tyre, const T& shifts) {
  return magic_formula_61<T>(set, fz, {kappa, alpha, gamma}, tyre.pressure, tyre.friction, shifts, tyre.ellipse);
}

template <class T>
TyreForces<T> formula(const Pac89<T>& set, const T& fz, const T& kappa, const T& alpha, const T& gamma,
                      const TyreProperties<T>& tyre, const T& shifts) {
  const TyreForces<T> forces = magic_formula_pac89(set, fz, kappa, alpha, gamma, tyre.friction, shifts);
  return {forces.fx, -forces.fy, -forces.mz, forces.mx};
}

/// Forces of the set, with the patch that turns under it.
template <class T>
struct TurnedForces {
  TyreForces<T> forces;
  T turning;  ///< N m, about the road's normal, not in `forces` and not in the axes of a mirrored set
  T rate;     ///< rad/s, of the deflection of the patch
};

/// Forces of the set without turn slip.
template <class Set, class T>
TyreForces<T> straight_forces(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                              const T& load, const Slip<T>& slip) {
  return formula<T>(set, load, slip.kappa, tyre.side * slip.alpha, tyre.side * contact.camber, tyre, slip.rolling);
}

/// Turn slip of the set where the tyre has it; else, and at rest, the moment of the patch.
template <class Set, class T>
TurnedForces<T> with_turn_slip(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                               const T& load, const Slip<T>& slip, const TurningPatch<T>& patch) {
  return {straight_forces(set, tyre, contact, load, slip), patch.moment, patch.rate};
}
template <class T>
TurnedForces<T> with_turn_slip(const MagicFormula61<T>& set, const TyreProperties<T>& tyre,
                               const TyreContact<T>& contact, const T& load, const Slip<T>& slip,
                               const TurningPatch<T>& patch) {
  if (tyre.turning != Turning::turn_slip)
    return with_turn_slip<MagicFormula61<T>, T>(set, tyre, contact, load, slip, patch);
  const magic::Mf61Turn<T> turn = spin_of(set, tyre, contact, load, slip.rolling, patch);
  const Mf61Forces<T> of_spin =
      mf61_forces<T>(set, load, {slip.kappa, tyre.side * slip.alpha, tyre.side * contact.camber}, tyre.pressure,
                     tyre.friction, slip.rolling, turn, tyre.ellipse);
  return {of_spin.forces, patch.moment + slip.rolling * (tyre.side * of_spin.turning - patch.moment), patch.rate};
}

template <class Set, class T>
TurnedForces<T> turned_forces(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact,
                              const T& load, const Slip<T>& slip) {
  if (tyre.turning == Turning::none) return {straight_forces(set, tyre, contact, load, slip), T(0), T(0)};
  return with_turn_slip(set, tyre, contact, load, slip, turning_patch(set, tyre, contact, load, slip.rolling));
}

/// Moment against the rolling of a tyre under `load` with the longitudinal force fx, N m.
template <class T>
T rolling_resistance(const Pac2002<T>& set, const TyreProperties<T>& tyre, const TyreContact<T>&, const T& load,
                     const T&) {
  return tyre.rolling_resistance * set.lmy * load * tyre.radius;
}

template <class T>
T rolling_resistance(const Pac89<T>&, const TyreProperties<T>& tyre, const TyreContact<T>&, const T& load, const T&) {
  return tyre.rolling_resistance * load * tyre.radius;
}

/// The property replaces the set's QSY1.
template <class T>
T rolling_resistance(MagicFormula61<T> set, const TyreProperties<T>& tyre, const TyreContact<T>& contact, const T& load,
                     const T& fx) {
  set.qsy1 = tyre.rolling_resistance;
  return mf61_rolling_resistance<T>(set, load, fx, contact.vx, contact.camber, tyre.pressure);
}

}  // namespace tyre_law

/// Forces of a tyre on a flat road, and the rates of its deflection states u and v, with turning also turn (zero at the
/// start).
/// Set: Pac2002<T>, MagicFormula61<T> or Pac89<T>. A tyre without load gives exactly zero forces and moments. A
/// standing tyre has no horizontal forces but those of its deflections; what a set gives at zero slip comes with speed,
/// up to low_speed. The aligning moment turns its sign with the direction of travel and fades out below low_speed, as
/// the trail does; the rolling resistance fades out with the wheel's spin, so that it never drives. The moment my also
/// brings fx from the contact point down to the rolling radius, so that slip can only lose energy: power fx Vx - fx Re
/// Omega = fx Vsx. Requires: radius, relaxation lengths and low_speed > 0. Source: see tyre_law::slip and the formulas.
template <class T, class Set>
TyreResult<T> tyre_forces(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact) {
  using std::tanh;
  const T load = tyre_law::load(set, tyre, contact);
  const tyre_law::Slip<T> slip = tyre_law::slip(set, tyre, contact);
  const tyre_law::TurnedForces<T> turned = tyre_law::turned_forces(set, tyre, contact, load, slip);
  const TyreForces<T>& forces = turned.forces;
  const T rolling_radius = tyre_law::rolling_radius(set, tyre, contact);
  const T rolling = contact.spin * rolling_radius / tyre.low_speed;
  const T resistance = tyre_law::rolling_resistance(set, tyre, contact, load, forces.fx) * tanh(rolling);
  TyreResult<T> result;
  result.load = tyre.count * load;
  result.fx = tyre.count * forces.fx;
  result.fy = tyre.count * tyre.side * forces.fy;
  result.mx = tyre.count * tyre.side * forces.mx;
  result.my = -tyre.count * (resistance + forces.fx * (rolling_radius - (tyre.radius - contact.deflection)));
  result.mz = tyre.count * tyre.side * forces.mz * tanh(contact.vx / tyre.low_speed);
  if (tyre.turning != Turning::none) result.mz = result.mz + tyre.count * turned.turning;
  result.du = slip.du;
  result.dv = slip.dv;
  result.dturn = turned.rate;
  result.kappa = slip.kappa;
  result.alpha = slip.alpha;
  return result;
}

}  // namespace mbgen
