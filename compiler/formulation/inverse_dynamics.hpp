#pragma once
// Forces of the actuators for given accelerations: virtual work along the free directions of the loops,
// Rz' B force = Rz' (M zdd + h), B the directions of the actuators (theory.md section 4).

#include "compiler/formulation/driven.hpp"
#include "compiler/formulation/dynamics.hpp"

namespace mbgen {

/// Forces that give a mechanism its accelerations.
template <class T>
struct InverseDynamics {
  std::vector<T> zdd;        ///< all accelerations, dependent and driven ones as loops and motions have them
  std::vector<T> force;      ///< per actuator, at its motor: N or N m
  std::vector<T> clearance;  ///< per direction: pivot of the actuator that moves it, over its reference
  std::vector<T> quality;    ///< per loop block: smallest pivot over its reference
};

namespace detail {

/// While it lives the inputs of actuators are zero.
template <class T>
class SilentActuators {
 public:
  explicit SilentActuators(System<T>& system) : inputs_(system.environment.inputs), before_(inputs_) {
    for (const Actuator& actuator : system.model.actuators)
      if (actuator.input >= 0) inputs_[actuator.input] = T(0.0);
  }
  SilentActuators(const SilentActuators&) = delete;
  SilentActuators& operator=(const SilentActuators&) = delete;
  ~SilentActuators() { inputs_ = std::move(before_); }

 private:
  std::vector<T>& inputs_;
  std::vector<T> before_;
};

/// Accelerations with the prescribed ones of all motions in their places, of held coordinates and of coordinates with a
/// motion that actuators give.
template <class T>
std::vector<T> with_motions(const System<T>& system, std::vector<T> given) {
  for (const Drive<T>& drive : drives(system)) given[drive.coordinate] = drive.acceleration;
  return given;
}

/// Accelerations of held coordinates, zero of the others.
template <class T>
std::vector<T> of_held(const std::vector<T>& accelerations, const std::vector<bool>& held) {
  std::vector<T> result(accelerations.size(), T(0.0));
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i]) result[i] = accelerations[i];
  return result;
}

/// Accelerations of the free directions: of the independent coordinates in `given`, per coordinate.
template <class T, class Partitions>
std::vector<T> free_accelerations(const Topology& topology, const Partitions& partitions,
                                  const std::vector<GroupProjection<T>>& projections, const std::vector<T>& given) {
  std::vector<T> result;
  for (std::size_t g = 0; g < projections.size(); ++g) {
    const JointGroup& group = topology.groups[g];
    for (std::size_t q = 0; q < projections[g].rz[0].size(); ++q)
      result.push_back(given[group.joints[group.block < 0 ? 0 : partitions[group.block].independent[q]]]);
  }
  return result;
}

/// Rz' times generalised forces of the tree, per free direction.
template <class T>
std::vector<T> along_directions(const Topology& topology, const std::vector<GroupProjection<T>>& projections,
                                const std::vector<T>& force) {
  std::vector<T> result;
  for (std::size_t g = 0; g < projections.size(); ++g) {
    std::vector<T> of_group;
    for (const int j : topology.groups[g].joints) of_group.push_back(force[j]);
    for (const SparseRow<T>& direction : moving_coordinates(projections[g].rz))
      result.push_back(weighted(of_group, direction));
  }
  return result;
}

/// Generalised forces of the tree for a unit force of an actuator's motor.
template <class T>
std::vector<T> unit_force(const ForceWork<T>& work, const Actuator& actuator) {
  std::vector<T> force;
  const T gear = work.value(actuator.gear, "gear", actuator.name);
  connect(work, actuator, [&](const auto& at) { force = at.row(work).row; });
  for (T& entry : force)
    if (!is_zero(entry)) entry = gear * entry;
  return force;
}

}  // namespace detail

/// Rz' B: per free direction, its force for a unit force of each actuator that moves it.
template <class T>
std::vector<SparseRow<T>> actuation(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                                    const std::vector<GroupProjection<T>>& projections) {
  AppliedForces<T> none;
  none.about = v.about;
  const detail::ForceWork<T> work{system, k, v, none};
  std::vector<SparseRow<T>> rows;
  for (const Actuator& actuator : system.model.actuators) {
    const auto heading = within(system, actuator);
    const std::vector<T> force =
        detail::along_directions(system.topology, projections, detail::unit_force(work, actuator));
    rows.resize(force.size());
    for (std::size_t q = 0; q < force.size(); ++q)
      if (!is_zero(force[q])) rows[q].push_back(static_cast<int>(index_in(system.model.actuators, actuator)), force[q]);
  }
  return rows;
}

