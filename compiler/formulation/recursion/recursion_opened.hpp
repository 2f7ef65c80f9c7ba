#pragma once
// Recursive form: a loop block with few loops and many freedoms, on its opened tree. Its joints are eliminated one by
// one as in a tree, with the multipliers of its loops as unknowns beside the acceleration of its base; the equations of
// the multipliers are eliminated last. Cost: joints times the square of the multipliers. Source:
// docs/method/recursive.md, "Opened blocks".

#include "compiler/formulation/recursion/recursion_gathering.hpp"

namespace mbgen::detail {

/// Forces and inertia that a body of an opened block meets from the bodies above it, about its origin.
template <class T>
struct OpenedLoad {
  ArticulatedInertia<T> inertia;
  Spatial<T> needed;
  std::vector<Spatial<T>> closure;  ///< wrench per unit multiplier
};

/// The Jacobian's columns at the pivots of a partition.
template <class T>
std::vector<SparseRow<T>> dependent_columns(const std::vector<SparseRow<T>>& jacobian, const LoopPartition& partition) {
  std::vector<SparseRow<T>> rows(jacobian.size());
  for (std::size_t e = 0; e < jacobian.size(); ++e)
    for (std::size_t i = 0; i < jacobian[e].columns.size(); ++i)
      if (std::binary_search(partition.dependent.begin(), partition.dependent.end(), jacobian[e].columns[i]))
        rows[e].push_back(jacobian[e].columns[i], jacobian[e].values[i]);
  return rows;
}

/// Closures of an opened block (steps 2 and 6): Jacobian and right-hand side of the equations with pivots, driven
/// accelerations moved over. The frozen partition is watched as in other blocks.
template <class T>
void start_opened(RecursionState<T>& s, std::size_t u, const LoopPartition& partition, T& quality) {
  const RecursionUnit& unit = s.units()[u];
  Annotator<T>& annotator = s.system().annotator;
  BlockParts<T>& parts = s.blocks[u];
  UnitEquations<T>& multipliers = s.equations[u];
  const std::size_t columns = unit.joints.size(), rank = partition.pivots.size();
  parts.partition = &partition;
  parts.opened = PerBody<OpenedJoint<T>>(unit);
  parts.zdd_star.assign(columns, T(0.0));
  for (std::size_t c = 0; c < columns; ++c)
    if (const T* driven = s.driven(unit.joints[c])) parts.zdd_star[c] = *driven;
  {
    const auto step = annotator.step(Step::jacobian, unit.block);
    const SparseClosure<T> closed =
        quasi_closure(s.work, unit, PerBody<Spatial<T>>(unit), PerBody<BodyAcceleration<T>>(unit));
    const FrozenFactors<T> factors =
        factorise_frozen(dependent_columns(closed.jacobian, partition), partition, columns);
    name_pivots(s.system(), s.work.columns_of(unit), partition, factors);
    quality = factors.quality;
    for (std::size_t c = 0; c < columns; ++c)
      for (const Pivot& pivot : partition.pivots)
        parts.opened[unit.joints[c]].closure.push_back(closed.jacobian[pivot.equation].at(static_cast<int>(c)));
  }
  const auto step = annotator.step(Step::closure_bias, unit.block);
  parts.bias = block_bias(s.work, unit, parts.velocity);
  const SparseClosure<T> closed = quasi_closure(s.work, unit, parts.velocity, parts.bias);
  const std::vector<T> open = moved_over(closed.jacobian, closed.acceleration, partition.driven, parts.zdd_star);
  for (std::size_t m = 0; m < rank; ++m) {
    multipliers.mass.emplace_back(m + 1, T(0.0));
    multipliers.momentum.emplace_back();
    multipliers.force.push_back(-open[partition.pivots[m].equation]);
  }
}

/// Unit motion of a joint about the origin of its body, which is on the joint's axis.
template <class T>
Spatial<T> joint_motion(const RecursionState<T>& s, const JointStep& step) {
  const Vector<T>& axis = s.k().axis[step.body()];
  return step.revolute ? Spatial<T>{{}, axis} : Spatial<T>{axis, {}};
}

/// Takes a joint out of the load of its body, and adds its share to the equations of the multipliers.
template <class T>
void eliminate_opened_joint(RecursionState<T>& s, UnitEquations<T>& multipliers, const JointStep& step,
                            OpenedJoint<T>& joint, OpenedLoad<T>& load) {
  const Spatial<T> b = joint_motion(s, step);
  UnitEquations<T>& motion = joint.motion;
  motion.momentum = {load.inertia * b};
  motion.mass = {{dot(b, motion.momentum[0])}};
  motion.force = {s.force[step.body()] - dot(b, load.needed)};
  eliminate(motion);
  s.system().annotator.name(motion.mass[0][0], "pivot_", s.system().topology.bodies[step.body()].coordinate);
  reduce(motion, load.inertia, load.needed);
  clear_directions({b}, load.inertia);
  std::vector<T> scaled;
  for (std::size_t m = 0; m < joint.closure.size(); ++m) {
    T& own = joint.closure[m];
    own = own + dot(b, load.closure[m]);
    scaled.push_back(motion.reciprocal[0] * own);
    load.closure[m] = load.closure[m] - scaled[m] * motion.momentum[0];
    for (std::size_t d = 0; d <= m; ++d) multipliers.mass[m][d] = multipliers.mass[m][d] + own * scaled[d];
    multipliers.force[m] = multipliers.force[m] + scaled[m] * motion.force[0];
  }
}

/// Adds a load to another body's, from which its origin is seen at `place`.
template <class T>
void hand_over(const Vector<T>& place, const OpenedLoad<T>& load, OpenedLoad<T>& below) {
  below.inertia = below.inertia + shifted(place, load.inertia);
  below.needed = below.needed + shifted(place, load.needed);
  for (std::size_t m = 0; m < load.closure.size(); ++m)
    below.closure[m] = below.closure[m] + shifted(place, load.closure[m]);
}

/// Joints from the leaves on, then multipliers. Result: the share in the base about its origin.
template <class T>
CompositeBody<T> eliminate_opened_joints(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  UnitEquations<T>& multipliers = s.equations[u];
  BlockGathering<T> g = block_gathering(s, u);
  g.parts.zdd_star_motion = block_motion(s.work, unit, per_joint(unit, g.parts.zdd_star));
  const std::vector<Spatial<T>> none(multipliers.size());
  PerBody<OpenedLoad<T>> loads(unit);
  OpenedLoad<T> of_base{{}, {}, none};
  for (const JointStep& step : unit.steps) loads[step.body()].closure = none;
  for (auto step = unit.steps.rbegin(); step != unit.steps.rend(); ++step) {
    const int i = step->body(), below = s.work.parent(*step);
    const auto heading = within_body(s.system().annotator, i);
    const CompositeBody<T> body = with_arms(s, g, i);
    OpenedLoad<T>& load = loads[i];
    load.inertia = articulated(body.rigid + body.above) + body.reduced + load.inertia;
    load.needed = needed_of(s, g, i, body, Vector<T>{}) + load.needed;
    if (!s.driven(i)) eliminate_opened_joint(s, multipliers, *step, g.parts.opened[i], load);
    hand_over(s.work.offset[i], load, below == unit.base ? of_base : loads[below]);
    load = {};
  }
  for (std::size_t m = 0; m < multipliers.size(); ++m) multipliers.momentum[m] = Spatial<T>{} - of_base.closure[m];
  for (std::size_t m = 0; m < multipliers.size(); ++m) g.parts.compliance.push_back(multipliers.mass[m][m]);
  eliminate(multipliers);
  // The multipliers' equations have the opposite sign of those of free directions: they stiffen the base.
  for (std::size_t m = 0; m < multipliers.size(); ++m) {
    const Spatial<T> scaled = multipliers.reciprocal[m] * multipliers.momentum[m];
    of_base.inertia = less_dyad(of_base.inertia, Spatial<T>{} - scaled, multipliers.momentum[m]);
    of_base.needed = of_base.needed - multipliers.force[m] * scaled;
  }
  return {{}, {}, of_base.inertia, of_base.needed};
}

/// Accelerations of an opened block's joints on the way back, by column. base: acceleration of the base.
template <class T>
std::vector<T> opened_accelerations(const RecursionState<T>& s, std::size_t u, const Spatial<T>& base) {
  const RecursionUnit& unit = s.units()[u];
  const BlockParts<T>& parts = s.blocks[u];
  const std::vector<T> lambda = free_accelerations(s.equations[u], base);
  std::vector<T> zdd = parts.zdd_star;
  PerBody<Spatial<T>> moved(unit);
  for (const JointStep& step : unit.steps) {
    const int i = step.body(), p = s.work.parent(step);
    const auto heading = within_body(s.system().annotator, i);
    const Spatial<T>& below = p == unit.base ? base : moved[p];
    moved[i] = {velocity_at(below, s.work.offset[i]), below.angular};
    if (s.driven(i)) continue;
    const OpenedJoint<T>& joint = parts.opened[i];
    UnitEquations<T> motion = joint.motion;
    for (std::size_t m = 0; m < lambda.size(); ++m) motion.force[0] = motion.force[0] - joint.closure[m] * lambda[m];
    const Spatial<T> b = joint_motion(s, step);
    const T value = free_accelerations(motion, {b}, moved[i])[0];
    zdd[unit.column(i)] = value;
    moved[i] = moved[i] + value * b;
  }
  return zdd;
}

/// Inertias of an opened block's free directions: those of the joints that name them. The first one holds the monitors
/// of the other joints and of the multipliers too: the share of a row's compliance that is not along the other rows.
template <class T>
std::vector<DirectionInertia<T>> opened_inertias(const RecursionState<T>& s, std::size_t u) {
  using std::min;
  const RecursionUnit& unit = s.units()[u];
  const BlockParts<T>& parts = s.blocks[u];
  const auto of_column = [&](int c) { return parts.opened[unit.joints[c]].motion.inertia[0]; };
  std::vector<DirectionInertia<T>> found;
  for (std::size_t q = 0; q < parts.partition->independent.size(); ++q)
    found.push_back({unit.block, static_cast<int>(q), of_column(parts.partition->independent[q])});
  if (found.empty()) return found;
  T& least = found[0].value;
  for (const int c : parts.partition->dependent) least = min(least, of_column(c));
  const T inertia = least;
  for (std::size_t m = 0; m < parts.compliance.size(); ++m)
    least = min(least, inertia * (s.equations[u].inertia[m] / parts.compliance[m]));
  return found;
}

}  // namespace mbgen::detail
