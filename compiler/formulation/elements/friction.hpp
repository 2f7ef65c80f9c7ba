#pragma once
// Friction on coordinates and along springs, part of the applied forces.

#include "compiler/formulation/elements/force_work.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/bristle.hpp"

namespace mbgen::detail {

/// rad/s: below it a rod's end counts as at rest, and the direction of its turn fades.
inline constexpr double kLeastTurn = 1e-9;

/// Force of the smooth law without its viscous part, N m or N, on the part that moves at `rate`.
/// A: T, or Slope<T> where the law is differentiated.
template <class T, class A>
A smooth_friction(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const A& rate) {
  const auto value = [&](const Quantity& q, const char* meaning) { return number<A>(work, q, meaning, name); };
  return friction_force(value(friction.coulomb, "coulomb"), value(friction.stiction, "stiction"), A(0.0),
                        value(friction.velocity, "velocity"), value(friction.stribeck_velocity, "stribeck"), rate);
}

/// Viscous part of the friction, N m or N.
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
  const BristleResult<A> bent =
      friction.kind == FrictionLaw::Kind::lugre
          ? lugre_friction(bristles, deflection, rate)
          : elasto_plastic_friction(bristles, value(friction.elastic, "elastic"), deflection, rate);
  if (!friction.is_for_slopes) return bent;
  using mbgen::select;
  const BristleResult<A> open = open_bristle(bristles, *friction.lag, deflection, rate);
  const A has_limit = largest_deflection(bristles, rate) - A(2 * kLeastBristle);
  return {select(has_limit, bent.force, open.force), select(has_limit, bent.rate, open.rate)};
}

/// Force of friction, N m or N, on the part that moves at `rate`, against the motion, and the rate of its bristles.
/// normal: force of the spring that presses, without friction, or of the reaction, where one does; deflection: of the
/// bristles, where there are some.
template <class T, class A>
BristleResult<A> friction_law(const ForceWork<T>& work, const FrictionLaw& friction, const std::string& name,
                              const A& rate, const A& normal, const A& deflection) {
  BristleResult<A> result = friction.has_bristle()
                                ? bristle_law(work, friction, name, rate, deflection)
                                : BristleResult<A>{smooth_friction(work, friction, name, rate), A(0.0)};
  if (friction.normal >= 0 || friction.load >= 0) result.force = result.force * abs(normal);
  result.force = result.force - viscous_friction(work, friction, name, rate);
  return result;
}

/// The reaction that presses a friction as it was taken last, N or N m. Requires: the friction has one.
template <class T>
const T& held_load(const System<T>& system, const FrictionLaw& friction) {
  return system.x[static_cast<std::size_t>(first_sampled_value(system.model) + friction.load)];
}

/// Moment in the ball at an end of a rod against the turn of the body there relative to the rod's line, as far as that
/// is across the line: a rod spins about it as it likes. The rod, without inertia of its own here, hands the moment on
/// by a pair of forces at its ends. moment: N m, over the size of the turn, rad/s, against it.
template <class T, class Moment>
void rod_friction(ForceWork<T>& work, const RodFriction& friction, const Moment& moment) {
  const System<T>& system = work.system;
  const Rod& rod = system.model.rods[friction.rod];
  const Attachment& end = friction.at_from ? rod.from : rod.to;
  const Line<T> line = line_between(system, work.k, work.v, rod.from, rod.to);
  const auto velocity = [&](const Place<T>& place) { return velocity_in(system, work.k, work.v, place, line.frame); };
  const int body = work.place(end).body, carrier = system.layout.frame_of(body);
  const Vector<T> along = line.reciprocal * line.gap;
  const Vector<T> spin = direction_in(system, work.k, carrier, velocity_of(system, work.v, body).angular, line.frame);
  const Vector<T> rod_turn = line.reciprocal * cross(along, velocity(line.to) - velocity(line.from));
  const Vector<T> turn = spin - dot(spin, along) * along - rod_turn;
  using std::sqrt;
  const T rate = sqrt(dot(turn, turn) + T(kLeastTurn * kLeastTurn));
  const Vector<T> on_body = (moment(rate) / rate) * turn;
  const Vector<T> on_to = line.reciprocal * cross(along, on_body);  // of -on_body = gap x on_to, the rod at rest
  act(work, {end.body, {}, direction_up(system, work.k, line.frame, on_body, carrier), {}});
  apply_force(work, rod.to.body, line.to, on_to, line.frame);
  apply_force(work, rod.from.body, line.from, -on_to, line.frame);
}

template <class T>
void frictions(ForceWork<T>& work) {
  const Model& model = work.system.model;
  const std::vector<ElementState<T>> springs = work.forces.springs;
  std::size_t state = static_cast<std::size_t>(first_bristle(model));
  const auto force_of = [&](const FrictionLaw& friction, const std::string& name, const T& rate) {
    const T normal = friction.normal >= 0 ? springs[friction.normal].force
                     : friction.load >= 0 ? held_load(work.system, friction)
                                          : T(0.0);
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
  for (const RodFriction& friction : model.rod_frictions) {
    const auto heading = work.system.scribe.within(OwnerKind::rod_friction, index_in(model.rod_frictions, friction));
    rod_friction(work, friction, [&](const T& rate) { return force_of(friction, friction.name, rate); });
  }
}

}  // namespace mbgen::detail
