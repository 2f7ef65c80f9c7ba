#pragma once
// Tangents of a force element: how its forces, and the rates of its auxiliary states, change with its own coordinates
// (a length, a joint's angle, the motion of a tyre's contact), their rates and the states, and along which directions
// of the tree these coordinates go. The change of a direction at a constant force is left out, see
// docs/method/implicit.md.

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/formulation/elements/seen_place.hpp"
#include "compiler/formulation/elements/slope.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

/// A coordinate that an element acts along or looks at: it moves by row . zd.
template <class T>
struct LocalCoordinate {
  std::vector<T> row;  ///< over the tree's coordinates
  /// One number for one coordinate in all elements: that of the tree's coordinate, or their number and that of the
  /// line whose length it is, see each_line; -1 of an element's own.
  int shared = -1;
};

/// Derivatives of one element. Its force a acts along local coordinate a. Matrices are [force or rate][by what].
template <class T>
struct ElementTangents {
  std::vector<LocalCoordinate<T>> coordinates;
  std::vector<int> states;                                                        ///< auxiliary ones
  std::vector<std::vector<T>> by_position, by_velocity, by_state;                 ///< of forces
  std::vector<std::vector<T>> rate_by_position, rate_by_velocity, rate_by_state;  ///< of the rates of its states
  /// Of its forces by velocities, states eliminated, the symmetric part counts.
  bool counts_as_symmetric = false;
};

