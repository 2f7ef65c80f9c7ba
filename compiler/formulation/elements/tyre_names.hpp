#pragma once
// Names of the quantities of a tyre in programs for reading. The terms of the tyre's law are computed again to find
// their values: equal terms are one value of a program, and a term that nobody else uses is no part of it.

#include "compiler/formulation/elements/force_work.hpp"

namespace mbgen::detail {

/// Gives the quantities of one tyre their names: the symbol, then the tyre.
template <class T>
struct TyreNames {
  Annotator<T>& annotator;
  const std::string& tyre;
  void operator()(const T& value, const char* symbol) const { annotator.detail(value, symbol, "_", tyre); }
  void operator()(const Vector<T>& v, const char* symbol) const { detail_name(annotator, v, symbol, "_", tyre); }
};

/// Names the motion of a wheel, the axes and the point of its contact.
template <class T>
void detail_contact(const ForceWork<T>& work, const WheelMotion<T>& wheel, const RoadContact<T>& contact,
                    const std::string& tyre) {
  if (!work.system.annotator.has_details()) return;
  const TyreNames<T> name{work.system.annotator, tyre};
  const Vector<T> across = cross(wheel.axis, wheel.up);
  const T cosine = norm(across), sine = dot(wheel.axis, wheel.up), loaded = wheel.height / cosine;
  name(wheel.up, "ez");
  name(wheel.axis, "ewheel");
  name(wheel.height, "height");
  name(wheel.velocity, "Vc");
  name(contact.forward, "ex");
  name(contact.left, "ey");
  name(contact.down, "contact");
  name(cosine, "cosgamma");
  name(sine, "singamma");
  name(T(1.0) / cosine, "per_cosgamma");
  name(loaded, "Rl");
  name(loaded / cosine, "Rlslant");
  name(across, "ewheelxez");
  const Vector<T> turning = wheel.angular - contact.motion.spin * wheel.axis;
  name(turning, "wturn");
  name(cross(wheel.angular, wheel.axis), "ewheelrate");
  name(cross(turning, contact.down), "vcontact");
  name(contact.motion.deflection, "rho");
  name(contact.motion.deflection_rate, "rhod");
  name(contact.motion.vx, "Vx");
  name(contact.motion.vy, "Vy");
  name(contact.motion.spin, "Omega");
  name(contact.motion.camber, "gamma");
  name(contact.motion.turn_rate, "psid");
}

/// Names the terms of the slips with relaxation, see tyre_law::slip.
template <class T, class Set>
void detail_slip(const TyreNames<T>& name, const Set& set, const TyreProperties<T>& tyre,
                 const TyreContact<T>& contact) {
  using std::cos;
  using std::sqrt;
  const T radius = tyre_law::rolling_radius(set, tyre, contact), vsx = contact.vx - contact.spin * radius;
  const T speed = abs(contact.vx), slip_speed = sqrt(vsx * vsx + contact.vy * contact.vy + magic::kRootFloor);
  const T limit = min(tyre_law::kSlidingDeflection * (1.0 + (speed + slip_speed) / tyre.low_speed),
                      T(tyre_law::kSlidingDeflectionAtSpeed));
  const tyre_law::Relaxation<T> sigma = tyre_law::relaxation(set, tyre, contact);
  const T qx = contact.u / sigma.x, qy = contact.v / sigma.y;
  const T q = sqrt(qx * qx + qy * qy + magic::kRootFloor), sticking = 1.0 - q / limit;
  const T fade = 0.5 + 0.5 * cos(magic::kPi * min(speed / tyre.low_speed, T(1)));
  const tyre_law::Slip<T> slip = tyre_law::slip(set, tyre, contact);
  name(radius, "Re");
  name(vsx, "Vsx");
  name(speed, "Vxabs");
  name(slip_speed, "Vs");
  name(limit, "qmax");
  name(sigma.x, "sigmax");
  name(sigma.y, "sigmay");
  name(qx, "qx");
  name(qy, "qy");
  name(q, "q");
  name(speed + slip_speed / limit, "transport");
  name(sticking, "sticking");
  name(1.0 / max(sticking, q * (1.0 / tyre_law::kLargestSlip)), "growth");
  name(fade, "fade");
  name(tyre_law::kSlipDamping * fade * max(sticking, T(0)), "slipdamping");
  name(slip.rolling, "speedshare");
}

/// Names the terms of a curve of pure slip.
template <class T>
void detail_curve(const TyreNames<T>& name, const magic::PureCurve<T>& curve, bool is_lateral) {
  const auto pick = [&](const char* x, const char* y) { return is_lateral ? y : x; };
  name(curve.b, pick("Bx", "By"));
  name(curve.d, pick("Dx", "Dy"));
  name(curve.e, pick("Ex", "Ey"));
  name(curve.slip, pick("kappax", "alphay"));
  name(curve.c * curve.d, pick("CDx", "CDy"));
  name(curve.b * curve.slip, pick("Bslipx", "Bslipy"));
  name(curve.shift, pick("SVx", "SVy"));
  name(magic::angle<T>(curve.b, curve.c, curve.e, curve.slip), pick("anglex", "angley"));
}

/// Names the terms of a set's formula that have a symbol: of PAC2002 the curves, weights, trail and residual moment.
template <class T, class Set>
void detail_formula(const TyreNames<T>&, const Set&, const TyreProperties<T>&, const TyreContact<T>&, const T&,
                    const tyre_law::Slip<T>&) {}

template <class T>
void detail_formula(const TyreNames<T>& name, const Pac2002<T>& set, const TyreProperties<T>& tyre,
                    const TyreContact<T>& contact, const T& load, const tyre_law::Slip<T>& slip) {
  using std::atan, std::cos, std::sin, std::sqrt;
  const T alpha = tyre.side * slip.alpha, gamma = tyre.side * contact.camber;
  const magic::LoadTerms<T> at = magic::load_terms<T>(set.fnomin * set.lfzo, load, tyre.friction, slip.rolling);
  name(at.load, "Fzlimited");
  name(at.dfz, "dfz");
  name(at.proportion, "proportion");
  name(at.friction, "mu");
  name(1e-9 * at.load, "floor");
  name(abs(gamma), "gammaabs");
  const magic::PureLongitudinal<T> x = magic::pac2002_longitudinal(set, at, slip.kappa, gamma);
  const magic::PureLateral<T> y = magic::pac2002_lateral(set, at, alpha, gamma);
  name(x.stiffness, "Kx");
  name(y.stiffness, "Ky");
  name(y.friction, "muy");
  name(y.slip_shift, "SHf");
  detail_curve(name, x.curve, false);
  detail_curve(name, y.curve, true);
  name(x.force, "Fx0");
  name(y.force, "Fy0");
  const T ratio = x.stiffness / y.stiffness * slip.kappa;
  const auto with_kappa = [&](const T& angle) {
    const T tangent = sin(angle) / cos(angle);
    return atan(sqrt(tangent * tangent + ratio * ratio + magic::kRootFloor));
  };
  const T trail_slip = magic::pac2002_trail_slip(set, at, alpha, gamma), residual_slip = alpha + y.slip_shift;
  name(ratio, "kappaeq");
  name(trail_slip, "alphat");
  name(residual_slip, "alphar");
  name(with_kappa(trail_slip), "alphateq");
  name(with_kappa(residual_slip), "alphareq");
  name(magic::pac2002_trail<T>(set, at, trail_slip, with_kappa(trail_slip), gamma), "trail");
  name(magic::pac2002_residual_moment<T>(set, at, y, with_kappa(residual_slip), gamma), "Mzr");
  const T bx = set.rbx1 * magic::cos_of_arc<T>(set.rbx2 * slip.kappa) * set.lxal;
  const T by = set.rby1 * magic::cos_of_arc<T>(set.rby2 * (alpha - set.rby3)) * set.lyka;
  name(bx, "Bxalpha");
  name(by, "Bykappa");
  name(magic::weight<T>(bx, set.rcx1, set.rex1 + set.rex2 * at.dfz, set.rhx1, alpha), "Gxalpha");
  name(magic::weight<T>(by, set.rcy1, set.rey1 + set.rey2 * at.dfz, set.rhy1 + set.rhy2 * at.dfz, slip.kappa),
       "Gykappa");
}

/// Names the forces, moments and slips of a tyre.
template <class T>
void detail_result(const TyreNames<T>& name, const TyreResult<T>& result) {
  name(result.load, "Fz");
  name(result.fx, "Fx");
  name(result.fy, "Fy");
  name(result.mx, "Mx");
  name(result.my, "My");
  name(result.mz, "Mz");
  name(result.kappa, "kappa");
  name(result.alpha, "alpha");
  name(result.du, "du");
  name(result.dv, "dv");
}

/// Names the terms of a tyre's law.
template <class T, class Set>
void detail_law(const TyreNames<T>& name, const Set& set, const TyreProperties<T>& tyre,
                const TyreContact<T>& contact) {
  const T load = tyre_law::load(set, tyre, contact);
  name(load, "Fz1");
  name(tyre_law::spring(set, tyre, contact), "Fzspring");
  detail_slip(name, set, tyre, contact);
  detail_formula(name, set, tyre, contact, load, tyre_law::slip(set, tyre, contact));
}

}  // namespace mbgen::detail
