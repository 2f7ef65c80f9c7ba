#pragma once
// Bump stops: travel between points or of a coordinate, and the law that pushes after the clearance.

#include "compiler/formulation/elements/seen_place.hpp"

namespace mbgen::detail {

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
void bump_stops(ForceWork<T>& work) {
  for (const BumpStop& stop : work.system.model.bump_stops) {
    const auto heading = work.system.scribe.within(OwnerKind::bump_stop, index_in(work.system.model.bump_stops, stop));
    work.forces.bump_stops.push_back(stop.is_on_joint() ? stop_on_coordinate(work, stop)
                                     : stop.axis        ? stop_along_axis(work, stop)
                                                        : stop_on_distance(work, stop));
  }
}

}  // namespace mbgen::detail
