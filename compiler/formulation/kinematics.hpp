#pragma once
// Poses of the bodies and columns b of the joints (theory.md section 1), each in the frame that the layout chose.

#include <algorithm>
#include <vector>

#include "compiler/formulation/constants.hpp"
#include "compiler/formulation/layout.hpp"

namespace mbgen {

/// Data that every part of the formulation reads.
template <class T>
struct System {
  const Model& model;
  const Topology& topology;
  const Layout& layout;
  Environment<T> environment;  ///< parameters, inputs, t, z, zd
  std::vector<T> x;            ///< auxiliary states: auxiliary_states.hpp
  Constants<T> constants;
  Annotator<T>& annotator;

  const std::string& body_name(int i) const { return topology.bodies[i].name; }
  bool revolute(int i) const { return topology.bodies[i].kind == FreedomKind::revolute; }
  const T& z(int i) const { return environment.z[i]; }
  const T& zd(int i) const { return environment.zd[i]; }
  /// The ball that starts with joint i, -1 where none does or all are in the chart of the model.
  int ball(int i) const { return environment.charts.empty() ? -1 : ball_from(topology, i); }
  /// The body whose motion body i adds to, seen in i's base frame: is it the base itself?
  bool on_base(int i) const { return topology.bodies[i].parent == layout.bodies[i].base; }
};

template <class T>
struct Kinematics {
  std::vector<Matrix<T>> orientation;   ///< R_i: axes of body i in its base frame
  std::vector<Vector<T>> position;      ///< r_i: origin of body i in its base frame, m
  std::vector<Vector<T>> axis;          ///< u_i: joint axis in the joint's frame
  std::vector<Vector<T>> pin;           ///< point of a revolute joint in the joint's frame, m
  std::vector<Spatial<T>> column;       ///< b_i of (36): motion of body i for zd_i = 1, joint's frame
  std::vector<Spatial<T>> base_column;  ///< the same in the base frame (equal to `column` inside loop blocks)
};

/// Place of an attachment on its tree body, named p_<body>_<point>.
template <class T>
Place<T> place_of(const System<T>& system, const Attachment& at) {
  Place<T> place = place_of(system.model, system.topology, system.constants, at, system.environment);
  const Body& body = system.model.bodies[at.body];
  name_constant(system.annotator, place.at, "p_", body.name, "_", body.points[at.point].name);
  return place;
}

/// Origin of a body relative to the origin of the previous body, at the reference configuration, m: p_<coordinate>.
template <class T>
Vector<T> joint_offset(const System<T>& system, int body) {
  const int parent = system.topology.bodies[body].parent;
  Vector<T> offset = system.constants.origin[body];
  if (parent != kGround) offset = offset - system.constants.origin[parent];
  name_constant(system.annotator, offset, "p_", system.topology.bodies[body].coordinate);
  return offset;
}

namespace detail {

template <class T>
Spatial<T> joint_column(bool revolute, const Vector<T>& axis, const Vector<T>& pin) {
  return revolute ? Spatial<T>{cross(pin, axis), axis} : Spatial<T>{axis, {}};
}

/// Axes of the body before a ball, in chart 1 turned by a quarter about its second axis. back: the axes are seen from
/// the other side of the ball, as rows of the rotated matrix.
template <class T>
Matrix<T> before_ball(const System<T>& system, int ball, const Matrix<T>& axes, bool back = false) {
  const int second = system.topology.balls[ball].coordinate[1];
  const Matrix<T> quarter = quarter_turn<T>(system.topology.bodies[second].axis);
  const Matrix<T> other = axes * (back ? transpose(quarter) : quarter);
  const T is_other = system.environment.charts[ball] - T(0.5);
  using mbgen::select;
  const auto chosen = [&](const Vector<T>& a, const Vector<T>& b) {
    return Vector<T>{select(is_other, a.x, b.x), select(is_other, a.y, b.y), select(is_other, a.z, b.z)};
  };
  return {chosen(other.x, axes.x), chosen(other.y, axes.y), chosen(other.z, axes.z)};
}

/// Turn of a body by successive joints about parallel axes: one rotation by the sum of their angles.
template <class T>
struct Turn {
  Matrix<T> before = identity<T>();  ///< axes that it starts from, in the base frame
  Vector3 axis{};                    ///< of the first of them; zero: no turn
  T angle{0.0};
};

/// Rotation of body i: of its joint, added to the rotation of the previous body if the axes are parallel.
template <class T>
Turn<T> turn_of(const System<T>& system, const Kinematics<T>& k, const std::vector<Turn<T>>& turns, int i) {
  const TreeBody& body = system.topology.bodies[i];
  const Turn<T> below = system.on_base(i) ? Turn<T>{} : turns[body.parent];
  if (!system.revolute(i)) return below;
  if (const int ball = system.ball(i); ball >= 0) {
    const Matrix<T> axes = system.on_base(i) ? identity<T>() : k.orientation[body.parent];
    return {before_ball(system, ball, axes), body.axis, system.z(i)};
  }
  const Vector3 opposite{-body.axis[0], -body.axis[1], -body.axis[2]};
  if (below.axis == body.axis) return {below.before, below.axis, below.angle + system.z(i)};
  if (below.axis == opposite) return {below.before, below.axis, below.angle - system.z(i)};
  return {system.on_base(i) ? identity<T>() : k.orientation[body.parent], body.axis, system.z(i)};
}

/// Pose of body i in its base frame, from its parent's.
template <class T>
void advance_pose(const System<T>& system, Kinematics<T>& k, const Turn<T>& turn, int i) {
  const TreeBody& body = system.topology.bodies[i];
  const bool on_base = system.on_base(i);
  const int p = body.parent;
  const Matrix<T> parent_axes = on_base ? identity<T>() : k.orientation[p];
  const Vector<T> offset = joint_offset(system, i);
  const Vector<T> axis = (system.revolute(i) ? turn.before : parent_axes) * constant<T>(body.axis);
  Vector<T> place = parent_axes * offset;
  if (!on_base) place = k.position[p] + place;
  if (system.revolute(i)) {
    k.orientation[i] = turn.before * rotation(turn.axis, turn.angle);
    k.position[i] = place;
  } else {
    k.orientation[i] = parent_axes;
    k.position[i] = place + system.z(i) * axis;
  }
  k.base_column[i] = joint_column(system.revolute(i), axis, place);
  if (system.layout.bodies[i].joint_frame == system.layout.bodies[i].base) {
    k.axis[i] = axis;
    k.pin[i] = place;
    k.column[i] = k.base_column[i];
  }
}

/// Joints of an own body in its own frame, from the body down: the far side of the chain never enters.
template <class T>
void own_chain(const System<T>& system, Kinematics<T>& k, int end) {
  const int start = system.layout.bodies[end].chain_start;
  Matrix<T> axes = identity<T>();  // of the joint's child, in the end body's frame
  Vector<T> place;                 // its origin there
  for (int i = end;; i = system.topology.bodies[i].parent) {
    const TreeBody& body = system.topology.bodies[i];
    k.axis[i] = axes * constant<T>(body.axis);
    k.pin[i] = place;
    k.column[i] = joint_column(system.revolute(i), k.axis[i], place);
    if (system.revolute(i)) {
      axes = axes * transpose(rotation(body.axis, system.z(i)));
      if (const int ball = system.ball(i); ball >= 0) axes = before_ball(system, ball, axes, true);
    } else {
      place = place - system.z(i) * k.axis[i];
    }
    if (i == start) break;
    place = place + axes * -joint_offset(system, i);
  }
  if (system.on_base(start)) k.orientation[end] = transpose(axes);
}

}  // namespace detail

/// Poses and joint columns of all bodies. Cost: linear. Source: (36), theory.md section 1.
template <class T>
Kinematics<T> kinematics(System<T>& system) {
  const std::size_t n = system.topology.bodies.size();
  Kinematics<T> k;
  k.orientation.resize(n);
  k.position.resize(n);
  k.axis.resize(n);
  k.pin.resize(n);
  k.column.resize(n);
  k.base_column.resize(n);
  std::vector<detail::Turn<T>> turns(n);
  for (int i = 0; i < static_cast<int>(n); ++i) {
    const auto heading = within_body(system.annotator, i);
    turns[i] = detail::turn_of(system, k, turns, i);
    system.annotator.detail(turns[i].angle, "angle_", system.body_name(i));
    detail::advance_pose(system, k, turns[i], i);
    if (system.layout.bodies[i].chain_start >= 0) detail::own_chain(system, k, i);
    name(system.annotator, k.orientation[i], "R_", system.body_name(i));
    name(system.annotator, k.position[i], "r_", system.body_name(i));
    name(system.annotator, k.axis[i], "u_", system.topology.bodies[i].coordinate);
    detail_name(system.annotator, k.pin[i], "pin_", system.topology.bodies[i].coordinate);
  }
  for (int i = 0; i < static_cast<int>(n); ++i)
    name(system.annotator, k.column[i].linear, "b_", system.topology.bodies[i].coordinate);
  return k;
}

/// Origin of a body relative to its parent's origin, in the axes of its base frame, m.
template <class T>
Vector<T> offset_from_parent(const System<T>& system, const Kinematics<T>& k, int i) {
  if (system.on_base(i)) return k.position[i];
  const Vector<T> offset = k.orientation[system.topology.bodies[i].parent] * joint_offset(system, i);
  return system.revolute(i) ? offset : offset + system.z(i) * k.base_column[i].linear;
}

/// Position of a place in a frame at or below the one that carries its body, m.
template <class T>
Vector<T> position_in(const System<T>& system, const Kinematics<T>& k, const Place<T>& place, int frame) {
  if (place.body == frame) return place.at;
  Vector<T> at = k.position[place.body] + k.orientation[place.body] * place.at;
  for (int f = system.layout.bodies[place.body].base; f != frame; f = system.layout.bodies[f].base)
    at = k.position[f] + k.orientation[f] * at;
  return at;
}

/// A direction given in body axes, in the axes of a frame at or below.
template <class T>
Vector<T> direction_in(const System<T>& system, const Kinematics<T>& k, int body, Vector<T> direction, int frame) {
  for (int f = body; f != frame; f = system.layout.bodies[f].base) direction = k.orientation[f] * direction;
  return direction;
}

/// A direction given in a frame, in the axes of a frame at or above it (an own body reached through bases).
template <class T>
Vector<T> direction_up(const System<T>& system, const Kinematics<T>& k, int frame, const Vector<T>& direction,
                       int above) {
  if (above == frame) return direction;
  return transposed_times(k.orientation[above],
                          direction_up(system, k, frame, direction, system.layout.bodies[above].base));
}

/// Deepest frame that carries both bodies.
template <class T>
int common_frame(const System<T>& system, int a, int b) {
  std::vector<int> below;
  for (int f = system.layout.frame_of(a);; f = system.layout.bodies[f].base) {
    below.push_back(f);
    if (f == kGround) break;
  }
  int f = system.layout.frame_of(b);
  while (std::find(below.begin(), below.end(), f) == below.end()) f = system.layout.bodies[f].base;
  return f;
}

}  // namespace mbgen
