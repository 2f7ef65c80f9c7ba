#pragma once
// Inertias of the bodies, accumulated from the leaves to the root (50), each in the frame that carries its body.

#include "compiler/formulation/motion.hpp"
#include "compiler/formulation/rods.hpp"

namespace mbgen {

/// Central inertia of a body as the equations of motion see it.
template <class T>
struct BodyInertia {
  T mass{0.0};
  Vector<T> com;         ///< in the carrying frame, m
  Symmetric<T> central;  ///< about com, axes of the carrying frame, kg m^2
};

template <class T>
struct Inertias {
  std::vector<BodyInertia<T>> body;
  std::vector<Inertia<T>> own;   ///< own bodies: M^R of all that moves on them in their frame
  std::vector<Inertia<T>> base;  ///< all bodies: M^R in the base frame
  /// M^R for joint i, in the joint's frame.
  const Inertia<T>& of_joint(const Layout& layout, int i) const {
    const int frame = layout.bodies[i].joint_frame;
    return frame == layout.bodies[i].base ? base[i] : own[frame];
  }
};

/// Axes of a body's inertia in the frame that carries it: a rotor's are those of the body that it turns on.
template <class T>
Matrix<T> inertia_axes(const System<T>& system, const Kinematics<T>& k, int i) {
  if (system.layout.frame_of(i) == i) return identity<T>();
  if (!system.layout.bodies[i].rotor) return k.orientation[i];
  return system.on_base(i) ? identity<T>() : k.orientation[system.topology.bodies[i].parent];
}

/// A point of body i's inertia, as its centre of mass, from the point that motions are about, in the axes of the frame
/// that carries the body.
template <class T>
Vector<T> inertia_arm(const System<T>& system, const Kinematics<T>& k, int i, const Vector<T>& at, MotionPoint about) {
  if (system.layout.frame_of(i) == i) return at;
  const Vector<T> arm = inertia_axes(system, k, i) * at;
  return about == MotionPoint::body_origin ? arm : k.position[i] + arm;
}

/// Force that a rigid part of tree body i (or of ground) takes, moments in the part's own axes, where its inertia is
/// constant. Result: about the point of the motion.
template <class T>
Spatial<T> part_force(const System<T>& system, const Kinematics<T>& k, int i, const Part<T>& part,
                      const Vector<T>& angular_velocity, const Acceleration<T>& a, MotionPoint about) {
  const Matrix<T> axes = inertia_axes(system, k, i);
  const Vector<T> com = inertia_arm(system, k, i, part.com, about);
  const Vector<T> w = transposed_times(axes, angular_velocity), alpha = transposed_times(axes, a.angular);
  const Vector<T> at_com = a.at(com), force = part.mass * at_com;
  if (i >= 0) {
    detail_name(system.annotator, com, "arm_", system.body_name(i), "_com");
    detail_name(system.annotator, at_com, "a_", system.body_name(i), "_com");
    detail_name(system.annotator, w, "w_", system.body_name(i), "_in_own_axes");
    detail_name(system.annotator, alpha, "alpha_", system.body_name(i), "_in_own_axes");
  }
  return {force, cross(com, force) + axes * (part.inertia * alpha + cross(w, part.inertia * w))};
}

/// A rigid part of tree body i (or of ground), given from the body's origin in its axes.
template <class T>
BodyInertia<T> carried_part(const System<T>& system, const Kinematics<T>& k, int i, const Part<T>& part) {
  if (system.layout.frame_of(i) == i) return {part.mass, part.com, part.inertia};
  const Matrix<T> axes = inertia_axes(system, k, i);
  return {part.mass, k.position[i] + axes * part.com, rotated(axes, part.inertia)};
}

template <class T>
BodyInertia<T> body_inertia(const System<T>& system, const Kinematics<T>& k, int i) {
  const Constants<T>& c = system.constants;
  const bool nothing = is_zero(c.mass[i]) && system.topology.bodies[i].massless;
  if (nothing && !system.layout.bodies[i].own_frame) return {};
  return carried_part(system, k, i, Part<T>{c.mass[i], c.com[i], c.inertia[i]});
}

/// Ten parameters about the frame origin, Mbar of theory.md section 2.
template <class T>
Inertia<T> about_origin(const BodyInertia<T>& body) {
  return {body.mass, body.mass * body.com, body.central + point_inertia(body.mass, body.com)};
}

/// Inertia that a rod's coupling mass adds to a body that carries both ends: the kinetic energy m_jk v_j . v_k of a
/// common motion.
template <class T>
Inertia<T> pair_inertia(const T& coupling, const Vector<T>& a, const Vector<T>& b) {
  const Vector<T> sum = a + b;
  const Symmetric<T> whole = point_inertia(coupling, sum), first = point_inertia(-coupling, a),
                     second = point_inertia(-coupling, b);
  return {coupling + coupling, coupling * sum, whole + (first + second)};
}

/// Accumulated inertias (step 1). Rod couplings enter at the base of their loop block. Cost: linear. Source: (49),
/// (50).
template <class T>
Inertias<T> inertias(System<T>& system, const Kinematics<T>& k) {
  const int n = system.topology.size();
  Inertias<T> m;
  m.body.resize(n);
  m.own.resize(n);
  m.base.resize(n);
  for (int i = 0; i < n; ++i) {
    const auto heading = within_body(system.annotator, i);
    m.body[i] = body_inertia(system, k, i);
    (system.layout.bodies[i].own_frame ? m.own[i] : m.base[i]) = about_origin(m.body[i]);
  }
  for (const LoopBlock& block : system.topology.blocks) {
    if (block.base == kGround) continue;
    each_coupling_rod(system, block, [&](const Rod&, const RodConstants<T>& rod) {
      m.own[block.base] = m.own[block.base] + pair_inertia(rod.coupling, position_in(system, k, rod.from, block.base),
                                                           position_in(system, k, rod.to, block.base));
    });
  }
  for (int i = n - 1; i >= 0; --i) {
    const auto heading = within_body(system.annotator, i);
    if (system.layout.bodies[i].own_frame) m.base[i] = m.base[i] + moved(k.orientation[i], k.position[i], m.own[i]);
    const int p = system.topology.bodies[i].parent;
    if (p == kGround) continue;
    Inertia<T>& below = p == system.layout.bodies[i].base ? m.own[p] : m.base[p];
    below = below + m.base[i];
  }
  return m;
}

/// Wrench that moves a body: its force and moment about the frame origin for an acceleration (less gravity).
template <class T>
Spatial<T> inertial_force(const BodyInertia<T>& body, const Vector<T>& angular_velocity, const Acceleration<T>& a) {
  const Vector<T> force = body.mass * a.at(body.com);
  const Vector<T> moment = body.central * a.angular + cross(angular_velocity, body.central * angular_velocity);
  return {force, cross(body.com, force) + moment};
}

}  // namespace mbgen
