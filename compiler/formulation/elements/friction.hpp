#pragma once
// Friction on coordinates, along springs and in rod ends.

#include "compiler/formulation/elements/point_spring.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/bristle.hpp"

namespace mbgen {
namespace detail {

/// rad/s: below it a rod's end counts as at rest, and the direction of its rotation is regularised.
inline constexpr double kLeastTurn = 1e-9;

/// Force of smooth friction without its viscous part, N m or N, on the part that moves at `rate`. A: T, or Slope<T> for
/// differentiation.
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
/// normal: normal force, from a spring without its friction, or from a reaction, if any; deflection: of the bristles,
/// if any.
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

/// Relative speed of the parts of a friction with possible bristles, rad/s or m/s.
template <class T>
T sliding_rate(const System<T>& system, const Kinematics<T>&, const Velocities<T>&, const JointFriction& friction) {
  const T rate = system.environment.velocity(friction.joint);
  return friction.relative_to ? rate - system.environment.velocity(*friction.relative_to) : rate;
}
template <class T>
T sliding_rate(const System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
               const SpringFriction& friction) {
  const PointSpring& spring = system.model.springs[static_cast<std::size_t>(friction.spring)];
  return line_between(system, k, v, spring.from, spring.to).rate;
}

/// Last sampled reaction that presses a friction, N or N m. Requires: the friction has one.
template <class T>
const T& held_load(const System<T>& system, const FrictionLaw& friction) {
  return system.x[static_cast<std::size_t>(first_sampled_value(system.model) + friction.load)];
}

/// Moment in the ball joint at a rod's end against the rotation of the body relative to the rod's line, except its
/// component along the line: the rod spins freely about it. The rod, without inertia here, transmits the moment as a
/// pair of forces at its ends. moment: N m, over the angular speed, rad/s, against it.
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
  const Vector<T> on_to =
      line.reciprocal * cross(along, on_body);  // solution of -on_body = gap x on_to, the rod in equilibrium
  act(work, {end.body, {}, direction_up(system, work.k, line.frame, on_body, carrier), {}});
  apply_force(work, rod.to.body, line.to, on_to, line.frame);
  apply_force(work, rod.from.body, line.from, -on_to, line.frame);
}

/// Force of a friction, N m or N, on the part that moves at `rate`. state: of its bristles, if any.
template <class T>
T friction_force_at(ForceWork<T>& work, const FrictionLaw& friction, const std::string& name, const T& rate,
                    std::size_t state) {
  const T normal = friction.normal >= 0 ? states_of<PointSpring>(work.forces)[friction.normal].own
                   : friction.load >= 0 ? held_load(work.system, friction)
                                        : T(0.0);
  const T deflection = friction.has_bristle() ? work.system.x[state] : T(0.0);
  BristleResult<T> result = friction_law(work, friction, name, rate, normal, deflection);
  if (friction.has_bristle()) work.forces.xd[state] = result.rate;
  return result.force;
}

template <class T>
void apply(ForceWork<T>& work, const JointFriction& friction) {
  const T rate = sliding_rate(work.system, work.k, work.v, friction);
  const T force = friction_force_at(work, friction, friction.name, rate, state_of_element(work.system.model, friction));
  work.system.annotator.name(force, "force_", friction.name);
  add_joint_force(work, friction.joint, force);
  if (friction.relative_to) add_joint_force(work, *friction.relative_to, -force);
}

template <class T>
void apply(ForceWork<T>& work, const SpringFriction& friction) {
  const Model& model = work.system.model;
  const PointSpring& spring = model.springs[friction.spring];
  const AlongLine<T> at(work, spring.from, spring.to, friction.spring);
  T tension = -friction_force_at(work, friction, friction.name, at.rate, state_of_element(model, friction));
  work.system.annotator.name(tension, "force_", friction.name);
  at.resist(work, tension);
  SpringState<T>& total = states_of<PointSpring>(work.forces)[friction.spring];
  total.force = total.force + tension;
}

/// Smooth friction, without bristles.
template <class T>
void apply(ForceWork<T>& work, const RodFriction& friction) {
  rod_friction(work, friction,
               [&](const T& rate) { return friction_force_at(work, friction, friction.name, rate, 0); });
}

/// The spring that presses a friction, with its line.
template <class T>
struct PressingSpring {
  const PointSpring& spring;
  AlongLine<T> at;
  LocalCoordinate<T> row;
  T natural;  ///< m
};

/// number: index into Model::springs.
template <class T>
PressingSpring<T> pressing_spring(const ForceWork<T>& work, int number) {
  const PointSpring& spring = work.system.model.springs[number];
  const AlongLine<T> at(work, spring.from, spring.to, number);
  LocalCoordinate<T> row = at.row(work);
  return {spring, at, std::move(row), natural_length(work, spring.free_length, at.reference(work), spring.name)};
}

/// A friction on a local coordinate that moves at `rate`. state: of its bristles, if any.
template <class T>
ElementTangents<T> friction_element(ForceWork<T>& work, const FrictionLaw& friction, const std::string& name,
                                    LocalCoordinate<T> coordinate, const T& rate, int state) {
  using S = Slope<T>;
  LawElement<T> element{
      {std::move(coordinate)}, {}, {{T(0.0)}, {rate}, {}}, {friction.coulomb.expression, friction.stiction.expression}};
  if (friction.has_bristle()) {
    element.states.push_back(state);
    element.at.state.push_back(work.system.x[state]);
  }
  std::optional<PressingSpring<T>> normal;
  if (friction.normal >= 0) {
    normal.emplace(pressing_spring(work, friction.normal));
    const LocalCoordinate<T>& line = normal->row;
    if (line.shared == element.coordinates[0].shared) {
      element.at.position[0] = normal->at.position;
    } else {
      element.coordinates.push_back(line);
      element.at.position.push_back(normal->at.position);
      element.at.velocity.push_back(normal->at.rate);
    }
    for (const int expression : law_expressions(work, normal->spring)) element.expressions.push_back(expression);
  }
  ElementTangents<T> tangents = differentiated(work, std::move(element), [&](const LawPoint<S>& at) {
    const S pressing =
        normal ? spring_tension(work, normal->spring, at.position.back(), at.velocity.back(), normal->natural)
        : friction.load >= 0 ? S(held_load(work.system, friction))
                             : S(0.0);
    const S deflection = friction.has_bristle() ? at.state[0] : S(0.0);
    BristleResult<S> law = friction_law(work, friction, name, at.velocity[0], pressing, deflection);
    LawResult<S> result{{law.force}, {}};
    if (friction.has_bristle()) result.rate.push_back(law.rate);
    return result;
  });
  if (friction.has_bristle()) {
    // Bristles beyond their largest deflection spring back, and would add energy over a whole step.
    using mbgen::max, mbgen::min, mbgen::select;
    T &force = tangents.by_velocity[0][0], &bending = tangents.rate_by_velocity[0][0];
    force = select(bending, force, min(force, T(0.0)));
    bending = max(bending, T(0.0));
  }
  return tangents;
}

template <class T>
void add_tangents(ForceWork<T>& work, const JointFriction& friction, std::vector<ElementTangents<T>>& elements) {
  const System<T>& system = work.system;
  LocalCoordinate<T> row = friction.relative_to
                               ? AlongCoordinate<T>(system, friction.joint, friction.relative_to).row(work)
                               : tree_local(system, friction.joint);
  elements.push_back(friction_element(work, friction, friction.name, std::move(row),
                                      sliding_rate(system, work.k, work.v, friction),
                                      static_cast<int>(state_of_element(system.model, friction))));
}

template <class T>
void add_tangents(ForceWork<T>& work, const SpringFriction& friction, std::vector<ElementTangents<T>>& elements) {
  const Model& model = work.system.model;
  const PointSpring& spring = model.springs[friction.spring];
  const AlongLine<T> line(work, spring.from, spring.to, friction.spring);
  elements.push_back(friction_element(work, friction, friction.name, line.row(work), line.rate,
                                      static_cast<int>(state_of_element(model, friction))));
}

}  // namespace detail
}  // namespace mbgen
