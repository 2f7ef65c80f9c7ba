#pragma once
// Equations of motion: forces accumulated from the leaves to the root (51), (52), columns of the tree mass matrix (49),
// and the projection on the free directions (63), group by group.

#include "compiler/formulation/elements/applied_forces.hpp"
#include "compiler/formulation/implicit/elimination.hpp"
#include "compiler/formulation/inertia.hpp"
#include "compiler/formulation/loop_solution.hpp"

namespace mbgen {

namespace detail {

/// A wrench about an own body's origin, seen in its base frame.
template <class T>
Spatial<T> lowered(const Kinematics<T>& k, int body, const Spatial<T>& wrench) {
  return force_at(k.orientation[body] * wrench.linear, k.position[body]) +
         Spatial<T>{{}, k.orientation[body] * wrench.angular};
}

/// Forces that a rod's coupling mass puts on its ends: -m_jk times the acceleration of the other end (theory.md section
/// 5).
template <class T>
void rod_forces(System<T>& system, const Kinematics<T>& k, const Accelerations<T>& a, AppliedForces<T>& forces) {
  const Velocities<T> none;
  ForceWork<T> work{system, k, none, forces};
  for (const LoopBlock& block : system.topology.blocks)
    each_coupling_rod(system, block, [&](const Rod& ends, const RodConstants<T>& rod) {
      const auto acceleration = [&](const Place<T>& end) {
        const int carrier = system.layout.frame_of(end.body);
        return direction_in(system, k, carrier, place_acceleration(system, k, a, end), block.base);
      };
      apply_force(work, ends.from.body, rod.from, -rod.coupling * acceleration(rod.to), block.base);
      apply_force(work, ends.to.body, rod.to, -rod.coupling * acceleration(rod.from), block.base);
    });
}

}  // namespace detail

/// Generalised forces of the tree: tau + Rd' (Q - P) for given body accelerations (48), (63). forces: applied, without
/// tau. Result: per coordinate, N or N m. Cost: linear.
template <class T>
std::vector<T> tree_forces(System<T>& system, const Kinematics<T>& k, const Inertias<T>& m, const Velocities<T>& v,
                           const Accelerations<T>& a, AppliedForces<T> forces, const std::vector<T>& tau) {
  const int n = system.topology.size();
  detail::rod_forces(system, k, a, forces);
  std::vector<Spatial<T>> own(n), base(n);
  for (int i = 0; i < n; ++i) {
    const auto heading = within_body(system.annotator, i);
    const Spatial<T> inertial =
        inertial_force(m.body[i], velocity_of(system, v, i).angular, acceleration_of(system, a, i));
    (system.layout.bodies[i].own_frame ? own[i] : base[i]) = forces.wrench[i] - inertial;
  }
  std::vector<T> result(n);
  for (int i = n - 1; i >= 0; --i) {
    const auto heading = within_body(system.annotator, i);
    const BodyLayout& layout = system.layout.bodies[i];
    if (layout.own_frame) base[i] = base[i] + detail::lowered(k, i, own[i]);
    const Spatial<T>& above = layout.joint_frame == layout.base ? base[i] : own[layout.joint_frame];
    result[i] = tau[i] + forces.joint[i] + dot(k.column[i], above);
    system.annotator.name(result[i], "Q_", system.topology.bodies[i].coordinate);
    const int p = system.topology.bodies[i].parent;
    if (p == kGround) continue;
    Spatial<T>& below = p == layout.base ? own[p] : base[p];
    below = below + base[i];
  }
  return result;
}

/// The projected equations (63): reduced mass matrix and right-hand side, one row per free direction, parents'
/// directions first.
template <class T>
struct ReducedSystem {
  std::vector<std::vector<T>> mass;  ///< lower triangle, [row][column <= row]
  std::vector<T> right_hand_side;
  std::vector<int> group;  ///< joint group of each direction
  std::vector<int> first;  ///< per group: index of its first direction
};

namespace detail {

/// Momentum wrenches F_i = M^R_i b_i of a group's joints, in the group's joint frame, rods' couplings included; and the
/// group's diagonal block of the tree mass matrix (49).
template <class T>
struct GroupMass {
  std::vector<Spatial<T>> momentum;  ///< per joint of the group
  std::vector<std::vector<T>> mass;  ///< symmetric, full
};

/// Adds m_jk (V_j' V_k + V_k' V_j) of one rod (theory.md section 5).
template <class T>
void add_rod(const System<T>& system, const Kinematics<T>& k, const std::vector<int>& joints, int base,
             const RodConstants<T>& rod, GroupMass<T>& group) {
  const Vector<T> from = position_in(system, k, rod.from, base), to = position_in(system, k, rod.to, base);
  const std::size_t count = joints.size();
  std::vector<Vector<T>> at_from(count), at_to(count);
  std::vector<std::size_t> moving;  // joints that move an end
  for (std::size_t c = 0; c < count; ++c) {
    const bool moves_from = on_path(system.topology, rod.from.body, joints[c]);
    const bool moves_to = on_path(system.topology, rod.to.body, joints[c]);
    if (moves_from) at_from[c] = rod.coupling * velocity_at(k.column[joints[c]], from);
    if (moves_to) at_to[c] = velocity_at(k.column[joints[c]], to);
    if (moves_from || moves_to) moving.push_back(c);
  }
  for (std::size_t c : moving) {
    group.momentum[c] = group.momentum[c] + force_at(at_from[c], to) + force_at(rod.coupling * at_to[c], from);
    for (std::size_t d : moving)
      group.mass[c][d] = group.mass[c][d] + (dot(at_from[c], at_to[d]) + dot(at_to[c], at_from[d]));
  }
}

template <class T>
GroupMass<T> group_mass(System<T>& system, const Kinematics<T>& k, const Inertias<T>& m, const JointGroup& group) {
  const std::size_t count = group.joints.size();
  GroupMass<T> result;
  for (int i : group.joints) {
    const auto heading = within_body(system.annotator, i);
    result.momentum.push_back(m.of_joint(system.layout, i) * k.column[i]);
    name(system.annotator, result.momentum.back(), "F", "N", system.topology.bodies[i].coordinate);
  }
  result.mass.assign(count, std::vector<T>(count, T(0.0)));
  for (std::size_t c = 0; c < count; ++c)
    for (std::size_t d = 0; d <= c; ++d)
      if (on_path(system.topology, group.joints[c], group.joints[d]))
        result.mass[c][d] = result.mass[d][c] = dot(k.column[group.joints[d]], result.momentum[c]);
  if (group.block < 0) return result;
  each_coupling_rod(system, system.topology.blocks[group.block], [&](const Rod&, const RodConstants<T>& rod) {
    add_rod(system, k, group.joints, group.base, rod, result);
  });
  return result;
}

/// Calls use(joint, generalised momentum) for a wrench on each joint from a body down to the root.
template <class T, class Use>
void each_momentum_below(const System<T>& system, const Kinematics<T>& k, int body, int frame, Spatial<T> wrench,
                         const Use& use) {
  for (int j = body; j != kGround; j = system.topology.bodies[j].parent) {
    for (; frame != system.layout.bodies[j].joint_frame; frame = system.layout.bodies[frame].base)
      wrench = lowered(k, frame, wrench);
    use(j, dot(k.column[j], wrench));
  }
}

/// The same per coordinate, zero off the path.
template <class T>
std::vector<T> momentum_below(const System<T>& system, const Kinematics<T>& k, int body, int frame,
                              const Spatial<T>& wrench) {
  std::vector<T> result(system.topology.bodies.size(), T(0.0));
  each_momentum_below(system, k, body, frame, wrench, [&](int j, const T& momentum) { result[j] = momentum; });
  return result;
}

/// Columns of Rz without their zeros: per free direction, the coordinates of the group that move with it.
template <class T>
std::vector<SparseRow<T>> moving_coordinates(const std::vector<std::vector<T>>& rz) {
  std::vector<SparseRow<T>> directions(rz.empty() ? 0 : rz[0].size());
  for (std::size_t c = 0; c < rz.size(); ++c)
    for (std::size_t q = 0; q < rz[c].size(); ++q)
      if (!is_zero(rz[c][q])) directions[q].push_back(static_cast<int>(c), rz[c][q]);
  return directions;
}

template <class T>
T weighted(const std::vector<T>& values, const SparseRow<T>& direction) {
  T sum(0.0);
  for (std::size_t i = 0; i < direction.columns.size(); ++i)
    sum = sum + values[direction.columns[i]] * direction.values[i];
  return sum;
}

/// Entries of the reduced mass matrix between a direction of a group with this momentum and the directions of the
/// groups below.
template <class T>
void couple_below(const System<T>& system, const Kinematics<T>& k, const JointGroup& group, const Spatial<T>& momentum,
                  const std::vector<std::vector<SparseRow<T>>>& moving, const std::vector<int>& first,
                  std::vector<T>& row) {
  if (group.parent < 0) return;
  const Topology& topology = system.topology;
  const std::vector<T> below =
      momentum_below(system, k, group.base, system.layout.bodies[group.joints[0]].joint_frame, momentum);
  for (int h = group.parent; h >= 0; h = topology.groups[h].parent) {
    std::vector<T> part;
    for (int j : topology.groups[h].joints) part.push_back(below[j]);
    for (std::size_t d = 0; d < moving[h].size(); ++d) row[first[h] + d] = weighted(part, moving[h][d]);
  }
}

}  // namespace detail

/// Rz' M Rz and Rz' (tree forces) (63), group by group: a direction's momentum is summed first, then met with the
/// joints below. Cost: free directions times depth.
template <class T>
ReducedSystem<T> reduced_system(System<T>& system, const Kinematics<T>& k, const Inertias<T>& m,
                                const std::vector<GroupProjection<T>>& projections, const std::vector<T>& tree_force) {
  const Topology& topology = system.topology;
  ReducedSystem<T> reduced;
  std::vector<std::vector<SparseRow<T>>> moving;
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const JointGroup& group = topology.groups[g];
    moving.push_back(detail::moving_coordinates(projections[g].rz));
    reduced.first.push_back(static_cast<int>(reduced.group.size()));
    if (moving[g].empty()) continue;
    const detail::GroupMass<T> mass = detail::group_mass(system, k, m, group);
    std::vector<T> force;
    for (int i : group.joints) force.push_back(tree_force[i]);
    for (std::size_t q = 0; q < moving[g].size(); ++q) {
      const SparseRow<T>& direction = moving[g][q];
      Spatial<T> momentum;
      for (std::size_t i = 0; i < direction.columns.size(); ++i)
        momentum = momentum + direction.values[i] * mass.momentum[direction.columns[i]];
      std::vector<T> mass_times_rz;
      for (const std::vector<T>& mass_row : mass.mass) mass_times_rz.push_back(detail::weighted(mass_row, direction));
      std::vector<T> row(reduced.group.size() + 1, T(0.0));
      detail::couple_below(system, k, group, momentum, moving, reduced.first, row);
      for (std::size_t d = 0; d <= q; ++d) row[reduced.first[g] + d] = detail::weighted(mass_times_rz, moving[g][d]);
      reduced.mass.push_back(std::move(row));
      reduced.right_hand_side.push_back(detail::weighted(force, direction));
      reduced.group.push_back(static_cast<int>(g));
    }
  }
  return reduced;
}