namespace detail {

/// Elements add their tangents pass after pass, in each in the order of the list of kinds: the order of these sums is
/// part of the bits of emitted code.
template <class Kind>
inline constexpr int kTangentPass = 1;
inline constexpr int kTangentPasses = 3;

template <class T>
std::vector<std::vector<T>> zeros(std::size_t rows, std::size_t columns) {
  return std::vector<std::vector<T>>(rows, std::vector<T>(columns, T(0.0)));
}

/// Gives the matrices of an element their sizes; what is new is zero.
template <class T>
void fit(ElementTangents<T>& e) {
  const std::size_t coordinates = e.coordinates.size(), states = e.states.size();
  const auto to = [](std::vector<std::vector<T>>& matrix, std::size_t rows, std::size_t columns) {
    matrix.resize(rows);
    for (std::vector<T>& row : matrix) row.resize(columns, T(0.0));
  };
  for (auto* matrix : {&e.by_position, &e.by_velocity}) to(*matrix, coordinates, coordinates);
  to(e.by_state, coordinates, states);
  for (auto* matrix : {&e.rate_by_position, &e.rate_by_velocity}) to(*matrix, states, coordinates);
  to(e.rate_by_state, states, states);
}

/// An element with no tangents yet.
template <class T>
ElementTangents<T> element_tangents(std::vector<LocalCoordinate<T>> coordinates, std::vector<int> states) {
  ElementTangents<T> element{std::move(coordinates), std::move(states), {}, {}, {}, {}, {}, {}, false};
  fit(element);
  return element;
}

/// The place of a coordinate in an element, which takes it in where it does not have it.
template <class T>
std::size_t place_in(ElementTangents<T>& element, LocalCoordinate<T> coordinate) {
  auto& all = element.coordinates;
  std::size_t place = all.size();
  if (coordinate.shared >= 0)
    place =
        static_cast<std::size_t>(std::ranges::find(all, coordinate.shared, &LocalCoordinate<T>::shared) - all.begin());
  if (place < all.size()) return place;
  all.push_back(std::move(coordinate));
  fit(element);
  return place;
}

/// The place of an auxiliary state in an element, likewise.
template <class T>
std::size_t place_of_state(ElementTangents<T>& element, int state) {
  const auto place = static_cast<std::size_t>(std::ranges::find(element.states, state) - element.states.begin());
  if (place < element.states.size()) return place;
  element.states.push_back(state);
  fit(element);
  return place;
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

/// Adds to a row how a force through a place and a moment, on its body, act on the tree's coordinates, without the
/// joints that also move body `other`. frame: of their axes, which both bodies see. Joints are met in their base
/// frames, where the axes of many are constant; those on the ground, which may be far away, in the frame that carries
/// the body.
template <class T>
void add_force(const ForceWork<T>& work, const Place<T>& place, int other, int frame, const Vector<T>& force,
               const Vector<T>& moment, std::vector<T>& row) {
  const System<T>& system = work.system;
  const Kinematics<T>& k = work.k;
  if (place.body == kGround) return;
  if (frame == kGround) {
    const int carrier = system.layout.frame_of(place.body);
    Spatial<T> wrench = force_at(direction_up(system, k, frame, force, carrier), local_position(system, k, place));
    wrench.angular = wrench.angular + direction_up(system, k, frame, moment, carrier);
    add_wrench(work, place.body, other, wrench, row);
    return;
  }
  for (int j = place.body; j != kGround && !(other != kGround && on_path(system.topology, other, j));
       j = system.topology.bodies[j].parent) {
    const int base = system.layout.bodies[j].base;
    const Vector<T> seen = direction_up(system, k, frame, force, base);
    const Spatial<T>& column = k.base_column[j];
    if (!system.revolute(j)) {
      row[j] = row[j] + dot(column.linear, seen);
      continue;
    }
    const Vector<T> arm = position_in(system, k, place, base) - k.position[j];
    row[j] = row[j] + dot(column.angular, cross(arm, seen) + direction_up(system, k, frame, moment, base));
  }
}

/// A coordinate of the tree; one that does not move where the tree does not have it.
template <class T>
LocalCoordinate<T> tree_local(const System<T>& system, const CoordinateReference& reference) {
  LocalCoordinate<T> local{std::vector<T>(system.topology.bodies.size(), T(0.0)),
                           tree_coordinate(system.topology, reference)};
  if (local.shared >= 0) local.row[local.shared] = T(1.0);
  return local;
}

/// How a coordinate between two bodies moves with the tree's coordinates: what a unit force along it does, turned
/// round. force, moment: on `to`, in the axes of the body of `from`.
template <class T>
std::vector<T> row_between(const ForceWork<T>& work, const SeenPlace<T>& s, const Vector<T>& force,
                           const Vector<T>& moment) {
  const System<T>& system = work.system;
  std::vector<T> row(system.topology.bodies.size(), T(0.0));
  const auto seen = [&](const Vector<T>& v) { return direction_in(system, work.k, s.from.body, v, s.frame); };
  add_force(work, s.to, s.from.body, s.frame, seen(force), seen(moment), row);
  add_force(work, s.from, s.to.body, s.frame, seen(-force), seen(-moment - cross(s.gap, force)), row);
  return row;
}

/// The distance of two points, m.
template <class T>
struct AlongLine {
  const Attachment &from, &to;
  int number = -1;  ///< of the line in expressions, see LocalCoordinate; -1 of one that they do not see
  Line<T> line;
  T position, rate;  ///< m, m/s

  AlongLine(const ForceWork<T>& work, const Attachment& a, const Attachment& b, int of_expressions)
      : from(a),
        to(b),
        number(of_expressions),
        line(line_between(work.system, work.k, work.v, a, b)),
        position(line.length),
        rate(line.rate) {}

  /// The distance at the reference, m.
  T reference(const ForceWork<T>& work) const {
    return reference_distance(work.system.topology, work.system.constants, to, line.to, from, line.from);
  }
  void resist(ForceWork<T>& work, const T& tension) const {
    const Vector<T> force = (tension * line.reciprocal) * line.gap;
    apply_force(work, from.body, line.from, force, line.frame);
    apply_force(work, to.body, line.to, -force, line.frame);
  }
  LocalCoordinate<T> row(const ForceWork<T>& work) const {
    const Vector<T> direction = line.reciprocal * line.gap;
    std::vector<T> row(work.system.topology.bodies.size(), T(0.0));
    add_force(work, line.to, line.from.body, line.frame, direction, {}, row);
    add_force(work, line.from, line.to.body, line.frame, -direction, {}, row);
    return {std::move(row), number < 0 ? -1 : work.system.topology.size() + number};
  }
};

/// Local coordinate that an expression depends on: a coordinate of the tree, or a length.
template <class T>
LocalCoordinate<T> local_of(const ForceWork<T>& work, const ExpressionNode& node) {
  if (node.kind == ExpressionNode::Kind::position || node.kind == ExpressionNode::Kind::velocity)
    return tree_local(work.system, node.coordinate);
  LocalCoordinate<T> local;
  int number = 0;
  each_line(work.system.model, [&](const auto& element) {
    if (number++ == node.index) local = AlongLine<T>(work, element.from, element.to, node.index).row(work);
  });
  return local;
}

/// Where a law is differentiated: at its coordinates, their rates and its states.
template <class T>
struct LawPoint {
  std::vector<T> position, velocity, state;
};

/// Results of a law: forces along the first coordinates, and the rates of the first states.
template <class T>
struct LawResult {
  std::vector<T> force, rate;
};

/// An element as its law sees it.
template <class T>
struct LawElement {
  std::vector<LocalCoordinate<T>> coordinates;
  std::vector<int> states = {};
  LawPoint<T> at = {};                ///< of the first of them, by which the law is differentiated
  std::vector<int> expressions = {};  ///< of the law: it is differentiated by what these look at, too; -1 for none
};

inline void add_expression(const Quantity& field, std::vector<int>& to) { to.push_back(field.expression); }
inline void add_expression(const std::optional<int>& field, std::vector<int>& to) { to.push_back(field.value_or(-1)); }
inline void add_expression(const std::optional<Law>& field, std::vector<int>& to) {
  if (field && std::holds_alternative<Quantity>(*field)) add_expression(std::get<Quantity>(*field), to);
}

/// The expressions of an element's fields, -1 for none.
template <class... Fields>
std::vector<int> expressions_of(const Fields&... fields) {
  std::vector<int> expressions;
  (add_expression(fields, expressions), ...);
  return expressions;
}

/// Moving quantities that the expressions depend on, each once.
inline std::vector<const ExpressionNode*> moving_nodes(const Model& model, const std::vector<int>& expressions) {
  using Kind = ExpressionNode::Kind;
  std::vector<const ExpressionNode*> nodes;
  const auto moves = [&](const ExpressionNode& node) {
    if (node.kind == Kind::state) return node.index < static_cast<int>(model.states.size());  // others hold
    return node.kind == Kind::position || node.kind == Kind::velocity || node.kind == Kind::length ||
           node.kind == Kind::rate;
  };
  for (const int expression : expressions) {
    if (expression < 0) continue;
    for (const ExpressionNode& node : model.expressions[expression].nodes) {
      const bool is_new = std::ranges::none_of(nodes, [&](const ExpressionNode* other) {
        return other->kind == node.kind && other->coordinate == node.coordinate && other->index == node.index;
      });
      if (moves(node) && is_new) nodes.push_back(&node);
    }
  }
  return nodes;
}

/// Derivatives of a law. law(LawPoint<Slope<T>>): LawResult<Slope<T>>.
template <class T, class Law>
ElementTangents<T> differentiated(ForceWork<T>& work, LawElement<T> of, const Law& law) {
  using S = Slope<T>;
  using Kind = ExpressionNode::Kind;
  ElementTangents<T> e = element_tangents(std::move(of.coordinates), std::move(of.states));
  LawPoint<S> point{{of.at.position.begin(), of.at.position.end()},
                    {of.at.velocity.begin(), of.at.velocity.end()},
                    {of.at.state.begin(), of.at.state.end()}};
  const auto take = [&](auto forces, auto rates, std::size_t by) {
    const LawResult<S> result = law(std::as_const(point));
    for (std::size_t a = 0; a < result.force.size(); ++a)
      (e.*forces)[a][by] = (e.*forces)[a][by] + result.force[a].slope;
    for (std::size_t s = 0; s < result.rate.size(); ++s) (e.*rates)[s][by] = (e.*rates)[s][by] + result.rate[s].slope;
  };
  using E = ElementTangents<T>;
  const auto along = [&](S& moved, auto forces, auto rates, std::size_t by) {
    moved.slope = T(1.0);
    take(forces, rates, by);
    moved.slope = T(0.0);
  };
  for (std::size_t b = 0; b < point.velocity.size(); ++b) {
    along(point.position[b], &E::by_position, &E::rate_by_position, b);
    along(point.velocity[b], &E::by_velocity, &E::rate_by_velocity, b);
  }
  for (std::size_t s = 0; s < point.state.size(); ++s) along(point.state[s], &E::by_state, &E::rate_by_state, s);
  const Model& model = work.system.model;
  for (const ExpressionNode* node : moving_nodes(model, of.expressions)) {
    work.moved = node;
    if (node->kind == Kind::state)
      take(&E::by_state, &E::rate_by_state, place_of_state(e, first_user_state(model) + node->index));
    else if (node->kind == Kind::position || node->kind == Kind::length)
      take(&E::by_position, &E::rate_by_position, place_in(e, local_of(work, *node)));
    else
      take(&E::by_velocity, &E::rate_by_velocity, place_in(e, local_of(work, *node)));
    work.moved = nullptr;
  }
  return e;
}

/// One local coordinate with a force law. force(position, rate) of Slopes.
template <class T, class Force>
ElementTangents<T> scalar_element(ForceWork<T>& work, LocalCoordinate<T> coordinate, const T& position, const T& rate,
                                  std::vector<int> expressions, const Force& force) {
  return differentiated<T>(work, {{std::move(coordinate)}, {}, {{position}, {rate}, {}}, std::move(expressions)},
                           [&](const LawPoint<Slope<T>>& at) {
                             return LawResult<Slope<T>>{{force(at.position[0], at.velocity[0])}, {}};
                           });
}

/// Adds an element to another one.
template <class T>
void join(ElementTangents<T>& to, const ElementTangents<T>& from) {
  to.counts_as_symmetric = to.counts_as_symmetric && from.counts_as_symmetric;
  std::vector<std::size_t> coordinates, states;
  for (const LocalCoordinate<T>& coordinate : from.coordinates) coordinates.push_back(place_in(to, coordinate));
  for (const int state : from.states) states.push_back(place_of_state(to, state));
  const auto add = [&](auto matrix, const auto& rows, const auto& columns) {
    for (std::size_t a = 0; a < rows.size(); ++a)
      for (std::size_t b = 0; b < columns.size(); ++b) {
        T& entry = (to.*matrix)[rows[a]][columns[b]];
        entry = entry + (from.*matrix)[a][b];
      }
  };
  using E = ElementTangents<T>;
  for (const auto matrix : {&E::by_position, &E::by_velocity}) add(matrix, coordinates, coordinates);
  add(&E::by_state, coordinates, states);
  for (const auto matrix : {&E::rate_by_position, &E::rate_by_velocity}) add(matrix, states, coordinates);
  add(&E::rate_by_state, states, states);
}

/// Elements that share auxiliary states, joined to one; the others as they are.
template <class T>
std::vector<ElementTangents<T>> joined_by_states(std::vector<ElementTangents<T>> elements) {
  std::vector<ElementTangents<T>> result;
  const auto share = [](const ElementTangents<T>& a, const ElementTangents<T>& b) {
    return std::ranges::any_of(a.states, [&](int state) { return std::ranges::count(b.states, state) > 0; });
  };
  for (ElementTangents<T>& element : elements) {
    std::size_t home = result.size();
    result.push_back(std::move(element));
    for (std::size_t r = result[home].states.empty() ? 0 : home; r-- > 0;) {
      if (!share(result[r], result[home])) continue;
      join(result[r], result[home]);
      result.erase(result.begin() + static_cast<std::ptrdiff_t>(home));
      home = r;
    }
  }
  return result;
}

}  // namespace detail
}  // namespace mbgen
