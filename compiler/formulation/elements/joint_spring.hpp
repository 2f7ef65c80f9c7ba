#pragma once
// Springs and dampers on a coordinate, or on the difference of two.

#include "compiler/formulation/elements/connections.hpp"
#include "compiler/formulation/elements/energy.hpp"

namespace mbgen {
namespace detail {

/// Force of a joint spring against its deflection, N or N m.
template <class T, class A>
A joint_spring_force(const ForceWork<T>& work, const JointSpring& spring, const A& position, const A& rate) {
  A force = number<A>(work, spring.preload, "f0", spring.name);
  force =
      force + law(work, spring.stiffness, position - A(work.value(spring.free, "z0", spring.name)), "k", spring.name);
  force = force + law(work, spring.damping, rate, "d", spring.name);
  if (spring.force) force = force + with_locals(work, *spring.force, position, rate);
  return force;
}

template <class T, class Use>
void connect(const ForceWork<T>& work, const JointSpring& spring, const Use& use) {
  use(AlongCoordinate<T>(work.system, spring.joint, spring.relative_to));
}

template <class T>
auto law_of(const ForceWork<T>& work, const JointSpring& spring, const AlongCoordinate<T>&) {
  return [&]<class A>(const A& position, const A& rate) {
    A force = joint_spring_force(work, spring, position, rate);
    if constexpr (std::is_same_v<T, A>) work.system.annotator.name(force, "force_", spring.name);
    return force;
  };
}

template <class T>
std::vector<int> law_expressions(const ForceWork<T>&, const JointSpring& spring) {
  return expressions_of(spring.stiffness, spring.damping, spring.preload, spring.force);
}

template <>
inline constexpr int kTangentPass<JointSpring> = 0;

template <class T>
T stored_energy(const EnergyWork<T>& work, const JointSpring& spring) {
  const T deflection =
      AlongCoordinate<T>(work.system, spring.joint, spring.relative_to).position - work.value(spring.free);
  return work_of(work, spring.stiffness, deflection) + work.value(spring.preload) * deflection;
}

}  // namespace detail
}  // namespace mbgen
