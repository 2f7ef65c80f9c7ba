#pragma once
// The recursive form: the same equations as the matrix form (63), with each loop block and each run of joints
// eliminated from the leaves to the root into the 6x6 inertia of its base body. Quasi-velocities inside, joint
// accelerations at the doors. Source: docs/method/recursive.md; R. Featherstone, Rigid Body Dynamics Algorithms, 2008,
// chapter 7 (articulated bodies), extended by the loop blocks' Rz (61).

#include "compiler/formulation/recursion/recursion_return.hpp"

namespace mbgen {
namespace detail {

/// A loop block: (63) of its free directions, or of the joints of its opened tree, solved for the acceleration of its
/// base.
template <class T>
void eliminate_block(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  UnitEquations<T>& equations = s.equations[u];
  Annotator<T>& annotator = s.system().annotator;
  CompositeBody<T> base = unit.opened ? eliminate_opened_joints(s, u) : gather_block(s, u);
  if (!unit.opened) {
    T rounding(s.rounding), lost(kLostByElimination);
    name_bounds(annotator, rounding, lost);
    eliminate(equations, rounding, lost);
    detail_eliminated(s, s.blocks[u].directions, equations);
  }
  if (unit.base == kGround) return;
  if (!unit.opened) reduce(equations, base.reduced, base.needed);
  detail_articulated(annotator, base.reduced, s.system().body_name(unit.base), "_less_",
                     s.system().topology.bodies[unit.end()].coordinate);
  CompositeBody<T>& below = s.composite[unit.base];
  below.rigid = below.rigid + base.rigid;
  below.above = below.above + base.above;
  below.reduced = below.reduced + base.reduced;
  below.needed = below.needed + base.needed;
}

/// A run of joints: the articulated inertia of its end, handed down to its base.
template <class T>
void eliminate_run(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  if (is_arm_run(s, unit)) {
    eliminate_arm_run(s, u);
    return;
  }
  UnitEquations<T>& equations = s.equations[u];
  ArticulatedInertia<T> inertia;
  Spatial<T> needed;
  if (is_free(unit)) {
    gather_free(s, u, equations, needed);
    eliminate(equations);
    if (s.system().annotator.has_details()) detail_eliminated(s, directions_of(s, s.runs[u]), equations);
    hand_down(s, u, {}, needed);
    return;
  }
  gather_run(s, u, equations, inertia, needed);
  eliminate(equations);
  if (s.system().annotator.has_details()) detail_eliminated(s, directions_of(s, s.runs[u]), equations);
  reduce(equations, inertia, needed);
  clear_directions(s.runs[u].directions, inertia);
  hand_down(s, u, inertia, needed);
}

/// A rotor spins freely on its base, which holds its inertia across the axis and its mass.
template <class T>
void eliminate_rotor(RecursionState<T>& s, std::size_t u, const AppliedForces<T>& forces) {
  const RecursionUnit& unit = s.units()[u];
  const int w = unit.end();
  const Vector<T>& axis = s.k().axis[w];
  UnitEquations<T>& equations = s.equations[u];
  const T* driven = s.driven(w);
  const T applied = dot(axis, forces.wrench[w].angular);
  CompositeBody<T>& base = s.composite[unit.base];
  base.needed = base.needed - shifted(offset_from_parent(s.system(), s.k(), w), forces.wrench[w]);
  const Vector<T> omega = s.omega[unit.base];
  const T spin = dot(axis, omega) + s.system().zd(w);
  const Vector<T> across = cross(omega, axis);
  const T momentum = s.polar[w] * spin;
  detail_rotor(s, w, spin, momentum, across);
  base.needed.angular = base.needed.angular + momentum * across;
  if (driven) {  // its spin acceleration: of the base, plus the prescribed one
    const Vector<T> along = s.polar[w] * axis;
    base.reduced.angular = base.reduced.angular + square(s.polar[w], axis);
    base.needed.angular = base.needed.angular + *driven * along;
    return;
  }
  const T force = s.force[w] + applied;
  base.needed.angular = base.needed.angular + force * axis;
  equations.mass = {{s.polar[w]}};
  equations.momentum = {{}};
  equations.force = {force};
  eliminate(equations);
}

/// Inertias of a unit's free directions. Where the joint rates of its balls are singular the monitor falls, of its
/// block or of the middle joint's direction.
template <class T>
void watch_unit(const RecursionState<T>& s, std::size_t u, RecursiveSolution<T>& solution) {
  using std::abs;
  using std::min;
  const RecursionUnit& unit = s.units()[u];
  std::vector<DirectionInertia<T>> found;
  if (unit.opened) found = opened_inertias(s, u);
  for (std::size_t q = 0; !unit.opened && q < s.equations[u].size(); ++q) {
    const int column = unit.rotor ? unit.end() : unit.block < 0 ? s.runs[u].columns[q] : static_cast<int>(q);
    found.push_back({unit.block, column, s.equations[u].inertia[q]});
  }
  for (const JointStep& step : unit.steps) {
    if (!step.quasi() || !step.revolute) continue;
    const T& volume = s.work.quasi[step.body()].volume;
    if (unit.block >= 0) {
      T& quality = solution.quality[unit.block];
      quality = min(quality, abs(volume));
    } else {
      for (DirectionInertia<T>& d : found)
        if (d.place == step.joints[1]) {
          T least(1e-12);
          s.system().annotator.bound(least, "Square of the least volume of a ball's three axes",
                                     "least_volume_squared");
          d.value = min(d.value, volume * volume - least);
        }
    }
  }
  solution.inertia.insert(solution.inertia.end(), found.begin(), found.end());
}

/// Names the pivot of a unit's free direction after the direction's joint.
template <class T>
void name_pivot(const RecursionState<T>& s, std::size_t u, std::size_t direction, int joint) {
  s.system().annotator.name(s.equations[u].mass[direction][direction], "pivot_", s.work.name_of(joint));
}

/// Adds a unit's own inertia and applied forces to the shares that the units above have left on its bodies.
template <class T>
void add_own_parts(RecursionState<T>& s, const RecursionUnit& unit, const AppliedForces<T>& forces) {
  for (const JointStep& step : unit.steps) {
    const int i = step.body();
    if (unit.block < 0 && i != unit.end()) continue;
    const auto heading = within_body(s.system().annotator, i);
    CompositeBody<T>& c = s.composite[i];
    c.rigid = c.rigid + (s.work.own(i) ? s.constant[i] : s.in_base_axes(i, s.constant[i]));
    c.needed = c.needed - forces.wrench[i];
  }
}

/// A block as its frozen partition solves it (steps 2, 3 and 6).
template <class T>
void project_block(RecursionState<T>& s, std::size_t u, const LoopPartition& partition, T& quality) {
  const RecursionUnit& unit = s.units()[u];
  Annotator<T>& annotator = s.system().annotator;
  BlockParts<T>& parts = s.blocks[u];
  name_directions(s, unit, partition.independent, parts.directions);
  {
    const auto step = annotator.step(Step::jacobian, unit.block);
    const auto heading = detail_within_block(annotator, unit.block);
    const SparseClosure<T> closed =
        quasi_closure(s.work, unit, PerBody<Spatial<T>>(unit), PerBody<BodyAcceleration<T>>(unit));
    parts.factors = factorise_frozen(closed.jacobian, partition, unit.joints.size(),
                                     scale_names(s.system(), s.work.columns_of(unit), partition));
    name_pivots(s.system(), s.work.columns_of(unit), partition, parts.factors);
    quality = parts.factors.quality;
  }
  {
    const auto step = annotator.step(Step::projection, unit.block);
    const auto heading = detail_within_block(annotator, unit.block);
    parts.rz = frozen_rz(parts.factors, partition, unit.joints.size());
    name_rz(s.system(), s.work.columns_of(unit), parts.rz);
  }
  const auto step = annotator.step(Step::closure_bias, unit.block);
  const auto heading = detail_within_block(annotator, unit.block);
  set_block_bias(s, u, partition);
}

/// A block with a projection over joint rates that was chosen at run time: the same over quasi-velocities.
template <class T>
void project_block(RecursionState<T>& s, std::size_t u, const GroupProjection<T>& chosen, T&) {
  const RecursionUnit& unit = s.units()[u];
  BlockParts<T>& parts = s.blocks[u];
  parts.chosen = &chosen;
  name_directions(s, chosen.rz.front().size(), parts.directions);
  {
    const auto step = s.system().annotator.step(Step::projection, unit.block);
    const auto heading = detail_within_block(s.system().annotator, unit.block);
    parts.rz = quasi_projection(s.work, unit, chosen.rz);
  }
  const auto step = s.system().annotator.step(Step::closure_bias, unit.block);
  const auto heading = detail_within_block(s.system().annotator, unit.block);
  parts.bias = block_bias(s.work, unit, parts.velocity);
  parts.zdd_star = quasi_accelerations(s.work, unit, parts.velocity, chosen.zdd_star);
}

/// Steps 2, 3, 6, 7 and 8 of a loop block. An opened one takes the equations of its frozen partition.
template <class T>
void eliminate_block(RecursionState<T>& s, std::size_t u, const AppliedForces<T>& forces,
                     const BlockProjection<T>& projection, T& quality) {
  const RecursionUnit& unit = s.units()[u];
  Annotator<T>& annotator = s.system().annotator;
  if (unit.opened)
    start_opened(s, u, std::get<LoopPartition>(projection), quality);
  else
    std::visit([&](const auto& of_block) { project_block(s, u, of_block, quality); }, projection);
  {
    const auto step = annotator.step(Step::accelerations, unit.block);
    add_own_parts(s, unit, forces);
  }
  const auto step = annotator.step(Step::reduced_system, unit.block);
  const auto heading = detail_within_block(annotator, unit.block);
  eliminate_block(s, u);
  const LoopPartition* const frozen = std::get_if<LoopPartition>(&projection);
  if (frozen != nullptr && !unit.opened)
    for (std::size_t q = 0; q < frozen->independent.size(); ++q)
      name_pivot(s, u, q, unit.joints[frozen->independent[q]]);
}

/// The way to the root (steps 2 to 8).
template <class T>
void eliminate_units(RecursionState<T>& s, const AppliedForces<T>& forces,
                     const std::vector<BlockProjection<T>>& projections, RecursiveSolution<T>& solution) {
  Annotator<T>& annotator = s.system().annotator;
  for (std::size_t u = s.units().size(); u-- > 0;) {
    const RecursionUnit& unit = s.units()[u];
    if (unit.block >= 0) {
      eliminate_block(s, u, forces, projections[unit.block], solution.quality[unit.block]);
      continue;
    }
    const auto step = annotator.step(Step::reduced_system);
    const auto heading = within_body(annotator, unit.end());
    if (unit.rotor) {
      eliminate_rotor(s, u, forces);
      continue;
    }
    set_run_bias(s, u);
    add_own_parts(s, unit, forces);
    eliminate_run(s, u);
    for (std::size_t q = 0; q < s.equations[u].size(); ++q) name_pivot(s, u, q, s.runs[u].columns[q]);
  }
}

/// The way back to the leaves (step 9).
template <class T>
void solve_units(RecursionState<T>& s, RecursiveSolution<T>& solution) {
  const System<T>& system = s.system();
  const auto step = system.annotator.step(Step::solution);
  solution.zdd.assign(system.topology.bodies.size(), T(0.0));
  for (std::size_t u = 0; u < s.units().size(); ++u) {
    const RecursionUnit& unit = s.units()[u];
    const auto heading = within_body(system.annotator, unit.end());
    if (unit.rotor)
      solve_rotor(s, u, solution.zdd);
    else if (unit.block >= 0)
      solve_block(s, u, solution.zdd);
    else
      solve_run(s, u, solution.zdd);
    watch_unit(s, u, solution);
  }
}

}  // namespace detail

/// All joint accelerations by the recursive form. projections: per block, of an opened one its partition. forces:
/// applied, about the bodies' origins, without tau. Cost: linear in bodies, quadratic in the free directions of one
/// unit.
template <class T>
RecursiveSolution<T> recursive_accelerations(System<T>& system, const Recursion& recursion, const Kinematics<T>& k,
                                             const AppliedForces<T>& forces, const std::vector<Drive<T>>& drives,
                                             const std::vector<T>& tau,
                                             const std::vector<BlockProjection<T>>& projections) {
  const std::size_t n = system.topology.bodies.size(), units = recursion.units.size();
  const RecursionWork<T> work = recursion_work(system, recursion, k);
  detail::RecursionState<T> s{work, drives, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  s.blocks.resize(units);
  s.runs.resize(units);
  s.equations.resize(units);
  s.acceleration.resize(n);
  s.composite.resize(n);
  if (!system.topology.blocks.empty()) s.rounding = inertia_left_by_rounding(system.constants);
  RecursiveSolution<T> solution;
  solution.quality.assign(system.topology.blocks.size(), T(1.0));
  {
    const auto step = system.annotator.step(Step::inertias);
    detail::set_constants(s);
  }
  {
    const auto step = system.annotator.step(Step::velocities);
    detail::set_velocities(s);
  }
  {
    const auto step = system.annotator.step(Step::accelerations);
    s.force = tau;
    for (std::size_t i = 0; i < n; ++i) s.force[i] = s.force[i] + forces.joint[i];
    s.force = quasi_forces(work, s.force);
    for (std::size_t i = 0; i < n; ++i)
      system.annotator.detail(s.force[i], "Q_", work.name_of(static_cast<int>(i)), "_applied");
  }
  detail::eliminate_units(s, forces, projections, solution);
  detail::solve_units(s, solution);
  return solution;
}

/// Jacobian of a block by (quasi-)velocities at the present position, for choosing its partition.
template <class T>
std::vector<SparseRow<T>> quasi_jacobian(const RecursionWork<T>& work, const RecursionUnit& unit) {
  return quasi_closure(work, unit, PerBody<Spatial<T>>(unit), PerBody<BodyAcceleration<T>>(unit)).jacobian;
}

}  // namespace mbgen
