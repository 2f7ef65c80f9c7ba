#pragma once
// Tangents of a tyre: of its load by the deflection and its rate; of its forces in the road's plane and the rates of
// its deflection states by the velocities of the slips and these states; of its moment against turning.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/tyre.hpp"

namespace mbgen {
namespace detail {

/// Forces in the road's plane, N, of one tyre.
template <class T>
struct PlaneForces {
  T fx, fy;
};

/// Derivatives of the forces in the plane by the slips, from the law of the tyre's set.
template <class T>
struct SlipStiffness {
  PlaneForces<T> by_kappa, by_alpha;
};

/// Set, properties: of the tyre.
template <class Set, class T>
SlipStiffness<T> slip_stiffness(const Set& set, const TyreProperties<Slope<T>>& properties,
                                const TyreContact<Slope<T>>& contact) {
  using S = Slope<T>;
  const T load = tyre_law::load(set, properties, contact).value;
  const tyre_law::Slip<S> slip = tyre_law::slip(set, properties, contact);
  const S& side = properties.side;
  const auto forces = [&](const S& kappa, const S& alpha) {
    const tyre_law::Slip<S> moved{kappa, alpha, S(), S(), S(slip.rolling.value)};
    const TyreForces<S> f = tyre_law::turned_forces(set, properties, contact, S(load), moved).forces;
    return PlaneForces<T>{properties.count.value * f.fx.slope, properties.count.value * side.value * f.fy.slope};
  };
  return {forces(S(slip.kappa.value, T(1.0)), S(slip.alpha.value)),
          forces(S(slip.kappa.value), S(slip.alpha.value, T(1.0)))};
}

/// Derivatives from the law of a set: set, properties and contact over Slope, with no direction yet.
template <class Set, class T>
void add_law(const Set& set, const TyreProperties<Slope<T>>& properties, const TyreContact<Slope<T>>& contact,
             ElementTangents<T>& element) {
  using S = Slope<T>;
  using C = TyreContact<S>;
  const auto moved = [&](S C::*coordinate, const T& by) {
    C c = contact;
    (c.*coordinate).slope = by;
    return c;
  };
  const T down = -properties.count.value;
  element.by_position[2][2] = tyre_law::load(set, properties, moved(&C::deflection, down)).slope;
  element.by_velocity[2][2] = tyre_law::load(set, properties, moved(&C::deflection_rate, down)).slope;

  const SlipStiffness<T> k = slip_stiffness(set, properties, contact);
  const auto force = [&](const tyre_law::Slip<S>& slip, int component) {
    const T PlaneForces<T>::*f = component == 0 ? &PlaneForces<T>::fx : &PlaneForces<T>::fy;
    return S::times(k.by_kappa.*f, slip.kappa.slope) + S::times(k.by_alpha.*f, slip.alpha.slope);
  };
  const auto slip = [&](S C::*coordinate, const T& by) {
    return tyre_law::slip(set, properties, moved(coordinate, by));
  };
  const T spin_per_slip = T(-1.0) / tyre_law::rolling_radius(set, properties, contact).value;
  const tyre_law::Slip<S> by_motion[] = {slip(&C::spin, spin_per_slip), slip(&C::vy, T(1.0))};
  const tyre_law::Slip<S> by_state[] = {slip(&C::u, T(1.0)), slip(&C::v, T(1.0))};
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      element.by_velocity[a][b] = force(by_motion[b], a);
      element.by_state[a][b] = force(by_state[b], a);
    }
    element.rate_by_velocity[0][b] = by_motion[b].du.slope;
    element.rate_by_velocity[1][b] = by_motion[b].dv.slope;
    element.rate_by_state[b][b] = b == 0 ? by_state[b].du.slope : by_state[b].dv.slope;
  }
}

/// Derivatives of the patch of a tyre with turning; its coordinate and its state are the last ones. The decay of the
/// rotation by the motion of the patch over the road is omitted: it is never stiff.
template <class Set, class T>
void add_turning(const Set& set, const TyreProperties<Slope<T>>& properties, const TyreContact<Slope<T>>& contact,
                 ElementTangents<T>& element) {
  TyreContact<Slope<T>> turned = contact, turning = contact;
  turned.turn.slope = T(1.0);
  turning.turn_rate.slope = T(1.0);
  const TyreResult<Slope<T>> by_turn = tyre_forces(set, properties, turned);
  const TyreResult<Slope<T>> by_rate = tyre_forces(set, properties, turning);
  element.by_state[0][2] = by_turn.fx.slope;
  element.by_state[1][2] = by_turn.fy.slope;
  element.by_state[3][2] = by_turn.mz.slope;
  element.by_velocity[3][3] = by_rate.mz.slope;
  element.rate_by_state[2][2] = by_turn.dturn.slope;
  element.rate_by_velocity[2][3] = by_rate.dturn.slope;
}

/// Local coordinates of the contact point: slip along the wheel, motion to the left, motion up; with turning also the
/// rotation about the road's normal.
template <class T>
ElementTangents<T> tyre_element(ForceWork<T>& work, const Tyre& tyre, std::size_t index) {
  using S = Slope<T>;
  const RoadPlane<T> road = road_plane(work, tyre);
  const PlacedContact<T> placed = placed_contact(work, tyre, wheel_motion(work, tyre, index, road));
  const RoadContact<T>& contact = placed.contact;
  const TyreContact<T>& m = contact.motion;
  const TyreContact<S> motion{m.deflection, m.deflection_rate, m.vx,  m.vy, m.spin, m.camber, m.u,
                              m.v,          m.turn_rate,       m.turn};
  const TyreProperties<S> properties = properties_on<S>(work, tyre, road);
  std::vector<S> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(S(work.value(q)));
  return with_tyre_set(tyre.model, coefficients, [&](const auto& set) {
    const T radius = tyre_law::rolling_radius(set, properties, motion).value;
    const T lever = radius - (properties.radius.value - m.deflection);
    std::vector<LocalCoordinate<T>> coordinates(3, {std::vector<T>(work.system.topology.bodies.size(), T(0.0))});
    const int body = work.system.topology.tree_body[tyre.centre.body];
    Spatial<T> along = force_at(contact.forward, placed.point);
    along.angular = along.angular - lever * contact.left;
    add_wrench(work, body, kGround, along, coordinates[0].row);
    add_wrench(work, body, kGround, force_at(contact.left, placed.point), coordinates[1].row);
    add_wrench(work, body, kGround, force_at(contact.up, placed.point), coordinates[2].row);
    const int first = static_cast<int>(2 * index);
    std::vector<int> states{first, first + 1};
    if (tyre.parking) {
      coordinates.push_back({std::vector<T>(work.system.topology.bodies.size(), T(0.0))});
      add_wrench(work, body, kGround, Spatial<T>{{}, contact.up}, coordinates[3].row);
      states.push_back(turn_state(work.system.model, index));
    }
    ElementTangents<T> element = element_tangents<T>(std::move(coordinates), std::move(states));
    add_law(set, properties, motion, element);
    if (tyre.parking) add_turning(set, properties, motion, element);
    // The matrix of a vehicle then is symmetric, and half of it is sufficient; not for forces by turn slip, which have
    // no symmetric counterpart.
    element.counts_as_symmetric = !tyre.turn_slip;
    return element;
  });
}

template <class T>
void add_tangents(ForceWork<T>& work, const Tyre& tyre, std::vector<ElementTangents<T>>& elements) {
  elements.push_back(tyre_element(work, tyre, index_in(work.system.model.tyres, tyre)));
}

}  // namespace detail
}  // namespace mbgen
