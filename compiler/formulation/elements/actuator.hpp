#pragma once
// Actuators: forces by inputs, on coordinates or between two points.

#include "compiler/formulation/elements/connections.hpp"

namespace mbgen {

/// Quantities of an actuator at its motor.
template <class T>
struct ActuatorState {
  T force{0.0}, speed{0.0};  ///< N or N m, m/s or rad/s
};
template <>
struct StateOf<Actuator> {
  template <class T>
  using type = ActuatorState<T>;
};

/// Value of an actuator's quantity by its index.
template <class T>
T shown(const ActuatorState<T>& state, int quantity, int /*axis*/) {
  const T values[] = {state.force, state.speed, state.force * state.speed};
  return values[quantity];
}

namespace detail {

/// Forces of an actuator.
template <class A>
struct Actuation {
  A resistance;   ///< against the coordinate or the length, N or N m
  A force, gear;  ///< of the motor
};

template <class T, class Use>
void connect(const ForceWork<T>& work, const Actuator& actuator, const Use& use) {
  if (actuator.joint)
    use(AlongCoordinate<T>(work.system, *actuator.joint, actuator.relative_to));
  else
    use(AlongLine<T>(work, actuator.from, actuator.to, -1));
}

/// Force by the input, whatever position and rate.
template <class T, class At>
auto law_of(const ForceWork<T>& work, const Actuator& actuator, const At&) {
  return [&]<class A>(const A& /*position*/, const A& /*rate*/) {
    const A force = actuator.input < 0 ? A(0.0) : A(work.system.environment.input(actuator.input));
    const A gear = number<A>(work, actuator.gear, "gear", actuator.name);
    return Actuation<A>{-(gear * force), force, gear};
  };
}

template <class T, class At>
ActuatorState<T> seen_as(const Actuator&, const At& at, const Actuation<T>& acting) {
  return {acting.force, acting.gear * at.rate};
}

}  // namespace detail
}  // namespace mbgen
