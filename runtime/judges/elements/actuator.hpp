#pragma once
// Actuators: forces by inputs, on coordinates or between two points.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline double force_of(const AtWork& at, const Actuator& actuator) {
  return actuator.input < 0 ? 0.0 : at.value.input(actuator.input);
}

inline void apply(const AtWork& at, const Actuator& actuator, Forces& forces) {
  const double push = at.value(actuator.gear) * force_of(at, actuator);
  if (!actuator.joint) {
    const ElementPart& part = part_of(at, actuator);
    return add_tension(line_between(part.from, part.to, at.bodies), -push, forces);
  }
  add_on_coordinate(at, *actuator.joint, push, forces);
  if (actuator.relative_to) add_on_coordinate(at, *actuator.relative_to, -push, forces);
}

inline double shown(const AtWork& at, const Forces&, const Actuator& actuator, int quantity, int) {
  double rate = 0;
  if (actuator.joint) {
    rate = at.value.velocity(*actuator.joint);
    if (actuator.relative_to) rate -= at.value.velocity(*actuator.relative_to);
  } else {
    const ElementPart& part = part_of(at, actuator);
    rate = line_between(part.from, part.to, at.bodies).rate;
  }
  const double force = force_of(at, actuator), speed = at.value(actuator.gear) * rate;
  const double values[] = {force, speed, force * speed};
  return values[quantity];
}

}  // namespace mbgen::cartesian
