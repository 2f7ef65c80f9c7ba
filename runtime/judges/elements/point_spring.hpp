#pragma once
// Springs and dampers between two points.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline double tension(const PointSpring& spring, const Values& value, double length, double rate, double reference) {
  const double free = spring.free_length ? value(*spring.free_length) : reference;
  return value(spring.preload) + law(spring.stiffness, value, length - free) + law(spring.damping, value, rate) +
         with_locals(spring.force, value, length, rate);
}

inline void apply(const AtWork& at, const PointSpring& spring, Forces& forces) {
  const ElementPart& part = part_of(at, spring);
  const Line line = line_between(part.from, part.to, at.bodies);
  const double pull = tension(spring, at.value, line.length, line.rate, part.reference);
  add_tension(line, pull, forces);
  forces.springs[index_of(at, spring)] = {line.length, line.rate, pull, pull};
}

inline double shown(const AtWork& at, const Forces& forces, const PointSpring& spring, int quantity, int) {
  const LineAtWork& line = forces.springs[index_of(at, spring)];
  const double values[] = {line.force, line.length, line.rate};
  return values[quantity];
}

inline double energy_of(const AtWork& at, const PointSpring& spring) {
  const ElementPart& part = part_of(at, spring);
  const double natural = spring.free_length ? at.value(*spring.free_length) : part.reference;
  const double extension = line_between(part.from, part.to, at.bodies).length - natural;
  return work_of(spring.stiffness, at.value, extension) + at.value(spring.preload) * extension;
}

}  // namespace mbgen::cartesian
