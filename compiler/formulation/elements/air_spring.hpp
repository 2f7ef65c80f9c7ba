#pragma once
// Air springs between two points.

#include "compiler/formulation/elements/connections.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {

template <>
struct StateOf<AirSpring> {
  template <class T>
  using type = ElementState<T>;
};

namespace detail {

/// Pushing force of an air spring from its length, N. natural: see natural_length.
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

template <class T, class Use>
void connect(const ForceWork<T>& work, const AirSpring& spring, const Use& use) {
  use(AlongLine<T>(work, spring.from, spring.to, line_number(work.system.model, spring)));
}

template <class T>
auto law_of(const ForceWork<T>& work, const AirSpring& spring, const AlongLine<T>& at) {
  return [&, natural = natural_length(work, spring.length, at.reference(work), spring.name)]<class A>(const A& length,
                                                                                                      const A&) {
    A push = air_spring_push(work, spring, length, natural);
    if constexpr (std::is_same_v<T, A>) {
      work.system.annotator.detail(push, "minus_force_", spring.name);
      work.system.annotator.name(push, "push_", spring.name);
    }
    return -push;
  };
}

template <class T>
std::vector<int> law_expressions(const ForceWork<T>&, const AirSpring&) {
  return {};
}

template <>
inline constexpr int kTangentPass<AirSpring> = 0;

}  // namespace detail
}  // namespace mbgen
