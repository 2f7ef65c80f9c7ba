#pragma once
// Air springs between two points.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {

template <>
struct StateOf<AirSpring> {
  template <class T>
  using type = ElementState<T>;
};

namespace detail {

/// Push of an air spring by its length, N. natural: see natural_length.
template <class T, class A>
A air_spring_push(const ForceWork<T>& work, const AirSpring& spring, const A& length, const T& natural) {
  const auto area = [&](const A& l) {
    const Quantity* fixed = std::get_if<Quantity>(&spring.area);
    return fixed ? A(work.value(*fixed, "area", spring.name)) : law(work, spring.area, l, "area", spring.name);
  };
  const auto volume = [&](const A& l) {
    return spring.volume ? value_along(*spring.volume, l)
                         : A(work.value(spring.volume0, "volume0", spring.name)) + area(A(natural)) * (l - natural);
  };
  const auto value = [&](const Quantity& q, const char* meaning) { return A(work.value(q, meaning, spring.name)); };
  return air_spring_force(value(spring.pressure, "pressure"), value(spring.ambient, "ambient"),
                          value(spring.exponent, "exponent"), volume(A(natural)), volume(length), area(length));
}

template <class T>
void apply(ForceWork<T>& work, const AirSpring& spring) {
  states_of<AirSpring>(work.forces)
      .push_back(line_element(work, spring.from, spring.to, [&](const T& length, const T&, const T& reference) {
        const T natural = natural_length(work, spring.length, reference, spring.name);
        const T push = air_spring_push(work, spring, length, natural);
        work.system.scribe.name(push, "push_", spring.name);
        return -push;
      }));
}

template <>
inline constexpr int kTangentPass<AirSpring> = 0;

template <class T>
void add_tangents(ForceWork<T>& work, const AirSpring& spring, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const Model& model = work.system.model;
  const std::size_t number = model.springs.size() + index_in(model.air_springs, spring);
  const LocalLine<T> line = local_line(work, spring.from, spring.to, static_cast<int>(number));
  const T natural = natural_length(work, spring.length, line.reference, spring.name);
  elements.push_back(scalar_element(work, line.coordinate, line.length, line.rate, {}, [&](const S& length, const S&) {
    return air_spring_push(work, spring, length, natural);
  }));
}

}  // namespace detail
}  // namespace mbgen
