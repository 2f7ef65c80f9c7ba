// The equations of all joints, rods and motions.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/model/moving.hpp"
#include "runtime/judges/mechanism.hpp"

namespace mbgen {
namespace cartesian {
namespace {

using Eigen::Vector3d;

void add_point(const End& from, const End& to, std::vector<Row>& rows) {
  for (int k = 0; k < 3; ++k) rows.push_back(coincidence(from, to, Vector3d::Unit(k)));
}

/// Equations of directions of a joint: its axis on both bodies, and the rotation about it.
void add_directions(JointType type, const End& from, const End& to, const Eigen::Matrix3d& on_from,
                    const Eigen::Matrix3d& on_to, std::vector<Row>& rows) {
  if (type == JointType::universal) {
    rows.push_back(perpendicular(from, to, on_from.col(2), on_to.col(2)));
  } else if (type == JointType::homokinetic) {
    rows.push_back(equal_turns(from, to, on_from, on_to));
  } else if (type != JointType::spherical && type != JointType::point_on_line && type != JointType::point_on_plane) {
    rows.push_back(perpendicular(from, to, on_from.col(0), on_to.col(2)));
    rows.push_back(perpendicular(from, to, on_from.col(1), on_to.col(2)));
  }
  if (type == JointType::prismatic || type == JointType::fixed || type == JointType::orientation)
    rows.push_back(perpendicular(from, to, on_from.col(0), on_to.col(1)));
}

/// Equations of a joint, in the order of the recursive formulation's closures.
void add_joint(const PartJoint& joint, const std::vector<Moving>& bodies, std::vector<Row>& rows) {
  if (joint.type == JointType::free) return;
  const End from = end_of(bodies, joint.from), to = end_of(bodies, joint.to);
  const Eigen::Matrix3d on_from = bodies[from.body].axes * joint.triad_from;
  const Eigen::Matrix3d on_to = bodies[to.body].axes * joint.triad_to;
  if (holds_velocities(joint.type)) {
    for (Row& row : rolling(joint.type, from, to, on_from, on_to, joint.radius)) rows.push_back(std::move(row));
    return;
  }
  switch (joint.type) {
    case JointType::prismatic:
    case JointType::cylindrical:
    case JointType::point_on_line:
      rows.push_back(in_plane(from, to, on_from.col(0)));
      rows.push_back(in_plane(from, to, on_from.col(1)));
      break;
    case JointType::planar:
    case JointType::point_on_plane:
      rows.push_back(in_plane(from, to, on_from.col(2)));
      break;
    case JointType::parallel_axes:
    case JointType::orientation:
      break;
    default:
      add_point(from, to, rows);
  }
  add_directions(joint.type, from, to, on_from, on_to, rows);
}

/// A rod with a prescribed length and its rates.
Row driven_distance(const End& from, const End& to, const Jet<double>& length) {
  Row row = distance(from, to, length.value);
  row.rate = length.first;
  row.bias += length.first * length.first / length.value + length.second;
  return row;
}

/// A rod that an actuator moves: its length is that at the reference and the coordinate of its slide.
Row sliding_distance(const End& from, const End& to, double length, const JointCoordinate& slide) {
  const double now = length + slide.row.residual;
  Row row = distance(from, to, now);
  row.further.emplace_back(slide.row.from, -slide.row.on_from);
  row.further.emplace_back(slide.row.to, -slide.row.on_to);
  row.bias += slide.zd * slide.zd / now - slide.row.bias;
  return row;
}

/// A massless rod has constant length; a massive one is a body with a spherical joint at each end, without spin.
void add_rod(const PartRod& rod, int ground, const std::vector<Moving>& bodies, std::vector<Row>& rows) {
  const End from = end_of(bodies, rod.from), to = end_of(bodies, rod.to);
  if (rod.body < 0) {
    rows.push_back(distance(from, to, rod.length));
    return;
  }
  add_point(from, end_of(bodies, {rod.body, Vector3d(-rod.length / 2, 0, 0)}), rows);
  add_point(to, end_of(bodies, {rod.body, Vector3d(rod.length / 2, 0, 0)}), rows);
  rows.push_back(no_spin(rod.body, ground, bodies[rod.body]));
}

int row_count(JointType type) {
  switch (type) {
    case JointType::fixed:
      return 6;
    case JointType::revolute:
    case JointType::prismatic:
      return 5;
    case JointType::cylindrical:
    case JointType::universal:
    case JointType::homokinetic:
      return 4;
    case JointType::spherical:
    case JointType::planar:
    case JointType::orientation:
    case JointType::rolling_disc:
    case JointType::rolling_ball:
      return 3;
    case JointType::point_on_line:
    case JointType::parallel_axes:
      return 2;
    case JointType::point_on_plane:
    case JointType::knife_edge:
      return 1;
    case JointType::free:
      break;
  }
  return 0;
}

/// Sum of the coordinates' rows by the slopes of the relation; the first one's bodies are its ends.
Row coupling_row(const std::vector<CoupledCoordinate>& coupled, const Jet<double>& relation) {
  Row row{coupled[0].coordinate.row.from,
          coupled[0].coordinate.row.to,
          Vector6d::Zero(),
          Vector6d::Zero(),
          relation.value,
          0,
          -relation.second};
  for (const auto& [coordinate, slope] : coupled) {
    row.further.emplace_back(coordinate.row.from, slope * coordinate.row.on_from);
    row.further.emplace_back(coordinate.row.to, slope * coordinate.row.on_to);
    row.bias += slope * coordinate.row.bias;
  }
  return row;
}

}  // namespace

FirstRows first_rows(const Parts& parts, const Model& model, const Topology& topology) {
  constexpr int kMassiveRod = 7;
  FirstRows first;
  int next = 0;
  const auto add = [&](std::vector<int>& rows, int count) {
    rows.push_back(next);
    next += count;
  };
  for (const PartJoint& joint : parts.joints) add(first.joints, row_count(joint.type));
  add(first.joints, 0);
  for (const PartRod& rod : parts.rods) add(first.rods, rod.body < 0 ? 1 : kMassiveRod);
  add(first.rods, 0);
  first.motions = next;
  first.couplings = first.motions + static_cast<int>(model.motions.size());
  first.end = first.couplings + static_cast<int>(model.couplings.size());
  first.loop_of.assign(first.end, -1);
  for (std::size_t l = 0; l < topology.loops.size(); ++l) {
    const Loop& loop = topology.loops[l];
    if (loop.coupling >= 0) {
      first.loop_of[first.couplings + loop.coupling] = static_cast<int>(l);
      continue;
    }
    const std::vector<int>& rows = loop.rod >= 0 ? first.rods : first.joints;
    const int index = loop.rod >= 0 ? loop.rod : loop.joint;
    std::fill(first.loop_of.begin() + rows[index], first.loop_of.begin() + rows[index + 1], static_cast<int>(l));
  }
  return first;
}

}  // namespace cartesian

using namespace cartesian;

std::vector<Row> CartesianMechanism::equations_at(const std::vector<Moving>& bodies, const Values& values) const {
  std::vector<Row> rows;
  for (const PartJoint& joint : parts.joints) add_joint(joint, bodies, rows);
  for (std::size_t r = 0; r < parts.rods.size(); ++r) {
    const PartRod& rod = parts.rods[r];
    if (const int slide = model.rods[r].drive; rod.motion < 0 && slide >= 0) {
      rows.push_back(sliding_distance(end_of(bodies, rod.from), end_of(bodies, rod.to), rod.length,
                                      coordinates_of(slide, bodies, *values.z)[0]));
      continue;
    }
    if (rod.motion < 0) {
      add_rod(rod, parts.ground(), bodies, rows);
      continue;
    }
    const Jet<double> more = evaluate_motion<double>(model, model.motions[rod.motion], values);
    rows.push_back(driven_distance(end_of(bodies, rod.from), end_of(bodies, rod.to),
                                   {rod.length + more.value, more.first, more.second}));
  }
  for (const Motion& motion : model.motions) {
    const Jet<double> wanted = evaluate_motion<double>(model, motion, values);
    Row row = coordinates_of(motion.joint.joint, bodies, *values.z)[motion.joint.component].row;
    const bool turns = parts.joints[motion.joint.joint].freedoms[motion.joint.component].kind == FreedomKind::revolute;
    row.residual -= wanted.value;
    if (turns) row.residual = std::remainder(row.residual, 2 * std::numbers::pi);
    row.rate = wanted.first;
    row.bias += wanted.second;
    rows.push_back(row);
  }
  for (const Coupling& coupling : model.couplings) {
    const std::vector<CoupledCoordinate> coupled = coupled_coordinates(coupling, bodies, values);
    std::vector<Jet<double>> moving;
    for (const auto& [coordinate, slope] : coupled) moving.emplace_back(coordinate.row.residual, coordinate.zd, 0.0);
    rows.push_back(coupling_row(coupled, evaluate_relation(model, coupling, moving, values)));
  }
  return rows;
}

std::vector<CoupledCoordinate> CartesianMechanism::coupled_coordinates(const Coupling& coupling,
                                                                       const std::vector<Moving>& bodies,
                                                                       const Values& values) const {
  std::vector<CoupledCoordinate> coupled;
  for (const CoordinateReference& c : coupling.coordinates) {
    const int index = table[c.joint][c.component];
    for (JointCoordinate& coordinate : coordinates_of(c.joint, bodies, *values.z))
      if (coordinate.index == index) coupled.push_back({std::move(coordinate), 0});
  }
  std::vector<double> positions;
  for (const CoupledCoordinate& one : coupled) positions.push_back(one.coordinate.row.residual);
  const std::vector<double> slopes = relation_slopes(model, coupling, positions, values);
  for (std::size_t i = 0; i < coupled.size(); ++i) coupled[i].slope = slopes[i];
  return coupled;
}

}  // namespace mbgen
