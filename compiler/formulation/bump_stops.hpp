#pragma once
// Bump stops: travel between points or of a coordinate, and the law that pushes after the clearance.

#include "compiler/formulation/force_work.hpp"

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
  Place<T> from, to;
  int frame = kGround;  ///< that both bodies see
  Vector<T> axis, gap;  ///< in the axes of the body of `from`, 1 and m
  T travel, rate;
};

template <class T>
TravelAlongAxis<T> travel_along_axis(const ForceWork<T>& work, const BumpStop& stop) {
  const System<T>& system = work.system;
  TravelAlongAxis<T> t;
  t.from = work.place(stop.from);
  t.to = work.place(stop.to);
  t.frame = common_frame(system, t.from.body, t.to.body);
  const auto in_from = [&](const Vector<T>& v) { return direction_up(system, work.k, t.frame, v, t.from.body); };
  t.gap = in_from(position_in(system, work.k, t.to, t.frame) - position_in(system, work.k, t.from, t.frame));
  const Vector<T> velocity = in_from(velocity_in(system, work.k, work.v, t.to, t.frame) -
                                     velocity_in(system, work.k, work.v, t.from, t.frame));
  const int from_carrier = system.layout.frame_of(t.from.body);
  const Vector<T> spin =
      in_from(direction_in(system, work.k, from_carrier, velocity_of(system, work.v, t.from.body).angular, t.frame));
  const auto reference = [&](const Attachment& at, const Place<T>& place) {
    return place.at + carrier_origin(system.topology, system.constants, at.body);
  };
  t.axis = T(stop.side == BumpStop::Side::compression ? -1.0 : 1.0) * constant<T>(*stop.axis);
  const Vector<T> way = t.gap - (reference(stop.to, t.to) - reference(stop.from, t.from));
  t.travel = dot(t.axis, way);
  t.rate = dot(t.axis, velocity - cross(spin, t.gap));
  return t;
}

template <class T>
BumpStopState<T> stop_along_axis(ForceWork<T>& work, const BumpStop& stop) {
  const System<T>& system = work.system;
  const TravelAlongAxis<T> t = travel_along_axis(work, stop);
  const int from_carrier = system.layout.frame_of(t.from.body), to_carrier = system.layout.frame_of(t.to.body);
  const BumpStopState<T> state = bump_stop_law(work, stop, t.travel, t.rate);
  const Vector<T> push = state.force * t.axis;  // on `from`
  act(work, {stop.from.body, direction_in(system, work.k, t.from.body, push, from_carrier),
             direction_in(system, work.k, t.from.body, cross(t.gap, push), from_carrier),
             arm_of(system, work.k, t.from, work.forces.about)});
  const Vector<T> on_to = direction_in(system, work.k, t.from.body, -push, t.frame);
  act(work, {stop.to.body,
             direction_up(system, work.k, t.frame, on_to, to_carrier),
             {},
             arm_of(system, work.k, t.to, work.forces.about)});
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
