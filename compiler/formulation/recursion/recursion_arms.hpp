#pragma once
// Recursive form: arms. A body by one revolute joint on another body that turns anyway: the angular velocity of the
// other body acts on it as on a part of that body, in that body's axes, so that only its motion against it and the
// Coriolis field are its own.

#include "compiler/formulation/recursion/recursion_block.hpp"

namespace mbgen::detail {

/// Accelerations of an arm by its own turn alone, against a body that turns: w~w~ + alpha~ + 2 W~w~.
/// twice: 2 W of the body; w, alpha: of the arm against it, along one axis.
template <class T>
Matrix<T> own_field(const Vector<T>& twice, const Vector<T>& w, const Vector<T>& alpha) {
  const T along = dot(twice, w), zero(0.0);
  return acceleration_gradient(w, alpha) + Matrix<T>{twice.x * w, twice.y * w, twice.z * w} -
         Matrix<T>{{along, zero, zero}, {zero, along, zero}, {zero, zero, along}};
}

/// A constant inertia that turns about one joint, in the axes of the body before it, and its rotation.
template <class T>
struct TurnedArm {
  Vector<T> axis;
  PseudoInertia<T> rigid;
  Spatial<T> momentum;  ///< of the joint's unit motion, about the joint
};

template <class T>
TurnedArm<T> turned_arm(const RecursionState<T>& s, int i, const Matrix<T>& turn) {
  const Vector3& own = s.system().topology.bodies[i].axis;
  const Vector<T> axis = constant<T>(own);
  const std::string& name = s.system().body_name(i);
  const PseudoInertia<T> rigid =
      turned(turn, own, axis, s.constant[i], [&](const T& across, const T& along, const T& reciprocal) {
        s.system().annotator.detail(across, "Kacross_", name);
        s.system().annotator.detail(along, "Kalong_", name);
        s.system().annotator.detail(reciprocal, "per_m_", name);
      });
  detail_inertia(s.system().annotator, rigid, "hb_", "Kb_", "Ib_", name);
  return {axis, rigid, rigid * Spatial<T>{{}, axis}};
}

/// Whether a body of a block moves on its base by one revolute joint and bears no units.
template <class T>
bool is_alone_on_base(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  const int i = step.body();
  if (!step.revolute || step.quasi() || s.work.own(i) || s.work.parent(step) != unit.base) return false;
  return s.work.recursion.on_body[i].empty();
}

/// Whether a body of a block is an arm of another body of it than the base: one revolute joint, nothing on it. On an
/// arm of the base with a parallel axis it is better off in the axes of the base.
template <class T>
bool is_outer_arm(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  const int i = step.body(), below = s.work.parent(step);
  if (!s.work.recursion.choices.outer_arms || !step.revolute || step.quasi() || below == unit.base) return false;
  const JointStep* const step_below = s.work.step[below];
  if (s.work.own(i) || bears_units(s, i) || step_below == nullptr) return false;
  if (std::any_of(unit.steps.begin(), unit.steps.end(), [&](const JointStep& o) { return s.work.parent(o) == i; }))
    return false;
  const Vector3 &axis = s.system().topology.bodies[i].axis, &axis_below = s.system().topology.bodies[below].axis;
  const Vector3 opposite{-axis[0], -axis[1], -axis[2]};
  return !is_alone_on_base(s, unit, *step_below) || (axis != axis_below && opposite != axis_below);
}

/// Whether a body of a block is an arm of its base.
template <class T>
bool is_arm(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  if (!s.work.recursion.choices.arms || unit.base == kGround || !is_alone_on_base(s, unit, step)) return false;
  return std::none_of(unit.steps.begin(), unit.steps.end(), [&](const JointStep& other) {
    return s.work.parent(other) == step.body() && is_outer_arm(s, unit, other);
  });
}

/// An arm: one revolute joint on the base, nothing on it. The base's angular velocity acts on it as on a part of the
/// base (there it costs nothing more), so that only its motion against the base and the Coriolis field are its own.
template <class T>
void gather_arm(RecursionState<T>& s, BlockGathering<T>& g, int i) {
  const CompositeBody<T>& arm = s.composite[i];
  const Vector<T>& w = g.parts.velocity[i].angular;
  const Vector<T> alpha = g.parts.zdd_star_motion[i].angular;
  const Matrix<T> field = own_field(g.twice, w, alpha);
  detail_name(s.system().annotator, field, "Gown_", s.system().body_name(i));
  const Spatial<T> needed = arm.needed + field_force(arm.rigid, Vector<T>{}, field);
  const Vector<T>& place = s.k().position[i];
  detail_name(s.system().annotator, needed, "f", "n", s.system().body_name(i));
  const PseudoInertia<T> share = shifted(place, arm.rigid);
  detail_inertia(s.system().annotator, share, "hp_", "Kp_", "Ip_", s.system().body_name(i));
  g.base.rigid = g.base.rigid + share;
  g.base.needed = g.base.needed + shifted(place, needed);
  const Spatial<T> as_part_of_base = field_force(arm.rigid, g.turning_field * place, g.turning_field);
  add_to_equations(s, g, i, Vector<T>{}, place, arm.rigid, {}, needed + as_part_of_base);
}

/// Whether a body of a block turns against the base about one coordinate axis alone. Such a body is a part of the base
/// as well, moved by more than its own turn.
template <class T>
bool turns_in_plane(const RecursionState<T>& s, const BlockGathering<T>& g, int i) {
  const Vector<T>& w = g.parts.velocity[i].angular;
  const int zeros = (is_zero(w.x) ? 1 : 0) + (is_zero(w.y) ? 1 : 0) + (is_zero(w.z) ? 1 : 0);
  return s.work.recursion.choices.in_plane && g.unit.base != kGround && zeros == 2 && g.subtree[i].is_empty;
}

/// Force that such a body needs, about the point `arm` from its origin: by its motion against the base, and as a part.
template <class T>
struct NeededInPlane {
  Spatial<T> own, as_part;
};

template <class T>
NeededInPlane<T> needed_in_plane(const RecursionState<T>& s, const BlockGathering<T>& g, int i,
                                 const CompositeBody<T>& body, const Vector<T>& arm) {
  const Spatial<T> v = about_point(g.parts.velocity[i], arm), extra = about_point(g.parts.zdd_star_motion[i], arm);
  const BodyAcceleration<T>& bias = g.parts.bias[i];
  const Vector<T> a = bias.linear + bias.gradient * arm + extra.linear + cross(g.twice, v.linear);
  const Matrix<T> field = own_field(g.twice, v.angular, bias.angular + extra.angular);
  detail_name(s.system().annotator, a, "aown_", s.system().body_name(i));
  detail_name(s.system().annotator, field, "Gown_", s.system().body_name(i));
  const Spatial<T> motion = acceleration_of(s, g, i, arm);
  return {body.needed + field_force(body.rigid, a, field) + body.above * motion + body.reduced * motion,
          field_force(body.rigid, g.turning_field * (s.k().position[i] + arm), g.turning_field)};
}

/// Whether the inertia of a body of a block joins the subtree of the body below.
template <class T>
bool is_in_subtree(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  const int below = s.work.parent(step);
  if (!s.work.recursion.choices.subtrees || step.quasi() || below == unit.base || s.work.own(step.body())) return false;
  return !bears_units(s, step.body()) && s.work.step[below] != nullptr && !is_arm(s, unit, *s.work.step[below]);
}

/// A body of a block with the arms that turn with it, about its origin in the axes of the block's base.
template <class T>
CompositeBody<T> with_arms(const RecursionState<T>& s, const BlockGathering<T>& g, int i) {
  CompositeBody<T> body = s.composite[i];
  const Matrix<T>& axes = s.k().orientation[i];
  const OuterArms<T>& arms = g.arms[i];
  if (s.work.own(i)) {
    if (!arms.is_empty) body.rigid = body.rigid + arms.rigid, body.needed = body.needed + arms.needed;
    return {rotated(axes, body.rigid), rotated(axes, body.above), rotated(axes, body.reduced),
            rotated(axes, body.needed)};
  }
  if (arms.is_empty) return body;
  body.rigid = rotated(axes, s.constant[i] + arms.rigid);
  body.needed = body.needed + rotated(axes, arms.needed);
  return body;
}

/// The motion of a joint on another body of the block, projected. seen_below: its momentum for a unit motion, about the
/// origin of the body below in the base's axes. half: half its power on that motion. torque: needed at the joint.
template <class T>
void project_joint(const RecursionState<T>& s, BlockGathering<T>& g, int i, int below, const Spatial<T>& seen_below,
                   const T& half, const T& torque) {
  SubtreeInertia<T>& subtree = g.subtree[below];
  subtree.momentum.resize(g.equations.size());
  const std::vector<T>& rate = g.parts.rz[g.unit.column(i)];
  std::vector<T> coupled;
  for (std::size_t q = 0; q < g.equations.size(); ++q) {
    coupled.push_back(dot(seen_below, g.parts.partial[q][below]) + half * rate[q]);
    if (s.system().annotator.has_details())
      s.system().annotator.detail(coupled.back(), "H_", s.system().topology.bodies[i].coordinate, "_",
                                  g.parts.directions[q]);
    for (std::size_t d = 0; d <= q; ++d)
      g.equations.mass[q][d] = g.equations.mass[q][d] + (rate[q] * coupled[d] + rate[d] * coupled[q]);
    subtree.momentum[q] = subtree.momentum[q] + rate[q] * seen_below;
    g.equations.force[q] = g.equations.force[q] - rate[q] * torque;
  }
}

/// An arm of another body of its block than the base.
template <class T>
void gather_outer_arm(RecursionState<T>& s, BlockGathering<T>& g, const JointStep& step) {
  const System<T>& system = s.system();
  const int i = step.body(), below = s.work.parent(step);
  const Matrix<T>& axes = s.k().orientation[below];
  const TurnedArm<T> arm = turned_arm(s, i, rotation(system.topology.bodies[i].axis, system.z(i)));
  const Vector<T> place = joint_offset(system, i);
  const Vector<T> turning = transposed_times(axes, g.turning + g.parts.velocity[below].angular);
  const Vector<T> w = s.velocity[i] * arm.axis, alpha = g.parts.zdd_star[g.unit.column(i)] * arm.axis;
  const Matrix<T> field = own_field(turning + turning, w, alpha);
  detail_name(system.annotator, field, "Gown_", system.body_name(i));
  const Spatial<T> needed = field_force(arm.rigid, Vector<T>{}, field);
  detail_name(system.annotator, needed, "f", "n", system.body_name(i));
  const PseudoInertia<T> share = shifted(place, arm.rigid);
  detail_inertia(system.annotator, share, "hp_", "Kp_", "Ip_", system.body_name(i));
  OuterArms<T>& arms = g.arms[below];
  arms.is_empty = false;
  arms.rigid = arms.rigid + share;
  arms.needed = arms.needed + shifted(place, needed);

  const Spatial<T> carried = acceleration_of(s, g, below, Vector<T>{});
  const Matrix<T> gradient = acceleration_gradient(turning, transposed_times(axes, carried.angular));
  detail_name(system.annotator, turning, "w_", system.body_name(below), "_in_own_axes");
  detail_name(system.annotator, gradient, "G_", system.body_name(below), "_in_own_axes");
  const Spatial<T> as_part =
      field_force(arm.rigid, transposed_times(axes, carried.linear) + gradient * place, gradient);
  const Spatial<T>& applied = s.composite[i].needed;  // in the base's axes
  const T torque = dot(arm.axis, needed.angular + as_part.angular) + dot(s.k().axis[i], applied.angular);
  g.subtree[below].needed = g.subtree[below].needed + shifted(s.work.offset[i], applied);
  const Spatial<T> momentum = rotated(axes, shifted(place, arm.momentum));
  detail_name(system.annotator, momentum, "F", "N", system.topology.bodies[i].coordinate);
  system.annotator.detail(torque, "n_", system.topology.bodies[i].coordinate);
  project_joint(s, g, i, below, momentum, T(0.5) * dot(arm.axis, arm.momentum.angular), torque);
}

/// Whether a run is an arm of its base: a body by one revolute joint that carries no unit but rotors.
template <class T>
bool is_arm_run(const RecursionState<T>& s, const RecursionUnit& unit) {
  const int e = unit.end();
  if (!s.work.recursion.choices.arm_runs || unit.block >= 0 || unit.rotor) return false;
  if (unit.joints.size() != 1 || !s.system().revolute(e) || s.driven(e) != nullptr || s.system().ball(e) >= 0)
    return false;
  if (unit.base == kGround || !s.work.own(unit.base)) return false;
  const std::vector<int>& above = s.work.recursion.on_body[e];
  return std::none_of(above.begin(), above.end(),
                      [&](int u) { return !s.units()[u].rotor || s.driven(s.units()[u].end()) != nullptr; });
}

/// A run that is an arm: it joins the inertia of its base, less its own joint.
template <class T>
void eliminate_arm_run(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  const int e = unit.end();
  UnitEquations<T>& equations = s.equations[u];
  const Matrix<T>& axes = s.k().orientation[e];
  const Vector<T> place = s.from_base(unit, e);
  const Vector<T>& turning = s.omega[unit.base];
  const TurnedArm<T> arm = turned_arm(s, e, axes);
  const Matrix<T> turning_field = acceleration_gradient(turning, Vector<T>{});
  const Matrix<T> field = own_field(turning + turning, s.velocity[e] * arm.axis, Vector<T>{});
  const Spatial<T> needed = rotated(axes, s.composite[e].needed) + field_force(arm.rigid, Vector<T>{}, field);
  const Spatial<T> as_part = field_force(arm.rigid, turning_field * place, turning_field);
  equations.mass = {{dot(arm.axis, arm.momentum.angular)}};
  equations.momentum = {shifted(place, arm.momentum)};
  detail_name(s.system().annotator, needed, "f", "n", s.system().body_name(e));
  detail_name(s.system().annotator, equations.momentum[0], "F", "N", s.system().topology.bodies[e].coordinate);
  const PseudoInertia<T> share = shifted(place, arm.rigid);
  detail_inertia(s.system().annotator, share, "hp_", "Kp_", "Ip_", s.system().body_name(e));
  equations.force = {s.force[e] - dot(arm.axis, needed.angular + as_part.angular)};
  eliminate(equations);
  CompositeBody<T>& below = s.composite[unit.base];
  below.rigid = below.rigid + share;
  below.needed = below.needed + shifted(place, needed);
  reduce(equations, below.reduced, below.needed);
}

}  // namespace mbgen::detail
