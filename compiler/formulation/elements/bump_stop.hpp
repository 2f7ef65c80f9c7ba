#pragma once
// Bump stops: travel between points or of a coordinate, and force law beyond the clearance.

#include "compiler/formulation/elements/connections.hpp"
#include "compiler/formulation/elements/energy.hpp"

namespace mbgen {

/// Penetration of a bump stop, its rate and its force.
template <class T>
struct BumpStopState {
  T penetration{0.0}, rate{0.0}, force{0.0};  ///< m or rad, per second, N or N m
};
template <>
struct StateOf<BumpStop> {
  template <class T>
  using type = BumpStopState<T>;
};

/// Value of a quantity by its index.
template <class T>
T shown(const BumpStopState<T>& stop, int quantity, int /*axis*/) {
  const T* values[] = {&stop.force, &stop.penetration, &stop.rate};
  return *values[quantity];
}

namespace detail {

/// Force of a bump stop against its travel, N or N m, never negative; depends on travel and its rate only. A: T, or
/// Slope<T> for differentiation.
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
  if constexpr (std::is_same_v<T, A>) {
    Annotator<T>& annotator = work.system.annotator;
    annotator.detail(travel, "travel_", stop.name);
    annotator.detail(state.penetration, "penetration_", stop.name);
    annotator.detail(depth, "depth_", stop.name);
    annotator.detail(elastic, "elastic_", stop.name);
    annotator.detail(force, "unlimited_", stop.name);
    annotator.detail(state.force, "force_", stop.name);
    annotator.name(state.force, "push_", stop.name);
  }
  return state;
}

template <class T, class Use>
void connect(const ForceWork<T>& work, const BumpStop& stop, const Use& use) {
  const int outwards = stop.side == BumpStop::Side::compression ? -1 : 1;
  if (stop.is_on_joint())
    use(AlongCoordinate<T>(work.system, stop.joint, stop.relative_to, stop.side == BumpStop::Side::below ? -1 : 1));
  else if (stop.axis)
    use(AlongAxis<T>(work, stop.from, stop.to, T(outwards) * constant<T>(*stop.axis)));
  else
    use(AlongLine<T>(work, stop.from, stop.to, -1));
}

/// State of a stop with the force against the position of its connection.
template <class A>
struct ActingBumpStop : BumpStopState<A> {
  A resistance{0.0};
};

/// On a coordinate or along an axis, the position is the travel.
template <class T, class At>
auto law_of(const ForceWork<T>& work, const BumpStop& stop, const At&) {
  return [&]<class A>(const A& travel, const A& rate) {
    const BumpStopState<A> state = bump_stop_law(work, stop, travel, rate);
    return ActingBumpStop<A>{state, state.force};
  };
}

/// Between points, the position is the length.
template <class T>
auto law_of(const ForceWork<T>& work, const BumpStop& stop, const AlongLine<T>& at) {
  return [&, reference = at.reference(work)]<class A>(const A& length, const A& rate) {
    const A sign(stop.side == BumpStop::Side::compression ? -1.0 : 1.0);
    const BumpStopState<A> state = bump_stop_law(work, stop, A(sign * (length - A(reference))), A(sign * rate));
    return ActingBumpStop<A>{state, sign * state.force};
  };
}

template <class T, class At>
BumpStopState<T> seen_as(const BumpStop&, const At&, const ActingBumpStop<T>& acting) {
  return acting;
}

template <class T>
std::vector<int> law_expressions(const ForceWork<T>&, const BumpStop& stop) {
  return expressions_of(stop.force);
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
