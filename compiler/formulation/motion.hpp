#pragma once
// Velocity and acceleration sweeps from the root to the leaves. Accelerations belong to material points (theory.md
// section 1, material convention) less gravity, so that gravity enters once, at the root, and body frames may move.

#include "compiler/formulation/kinematics.hpp"

namespace mbgen {

/// Point that the motion of a body, and the forces on it, are about, in the axes of the frame that carries the body.
enum class MotionPoint {
  frame_origin,  ///< of the frame that carries the body: the paper's Z (32)
  body_origin    ///< the body's own: the recursive form
};

/// Acceleration of a body about such a point: of its point there (less gravity), angular, and w~w~ + alpha~.
template <class T>
struct Acceleration {
  Vector<T> linear, angular;
  Matrix<T> gradient{};
  /// Acceleration of the body point at `place`.
  Vector<T> at(const Vector<T>& place) const { return linear + gradient * place; }
};

/// Motion of each body in the axes of its base frame (Z of (32) about that frame's origin), and of own bodies also in
/// their own, about their own origin.
template <class T>
struct Velocities {
  std::vector<Spatial<T>> base, own;
  MotionPoint about = MotionPoint::frame_origin;
};

template <class T>
struct Accelerations {
  std::vector<Acceleration<T>> base, own;
  Acceleration<T> ground;  ///< -g, global axes
  MotionPoint about = MotionPoint::frame_origin;
};

/// A motion seen from another frame: r holds its axes, `place` its origin, both in the old frame.
template <class T>
Spatial<T> seen_from(const Matrix<T>& r, const Vector<T>& place, const Spatial<T>& motion) {
  return {transposed_times(r, velocity_at(motion, place)), transposed_times(r, motion.angular)};
}

template <class T>
Acceleration<T> seen_from(const Matrix<T>& r, const Vector<T>& place, const Acceleration<T>& a,
                          const Vector<T>& velocity) {
  const Vector<T> angular = transposed_times(r, a.angular);
  return {transposed_times(r, a.at(place)), angular, acceleration_gradient(velocity, angular)};
}

/// Z_i = Z_p + b_i zd_i (36).
template <class T>
Spatial<T> advanced(const Spatial<T>& parent, const Spatial<T>& column, const T& zd) {
  return parent + zd * column;
}

/// Acceleration of a joint's child from its parent's, same frame (37). velocity: angular velocities of parent and
/// child.
template <class T>
Acceleration<T> advanced(const Acceleration<T>& parent, bool revolute, const Vector<T>& axis, const Vector<T>& pin,
                         const T& zd, const T& zdd, const Vector<T>& parent_velocity, const Vector<T>& velocity) {
  Acceleration<T> child = parent;
  if (revolute) {
    child.angular = parent.angular + zdd * axis + cross(parent_velocity, zd * axis);
    child.gradient = acceleration_gradient(velocity, child.angular);
    child.linear = parent.linear + (parent.gradient - child.gradient) * pin;
  } else {
    const Vector<T> coriolis = cross(parent_velocity, zd * axis);
    child.linear = parent.linear + zdd * axis + coriolis + coriolis;
  }
  return child;
}

namespace detail {

template <class T>
Spatial<T> parent_velocity(const System<T>& system, const Velocities<T>& v, int i) {
  const int p = system.topology.bodies[i].parent;
  if (p == kGround) return {};
  return p == system.layout.bodies[i].base ? v.own[p] : v.base[p];
}

template <class T>
Acceleration<T> parent_acceleration(const System<T>& system, const Accelerations<T>& a, int i) {
  const int p = system.topology.bodies[i].parent;
  if (p == kGround) return a.ground;
  return p == system.layout.bodies[i].base ? a.own[p] : a.base[p];
}

/// Joint i in the base frame of its body, about the points that motions are about.
template <class T>
struct JointSeen {
  Vector<T> offset;     ///< of the point of the child from the parent's point
  Vector<T> axis, pin;  ///< pin: from the point of the child
  Spatial<T> column;    ///< motion of the child for a unit rate
  Vector<T> origin;     ///< of the child, from its point
};

template <class T>
JointSeen<T> joint_seen(const System<T>& system, const Kinematics<T>& k, int i, MotionPoint about) {
  const Vector<T>& axis = system.revolute(i) ? k.base_column[i].angular : k.base_column[i].linear;
  if (about == MotionPoint::frame_origin) return {{}, axis, k.position[i], k.base_column[i], k.position[i]};
  return {offset_from_parent(system, k, i), axis, {}, joint_column(system.revolute(i), axis, Vector<T>{}), {}};
}

/// Origin of an own body from the point of the body that its chain of joints starts on.
template <class T>
Vector<T> end_from_parent(const System<T>& system, const Kinematics<T>& k, int end, MotionPoint about) {
  const int start = system.layout.bodies[end].chain_start;
  if (about == MotionPoint::frame_origin || system.on_base(start)) return k.position[end];
  return k.position[end] - k.position[system.topology.bodies[start].parent];
}

/// Joints of an own body's chain, lowest first.
inline std::vector<int> chain_of(const Topology& topology, const Layout& layout, int end) {
  std::vector<int> chain;
  for (int i = end;; i = topology.bodies[i].parent) {
    chain.insert(chain.begin(), i);
    if (i == layout.bodies[end].chain_start) return chain;
  }
}

}  // namespace detail

/// Velocities of all bodies (step 4), (36). Cost: linear.
template <class T>
Velocities<T> velocities(System<T>& system, const Kinematics<T>& k, MotionPoint about = MotionPoint::frame_origin) {
  const int n = system.topology.size();
  Velocities<T> v{std::vector<Spatial<T>>(n), std::vector<Spatial<T>>(n), about};
  for (int i = 0; i < n; ++i) {
    const BodyLayout& layout = system.layout.bodies[i];
    const auto heading = within_body(system.annotator, i);
    const detail::JointSeen<T> joint = detail::joint_seen(system, k, i, about);
    const Spatial<T> parent = detail::parent_velocity(system, v, i);
    v.base[i] = advanced(Spatial<T>{velocity_at(parent, joint.offset), parent.angular}, joint.column, system.zd(i));
    if (layout.chain_start >= 0) {
      v.own[i] = seen_from(k.orientation[i], detail::end_from_parent(system, k, i, about),
                           detail::parent_velocity(system, v, layout.chain_start));
      for (int j : detail::chain_of(system.topology, system.layout, i))
        v.own[i] = advanced(v.own[i], k.column[j], system.zd(j));
    } else if (layout.own_frame) {
      v.own[i] = seen_from(k.orientation[i], joint.origin, v.base[i]);
    }
    name(system.annotator, v.base[i], "v", "w", system.body_name(i));
    name(system.annotator, v.own[i], "v", "w", system.body_name(i));
  }
  return v;
}

/// Accelerations of all bodies for given joint accelerations (steps 6 and 7), (37). zdd: per coordinate. Cost: linear.
template <class T>
Accelerations<T> accelerations(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                               const std::vector<T>& zdd) {
  const int n = system.topology.size();
  Accelerations<T> a{std::vector<Acceleration<T>>(n), std::vector<Acceleration<T>>(n), {}, v.about};
  a.ground.linear = -system.constants.gravity;
  for (int i = 0; i < n; ++i) {
    const BodyLayout& layout = system.layout.bodies[i];
    const auto heading = within_body(system.annotator, i);
    const detail::JointSeen<T> joint = detail::joint_seen(system, k, i, v.about);
    Acceleration<T> parent = detail::parent_acceleration(system, a, i);
    parent.linear = parent.at(joint.offset);
    a.base[i] = advanced(parent, system.revolute(i), joint.axis, joint.pin, system.zd(i), zdd[i],
                         detail::parent_velocity(system, v, i).angular, v.base[i].angular);
    if (layout.chain_start >= 0) {
      const Vector<T> place = detail::end_from_parent(system, k, i, v.about);
      Spatial<T> velocity = seen_from(k.orientation[i], place, detail::parent_velocity(system, v, layout.chain_start));
      Acceleration<T> own = seen_from(k.orientation[i], place,
                                      detail::parent_acceleration(system, a, layout.chain_start), velocity.angular);
      for (int j : detail::chain_of(system.topology, system.layout, i)) {
        const Spatial<T> next = advanced(velocity, k.column[j], system.zd(j));
        own = advanced(own, system.revolute(j), k.axis[j], k.pin[j], system.zd(j), zdd[j], velocity.angular,
                       next.angular);
        velocity = next;
      }
      a.own[i] = own;
    } else if (layout.own_frame) {
      a.own[i] = seen_from(k.orientation[i], joint.origin, a.base[i], v.own[i].angular);
    }
    const Acceleration<T>& named = layout.own_frame ? a.own[i] : a.base[i];
    detail_name(system.annotator, named.gradient, "G_", system.body_name(i));
    name(system.annotator, named.linear, "a_", system.body_name(i));
    name(system.annotator, named.angular, "alpha_", system.body_name(i));
  }
  return a;
}

/// Motion of a body in the axes of the frame that carries it.
template <class T>
Spatial<T> velocity_of(const System<T>& system, const Velocities<T>& v, int body) {
  if (body == kGround) return {};
  return system.layout.bodies[body].own_frame ? v.own[body] : v.base[body];
}
template <class T>
Acceleration<T> acceleration_of(const System<T>& system, const Accelerations<T>& a, int body) {
  if (body == kGround) return a.ground;
  return system.layout.bodies[body].own_frame ? a.own[body] : a.base[body];
}

/// Position of a place in the frame that carries its body.
template <class T>
Vector<T> local_position(const System<T>& system, const Kinematics<T>& k, const Place<T>& place) {
  return position_in(system, k, place, system.layout.frame_of(place.body));
}

/// A place from the point that the motion of its body is about, in the axes of the frame that carries the body.
template <class T>
Vector<T> arm_of(const System<T>& system, const Kinematics<T>& k, const Place<T>& place, MotionPoint about) {
  if (about == MotionPoint::frame_origin || system.layout.frame_of(place.body) == place.body)
    return local_position(system, k, place);
  return k.orientation[place.body] * place.at;
}

/// Acceleration of a place less gravity, in the axes of the frame that carries it, m/s^2.
template <class T>
Vector<T> place_acceleration(const System<T>& system, const Kinematics<T>& k, const Accelerations<T>& a,
                             const Place<T>& place) {
  return acceleration_of(system, a, place.body).at(arm_of(system, k, place, a.about));
}

/// Velocity of a place, in the axes of a frame at or below the one that carries it, m/s.
template <class T>
Vector<T> velocity_in(const System<T>& system, const Kinematics<T>& k, const Velocities<T>& v, const Place<T>& place,
                      int frame) {
  const int carrier = system.layout.frame_of(place.body);
  const Vector<T> velocity = velocity_at(velocity_of(system, v, place.body), arm_of(system, k, place, v.about));
  return direction_in(system, k, carrier, velocity, frame);
}

}  // namespace mbgen
