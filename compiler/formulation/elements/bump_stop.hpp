#pragma once
// Bump stops: travel between points or of a coordinate, and the law that pushes after the clearance.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/energy.hpp"
#include "compiler/formulation/elements/seen_place.hpp"

namespace mbgen {

/// A bump stop's way beyond its clearance, the rate of that and the force against it.
template <class T>
struct BumpStopState {
  T penetration{0.0}, rate{0.0}, force{0.0};  ///< m or rad, per second, N or N m
};
template <>
struct StateOf<BumpStop> {
  template <class T>
  using type = BumpStopState<T>;
};

/// By index of the quantity.
template <class T>
T shown(const BumpStopState<T>& stop, int quantity, int /*axis*/) {
  const T* values[] = {&stop.force, &stop.penetration, &stop.rate};
  return *values[quantity];
}

namespace detail {

/// Force of a bump stop against its travel, N or N m, never negative; a function of travel and its rate alone.
/// A: T, or Slope<T> where the law is differentiated.
template <class T, class A>
BumpStopState<A> bump_stop_law(const ForceWork<T>& work, const BumpStop& stop, const A& travel, const A& rate) {
  using mbgen::max, mbgen::select;
  const A zero(0.0);
  BumpStopState<A> state;
  state.penetration = travel - A(work.value(stop.clearance, "clearance", stop.name));
  state.rate = rate;
  const A depth = max(state.penetration, zero);
  A elastic = zero;
  if (stop.stiffness) {
    const A argument = std::holds_alternative<Table>(*stop.stiffness) ? depth : power_by_constant(depth, stop.exponent);
    elastic = law(work, stop.stiffness, argument, "k", stop.name);
  }
  if (stop.force) elastic = elastic + with_locals(work, *stop.force, depth, rate);
  const A force = elastic * (A(1.0) + A(work.value(stop.damping, "d", stop.name)) * rate);
  state.force = select(-state.penetration, zero, max(force, zero));
  if constexpr (std::is_same_v<T, A>) work.system.scribe.name(state.force, "push_", stop.name);
  return state;
}

/// Travel of a stop across a plane of `from`: the direction and the travel are seen from that body.
template <class T>
struct TravelAlongAxis {
  SeenPlace<T> seen;
  Vector<T> axis;  ///< in the axes of the body of `from`
  T travel, rate;
};

template <class T>
TravelAlongAxis<T> travel_along_axis(const ForceWork<T>& work, const BumpStop& stop) {
  const System<T>& system = work.system;
  TravelAlongAxis<T> t;
  t.seen = seen_place(work, stop.from, stop.to);
  const auto reference = [&](const Attachment& at, const Place<T>& place) {
    return place.at + carrier_origin(system.topology, system.constants, at.body);
  };
  t.axis = T(stop.side == BumpStop::Side::compression ? -1.0 : 1.0) * constant<T>(*stop.axis);
  t.travel = dot(t.axis, t.seen.gap - (reference(stop.to, t.seen.to) - reference(stop.from, t.seen.from)));
  t.rate = dot(t.axis, t.seen.drift);
  return t;
}

template <class T>
BumpStopState<T> stop_along_axis(ForceWork<T>& work, const BumpStop& stop) {
  const TravelAlongAxis<T> t = travel_along_axis(work, stop);
  const BumpStopState<T> state = bump_stop_law(work, stop, t.travel, t.rate);
  act_between(work, stop.from, stop.to, t.seen, state.force * t.axis, Vector<T>{});
  return state;
}

/// A stop on the distance of two points.
template <class T>
BumpStopState<T> stop_on_distance(ForceWork<T>& work, const BumpStop& stop) {
  const T sign(stop.side == BumpStop::Side::compression ? -1.0 : 1.0);
  BumpStopState<T> state;
  line_element(work, stop.from, stop.to, [&](const T& length, const T& rate, const T& reference) {
    state = bump_stop_law(work, stop, T(sign * (length - reference)), T(sign * rate));
    return sign * state.force;
  });
  return state;
}

/// A stop on a coordinate.
template <class T>
BumpStopState<T> stop_on_coordinate(ForceWork<T>& work, const BumpStop& stop) {
  const Environment<T>& e = work.system.environment;
  const T sign(stop.side == BumpStop::Side::below ? -1.0 : 1.0);
  const BumpStopState<T> state =
      bump_stop_law(work, stop, T(sign * e.position(stop.joint)), T(sign * e.velocity(stop.joint)));
  add_joint_force(work, stop.joint, T(-sign * state.force));
  return state;
}

template <class T>
void apply(ForceWork<T>& work, const BumpStop& stop) {
  states_of<BumpStop>(work.forces)
      .push_back(stop.is_on_joint() ? stop_on_coordinate(work, stop)
                 : stop.axis        ? stop_along_axis(work, stop)
                                    : stop_on_distance(work, stop));
}

/// The tangents of a bump stop on a coordinate, between points or along an axis.
template <class T>
ElementTangents<T> tangents_of(ForceWork<T>& work, const BumpStop& stop) {
  using S = Slope<T>;
  const auto push = [&](const S& travel, const S& rate) { return -bump_stop_law(work, stop, travel, rate).force; };
  if (stop.is_on_joint()) {
    const Environment<T>& e = work.system.environment;
    const T sign(stop.side == BumpStop::Side::below ? -1.0 : 1.0);
    LocalCoordinate<T> along{tree_local(work.system, stop.joint).row};
    for (T& entry : along.row) entry = S::times(sign, entry);
    return scalar_element(work, std::move(along), T(sign * e.position(stop.joint)), T(sign * e.velocity(stop.joint)),
                          expressions_of(stop.force), push);
  }
  if (stop.axis) {
    const TravelAlongAxis<T> t = travel_along_axis(work, stop);
    return scalar_element(work, {row_between(work, t.seen, t.axis, Vector<T>{})}, t.travel, t.rate,
                          expressions_of(stop.force), push);
  }
  const S sign(stop.side == BumpStop::Side::compression ? -1.0 : 1.0);
  const LocalLine<T> line = local_line(work, stop.from, stop.to, -1);
  return scalar_element(
      work, line.coordinate, line.length, line.rate, expressions_of(stop.force), [&](const S& length, const S& rate) {
        return -(sign * bump_stop_law(work, stop, S(sign * (length - S(line.reference))), S(sign * rate)).force);
      });
}

template <class T>
void add_tangents(ForceWork<T>& work, const BumpStop& stop, std::vector<ElementTangents<T>>& elements) {
  elements.push_back(tangents_of(work, stop));
}

template <class T>
T stored_energy(const EnergyWork<T>& work, const BumpStop& stop) {
  using mbgen::max;
  const T zero(0.0), depth = max(state_of(work.system, work.forces, stop).penetration, zero);
  const Quantity* factor = std::get_if<Quantity>(&*stop.stiffness);
  if (!factor) return work_of(work, stop.stiffness, depth);
  const double power = stop.exponent + 1;
  return max(work.value(*factor), zero) * power_by_constant(depth, power) / T(power);
}

}  // namespace detail
}  // namespace mbgen
