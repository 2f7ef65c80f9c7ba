#pragma once
// Recursive form, the way back from the root: accelerations of joints and bodies by the accelerations of the bases.

#include "compiler/formulation/recursion/recursion_opened.hpp"

namespace mbgen::detail {

/// Motion of a unit's base, and of the frame about the base's origin.
template <class T>
Spatial<T> base_acceleration(const RecursionState<T>& s, int base) {
  return base == kGround ? Spatial<T>{-s.system().constants.gravity, {}} : s.acceleration[base];
}

/// Quasi-accelerations of a step.
template <class T>
Vector<T> quasi_of(const JointStep& step, const std::vector<T>& values) {
  return {values[step.joints[0]], values[step.joints[1]], values[step.joints[2]]};
}

/// Accelerations of a block's columns by those of its free directions (62).
template <class T>
std::vector<T> projected_accelerations(const RecursionState<T>& s, std::size_t u, const Spatial<T>& base) {
  const BlockParts<T>& parts = s.blocks[u];
  const std::vector<T> free = free_accelerations(s.equations[u], base);
  Annotator<T>& annotator = s.system().annotator;
  for (std::size_t q = 0; q < free.size() && annotator.has_details(); ++q)
    annotator.detail(free[q], "qdd_", parts.directions[q]);
  std::vector<T> local = parts.zdd_star;
  const std::vector<std::vector<T>>& rz = parts.chosen ? parts.chosen->rz : parts.rz;
  if (parts.chosen) local = parts.chosen->zdd_star;
  for (std::size_t c = 0; c < local.size(); ++c)
    for (std::size_t q = 0; q < free.size(); ++q) local[c] = local[c] + rz[c][q] * free[q];
  return local;
}

/// A loop block on the way back: joint accelerations (62), and those of its bodies (37).
template <class T>
void solve_block(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const System<T>& system = s.system();
  const RecursionUnit& unit = s.units()[u];
  const BlockParts<T>& parts = s.blocks[u];
  const bool grounded = unit.base == kGround;
  const Spatial<T> base = grounded ? Spatial<T>{} : base_acceleration(s, unit.base);
  std::vector<T> local = unit.opened ? opened_accelerations(s, u, base) : projected_accelerations(s, u, base);
  for (std::size_t c = 0; c < local.size(); ++c) zdd[unit.joints[c]] = local[c];
  if (parts.chosen) local = quasi_accelerations(s.work, unit, parts.velocity, local);
  const PerBody<Spatial<T>> moved = block_motion(s.work, unit, per_joint(unit, local));
  const Vector<T> turning = s.omega_of(unit.base), twice = turning + turning;
  const Matrix<T> base_gradient = acceleration_gradient(turning, base.angular);
  for (const JointStep& step : unit.steps) {
    const int i = step.body(), p = s.work.parent(step);
    const auto heading = within_body(system.annotator, i);
    if (step.quasi() && !parts.chosen) {
      set_joint_accelerations(s.work, step, p == unit.base ? Vector<T>{} : parts.velocity[p].angular,
                              quasi_of(step, zdd), zdd);
    }
    const Spatial<T>& v = parts.velocity[i];
    Spatial<T> a = moved[i];
    a.linear =
        a.linear + parts.bias[i].linear + base.linear + base_gradient * s.k().position[i] + cross(twice, v.linear);
    a.angular = a.angular + parts.bias[i].angular + base.angular + cross(turning, v.angular);
    if (grounded) a.linear = a.linear - system.constants.gravity;
    if (s.work.own(i))
      a = {transposed_times(s.k().orientation[i], a.linear), transposed_times(s.k().orientation[i], a.angular)};
    name(system.annotator, a.linear, "a_", system.body_name(i));
    name(system.annotator, a.angular, "alpha_", system.body_name(i));
    s.acceleration[i] = a;
  }
}

/// A run of joints on the way back: accelerations of its end (37) and of its joints.
template <class T>
void solve_run(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const RecursionUnit& unit = s.units()[u];
  const RunParts<T>& run = s.runs[u];
  const int e = unit.end();
  const Matrix<T>& axes = s.k().orientation[e];
  const Spatial<T> below = base_acceleration(s, unit.base);
  const Spatial<T> base{transposed_times(axes, velocity_at(below, s.from_base(unit, e)) + run.carried),
                        transposed_times(axes, below.angular)};
  std::vector<T> free = is_arm_run(s, unit) ? free_accelerations(s.equations[u], below)
                        : is_free(unit)     ? free_accelerations(s.equations[u], base)
                                            : free_accelerations(s.equations[u], run.directions, base);
  Spatial<T>& a = s.acceleration[e];
  if (is_free(unit)) {
    const std::vector<Spatial<T>> units = unit_motions<T>(unit);
    for (std::size_t q = 0; q < free.size(); ++q) a = a + free[q] * units[q];
    const Spatial<T> left = a - base - run.bias;
    const bool turns_first = unit.steps[0].revolute;
    const Vector<T>& pin = s.k().pin[(turns_first ? unit.steps[0] : unit.steps[1]).joints[0]];
    const Vector<T> push = left.linear - cross(pin, left.angular);
    const Vector<T>& first = turns_first ? left.angular : push;
    const Vector<T>& second = turns_first ? push : left.angular;
    free = {first.x, first.y, first.z, second.x, second.y, second.z};
  } else {
    a = base + run.bias;
    for (std::size_t q = 0; q < free.size(); ++q) a = a + free[q] * run.directions[q];
  }
  name(s.system().annotator, a.linear, "a_", s.system().body_name(e));
  name(s.system().annotator, a.angular, "alpha_", s.system().body_name(e));
  for (int j : unit.joints)
    if (const T* driven = s.driven(j)) zdd[j] = *driven;
  for (std::size_t q = 0; q < free.size(); ++q) {
    zdd[run.columns[q]] = free[q];
    s.system().annotator.detail(free[q], "qdd_", s.work.name_of(run.columns[q]));
  }
  Vector<T> turning = run.before;
  for (const JointStep& step : unit.steps) {
    if (step.quasi()) set_joint_accelerations(s.work, step, turning, quasi_of(step, zdd), zdd);
    turning = turning + step_motion(s.work, step, s.velocity).angular;
  }
}

/// A rotor on the way back: its equation less the angular acceleration of its base.
template <class T>
void solve_rotor(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const RecursionUnit& unit = s.units()[u];
  const int w = unit.end();
  if (const T* driven = s.driven(w)) {
    zdd[w] = *driven;
    return;
  }
  const UnitEquations<T>& e = s.equations[u];
  zdd[w] = e.force[0] * e.reciprocal[0] - dot(s.k().axis[w], s.acceleration[unit.base].angular);
}

}  // namespace mbgen::detail
