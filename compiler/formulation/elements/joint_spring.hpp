#pragma once
// Springs and dampers on a coordinate, or on the difference of two.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/energy.hpp"

namespace mbgen {
namespace detail {

/// Deflection and rate of a joint spring, rad or m.
template <class T>
struct JointDeflection {
  T position, rate;
};

template <class T>
JointDeflection<T> joint_deflection(const System<T>& system, const JointSpring& spring) {
  const Environment<T>& e = system.environment;
  JointDeflection<T> d{e.position(spring.joint), e.velocity(spring.joint)};
  if (spring.relative_to) {
    d.position = d.position - e.position(*spring.relative_to);
    d.rate = d.rate - e.velocity(*spring.relative_to);
  }
  return d;
}

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

template <class T>
void apply(ForceWork<T>& work, const JointSpring& spring) {
  const JointDeflection<T> d = joint_deflection(work.system, spring);
  const T force = joint_spring_force(work, spring, d.position, d.rate);
  work.system.scribe.name(force, "force_", spring.name);
  add_joint_force(work, spring.joint, -force);
  if (spring.relative_to) add_joint_force(work, *spring.relative_to, force);
}

template <>
inline constexpr int kTangentPass<JointSpring> = 0;

template <class T>
void add_tangents(ForceWork<T>& work, const JointSpring& spring, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const System<T>& system = work.system;
  LocalCoordinate<T> along = tree_local(system, spring.joint);
  if (spring.relative_to) {
    along.shared = -1;
    if (const int other = tree_coordinate(system.topology, *spring.relative_to); other >= 0)
      along.row[other] = along.row[other] - T(1.0);
  }
  const JointDeflection<T> d = joint_deflection(system, spring);
  elements.push_back(scalar_element(
      work, std::move(along), d.position, d.rate,
      expressions_of(spring.stiffness, spring.damping, spring.preload, spring.force),
      [&](const S& position, const S& rate) { return -joint_spring_force(work, spring, position, rate); }));
}

template <class T>
T stored_energy(const EnergyWork<T>& work, const JointSpring& spring) {
  const T deflection = joint_deflection(work.system, spring).position - work.value(spring.free);
  return work_of(work, spring.stiffness, deflection) + work.value(spring.preload) * deflection;
}

}  // namespace detail
}  // namespace mbgen
