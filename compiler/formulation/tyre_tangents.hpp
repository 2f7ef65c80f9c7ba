#pragma once
// Tangents of a tyre: of its load by the deflection and its rate, and of its forces in the road's plane, with the rates
// of its deflection states, by the velocities of the slips and these states.

#include "compiler/formulation/element_tangents.hpp"

namespace mbgen {
namespace detail {

/// Forces in the road's plane, N, of one tyre.
template <class T>
struct PlaneForces {
  T fx, fy;
};

/// Derivatives of the forces in the plane by the slips, as the law of the tyre's set has them.
template <class T>
struct SlipStiffness {
  PlaneForces<T> by_kappa, by_alpha;
};

/// Properties of a tyre over A: T, or Slope<T>.
template <class A, class T>
TyreProperties<A> properties_of(const ForceWork<T>& work, const Tyre& tyre) {
  return tyre_properties<A>(
      tyre, [&](const Quantity& q, const char* meaning) { return A(work.value(q, meaning, tyre.name)); });
}

template <class T>
SlipStiffness<T> slip_stiffness(const ForceWork<T>& work, const Tyre& tyre, const TyreContact<T>& contact) {
  using S = Slope<T>;
  std::vector<S> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(S(work.value(q)));
  const TyreProperties<T> properties = properties_of<T>(work, tyre);
  const T load = tyre_law::load(properties, contact);
  const tyre_law::Slip<T> slip = tyre_law::slip(properties, contact);
  const auto forces = [&](const S& kappa, const S& alpha) {
    const S camber(T(tyre.side) * contact.camber);
    const TyreForces<S> f = with_tyre_set(tyre.model, coefficients, [&](const auto& set) {
      return tyre_law::formula<S>(set, S(load), kappa, tyre.side * alpha, camber, S(properties.friction),
                                  S(slip.rolling));
    });
    return PlaneForces<T>{T(tyre.count) * f.fx.slope, T(tyre.count * tyre.side) * f.fy.slope};
  };
  return {forces(S(slip.kappa, T(1.0)), S(slip.alpha)), forces(S(slip.kappa), S(slip.alpha, T(1.0)))};
}

/// Slips of a contact in which one of spin, vy, u, v moves.
template <class T>
tyre_law::Slip<Slope<T>> moved_slip(const TyreProperties<Slope<T>>& properties, const TyreContact<T>& contact,
                                    Slope<T> TyreContact<Slope<T>>::*moved, const T& by) {
  TyreContact<Slope<T>> c{contact.deflection, contact.deflection_rate, contact.vx, contact.vy,
                          contact.spin,       contact.camber,          contact.u,  contact.v};
  (c.*moved).slope = by;
  return tyre_law::slip(properties, c);
}

/// Local coordinates: slip along the wheel, motion to the left, motion up, of the contact point.
template <class T>
ElementTangents<T> tyre_element(ForceWork<T>& work, const Tyre& tyre, std::size_t index) {
  using S = Slope<T>;
  using C = TyreContact<S>;
  const auto [contact, point] = placed_contact(work, tyre, wheel_motion(work, tyre, index));
  const TyreProperties<S> properties = properties_of<S>(work, tyre);
  const TyreProperties<T> plain = properties_of<T>(work, tyre);
  const T radius = tyre_law::rolling_radius(plain, contact.motion);
  const T lever = radius - (plain.radius - contact.motion.deflection);
  std::vector<std::vector<T>> rows(3, std::vector<T>(work.system.topology.bodies.size(), T(0.0)));
  const int body = work.system.topology.tree_body[tyre.centre.body];
  Spatial<T> along = force_at(contact.forward, point);
  along.angular = along.angular - lever * contact.left;
  add_wrench(work, body, kGround, along, rows[0]);
  add_wrench(work, body, kGround, force_at(contact.left, point), rows[1]);
  add_wrench(work, body, kGround, force_at(contact.up, point), rows[2]);
  ElementTangents<T> element = element_tangents<T>(std::move(rows), 2, static_cast<int>(2 * index));

  C loaded{contact.motion.deflection, contact.motion.deflection_rate, {}, {}, {}, {}, {}, {}};
  loaded.deflection.slope = T(-tyre.count);
  element.by_position[2][2] = tyre_law::load(properties, loaded).slope;
  loaded.deflection.slope = T(0.0);
  loaded.deflection_rate.slope = T(-tyre.count);
  element.by_velocity[2][2] = tyre_law::load(properties, loaded).slope;

  const SlipStiffness<T> k = slip_stiffness(work, tyre, contact.motion);
  const auto force = [&](const tyre_law::Slip<S>& slip, int component) {
    const T PlaneForces<T>::*f = component == 0 ? &PlaneForces<T>::fx : &PlaneForces<T>::fy;
    return S::times(k.by_kappa.*f, slip.kappa.slope) + S::times(k.by_alpha.*f, slip.alpha.slope);
  };
  const T spin_per_slip = T(-1.0) / radius;
  const tyre_law::Slip<S> by_motion[] = {moved_slip(properties, contact.motion, &C::spin, spin_per_slip),
                                         moved_slip(properties, contact.motion, &C::vy, T(1.0))};
  const tyre_law::Slip<S> by_state[] = {moved_slip(properties, contact.motion, &C::u, T(1.0)),
                                        moved_slip(properties, contact.motion, &C::v, T(1.0))};
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      element.by_velocity[a][b] = force(by_motion[b], a);
      element.by_state[a][b] = force(by_state[b], a);
    }
    element.rate_by_velocity[0][b] = by_motion[b].du.slope;
    element.rate_by_velocity[1][b] = by_motion[b].dv.slope;
    element.decay[b] = b == 0 ? by_state[b].du.slope : by_state[b].dv.slope;
  }
  return element;
}

template <class T>
void tyre_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  for (std::size_t i = 0; i < work.system.model.tyres.size(); ++i) {
    const auto heading = work.system.scribe.within(OwnerKind::tyre, i);
    elements.push_back(tyre_element(work, work.system.model.tyres[i], i));
  }
}

}  // namespace detail
}  // namespace mbgen
