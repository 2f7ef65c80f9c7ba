#pragma once
// Forces and torques on bodies.

#include "compiler/formulation/elements/element_tangents.hpp"

namespace mbgen {
namespace detail {

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
void apply(ForceWork<T>& work, const AppliedForce& applied) {
  const System<T>& system = work.system;
  const Place<T> place = work.place(applied.at);
  const auto seen = [&](const Vector3Quantity& components) {
    return in_carrier(work, applied, place, value_of(system.model, components, system.environment));
  };
  const Vector<T> force = seen(applied.force), torque = seen(applied.torque);
  act(work, {applied.at.body, force, torque, arm_of(system, work.k, place, work.forces.about)});
}

template <>
inline constexpr int kTangentPass<AppliedForce> = 2;

/// By components that look at states of the user's own, by all that these look at.
template <class T>
void add_tangents(ForceWork<T>& work, const AppliedForce& applied, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const System<T>& system = work.system;
  const Model& model = system.model;
  const Place<T> place = work.place(applied.at);
  if (place.body == kGround) return;
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

}  // namespace detail
}  // namespace mbgen
