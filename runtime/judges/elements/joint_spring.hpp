#pragma once
// Springs and dampers on a coordinate, or on the difference of two.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline void apply(const AtWork& at, const JointSpring& spring, Forces& forces) {
  const Values& value = at.value;
  double position = value.position(spring.joint), rate = value.velocity(spring.joint);
  if (spring.relative_to) {
    position -= value.position(*spring.relative_to);
    rate -= value.velocity(*spring.relative_to);
  }
  const double force = value(spring.preload) + law(spring.stiffness, value, position - value(spring.free)) +
                       law(spring.damping, value, rate) + with_locals(spring.force, value, position, rate);
  add_on_coordinate(at, spring.joint, -force, forces);
  if (spring.relative_to) add_on_coordinate(at, *spring.relative_to, force, forces);
}

inline double energy_of(const AtWork& at, const JointSpring& spring) {
  double deflection = at.value.position(spring.joint) - at.value(spring.free);
  if (spring.relative_to) deflection -= at.value.position(*spring.relative_to);
  return work_of(spring.stiffness, at.value, deflection) + at.value(spring.preload) * deflection;
}

}  // namespace mbgen::cartesian
