#pragma once
// Loop closures of the recursive form (theory.md section 3): residual, Jacobian and acceleration right-hand side, each
// end seen from the origin of its own body. Rods by (d.d - l^2)/2 over quasi-velocities, divided by l over joint rates.

#include <map>

#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/recursion/recursion_motion.hpp"

namespace mbgen {

/// Columns of a block's Jacobian.
enum class Columns {
  quasi,  ///< the (quasi-)velocities of the recursion
  rates   ///< the joint rates, as in `closure`
};

namespace detail {

/// One end of a loop, in the axes of the block's base.
template <class T>
struct NearEnd {
  int body = kGround;
  Vector<T> arm;    ///< from the body's origin, m
  Vector<T> place;  ///< from the base's origin, m
  Spatial<T> velocity;
  BodyAcceleration<T> bias;
  Vector<T> point_velocity() const { return velocity_at(velocity, arm); }
  Vector<T> point_acceleration() const {
    return bias.linear + cross(bias.angular, arm) + cross(velocity.angular, cross(velocity.angular, arm));
  }
};

/// Wrench rows of a closure about the origins of its two bodies; `acceleration` is the second derivative of the
/// residual at the ends' bias.
template <class T>
struct NearRow {
  Vector<T> force, moment_from, moment_to;
  T acceleration{0.0};
  T residual{0.0};
};

/// (53), as the row of two LoopEnds.
template <class T>
NearRow<T> coincidence(const NearEnd<T>& from, const NearEnd<T>& to, const Vector<T>& direction) {
  return {direction, cross(from.arm, direction), cross(to.arm, direction),
          dot(direction, from.point_acceleration() - to.point_acceleration()), dot(direction, from.place - to.place)};
}

/// (54), likewise.
template <class T>
NearRow<T> perpendicular(const NearEnd<T>& from, const NearEnd<T>& to, const Vector<T>& a, const Vector<T>& b) {
  const Vector<T> moment = cross(a, b);
  const T twice = dot(cross(from.velocity.angular, a), cross(to.velocity.angular, b));
  return {
      {}, moment, moment, dot(from.bias.gradient * a, b) + dot(a, to.bias.gradient * b) + (twice + twice), dot(a, b)};
}

/// As of a LoopEnd.
template <class T>
NearEnd<T> at(NearEnd<T> end, const Vector<T>& place) {
  end.arm = end.arm + (place - end.place);
  end.place = place;
  return end;
}
template <class T>
Vector<T> point_velocity(const NearEnd<T>& end) {
  return end.point_velocity();
}

/// Half the difference of two rows.
template <class T>
NearRow<T> half_difference(const NearRow<T>& a, const NearRow<T>& b) {
  const T half(0.5);
  return {half * (a.force - b.force), half * (a.moment_from - b.moment_from), half * (a.moment_to - b.moment_to),
          half * (a.acceleration - b.acceleration), half * (a.residual - b.residual)};
}

/// The point of `to` in a plane of `from`, likewise.
template <class T>
NearRow<T> in_plane(const NearEnd<T>& from, const NearEnd<T>& to, const Vector<T>& a) {
  const Vector<T> gap = from.place - to.place;
  const Vector<T> rate = from.point_velocity() - to.point_velocity();
  const T twice = dot(cross(from.velocity.angular, a), rate);
  return {
      a, cross(from.arm - gap, a), cross(to.arm, a),
      dot(from.bias.gradient * a, gap) + dot(a, from.point_acceleration() - to.point_acceleration()) + (twice + twice),
      dot(a, gap)};
}

/// (55); over quasi-velocities times the length, and then without use for its residual.
template <class T>
NearRow<T> distance(const NearEnd<T>& from, const NearEnd<T>& to, const T& length, Columns columns) {
  const T scale = columns == Columns::rates ? T(1.0) / length : T(1.0);
  const Vector<T> gap = from.place - to.place, along = scale * gap;
  const Vector<T> rate = from.point_velocity() - to.point_velocity();
  return {along, cross(from.arm, along), cross(to.arm, along),
          scale * dot(rate, rate) + dot(along, from.point_acceleration() - to.point_acceleration()),
          T(0.5) * (dot(along, gap) - length)};
}

/// An end at a place of a body of the block or of its base.
template <class T>
NearEnd<T> near_end(const RecursionWork<T>& work, const RecursionUnit& unit, const PerBody<Spatial<T>>& velocity,
                    const PerBody<BodyAcceleration<T>>& bias, const Place<T>& place) {
  if (place.body == unit.base) return {place.body, place.at, place.at, {}, {}};
  const Vector<T> arm = work.k.orientation[place.body] * place.at;
  return {place.body, arm, work.origin(place.body) + arm, velocity[place.body], bias[place.body]};
}

/// Names the two ends of a loop in programs for reading.
template <class T>
void detail_ends(const System<T>& system, const Loop& loop, const NearEnd<T>& from, const NearEnd<T>& to) {
  Annotator<T>& annotator = system.annotator;
  if (!annotator.has_details()) return;
  for (const auto& [end, which] : {std::pair(&from, "_from"), std::pair(&to, "_to")}) {
    detail_name(annotator, end->arm, "arm_", loop.name, which);
    detail_name(annotator, end->place, "place_", loop.name, which);
    detail_name(annotator, cross(end->velocity.angular, end->arm), "varm_", loop.name, which);
    detail_name(annotator, end->point_velocity(), "v_", loop.name, which);
    detail_name(annotator, end->point_acceleration(), "a0_", loop.name, which);
  }
  detail_name(annotator, from.place - to.place, "gap_", loop.name);
  detail_name(annotator, from.point_velocity() - to.point_velocity(), "vgap_", loop.name);
  detail_name(annotator, from.point_acceleration() - to.point_acceleration(), "a0gap_", loop.name);
}

/// Names the wrench of a closure's row in programs for reading.
template <class T>
void detail_wrench(const System<T>& system, const Loop& loop, int number, const NearRow<T>& row) {
  if (!system.annotator.has_details()) return;
  const std::string name = loop.equations > 1 ? loop.name + "_" + std::to_string(number) : loop.name;
  detail_name(system.annotator, row.force, "along_", name);
  detail_name(system.annotator, row.moment_from, "lever_", name, "_from");
  detail_name(system.annotator, row.moment_to, "lever_", name, "_to");
}

template <class T>
std::vector<NearRow<T>> near_rows(const RecursionWork<T>& work, const RecursionUnit& unit,
                                  const PerBody<Spatial<T>>& velocity, const PerBody<BodyAcceleration<T>>& bias,
                                  const Loop& loop, Columns by) {
  const System<T>& system = work.system;
  const auto end = [&](const Place<T>& place) { return near_end(work, unit, velocity, bias, place); };
  if (loop.kind == ClosureKind::rod) {
    const RodConstants<T>& rod = system.constants.rods[loop.rod];
    const T length = length_of(system, loop);
    const NearEnd<T> from = end(rod.from), to = end(rod.to);
    detail_ends(system, loop, from, to);
    NearRow<T> row = distance(from, to, length, by);
    if (loop.length >= 0) {
      const T square = system.zd(loop.length) * system.zd(loop.length);
      row.acceleration = row.acceleration - (by == Columns::rates ? square / length : square);
    }
    return {row};
  }
  const Joint& joint = system.model.joints[loop.joint];
  const auto at = [&](const Attachment& a) { return end(place_of(system, a)); };
  const NearEnd<T> from = at(joint.from), to = at(joint.to);
  detail_ends(system, loop, from, to);
  const auto triad_at = [&](int body, const Triad& t) {
    const Matrix<T> axes = body == unit.base ? identity<T>() : work.k.orientation[body];
    return Matrix<T>{axes * constant<T>(t.first), axes * constant<T>(t.second), axes * constant<T>(t.axis)};
  };
  const Matrix<T> on_from = triad_at(from.body, triad(joint.axis)), on_to = triad_at(to.body, triad_on_to(joint));
  if (is_rolling(loop.kind)) return rolling_rows(loop.kind, from, to, on_from, on_to, radius_of(system, joint));
  return joint_rows(loop.kind, from, to, on_from, on_to);
}

/// Adds sign times the columns of a wrench about the origin of `body` to a row. by: what columns stand for.
template <class T>
void add_columns(const RecursionWork<T>& work, const RecursionUnit& unit, const Loop& loop, int body,
                 const Vector<T>& force, Vector<T> moment, double sign, Columns by, std::map<int, T>& row) {
  const auto local = [&](int joint) { return static_cast<int>(unit.column(joint)); };
  while (body != unit.base) {
    const JointStep& step = *work.step[body];
    const Vector<T>& acting = step.revolute ? moment : force;
    if (std::binary_search(loop.joints.begin(), loop.joints.end(), step.joints[0])) {
      if (step.quasi() && by == Columns::quasi) {
        row[local(step.joints[0])] = T(sign) * acting.x;
        row[local(step.joints[1])] = T(sign) * acting.y;
        row[local(step.joints[2])] = T(sign) * acting.z;
      } else {
        for (int j : step.joints) row[local(j)] = T(sign) * dot(work.k.axis[j], acting);
      }
    }
    moment = moment + cross(work.offset[body], force);
    body = work.parent(step);
  }
}

}  // namespace detail

/// Closure terms of a block, rows as in `closure`. velocity, bias: of block_motion and of block_bias or, by joint
/// rates, rate_bias; zero ones give residual and Jacobian alone. Residuals: right by joint rates only, see Columns.
template <class T>
SparseClosure<T> near_closure(const RecursionWork<T>& work, const RecursionUnit& unit,
                              const PerBody<Spatial<T>>& velocity, const PerBody<BodyAcceleration<T>>& bias,
                              Columns by) {
  SparseClosure<T> result;
  const bool is_quasi = by == Columns::quasi;
  const ColumnNames column_names = is_quasi ? work.columns_of(unit) : ColumnNames{work.system.topology, unit.joints};
  for (int l : work.system.topology.blocks[unit.block].loops) {
    const Loop& loop = work.system.topology.loops[l];
    if (loop.kind == ClosureKind::coupling) {
      add_coupling(
          work.system, loop, [&](int joint) { return unit.column(joint); }, result);
      continue;
    }
    const auto heading = within_loop(work.system.annotator, l);
    int number = 0;
    for (const detail::NearRow<T>& row : detail::near_rows(work, unit, velocity, bias, loop, by)) {
      std::map<int, T> columns;
      detail::add_columns(work, unit, loop, loop.body_from, row.force, row.moment_from, 1.0, by, columns);
      detail::add_columns(work, unit, loop, loop.body_to, row.force, row.moment_to, -1.0, by, columns);
      if (loop.length >= 0)
        columns[static_cast<int>(unit.column(loop.length))] =
            by == Columns::rates ? T(-1.0) : -detail::length_of(work.system, loop);
      SparseRow<T> entries;
      for (const auto& [column, value] : columns) entries.push_back(column, value);
      detail::detail_row(work.system, loop, column_names, number, entries, row.acceleration, row.residual,
                         is_quasi && loop.kind == ClosureKind::rod);
      detail::detail_wrench(work.system, loop, number++, row);
      result.jacobian.push_back(std::move(entries));
      result.acceleration.push_back(-row.acceleration);
      result.residual.push_back(row.residual);
    }
  }
  return result;
}

template <class T>
SparseClosure<T> quasi_closure(const RecursionWork<T>& work, const RecursionUnit& unit,
                               const PerBody<Spatial<T>>& velocity, const PerBody<BodyAcceleration<T>>& bias) {
  return near_closure(work, unit, velocity, bias, Columns::quasi);
}

}  // namespace mbgen
