#pragma once
// Air springs between two points.

#include "mbgen/solver/forces.hpp"
#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline double tension(const AirSpring& spring, const Values& value, double length, double reference) {
  const double length0 = spring.length ? value(*spring.length) : reference;
  const auto area = [&](double at) {
    const Quantity* constant = std::get_if<Quantity>(&spring.area);
    return constant ? value(*constant) : value_of(std::get<Table>(spring.area), at);
  };
  const auto volume = [&](double at) {
    return spring.volume ? value_of(*spring.volume, at) : value(spring.volume0) + area(length0) * (at - length0);
  };
  return -air_spring_force(value(spring.pressure), value(spring.ambient), value(spring.exponent), volume(length0),
                           volume(length), area(length));
}

inline void apply(const AtWork& at, const AirSpring& spring, Forces& forces) {
  const ElementPart& part = part_of(at, spring);
  const Line line = line_between(part.from, part.to, at.bodies);
  add_tension(line, tension(spring, at.value, line.length, part.reference), forces);
}

inline double shown(const AtWork& at, const Forces&, const AirSpring& spring, int quantity, int) {
  const ElementPart& part = part_of(at, spring);
  const Line line = line_between(part.from, part.to, at.bodies);
  const double values[] = {tension(spring, at.value, line.length, part.reference), line.length, line.rate};
  return values[quantity];
}

}  // namespace mbgen::cartesian
