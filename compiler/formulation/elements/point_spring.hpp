#pragma once
// Springs and dampers between two points.

#include "compiler/formulation/elements/connections.hpp"
#include "compiler/formulation/elements/energy.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {

/// Quantities of a spring; `force` includes frictions along its line.
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

/// Tension of a spring from its length and rate, N. natural: see natural_length.
template <class T, class A>
A spring_tension(const ForceWork<T>& work, const PointSpring& spring, const A& length, const A& rate,
                 const T& natural) {
  A tension = number<A>(work, spring.preload, "f0", spring.name);
  // Separate statements: the order of evaluation within an expression is unspecified, and values depend on it.
  tension = tension + law(work, spring.stiffness, length - natural, "k", spring.name);
  tension = tension + law(work, spring.damping, rate, "d", spring.name);
  if (spring.force) tension = tension + with_locals(work, *spring.force, length, rate);
  return tension;
}

template <class T, class Use>
void connect(const ForceWork<T>& work, const PointSpring& spring, const Use& use) {
  use(AlongLine<T>(work, spring.from, spring.to, line_number(work.system.model, spring)));
}

template <class T>
auto law_of(const ForceWork<T>& work, const PointSpring& spring, const AlongLine<T>& at) {
  return [&, natural = natural_length(work, spring.free_length, at.reference(work), spring.name)]<class A>(
             const A& length, const A& rate) {
    A tension = spring_tension(work, spring, length, rate, natural);
    if constexpr (std::is_same_v<T, A>) {
      if (work.system.annotator.has_details())
        work.system.annotator.detail(length - natural, "deflection_", spring.name);
      work.system.annotator.detail(tension, "force_", spring.name);
      work.system.annotator.name(tension, "tension_", spring.name);
    }
    return tension;
  };
}

template <class T>
SpringState<T> seen_as(const PointSpring&, const AlongLine<T>& at, const T& tension) {
  return {{at.position, at.rate, tension}, tension};
}

template <class T>
std::vector<int> law_expressions(const ForceWork<T>&, const PointSpring& spring) {
  return expressions_of(spring.stiffness, spring.damping, spring.preload, spring.force);
}

template <>
inline constexpr int kTangentPass<PointSpring> = 0;

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
