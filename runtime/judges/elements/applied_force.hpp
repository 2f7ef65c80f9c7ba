#pragma once
// Forces and torques on bodies.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline void apply(const AtWork& at, const AppliedForce& applied, Forces& forces) {
  const Place& place = part_of(at, applied).from;
  const auto vector = [&](const Vector3Quantity& q) {
    const Eigen::Vector3d components(at.value(q[0]), at.value(q[1]), at.value(q[2]));
    return applied.in_body_axes ? Eigen::Vector3d(at.bodies[place.body].axes * components) : components;
  };
  Load load = force_at(end_of(at.bodies, place), vector(applied.force));
  load.wrench.tail<3>() += vector(applied.torque);
  forces.loads.push_back(load);
}

}  // namespace mbgen::cartesian
