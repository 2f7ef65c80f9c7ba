#pragma once
// Tangents of the force elements: how the force of each changes with its own coordinates (a length, a joint's angle,
// the motion of a tyre's contact) and their rates, and along which directions of the tree these coordinates go. The
// change of a direction at a constant force is left out, see docs/method/implicit.md.

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/formulation/applied_forces.hpp"
#include "compiler/formulation/slope.hpp"

namespace mbgen {

/// Derivatives of the forces of one element. Its local coordinate a moves by rows[a] . zd, and its force a acts as
/// rows[a]' times the force.
template <class T>
struct ElementTangents {
  std::vector<std::vector<T>> rows;                      ///< per local coordinate, over the tree's coordinates
  std::vector<std::vector<T>> by_position, by_velocity;  ///< of force a by local coordinate b, N/m ...
  std::vector<int> states;                               ///< its auxiliary states
  std::vector<T> decay;                                  ///< of the rate of each by itself, 1/s
  std::vector<std::vector<T>> by_state;                  ///< of force a by state s
  std::vector<std::vector<T>> rate_by_position, rate_by_velocity;  ///< of the rate of state s by local coordinate b
};

namespace detail {

template <class T>
std::vector<std::vector<T>> zeros(std::size_t rows, std::size_t columns) {
  return std::vector<std::vector<T>>(rows, std::vector<T>(columns, T(0.0)));
}

/// An element with these rows, `states` auxiliary states from `first` on, and no tangents yet.
template <class T>
ElementTangents<T> element_tangents(std::vector<std::vector<T>> rows, std::size_t states = 0, int first = 0) {
  const std::size_t size = rows.size();
  ElementTangents<T> element{std::move(rows), zeros<T>(size, size), zeros<T>(size, size), {}, {}, {}, {}, {}};
  for (std::size_t s = 0; s < states; ++s) element.states.push_back(first + static_cast<int>(s));
  element.decay.assign(states, T(0.0));
  element.by_state = zeros<T>(size, states);
  element.rate_by_position = element.rate_by_velocity = zeros<T>(states, size);
  return element;
}

/// Adds to a row how a wrench on a body acts on the tree's coordinates, without the joints that also move body `other`.
/// wrench: in the frame that carries the body, about its origin.
template <class T>
void add_wrench(const ForceWork<T>& work, int body, int other, Spatial<T> wrench, std::vector<T>& row) {
  const System<T>& system = work.system;
  int frame = body == kGround ? kGround : system.layout.frame_of(body);
  for (int j = body; j != kGround; j = system.topology.bodies[j].parent) {
    if (other != kGround && on_path(system.topology, other, j)) return;
    for (; frame != system.layout.bodies[j].joint_frame; frame = system.layout.bodies[frame].base)
      wrench = force_at(work.k.orientation[frame] * wrench.linear, work.k.position[frame]) +
               Spatial<T>{{}, work.k.orientation[frame] * wrench.angular};
    row[j] = row[j] + dot(work.k.column[j], wrench);
  }
}

/// A coordinate of the tree as a row; zero where the tree does not have it.
template <class T>
std::vector<T> coordinate_row(const System<T>& system, const CoordinateReference& reference) {
  std::vector<T> row(system.topology.bodies.size(), T(0.0));
  if (const int i = tree_coordinate(system.topology, reference); i >= 0) row[i] = T(1.0);
  return row;
}

/// One local coordinate with a force law. force(position, rate) of Slopes.
template <class T, class Force>
ElementTangents<T> scalar_element(std::vector<T> row, const T& position, const T& rate, const Force& force) {
  using S = Slope<T>;
  ElementTangents<T> element = element_tangents<T>({std::move(row)});
  element.by_position[0][0] = force(S(position, T(1.0)), S(rate)).slope;
  element.by_velocity[0][0] = force(S(position), S(rate, T(1.0))).slope;
  return element;
}

/// The tangents of a line element. tension(length, rate, reference): of Slopes and of T.
template <class T, class Tension>
ElementTangents<T> line_tangents(ForceWork<T>& work, const Attachment& from, const Attachment& to,
                                 const Tension& tension) {
  const System<T>& system = work.system;
  const Line<T> line = line_between(system, work.k, work.v, from, to);
  const Vector<T> direction = line.reciprocal * line.gap;
  std::vector<T> row(system.topology.bodies.size(), T(0.0));
  const auto add_end = [&](const Place<T>& place, int other, const Vector<T>& force) {
    if (place.body == kGround) return;
    const int carrier = system.layout.frame_of(place.body);
    const Vector<T> seen = direction_up(system, work.k, line.frame, force, carrier);
    add_wrench(work, place.body, other, force_at(seen, local_position(system, work.k, place)), row);
  };
  add_end(line.to, line.from.body, direction);
  add_end(line.from, line.to.body, -direction);
  const T reference = reference_distance(system.topology, system.constants, to, line.to, from, line.from);
  return scalar_element(std::move(row), line.length, line.rate,
                        [&](const Slope<T>& l, const Slope<T>& rate) { return -tension(l, rate, reference); });
}

/// A force that an expression gives: local coordinates are that on which it acts and those that the expression reads.
template <class T>
ElementTangents<T> expression_tangents(const ForceWork<T>& work, std::vector<T> row, const Quantity& force) {
  const System<T>& system = work.system;
  std::vector<std::vector<T>> rows = {std::move(row)};
  std::vector<const ExpressionNode*> read;
  if (force.expression >= 0) {
    for (const ExpressionNode& node : system.model.expressions[force.expression].nodes) {
      using Kind = ExpressionNode::Kind;
      const bool is_new = std::none_of(read.begin(), read.end(), [&](const ExpressionNode* other) {
        return other->kind == node.kind && other->coordinate == node.coordinate;
      });
      if ((node.kind != Kind::position && node.kind != Kind::velocity) || !is_new) continue;
      read.push_back(&node);
      rows.push_back(coordinate_row(system, node.coordinate));
    }
  }
  ElementTangents<T> element = element_tangents<T>(std::move(rows));
  for (std::size_t r = 0; r < read.size(); ++r) {
    const MovedEnvironment<T, Slope<T>> environment{system.environment, {}, read[r]};
    const T slope = evaluate<Slope<T>>(system.model.expressions[force.expression], environment).slope;
    auto& entry = (read[r]->kind == ExpressionNode::Kind::position ? element.by_position : element.by_velocity);
    entry[0][r + 1] = slope;
  }
  return element;
}

template <class T>
void spring_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  for (const PointSpring& spring : work.system.model.springs) {
    const auto heading = work.system.scribe.within(OwnerKind::spring, index_in(work.system.model.springs, spring));
    elements.push_back(line_tangents(
        work, spring.from, spring.to, [&](const Slope<T>& length, const Slope<T>& rate, const T& reference) {
          const T natural = natural_length(work, spring.free_length, reference, spring.name);
          return spring_tension(work, spring, length, rate, natural);
        }));
  }
  for (const AirSpring& spring : work.system.model.air_springs) {
    const auto heading =
        work.system.scribe.within(OwnerKind::air_spring, index_in(work.system.model.air_springs, spring));
    elements.push_back(
        line_tangents(work, spring.from, spring.to, [&](const Slope<T>& length, const Slope<T>&, const T& reference) {
          const T natural = natural_length(work, spring.length, reference, spring.name);
          return -air_spring_push(work, spring, length, natural);
        }));
  }
}

template <class T>
void joint_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  const System<T>& system = work.system;
  const Model& model = system.model;
  for (const JointSpring& spring : model.joint_springs) {
    const auto heading = system.scribe.within(OwnerKind::joint_spring, index_in(model.joint_springs, spring));
    std::vector<T> row = coordinate_row(system, spring.joint);
    if (spring.relative_to)
      if (const int other = tree_coordinate(system.topology, *spring.relative_to); other >= 0)
        row[other] = row[other] - T(1.0);
    const JointDeflection<T> d = joint_deflection(system, spring);
    elements.push_back(
        scalar_element(std::move(row), d.position, d.rate, [&](const Slope<T>& position, const Slope<T>& rate) {
          return -joint_spring_force(work, spring, position, rate);
        }));
  }
  for (const JointFriction& friction : model.frictions) {
    if (friction.has_bristle() || friction.normal >= 0) continue;  // left out: docs/method/implicit.md
    const auto heading = system.scribe.within(OwnerKind::friction, index_in(model.frictions, friction));
    elements.push_back(scalar_element(coordinate_row(system, friction.joint), T(0.0),
                                      system.environment.velocity(friction.joint),
                                      [&](const Slope<T>&, const Slope<T>& rate) {
                                        return smooth_friction(work, friction, friction.name, rate) -
                                               viscous_friction(work, friction, friction.name, rate);
                                      }));
  }
  for (const JointForce& force : model.joint_forces) {
    const auto heading = system.scribe.within(OwnerKind::joint_force, index_in(model.joint_forces, force));
    elements.push_back(expression_tangents(work, coordinate_row(system, force.joint), force.force));
  }
}

}  // namespace detail
}  // namespace mbgen