/// Sign of the determinant of Jacobian and actuators together, but for their orders, at a position: it changes where
/// actuators pass a singular position, and not where a partition does, det(Phi_d) det(Rz' B). Requires: as many
/// actuators as directions.
inline int side_of_actuators(System<double>& system, const ActuatedDirections& directions,
                             const LoopPartition& actuators) {
  const Kinematics<double> k = kinematics(system);
  int side = 1;
  const auto count_signs = [&](const FrozenFactors<double>& factors) {
    for (const double pivot : factors.pivot) side = pivot < 0 ? -side : side;
  };
  const RelativeMotion<double> rest = at_rest<double>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const LoopBlock& block = system.topology.blocks[b];
    count_signs(factorise_frozen(sparse_closure(system, k, block, rest).jacobian, directions.partitions[b],
                                 block.joints.size()));
  }
  count_signs(factorise_frozen(
      actuation(system, k, velocities(system, k), frozen_directions(system, k, directions.partitions, directions.held)),
      actuators, system.model.actuators.size()));
  return side;
}

namespace detail {

/// Least weighted forces with the same generalised forces: force less its part along the null
/// space of Rz' B, [-A_d^-1 A_i; I].
template <class T>
void make_least(const Model& model, const std::vector<std::vector<T>>& idle, std::vector<T>& force) {
  const std::size_t count = idle.empty() ? 0 : idle[0].size();
  std::vector<std::vector<T>> matrix(count);
  std::vector<T> right(count, T(0.0));
  for (std::size_t a = 0; a < count; ++a) {
    matrix[a].assign(a + 1, T(0.0));
    for (std::size_t i = 0; i < force.size(); ++i) {
      if (is_zero(idle[i][a])) continue;
      const T weighted = T(model.actuators[i].weight) * idle[i][a];
      right[a] = right[a] + weighted * force[i];
      for (std::size_t b = 0; b <= a; ++b)
        if (!is_zero(idle[i][b])) matrix[a][b] = matrix[a][b] + weighted * idle[i][b];
    }
  }
  const EliminatedPivots<T> pivots = eliminate(
      matrix, T(0.0), [&](std::size_t a, const T& factor, std::size_t q) { right[a] = right[a] - factor * right[q]; });
  const std::vector<T> along = substitute(matrix, pivots.reciprocal, [&](std::size_t q) { return right[q]; });
  for (std::size_t i = 0; i < force.size(); ++i)
    for (std::size_t a = 0; a < count; ++a)
      if (!is_zero(idle[i][a])) force[i] = force[i] - idle[i][a] * along[a];
}

}  // namespace detail

/// Forces of the actuators at a consistent state. The forces of actuators by their inputs do not act here. directions:
/// that actuators move; actuators: pivots of Rz' B, equations are directions, coordinates actuators; given:
/// accelerations, read at independent coordinates without motions; tau: other generalised forces on the coordinates.
/// Requires: every free direction has a pivot. Cost: as the forces and accelerations of the tree, the factors of the
/// blocks and of Rz' B.
template <class T>
InverseDynamics<T> inverse_dynamics(System<T>& system, const ActuatedDirections& directions,
                                    const LoopPartition& actuators, const std::vector<T>& given,
                                    const std::vector<T>& tau) {
  const detail::SilentActuators<T> silent(system);
  const auto in = [&](Step step, const auto& work) {
    const auto scope = system.annotator.step(step);
    return work();
  };
  InverseDynamics<T> result;
  const Kinematics<T> k = in(Step::inertias, [&] { return kinematics(system); });
  const Inertias<T> m = in(Step::inertias, [&] { return inertias(system, k); });
  const Velocities<T> v = in(Step::velocities, [&] { return velocities(system, k); });
  const AppliedForces<T> forces = in(Step::forces, [&] { return applied_forces(system, k, v); });
  const std::vector<GroupProjection<T>> projections = in(Step::closure_bias, [&] {
    const std::vector<T> moved = detail::with_motions(system, given), held = detail::of_held(moved, directions.held);
    std::vector<GroupProjection<T>> found =
        frozen_directions(system, k, directions.partitions, directions.held, &result.quality, &held);
    result.zdd = joint_accelerations(system.topology, found,
                                     detail::free_accelerations(system.topology, directions.partitions, found, moved));
    return found;
  });
  const std::vector<T> left = in(Step::accelerations, [&] {
    return tree_forces(system, k, m, v, accelerations(system, k, v, result.zdd), forces, tau);
  });
  const auto step = system.annotator.step(Step::solution);
  std::vector<T> required = detail::along_directions(system.topology, projections, left);
  for (T& force : required) force = -force;
  const std::size_t count = system.model.actuators.size();
  const FrozenFactors<T> factors = factorise_frozen(actuation(system, k, v, projections), actuators, count);
  result.force = solve_frozen(factors, actuators, required, count);
  if (!actuators.independent.empty())
    detail::make_least(system.model, frozen_rz(factors, actuators, count), result.force);
  result.clearance.assign(required.size(), T(1.0));
  for (std::size_t p = 0; p < actuators.pivots.size(); ++p) {
    using std::abs;
    const Pivot& pivot = actuators.pivots[p];
    result.clearance[pivot.equation] = abs(factors.pivot[p]) * T(1.0 / pivot.reference);
  }
  for (std::size_t i = 0; i < count; ++i)
    system.annotator.name(result.force[i], "actuation_", system.model.actuators[i].name);
  return result;
}

}  // namespace mbgen
