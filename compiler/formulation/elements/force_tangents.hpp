#pragma once
// Tangents of springs, friction, forces and the states of the user's own.

#include "compiler/formulation/elements/element_tangents.hpp"

namespace mbgen::detail {

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

template <class T>
void spring_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const Model& model = work.system.model;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const auto heading = work.system.scribe.within(OwnerKind::spring, i);
    const SpringLine<T> s = spring_line(work, static_cast<int>(i));
    elements.push_back(scalar_element(work, s.line.coordinate, s.line.length, s.line.rate, expressions_of(s.spring),
                                      [&](const S& length, const S& rate) { return -s.tension(work, length, rate); }));
  }
  for (std::size_t i = 0; i < model.air_springs.size(); ++i) {
    const AirSpring& spring = model.air_springs[i];
    const auto heading = work.system.scribe.within(OwnerKind::air_spring, i);
    const LocalLine<T> line = local_line(work, spring.from, spring.to, static_cast<int>(model.springs.size() + i));
    const T natural = natural_length(work, spring.length, line.reference, spring.name);
    elements.push_back(
        scalar_element(work, line.coordinate, line.length, line.rate, {},
                       [&](const S& length, const S&) { return air_spring_push(work, spring, length, natural); }));
  }
}

template <class T>
void joint_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const System<T>& system = work.system;
  const Model& model = system.model;
  for (const JointSpring& spring : model.joint_springs) {
    const auto heading = system.scribe.within(OwnerKind::joint_spring, index_in(model.joint_springs, spring));
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
  for (const JointForce& force : model.joint_forces) {
    const auto heading = system.scribe.within(OwnerKind::joint_force, index_in(model.joint_forces, force));
    elements.push_back(differentiated<T>(work, {{tree_local(system, force.joint)}, {}, {}, {force.force.expression}},
                                         [&](const LawPoint<S>&) {
                                           return LawResult<S>{{number<S>(work, force.force, "force", force.name)}, {}};
                                         }));
  }
}

/// A friction on a local coordinate that moves at `rate`. state: of its bristles, where it has some.
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
  std::optional<SpringLine<T>> normal;
  if (friction.normal >= 0) {
    normal.emplace(spring_line(work, friction.normal));
    const LocalLine<T>& line = normal->line;
    if (line.coordinate.shared == element.coordinates[0].shared) {
      element.at.position[0] = line.length;
    } else {
      element.coordinates.push_back(line.coordinate);
      element.at.position.push_back(line.length);
      element.at.velocity.push_back(line.rate);
    }
    for (const int expression : expressions_of(normal->spring)) element.expressions.push_back(expression);
  }
  ElementTangents<T> tangents = differentiated(work, std::move(element), [&](const LawPoint<S>& at) {
    const S pressing = normal               ? normal->tension(work, at.position.back(), at.velocity.back())
                       : friction.load >= 0 ? S(held_load(work.system, friction))
                                            : S(0.0);
    const S deflection = friction.has_bristle() ? at.state[0] : S(0.0);
    BristleResult<S> law = friction_law(work, friction, name, at.velocity[0], pressing, deflection);
    LawResult<S> result{{law.force}, {}};
    if (friction.has_bristle()) result.rate.push_back(law.rate);
    return result;
  });
  if (friction.has_bristle()) {
    // Bristles bent beyond their end spring back, and would feed the motion over a whole step.
    using mbgen::max, mbgen::min, mbgen::select;
    T &force = tangents.by_velocity[0][0], &bending = tangents.rate_by_velocity[0][0];
    force = select(bending, force, min(force, T(0.0)));
    bending = max(bending, T(0.0));
  }
  return tangents;
}

template <class T>
void friction_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  const System<T>& system = work.system;
  const Model& model = system.model;
  int state = first_bristle(model);
  for (const JointFriction& friction : model.frictions) {
    const auto heading = system.scribe.within(OwnerKind::friction, index_in(model.frictions, friction));
    elements.push_back(friction_element(work, friction, friction.name, tree_local(system, friction.joint),
                                        system.environment.velocity(friction.joint), state));
    state += friction.has_bristle() ? 1 : 0;
  }
  for (const SpringFriction& friction : model.spring_frictions) {
    const auto heading = system.scribe.within(OwnerKind::spring_friction, index_in(model.spring_frictions, friction));
    const PointSpring& spring = model.springs[friction.spring];
    const LocalLine<T> line = local_line(work, spring.from, spring.to, friction.spring);
    elements.push_back(friction_element(work, friction, friction.name, line.coordinate, line.rate, state));
    state += friction.has_bristle() ? 1 : 0;
  }
}

/// Forces and torques on bodies whose components look at states of the user's own, by all that these look at.
template <class T>
void body_force_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const System<T>& system = work.system;
  const Model& model = system.model;
  for (const AppliedForce& applied : model.forces) {
    const auto heading = system.scribe.within(OwnerKind::force, index_in(model.forces, applied));
    const Place<T> place = work.place(applied.at);
    if (place.body == kGround) continue;
    LawElement<T> element;
    std::vector<const Quantity*> components;
    for (std::size_t i = 0; i < 6; ++i) {
      const Quantity& component = i < 3 ? applied.force[i] : applied.torque[i - 3];
      const auto is_state = [](const ExpressionNode* node) { return node->kind == ExpressionNode::Kind::state; };
      if (std::ranges::none_of(moving_nodes(model, {component.expression}), is_state)) continue;
      Vector<T> axis;
      (i % 3 == 0 ? axis.x : i % 3 == 1 ? axis.y : axis.z) = T(1.0);
      axis = in_carrier(work, applied, place, axis);
      LocalCoordinate<T> along{std::vector<T>(system.topology.bodies.size(), T(0.0))};
      const Spatial<T> unit = i < 3 ? force_at(axis, local_position(system, work.k, place)) : Spatial<T>{{}, axis};
      add_wrench(work, place.body, kGround, unit, along.row);
      element.coordinates.push_back(std::move(along));
      element.expressions.push_back(component.expression);
      components.push_back(&component);
    }
    elements.push_back(differentiated(work, std::move(element), [&](const LawPoint<S>&) {
      LawResult<S> result;
      for (const Quantity* component : components)
        result.force.push_back(number<S>(work, *component, "force", applied.name));
      return result;
    }));
  }
}

/// The states of the user's own, each an element without a force.
template <class T>
void state_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const Model& model = work.system.model;
  for (std::size_t i = 0; i < model.states.size(); ++i) {
    const auto heading = work.system.scribe.within(OwnerKind::state, i);
    const UserState& state = model.states[i];
    elements.push_back(differentiated<T>(
        work, {{}, {first_user_state(model) + static_cast<int>(i)}, {}, {state.derivative.expression}},
        [&](const LawPoint<S>&) {
          return LawResult<S>{{}, {number<S>(work, state.derivative, "rate", state.name)}};
        }));
  }
}

}  // namespace mbgen::detail
