#pragma once
// Bump stops: travel between points or of a coordinate, and the law that pushes after the clearance.

#include "compiler/formulation/force_work.hpp"

namespace mbgen::detail {

/// Force of a bump stop against its travel, N or N m, never negative; a function of travel and its rate alone.
template <class T>
BumpStopState<T> bump_stop_law(const ForceWork<T>& work, const BumpStop& stop, const T& travel, const T& rate) {
  using mbgen::max, mbgen::select;
  const T zero(0.0);
  BumpStopState<T> state;
  state.penetration = travel - work.value(stop.clearance, "clearance", stop.name);
  state.rate = rate;
  const T depth = max(state.penetration, zero);
  T elastic = zero;
  if (stop.stiffness) {
    const T argument = std::holds_alternative<Table>(*stop.stiffness) ? depth : power_by_constant(depth, stop.exponent);
    elastic = law(work, stop.stiffness, argument, "k", stop.name);
  }
  if (stop.force) elastic = elastic + with_locals(work, *stop.force, depth, rate);
  const T force = elastic * (T(1.0) + work.value(stop.damping, "d", stop.name) * rate);
  state.force = select(-state.penetration, zero, max(force, zero));
  work.system.scribe.name(state.force, "push_", stop.name);
  return state;
}

/// A stop across a plane of `from`: the direction and the travel are seen from that body.
template <class T>
BumpStopState<T> stop_along_axis(ForceWork<T>& work, const BumpStop& stop) {
  const System<T>& system = work.system;
  const Place<T> from = work.place(stop.from), to = work.place(stop.to);
  const int frame = common_frame(system, from.body, to.body);
  const auto in_from = [&](const Vector<T>& v) { return direction_up(system, work.k, frame, v, from.body); };
  const Vector<T> gap = in_from(position_in(system, work.k, to, frame) - position_in(system, work.k, from, frame));
  const Vector<T> velocity = in_from(velocity_in(system, work.k, work.v, to, frame) -
                                     velocity_in(system, work.k, work.v, from, frame));
  const int from_carrier = system.layout.frame_of(from.body), to_carrier = system.layout.frame_of(to.body);
  const Vector<T> spin = in_from(direction_in(
      system, work.k, from_carrier, velocity_of(system, work.v, from.body).angular, frame));
  const auto reference = [&](const Attachment& at, const Place<T>& place) {
    return place.at + carrier_origin(system.topology, system.constants, at.body);
  };
  const Vector<T> axis = T(stop.side == BumpStop::Side::compression ? -1.0 : 1.0) * constant<T>(*stop.axis);
  const Vector<T> way = gap - (reference(stop.to, to) - reference(stop.from, from));
  const BumpStopState<T> state = bump_stop_law(work, stop, dot(axis, way), dot(axis, velocity - cross(spin, gap)));
  const Vector<T> push = state.force * axis;  // on `from`
  act(work, {stop.from.body, direction_in(system, work.k, from.body, push, from_carrier),
             direction_in(system, work.k, from.body, cross(gap, push), from_carrier),
             arm_of(system, work.k, from, work.forces.about)});
  const Vector<T> on_to = direction_in(system, work.k, from.body, -push, frame);
  act(work, {stop.to.body, direction_up(system, work.k, frame, on_to, to_carrier), {},
             arm_of(system, work.k, to, work.forces.about)});
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
