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
  const auto value = [&](const Quantity& q, const char* meaning) { return number<A>(work, q, meaning, name); };
  return friction_force(value(friction.coulomb, "coulomb"), value(friction.stiction, "stiction"), A(0.0),
                        value(friction.velocity, "velocity"), value(friction.stribeck_velocity, "stribeck"), rate);
}

/// What the viscous part takes from it, N m or N.
template <class T, class A>
A viscous_friction(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const A& rate) {
  return number<A>(work, friction.viscous, "viscous", name) * rate;
}

/// Force of bristles, N m or N, on the part that moves at `rate`, and the rate of their deflection.
template <class T, class A>
BristleResult<A> bristle_law(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name,
                             const A& rate, const A& deflection) {
  const auto value = [&](const Quantity& q, const char* meaning) { return number<A>(work, q, meaning, name); };
  const Bristles<A> bristles{value(friction.coulomb, "coulomb"),
                             value(friction.stiction, "stiction"),
                             value(friction.stribeck_velocity, "stribeck"),
                             value(friction.stiffness, "stiffness"),
                             value(friction.damping, "damping"),
                             A(*friction.lag)};
  return friction.kind == FrictionLaw::Kind::lugre
             ? lugre_friction(bristles, deflection, rate)
             : elasto_plastic_friction(bristles, value(friction.elastic, "elastic"), deflection, rate);
}

/// Force of friction, N m or N, on the part that moves at `rate`, against the motion, and the rate of its bristles.
/// normal: force of the spring that presses, without friction, where one does; deflection: of the bristles, where there
/// are some.
template <class T, class A>
BristleResult<A> friction_law(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name,
                              const A& rate, const A& normal, const A& deflection) {
  BristleResult<A> result = friction.has_bristle()
                                ? bristle_law(work, friction, name, rate, deflection)
                                : BristleResult<A>{smooth_friction(work, friction, name, rate), A(0.0)};
  if (friction.normal >= 0) result.force = result.force * abs(normal);
  result.force = result.force - viscous_friction(work, friction, name, rate);
  return result;
}

template <class T>
void frictions(ForceWork<T>& work) {
  const Model& model = work.system.model;
  const std::vector<ElementState<T>> springs = work.forces.springs;
  std::size_t state = static_cast<std::size_t>(first_bristle(model));
  const auto force_of = [&](const FrictionLaw& friction, const std::string& name, const T& rate) {
    const T normal = friction.normal >= 0 ? springs[friction.normal].force : T(0.0);
    const T deflection = friction.has_bristle() ? work.system.x[state] : T(0.0);
    BristleResult<T> result = friction_law(work, friction, name, rate, normal, deflection);
    if (friction.has_bristle()) work.forces.xd[state++] = result.rate;
    return result.force;
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
