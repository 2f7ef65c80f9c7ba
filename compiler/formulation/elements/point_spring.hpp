#pragma once
// Springs and dampers between two points.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/energy.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {

/// A spring as it is seen; `force` with the frictions along its line.
template <class T>
struct SpringState : ElementState<T> {
  T own{0.0};  ///< N, by its own law
};
template <>
struct StateOf<PointSpring> {
  template <class T>
  using type = SpringState<T>;
};

namespace detail {

/// Tension of a spring by its length and rate, N. natural: see natural_length.
template <class T, class A>
A spring_tension(const ForceWork<T>& work, const PointSpring& spring, const A& length, const A& rate,
                 const T& natural) {
  A tension = number<A>(work, spring.preload, "f0", spring.name);
  // One after the other: compilers choose the order within an expression, and values follow it.
  tension = tension + law(work, spring.stiffness, length - natural, "k", spring.name);
  tension = tension + law(work, spring.damping, rate, "d", spring.name);
  if (spring.force) tension = tension + with_locals(work, *spring.force, length, rate);
  return tension;
}

template <class T>
void apply(ForceWork<T>& work, const PointSpring& spring) {
  const ElementState<T> state =
      line_element(work, spring.from, spring.to, [&](const T& length, const T& rate, const T& reference) {
        const T natural = natural_length(work, spring.free_length, reference, spring.name);
        const T tension = spring_tension(work, spring, length, rate, natural);
        work.system.scribe.name(tension, "tension_", spring.name);
        return tension;
      });
  states_of<PointSpring>(work.forces).push_back({state, state.force});
}

/// The tension of a spring by its length and rate.
template <class T>
struct SpringLine {
  const PointSpring& spring;
  LocalLine<T> line;
  T natural;
  Slope<T> tension(const ForceWork<T>& work, const Slope<T>& length, const Slope<T>& rate) const {
    return spring_tension(work, spring, length, rate, natural);
  }
};

/// number: index into Model::springs.
template <class T>
SpringLine<T> spring_line(const ForceWork<T>& work, int number) {
  const PointSpring& spring = work.system.model.springs[number];
  LocalLine<T> line = local_line(work, spring.from, spring.to, number);
  T natural = natural_length(work, spring.free_length, line.reference, spring.name);
  return {spring, std::move(line), std::move(natural)};
}

inline std::vector<int> expressions_of(const PointSpring& spring) {
  return expressions_of(spring.stiffness, spring.damping, spring.preload, spring.force);
}

template <>
inline constexpr int kTangentPass<PointSpring> = 0;

template <class T>
void add_tangents(ForceWork<T>& work, const PointSpring& spring, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const SpringLine<T> s = spring_line(work, static_cast<int>(index_in(work.system.model.springs, spring)));
  elements.push_back(scalar_element(work, s.line.coordinate, s.line.length, s.line.rate, expressions_of(s.spring),
                                    [&](const S& length, const S& rate) { return -s.tension(work, length, rate); }));
}

template <class T>
T stored_energy(const EnergyWork<T>& work, const PointSpring& spring) {
  const System<T>& system = work.system;
  const Place<T> from = place_of(system, spring.from), to = place_of(system, spring.to);
  const T natural = spring.free_length
                        ? work.value(*spring.free_length)
                        : reference_distance(system.topology, system.constants, spring.to, to, spring.from, from);
  const T extension = state_of(work.system, work.forces, spring).length - natural;
  return work_of(work, spring.stiffness, extension) + work.value(spring.preload) * extension;
}

}  // namespace detail
}  // namespace mbgen
