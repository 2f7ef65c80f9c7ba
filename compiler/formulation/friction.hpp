#pragma once
// Friction on coordinates and along springs, part of the applied forces.

#include "compiler/formulation/force_work.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/bristle.hpp"

namespace mbgen::detail {

/// Force of the smooth law without its viscous part, N m or N, on the part that moves at `rate`.
/// A: T, or Slope<T> where the law is differentiated.
template <class T, class A>
A smooth_friction(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const A& rate) {
  const auto value = [&](const Quantity& q, const char* meaning) { return A(work.value(q, meaning, name)); };
  return friction_force(value(friction.coulomb, "coulomb"), value(friction.stiction, "stiction"), A(0.0),
                        value(friction.velocity, "velocity"), value(friction.stribeck_velocity, "stribeck"), rate);
}

/// What the viscous part takes from it, N m or N.
template <class T, class A>
A viscous_friction(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const A& rate) {
  return A(work.value(friction.viscous, "viscous", name)) * rate;
}

/// Force of bristles, N m or N, on the part that moves at `rate`. state: the auxiliary state that they bend.
template <class T>
T bristle_force(ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const T& rate,
                std::size_t state) {
  const auto value = [&](const Quantity& q, const char* meaning) { return work.value(q, meaning, name); };
  const T deflection = work.system.x[state];
  const Bristles<T> bristles{value(friction.coulomb, "coulomb"),
                             value(friction.stiction, "stiction"),
                             value(friction.stribeck_velocity, "stribeck"),
                             value(friction.stiffness, "stiffness"),
                             value(friction.damping, "damping"),
                             T(*friction.lag)};
  const BristleResult<T> result =
      friction.kind == FrictionLaw::Kind::lugre
          ? lugre_friction(bristles, deflection, rate)
          : elasto_plastic_friction(bristles, value(friction.elastic, "elastic"), deflection, rate);
  work.forces.xd[state] = result.rate;
  return result.force;
}

/// Force of friction, N m or N, on the part that moves at `rate`, against the motion. springs: forces of the springs
/// without friction; state: the auxiliary state of its bristles, where it has some.
template <class T>
T friction_of(ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const T& rate,
              const std::vector<ElementState<T>>& springs, std::size_t state) {
  T sliding = friction.has_bristle() ? bristle_force(work, friction, name, rate, state)
                                     : smooth_friction(work, friction, name, rate);
  if (friction.normal >= 0) sliding = sliding * abs(springs[friction.normal].force);
  return sliding - viscous_friction(work, friction, name, rate);
}

template <class T>
void frictions(ForceWork<T>& work) {
  const Model& model = work.system.model;
  const std::vector<ElementState<T>> springs = work.forces.springs;
  std::size_t state = static_cast<std::size_t>(first_bristle(model));
  const auto force_of = [&](const FrictionLaw& friction, const std::string& name, const T& rate) {
    T force = friction_of(work, friction, name, rate, springs, state);
    state += friction.has_bristle() ? 1 : 0;
    return force;
  };
  for (const JointFriction& friction : model.frictions) {
    const auto heading = work.system.scribe.within(OwnerKind::friction, index_in(model.frictions, friction));
    const T rate = work.system.environment.velocity(friction.joint);
    const T force = force_of(friction, friction.name, rate);
    work.system.scribe.name(force, "force_", friction.name);
    add_joint_force(work, friction.joint, force);
  }
  for (const SpringFriction& friction : model.spring_frictions) {
    const auto heading =
        work.system.scribe.within(OwnerKind::spring_friction, index_in(model.spring_frictions, friction));
    const PointSpring& spring = model.springs[friction.spring];
    const ElementState<T> state = line_element(work, spring.from, spring.to, [&](const T&, const T& rate, const T&) {
      T tension = -force_of(friction, friction.name, rate);
      work.system.scribe.name(tension, "force_", friction.name);
      return tension;
    });
    ElementState<T>& total = work.forces.springs[friction.spring];
    total.force = total.force + state.force;
  }
}

}  // namespace mbgen::detail