/// Solution of the reduced equations (63).
template <class T>
struct ReducedSolution {
  std::vector<T> acceleration;  ///< per free direction
  std::vector<T> inertia;       ///< per free direction, see EliminatedPivots
};

template <class T>
ReducedSolution<T> solve_reduced(const System<T>& system, ReducedSystem<T> s) {
  std::vector<T>& right = s.right_hand_side;
  EliminatedPivots<T> pivots =
      eliminate(s.mass, T(inertia_left_by_rounding(system.constants)),
                [&](std::size_t a, const T& factor, std::size_t q) { right[a] = right[a] - factor * right[q]; });
  return {substitute(s.mass, pivots.reciprocal, [&](std::size_t q) { return right[q]; }), std::move(pivots.inertia)};
}

/// z* of (62) of every group, per tree coordinate.
template <class T>
std::vector<T> starred_accelerations(const Topology& topology, const std::vector<GroupProjection<T>>& projections) {
  std::vector<T> zdd_star(topology.bodies.size(), T(0.0));
  for (std::size_t g = 0; g < topology.groups.size(); ++g)
    for (std::size_t c = 0; c < projections[g].zdd_star.size(); ++c)
      zdd_star[topology.groups[g].joints[c]] = projections[g].zdd_star[c];
  return zdd_star;
}

/// All joint accelerations from the accelerations of the free directions (62).
template <class T>
std::vector<T> joint_accelerations(const Topology& topology, const std::vector<GroupProjection<T>>& projections,
                                   const std::vector<T>& free_acceleration) {
  std::vector<T> zdd(topology.bodies.size(), T(0.0));
  std::size_t first = 0;
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    for (std::size_t c = 0; c < topology.groups[g].joints.size(); ++c) {
      T value = projections[g].zdd_star[c];
      for (std::size_t q = 0; q < projections[g].rz[c].size(); ++q)
        value = value + projections[g].rz[c][q] * free_acceleration[first + q];
      zdd[topology.groups[g].joints[c]] = value;
    }
    first += projections[g].rz[0].size();
  }
  return zdd;
}

}  // namespace mbgen
