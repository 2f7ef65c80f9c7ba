#pragma once
// Actuators as encoders see them: their positions, directions and accelerations, for maps between motors and joints.

#include "compiler/formulation/inverse_dynamics.hpp"

namespace mbgen {

/// Actuators at a state, each at its motor.
template <class T>
struct ActuatorsSeen {
  std::vector<T> position;                ///< gear times coordinate or length: rad or m
  std::vector<std::vector<T>> direction;  ///< per coordinate, generalised force of the tree for a unit force
  std::vector<T> drift;                   ///< acceleration where no coordinate accelerates
};

namespace detail {

/// Second derivative of the length of a line where no coordinate accelerates.
template <class T>
T drift_of(const ForceWork<T>& work, const Accelerations<T>& a, const AlongLine<T>& at) {
  const Line<T>& line = at.line;
  const auto gap_of = [&](const auto& seen) { return seen(line.to) - seen(line.from); };
  const Vector<T> rate =
      gap_of([&](const Place<T>& place) { return velocity_in(work.system, work.k, work.v, place, line.frame); });
  const Vector<T> acceleration = gap_of([&](const Place<T>& place) {
    return direction_in(work.system, work.k, work.system.layout.frame_of(place.body),
                        place_acceleration(work.system, work.k, a, place), line.frame);
  });
  return line.reciprocal * (dot(line.gap, acceleration) + dot(rate, rate) - line.rate * line.rate);
}
template <class T>
T drift_of(const ForceWork<T>&, const Accelerations<T>&, const AlongCoordinate<T>&) {
  return T(0.0);
}

}  // namespace detail

/// Positions and directions of all actuators, and drifts at the velocities of the state. Cost: linear.
template <class T>
ActuatorsSeen<T> actuators_seen(System<T>& system) {
  const Kinematics<T> k = kinematics(system);
  const Velocities<T> v = velocities(system, k);
  const Accelerations<T> a = accelerations(system, k, v, std::vector<T>(system.topology.bodies.size(), T(0.0)));
  AppliedForces<T> none;
  none.about = v.about;
  const detail::ForceWork<T> work{system, k, v, none};
  ActuatorsSeen<T> seen;
  for (const Actuator& actuator : system.model.actuators) {
    const auto heading = within(system, actuator);
    const T gear = work.value(actuator.gear, "gear", actuator.name);
    seen.direction.push_back(detail::unit_force(work, actuator));
    connect(work, actuator, [&](const auto& at) {
      seen.position.push_back(gear * at.position);
      seen.drift.push_back(gear * detail::drift_of(work, a, at));
    });
  }
  return seen;
}

/// Generalised forces of the tree that accelerations of all coordinates need, the actuators' forces by their inputs
/// left out. tau: other generalised forces on the coordinates. Cost: linear.
template <class T>
std::vector<T> required_forces(System<T>& system, const std::vector<T>& zdd, const std::vector<T>& tau) {
  const detail::SilentActuators<T> silent(system);
  const Kinematics<T> k = kinematics(system);
  const Inertias<T> m = inertias(system, k);
  const Velocities<T> v = velocities(system, k);
  const AppliedForces<T> forces = applied_forces(system, k, v);
  std::vector<T> required = tree_forces(system, k, m, v, accelerations(system, k, v, zdd), forces, tau);
  for (T& force : required) force = -force;
  return required;
}

}  // namespace mbgen
