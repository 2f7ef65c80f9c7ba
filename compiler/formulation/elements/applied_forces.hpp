#pragma once
// Applied forces (step 5): force elements of the model as wrenches on bodies, generalised forces on coordinates, and
// the rates of the auxiliary states. The laws themselves are templates of the runtime's headers.

#include "compiler/formulation/elements/bump_stops.hpp"
#include "compiler/formulation/elements/bushings.hpp"
#include "compiler/formulation/elements/friction.hpp"
#include "compiler/formulation/elements/tyre_road.hpp"
#include "compiler/formulation/elements/user_states.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {
namespace detail {

/// Length at which a spring or an air spring is counted from: its own, or that of the reference configuration.
template <class T>
T natural_length(const ForceWork<T>& work, const std::optional<Quantity>& own, const T& reference,
                 const std::string& element) {
  T length = own ? work.value(*own) : reference;
  work.system.scribe.constant(length, "l0_", element);
  return length;
}

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
void point_springs(ForceWork<T>& work) {
  for (const PointSpring& spring : work.system.model.springs) {
    const auto heading = work.system.scribe.within(OwnerKind::spring, index_in(work.system.model.springs, spring));
    work.forces.springs.push_back(
        line_element(work, spring.from, spring.to, [&](const T& length, const T& rate, const T& reference) {
          const T natural = natural_length(work, spring.free_length, reference, spring.name);
          const T tension = spring_tension(work, spring, length, rate, natural);
          work.system.scribe.name(tension, "tension_", spring.name);
          return tension;
        }));
  }
}

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
void air_springs(ForceWork<T>& work) {
  for (const AirSpring& spring : work.system.model.air_springs) {
    const auto heading =
        work.system.scribe.within(OwnerKind::air_spring, index_in(work.system.model.air_springs, spring));
    work.forces.air_springs.push_back(
        line_element(work, spring.from, spring.to, [&](const T& length, const T&, const T& reference) {
          const T natural = natural_length(work, spring.length, reference, spring.name);
          const T push = air_spring_push(work, spring, length, natural);
          work.system.scribe.name(push, "push_", spring.name);
          return -push;
        }));
  }
}

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
void joint_springs(ForceWork<T>& work) {
  const Model& model = work.system.model;
  for (const JointSpring& spring : model.joint_springs) {
    const auto heading = work.system.scribe.within(OwnerKind::joint_spring, index_in(model.joint_springs, spring));
    const JointDeflection<T> d = joint_deflection(work.system, spring);
    const T force = joint_spring_force(work, spring, d.position, d.rate);
    work.system.scribe.name(force, "force_", spring.name);
    add_joint_force(work, spring.joint, -force);
    if (spring.relative_to) add_joint_force(work, *spring.relative_to, force);
  }
}

template <class T>
void joint_forces(ForceWork<T>& work) {
  const Model& model = work.system.model;
  for (const JointForce& force : model.joint_forces) {
    const auto heading = work.system.scribe.within(OwnerKind::joint_force, index_in(model.joint_forces, force));
    add_joint_force(work, force.joint, work.value(force.force, "force", force.name));
  }
}

/// Components of a body's force or torque, seen from the frame that carries the place.
template <class T>
Vector<T> in_carrier(const ForceWork<T>& work, const AppliedForce& applied, const Place<T>& place,
                     const Vector<T>& components) {
  const System<T>& system = work.system;
  const int carrier = system.layout.frame_of(place.body);
  if (!applied.in_body_axes) return direction_up(system, work.k, kGround, components, carrier);
  const Pose& pose = system.model.bodies[applied.at.body].pose;
  return direction_in(system, work.k, place.body, pose_rotation<T>(pose) * components, carrier);
}

template <class T>
void body_forces(ForceWork<T>& work) {
  const System<T>& system = work.system;
  for (const AppliedForce& applied : system.model.forces) {
    const auto heading = work.system.scribe.within(OwnerKind::force, index_in(system.model.forces, applied));
    const Place<T> place = work.place(applied.at);
    const auto seen = [&](const Vector3Quantity& components) {
      return in_carrier(work, applied, place, value_of(system.model, components, system.environment));
    };
    const Vector<T> force = seen(applied.force), torque = seen(applied.torque);
    act(work, {applied.at.body, force, torque, arm_of(system, work.k, place, work.forces.about)});
  }
}

}  // namespace detail

/// All applied forces but gravity. Cost: linear in the number of elements.
template <class T>
AppliedForces<T> applied_forces(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                                const detail::SharedTyreLaw<T>& shared_law = {}) {
  AppliedForces<T> forces;
  forces.about = v.about;
  forces.wrench.resize(system.topology.bodies.size());
  forces.joint.assign(system.topology.bodies.size(), T(0.0));
  forces.xd.assign(system.x.size(), T(0.0));  // sampled values hold between the instants at which they are set
  see_states_and_lengths(system, k, v);
  detail::ForceWork<T> work{system, k, v, forces, shared_law};
  detail::point_springs(work);
  detail::air_springs(work);
  detail::joint_springs(work);
  detail::frictions(work);
  detail::joint_forces(work);
  detail::body_forces(work);
  detail::tyres(work);
  detail::bushings(work);
  detail::bump_stops(work);
  detail::user_states(work);
  return forces;
}

}  // namespace mbgen
