#pragma once
// Loop closures (theory.md section 3), each block in the frame of its base body: residuals, Jacobian, acceleration
// right-hand side. A row is a residual in m or 1; its Jacobian is the wrench of a unit multiplier on the joint columns,
// so a multiplier is N or N m.

#include "compiler/formulation/column_names.hpp"
#include "compiler/formulation/coupling.hpp"
#include "compiler/formulation/motion.hpp"
#include "compiler/formulation/rolling.hpp"

namespace mbgen {

/// Entries of a matrix row that are not structurally absent, columns ascending.
template <class T>
struct SparseRow {
  std::vector<int> columns;
  std::vector<T> values;
  /// Entry of a column, zero where there is none.
  T at(int column) const {
    const auto found = std::lower_bound(columns.begin(), columns.end(), column);
    return found == columns.end() || *found != column ? T(0.0) : values[found - columns.begin()];
  }
  void push_back(int column, T value) {
    columns.push_back(column);
    values.push_back(std::move(value));
  }
};

/// Closure terms of one loop block. Columns are LoopBlock::joints, rows the equations of LoopBlock::loops in order.
template <class T>
struct SparseClosure {
  std::vector<T> residual;             ///< Phi
  std::vector<SparseRow<T>> jacobian;  ///< Phi_z, per equation the joints of its loop
  std::vector<T> acceleration;         ///< c of Phi_z zdd = c
};

/// The same with all columns of the block in every row.
template <class T>
struct BlockClosure {
  std::vector<T> residual;               ///< Phi
  std::vector<std::vector<T>> jacobian;  ///< Phi_z, [equation][column]
  std::vector<T> acceleration;           ///< c of Phi_z zdd = c
};

/// Motion of the bodies of a block relative to its base at rest, with zero joint accelerations. Indexed by tree body.
template <class T>
struct RelativeMotion {
  std::vector<Spatial<T>> velocity;
  std::vector<Acceleration<T>> acceleration;
};

/// No motion at all: closures then have residuals and Jacobian only.
template <class T>
RelativeMotion<T> at_rest(const Topology& topology) {
  RelativeMotion<T> motion;
  motion.velocity.resize(topology.bodies.size());
  motion.acceleration.resize(topology.bodies.size());
  return motion;
}

/// Sets the motion of the block's bodies and leaves the others alone.
template <class T>
void set_relative_motion(System<T>& system, const Kinematics<T>& k, const LoopBlock& block, RelativeMotion<T>& m) {
  for (int i : block.joints) {
    const auto heading = within_body(system.annotator, i);
    const int p = system.topology.bodies[i].parent;
    const Spatial<T> below = p == block.base ? Spatial<T>{} : m.velocity[p];
    const Acceleration<T> below_acceleration = p == block.base ? Acceleration<T>{} : m.acceleration[p];
    m.velocity[i] = advanced(below, k.column[i], system.zd(i));
    m.acceleration[i] = advanced(below_acceleration, system.revolute(i), k.axis[i], k.pin[i], system.zd(i), T(0.0),
                                 below.angular, m.velocity[i].angular);
  }
}

template <class T>
RelativeMotion<T> relative_motion(System<T>& system, const Kinematics<T>& k, const LoopBlock& block) {
  RelativeMotion<T> m = at_rest<T>(system.topology);
  set_relative_motion(system, k, block, m);
  return m;
}

/// Adds the equation of a coupling. column_of: of a tree joint, ascending with it.
template <class T, class ColumnOf>
void add_coupling(const System<T>& system, const Loop& loop, const ColumnOf& column_of, SparseClosure<T>& closure) {
  const CouplingEquation<T> equation = coupling_equation(system, loop);
  SparseRow<T> entries;
  for (const auto& [joint, slope] : equation.slopes) entries.push_back(static_cast<int>(column_of(joint)), slope);
  closure.residual.push_back(equation.residual);
  closure.jacobian.push_back(std::move(entries));
  closure.acceleration.push_back(-equation.acceleration);
}

/// Names of a block's equations, `loop.row`.
std::vector<std::string> equation_names(const Topology& topology, const LoopBlock& block);

namespace detail {

/// One end of a loop: body, the joints of the block that move it, and its motion relative to the block's base.
template <class T>
struct LoopEnd {
  int body = kGround;
  Vector<T> place;               ///< m, block base frame
  Spatial<T> velocity;           ///< relative to the base
  Acceleration<T> acceleration;  ///< relative to the base, at zero joint accelerations
};

/// Unit vectors that complete an axis to a right-handed triad: coordinate axes when the axis is one.
struct Triad {
  Vector3 first, second, axis;
};
Triad triad(const Vector3& axis);
/// The same triad, turned the short way until its axis is another one. Requires: not opposite axes.
Triad bent(const Triad& triad, const Vector3& axis);
/// The triad that a cut joint fixes on its `to` body; on `from` its axis gives the triad.
Triad triad_on_to(const Joint& joint);

/// Wrench rows of a closure: the row's Jacobian entry is +wrench_from . b for joints that move `from`, -wrench_to . b
/// for the others.
template <class T>
struct Row {
  T residual{0.0};
  Spatial<T> wrench_from, wrench_to;
  T acceleration{0.0};  ///< second derivative of the residual at zero joint accelerations
};

/// Component of r_from - r_to along a constant direction of the base frame (53).
template <class T>
Row<T> coincidence(const LoopEnd<T>& from, const LoopEnd<T>& to, const Vector<T>& direction) {
  return {dot(direction, from.place - to.place), force_at(direction, from.place), force_at(direction, to.place),
          dot(direction, from.acceleration.at(from.place) - to.acceleration.at(to.place))};
}

/// a . b = 0 for a vector of `from` and one of `to` (robust form of (54)).
template <class T>
Row<T> perpendicular(const LoopEnd<T>& from, const LoopEnd<T>& to, const Vector<T>& a, const Vector<T>& b) {
  const Spatial<T> wrench{{}, cross(a, b)};
  const T twice = dot(cross(from.velocity.angular, a), cross(to.velocity.angular, b));
  return {dot(a, b), wrench, wrench,
          dot(from.acceleration.gradient * a, b) + dot(a, to.acceleration.gradient * b) + (twice + twice)};
}

/// a . (r_from - r_to) = 0 for a vector of `from`: the point of `to` stays in a plane of `from`.
template <class T>
Row<T> in_plane(const LoopEnd<T>& from, const LoopEnd<T>& to, const Vector<T>& a) {
  const Vector<T> gap = from.place - to.place;
  const Spatial<T> wrench = force_at(a, to.place);
  const Vector<T> rate = velocity_at(from.velocity, from.place) - velocity_at(to.velocity, to.place);
  const T twice = dot(cross(from.velocity.angular, a), rate);
  return {dot(a, gap), wrench, wrench,
          dot(from.acceleration.gradient * a, gap) +
              dot(a, from.acceleration.at(from.place) - to.acceleration.at(to.place)) + (twice + twice)};
}

/// The body of an end at another place, base frame; the velocity and acceleration of its point there.
template <class T>
LoopEnd<T> at(LoopEnd<T> end, const Vector<T>& place) {
  end.place = place;
  return end;
}
template <class T>
Vector<T> point_velocity(const LoopEnd<T>& end) {
  return velocity_at(end.velocity, end.place);
}

/// Half the difference of two rows.
template <class T>
Row<T> half_difference(const Row<T>& a, const Row<T>& b) {
  const T half(0.5);
  return {half * (a.residual - b.residual), half * (a.wrench_from - b.wrench_from), half * (a.wrench_to - b.wrench_to),
          half * (a.acceleration - b.acceleration)};
}

/// Constant distance (55), scaled by 1/(2 l): residual in m, multiplier the axial force of the rod in N.
template <class T>
Row<T> distance(const LoopEnd<T>& from, const LoopEnd<T>& to, const T& length) {
  const Vector<T> gap = from.place - to.place;
  const T scale = T(1.0) / length;
  const Vector<T> direction = scale * gap;
  const Vector<T> rate = velocity_at(from.velocity, from.place) - velocity_at(to.velocity, to.place);
  return {T(0.5) * (dot(direction, gap) - length), force_at(direction, from.place), force_at(direction, to.place),
          scale * dot(rate, rate) + dot(direction, from.acceleration.at(from.place) - to.acceleration.at(to.place))};
}

constexpr bool is_one_of(ClosureKind kind, std::initializer_list<ClosureKind> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Length of a rod; loop: of the rod.
template <class T>
T length_of(const System<T>& system, const Loop& loop) {
  const T& length = system.constants.rods[loop.rod].length;
  return loop.length < 0 ? length : length + system.z(loop.length);
}

/// Radius of a disc or ball, zero of others.
template <class T>
T radius_of(const System<T>& system, const Joint& joint) {
  return joint.radius ? value_of(system.model, *joint.radius, system.environment) : T(0.0);
}

/// The rows of a cut joint (53), (54), between ends of a kind for which such rows are defined. axes: the joint's triad
/// on both bodies, base frame axes. The turn of a homokinetic joint: x1 . y2 = y1 . x2 says that `to` is turned against
/// `from` about a line across the shaft, so that the shafts lie like mirror images about the plane between them.
template <class T, template <class> class End>
auto joint_rows(ClosureKind kind, const End<T>& from, const End<T>& to, const Matrix<T>& on_from,
                const Matrix<T>& on_to) {
  std::vector<decltype(perpendicular(from, to, on_from.x, on_to.x))> rows;
  using enum ClosureKind;
  if (is_one_of(kind, {spherical, revolute, universal, fixed, homokinetic}))
    for (const Vector<T>& direction : {identity<T>().x, identity<T>().y, identity<T>().z})
      rows.push_back(coincidence(from, to, direction));
  if (is_one_of(kind, {prismatic, cylindrical, point_on_line})) {
    rows.push_back(in_plane(from, to, on_from.x));
    rows.push_back(in_plane(from, to, on_from.y));
  }
  if (is_one_of(kind, {planar, point_on_plane})) rows.push_back(in_plane(from, to, on_from.z));
  if (kind == universal) rows.push_back(perpendicular(from, to, on_from.z, on_to.z));
  if (is_one_of(kind, {revolute, prismatic, cylindrical, planar, fixed, parallel_axes, orientation})) {
    rows.push_back(perpendicular(from, to, on_from.x, on_to.z));
    rows.push_back(perpendicular(from, to, on_from.y, on_to.z));
  }
  if (is_one_of(kind, {prismatic, fixed, orientation})) rows.push_back(perpendicular(from, to, on_from.x, on_to.y));
  if (kind == homokinetic)
    rows.push_back(
        half_difference(perpendicular(from, to, on_from.x, on_to.y), perpendicular(from, to, on_from.y, on_to.x)));
  return rows;
}

/// Names a closure's row in programs for reading: J, bias and residual. by_length: the row is multiplied by the length
/// of its rod.
template <class T>
void detail_row(const System<T>& system, const Loop& loop, const ColumnNames& column, int number,
                const SparseRow<T>& row, const T& acceleration, const T& residual, bool by_length) {
  if (!system.annotator.has_details()) return;
  const std::string name = loop.equations > 1 ? loop.name + "_" + std::to_string(number) : loop.name;
  for (std::size_t i = 0; i < row.columns.size(); ++i)
    system.annotator.detail(row.values[i], by_length ? "Jl_" : "J_", name, "_", column(row.columns[i]));
  system.annotator.detail(acceleration, by_length ? "biasl_" : "bias_", name);
  system.annotator.detail(residual, "Phi_", name);
}

/// A constant triad on a body, in the axes of the block's base frame.
template <class T>
Matrix<T> triad_on(const System<T>& system, const Kinematics<T>& k, int body, int frame, const Triad& t) {
  const auto turned = [&](const Vector3& v) { return direction_in(system, k, body, constant<T>(v), frame); };
  return {turned(t.first), turned(t.second), turned(t.axis)};
}

template <class T>
LoopEnd<T> loop_end(const System<T>& system, const Kinematics<T>& k, const RelativeMotion<T>& motion,
                    const Place<T>& place, int frame) {
  LoopEnd<T> end{place.body, position_in(system, k, place, frame), {}, {}};
  if (place.body != frame) {
    end.velocity = motion.velocity[place.body];
    end.acceleration = motion.acceleration[place.body];
  }
  return end;
}

template <class T>
std::vector<Row<T>> loop_rows(System<T>& system, const Kinematics<T>& k, const RelativeMotion<T>& motion,
                              const Loop& loop, int frame) {
  const auto heading = within_loop(system.annotator, index_in(system.topology.loops, loop));
  if (loop.kind == ClosureKind::rod) {
    const RodConstants<T>& rod = system.constants.rods[loop.rod];
    const T length = length_of(system, loop);
    Row<T> row =
        distance(loop_end(system, k, motion, rod.from, frame), loop_end(system, k, motion, rod.to, frame), length);
    // Its own coordinate has a constant entry in the Jacobian, and the square of its rate here.
    if (loop.length >= 0)
      row.acceleration = row.acceleration - system.zd(loop.length) * system.zd(loop.length) / length;
    return {row};
  }
  const Joint& joint = system.model.joints[loop.joint];
  const auto end = [&](const Attachment& at) { return loop_end(system, k, motion, place_of(system, at), frame); };
  const LoopEnd<T> from = end(joint.from), to = end(joint.to);
  const Matrix<T> on_from = triad_on(system, k, from.body, frame, triad(joint.axis));
  const Matrix<T> on_to = triad_on(system, k, to.body, frame, triad_on_to(joint));
  if (is_rolling(loop.kind)) return rolling_rows(loop.kind, from, to, on_from, on_to, radius_of(system, joint));
  return joint_rows(loop.kind, from, to, on_from, on_to);
}

}  // namespace detail

/// Residuals, Jacobian and, from the relative motion, acceleration right-hand side of one block (steps 2 and 6), rows
/// by (53) to (55). Cost: equations times joints of each loop.
template <class T>
SparseClosure<T> sparse_closure(System<T>& system, const Kinematics<T>& k, const LoopBlock& block,
                                const RelativeMotion<T>& motion) {
  SparseClosure<T> result;
  const auto column_of = [&](int joint) {
    return std::lower_bound(block.joints.begin(), block.joints.end(), joint) - block.joints.begin();
  };
  for (int l : block.loops) {
    const Loop& loop = system.topology.loops[l];
    if (loop.kind == ClosureKind::coupling) {
      add_coupling(system, loop, column_of, result);
      continue;
    }
    for (const detail::Row<T>& row : detail::loop_rows(system, k, motion, loop, block.base)) {
      SparseRow<T> entries;
      for (int j : loop.joints) {
        const bool moves_from = on_path(system.topology, loop.body_from, j);
        entries.push_back(static_cast<int>(column_of(j)), j == loop.length ? T(-1.0)
                                                          : moves_from     ? dot(k.column[j], row.wrench_from)
                                                                           : -dot(k.column[j], row.wrench_to));
        system.annotator.name(entries.values.back(), "J_", loop.name, "_", system.topology.bodies[j].coordinate);
      }
      result.residual.push_back(row.residual);
      result.jacobian.push_back(std::move(entries));
      result.acceleration.push_back(-row.acceleration);
    }
  }
  return result;
}

/// sparse_closure with the Jacobian written out. Cost: equations times joints of the block.
template <class T>
BlockClosure<T> closure(System<T>& system, const Kinematics<T>& k, const LoopBlock& block,
                        const RelativeMotion<T>& motion) {
  SparseClosure<T> sparse = sparse_closure(system, k, block, motion);
  BlockClosure<T> result{std::move(sparse.residual), {}, std::move(sparse.acceleration)};
  for (const SparseRow<T>& row : sparse.jacobian) {
    std::vector<T> columns(block.joints.size(), T(0.0));
    for (std::size_t i = 0; i < row.columns.size(); ++i) columns[row.columns[i]] = row.values[i];
    result.jacobian.push_back(std::move(columns));
  }
  return result;
}

/// Values per equation, given block by block, in the order of Topology::loops.
template <class T>
std::vector<T> in_loop_order(const Topology& topology, const std::vector<std::vector<T>>& by_block) {
  std::vector<std::vector<T>> of_loop(topology.loops.size());
  for (std::size_t b = 0; b < by_block.size(); ++b) {
    auto next = by_block[b].begin();
    for (int l : topology.blocks[b].loops) {
      of_loop[l].assign(next, next + topology.loops[l].equations);
      next += topology.loops[l].equations;
    }
  }
  std::vector<T> result;
  for (const std::vector<T>& values : of_loop) result.insert(result.end(), values.begin(), values.end());
  return result;
}

/// The way back: values per equation in the order of Topology::loops, block by block.
template <class T>
std::vector<std::vector<T>> by_block(const Topology& topology, const std::vector<T>& values) {
  std::vector<std::size_t> first(topology.loops.size() + 1, 0);
  for (std::size_t l = 0; l < topology.loops.size(); ++l) first[l + 1] = first[l] + topology.loops[l].equations;
  std::vector<std::vector<T>> result(topology.blocks.size());
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (int l : topology.blocks[b].loops)
      result[b].insert(result[b].end(), values.begin() + first[l], values.begin() + first[l + 1]);
  return result;
}

}  // namespace mbgen
