#pragma once
// The recursive form at given joint accelerations: forces gathered from the leaves to the root, every body about its
// own origin, and the multipliers of a loop block by its closure's rows over quasi-velocities.

#include "compiler/formulation/dynamics.hpp"
#include "compiler/formulation/recursion/recursion_bias.hpp"

namespace mbgen {

/// Forces that joints must still be given: applied forces less inertia, summed over all bodies that a joint carries.
template <class T>
struct GatheredForces {
  std::vector<T> joint;           ///< per tree joint, tau included, N or N m
  std::vector<Vector<T>> needed;  ///< per tree body: force or moment that its joint needs, in the joint's frame
};

namespace detail {

/// Force that body i needs: inertia less applied forces, about its origin, in the axes of the frame that carries it.
template <class T>
Spatial<T> needed_force(const System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                        const Accelerations<T>& a, const AppliedForces<T>& forces, int i) {
  const Constants<T>& c = system.constants;
  const Spatial<T> inertial =
      part_force(system, k, i, Part<T>{c.mass[i], c.com[i], c.inertia[i]}, velocity_of(system, v, i).angular,
                 acceleration_of(system, a, i), MotionPoint::body_origin);
  const Spatial<T> needed = inertial - forces.wrench[i];
  name(system.annotator, needed, "f", "n", system.body_name(i));
  return needed;
}

/// Force on joint j, applied less needed by what it carries. carried: about a point from which the pin is seen at
/// `pin`.
template <class T>
void take_joint(const System<T>& system, const Kinematics<T>& k, int j, const Spatial<T>& carried, const Vector<T>& pin,
                const T& applied, GatheredForces<T>& gathered) {
  Vector<T>& acting = gathered.needed[j];
  acting = system.revolute(j) ? carried.angular - cross(pin, carried.linear) : carried.linear;
  gathered.joint[j] = applied - dot(k.axis[j], acting);
  system.annotator.name(gathered.joint[j], "Q_", system.topology.bodies[j].coordinate);
}

}  // namespace detail

/// Forces of the tree's joints for given body accelerations (48). v, a, forces: about the bodies' origins. tau: added
/// to the applied forces of the joints. Cost: linear.
template <class T>
GatheredForces<T> gathered_forces(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                                  const Accelerations<T>& a, AppliedForces<T> forces, const std::vector<T>& tau) {
  const Topology& topology = system.topology;
  const int n = system.topology.size();
  detail::rod_forces(system, k, a, forces);
  GatheredForces<T> gathered{std::vector<T>(n), std::vector<Vector<T>>(n)};
  std::vector<Spatial<T>> carried(n);
  for (int i = n - 1; i >= 0; --i) {
    const BodyLayout& layout = system.layout.bodies[i];
    if (layout.joint_frame != layout.base && layout.joint_frame != i) continue;  // inside a run: taken with its end
    const auto heading = within_body(system.annotator, i);
    Spatial<T> whole = carried[i] + detail::needed_force(system, k, v, a, forces, i);
    const auto take = [&](int j, const Vector<T>& pin) {
      detail::take_joint(system, k, j, whole, pin, tau[j] + forces.joint[j], gathered);
    };
    int start = i;
    if (layout.chain_start >= 0) {
      for (int j : detail::chain_of(topology, system.layout, i)) take(j, k.pin[j]);
      start = layout.chain_start;
    }
    detail_name(system.annotator, whole, "fc", "nc", system.body_name(i));
    if (layout.own_frame) whole = rotated(k.orientation[i], whole);
    if (layout.chain_start < 0) take(i, {});
    const int p = topology.bodies[start].parent;
    if (p == kGround) continue;
    const Vector<T> offset = layout.chain_start >= 0 ? detail::end_from_parent(system, k, i, MotionPoint::body_origin)
                                                     : offset_from_parent(system, k, i);
    carried[p] = carried[p] + shifted(offset, whole);
  }
  return gathered;
}

/// Takes Phi_z' lambda off forces per column of a block.
template <class T>
void take_off(const std::vector<SparseRow<T>>& jacobian, const std::vector<T>& lambda, std::vector<T>& forces) {
  for (std::size_t e = 0; e < lambda.size(); ++e)
    for (std::size_t i = 0; i < jacobian[e].columns.size(); ++i)
      forces[jacobian[e].columns[i]] -= jacobian[e].values[i] * lambda[e];
}

/// Multipliers of a loop block at given accelerations, and the block's monitor.
template <class T>
struct BlockMultipliers {
  std::vector<T> lambda;  ///< per equation of the block
  std::vector<T> left;    ///< per column: force that the multipliers leave; zero at dependent ones up to rounding
  T quality{1.0};
};

namespace detail {

/// Forces on the (quasi-)velocities of a unit. The joints of balls by their moments, so that only tau is converted.
template <class T>
std::vector<T> forces_of_columns(const RecursionWork<T>& work, const RecursionUnit& unit,
                                 const GatheredForces<T>& gathered, const std::vector<T>& applied, T& quality) {
  using std::abs;
  using std::min;
  std::vector<T> values(unit.joints.size());
  for (const JointStep& step : unit.steps) {
    if (!step.quasi()) {
      values[unit.column(step.body())] = gathered.joint[step.body()];
      continue;
    }
    const auto heading = within_body(work.system.annotator, step.body());
    const QuasiAxes<T>& q = work.quasi[step.body()];
    Vector<T> sum = -gathered.needed[step.body()];
    for (int c = 0; c < 3; ++c) sum = sum + applied[step.joints[c]] * q.dual[c];
    set_components(step, sum, [&](int j) -> T& { return values[unit.column(j)]; });
    if (step.revolute) quality = min(quality, abs(q.volume));
  }
  return values;
}

/// Length that a block's rows over quasi-velocities are longer by, per equation: rods are closed by (d.d - l^2)/2.
template <class T>
std::vector<T> row_lengths(const System<T>& system, const LoopBlock& block) {
  std::vector<T> lengths;
  for (int l : block.loops) {
    const Loop& loop = system.topology.loops[l];
    lengths.insert(lengths.end(), loop.equations, loop.rod < 0 ? T(1.0) : length_of(system, loop));
  }
  return lengths;
}

}  // namespace detail

/// Phi_d' lambda = (forces of the joints)_d in the frozen order over (quasi-)velocities (theory.md section 4).
/// applied: tau and applied forces of the joints, per tree joint.
template <class T>
BlockMultipliers<T> block_multipliers(const RecursionWork<T>& work, const RecursionUnit& unit,
                                      const LoopPartition& partition, const GatheredForces<T>& gathered,
                                      const std::vector<T>& applied) {
  BlockMultipliers<T> result;
  const LoopBlock& block = work.system.topology.blocks[unit.block];
  const std::vector<SparseRow<T>> jacobian =
      quasi_closure(work, unit, PerBody<Spatial<T>>(unit), PerBody<BodyAcceleration<T>>(unit)).jacobian;
  const FrozenFactors<T> factors = factorise_frozen(jacobian, partition, unit.joints.size());
  name_pivots(work.system, work.columns_of(unit), partition, factors);
  result.quality = factors.quality;
  result.left = detail::forces_of_columns(work, unit, gathered, applied, result.quality);
  result.lambda = solve_frozen_transposed(factors, partition, result.left, jacobian.size());
  take_off(jacobian, result.lambda, result.left);
  const std::vector<T> lengths = detail::row_lengths(work.system, block);
  for (std::size_t e = 0; e < jacobian.size(); ++e) result.lambda[e] = lengths[e] * result.lambda[e];
  return result;
}

}  // namespace mbgen
