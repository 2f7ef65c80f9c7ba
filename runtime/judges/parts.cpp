#include "runtime/judges/parts.hpp"

#include <cmath>

#include "compiler/algebra/turns.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }
Vector3d vector_of(const Vector3Quantity& q, const Values& value) { return {value(q[0]), value(q[1]), value(q[2])}; }

Matrix3d axes_of(const Body& body) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.pose.rotation.data());
}

/// Global position at the reference configuration of a point in a body's frame.
Vector3d reference_of(const Body& body, const Vector3Quantity& point, const Values& value) {
  return vector_of(body.pose.origin) + axes_of(body) * vector_of(point, value);
}

Vector3d reference_of(const Attachment& at, const Values& value) {
  const Body& body = value.model.bodies[at.body];
  return reference_of(body, body.points[at.point].position, value);
}

/// The same at the parameters of the model, and what others have moved it by.
Vector3d written(const Attachment& at, const Values& value) {
  const Body& body = value.model.bodies[at.body];
  const Vector3Quantity& point = body.points[at.point].position;
  return vector_of(body.pose.origin) + axes_of(body) * Vector3d(point[0].value, point[1].value, point[2].value);
}
Vector3d tuned(const Attachment& at, const Values& value) { return reference_of(at, value) - written(at, value); }

Part part_of(const Body& body, const Values& value) {
  Part part;
  part.mass = value(body.mass);
  const auto j = [&](int k) { return value(body.inertia[k]); };
  part.inertia << j(0), j(3), j(4), j(3), j(1), j(5), j(4), j(5), j(2);
  part.axes = axes_of(body);
  part.centre = reference_of(body, body.com, value);
  return part;
}

Part rod_part(double mass, double length) {
  Part part;
  part.mass = mass;
  part.inertia.diagonal() << 0, mass * length * length / 12, mass * length * length / 12;
  part.is_rod = true;
  return part;
}

Place place_at(const Parts& parts, int model_body, const Vector3d& reference) {
  const Part& part = parts.bodies[parts.index_of[model_body]];
  return {parts.index_of[model_body], part.axes.transpose() * (reference - part.centre)};
}

}  // namespace

Place place_of(const Parts& parts, const Attachment& at, const Values& value) {
  return place_at(parts, at.body, reference_of(at, value));
}

namespace {

Vector3d in_body(const Parts& parts, const Place& place, const Vector3& direction) {
  return parts.bodies[place.body].axes.transpose() * vector_of(direction);
}

Matrix3d triad_on(const Parts& parts, const Place& place, const Vector3& axis) {
  return parts.bodies[place.body].axes.transpose() * triad(vector_of(axis));
}

PartJoint joint_of(const Parts& parts, const Joint& joint, bool cut, const std::vector<int>& coordinates,
                   const Values& value) {
  PartJoint part;
  part.type = joint.type;
  part.from = place_of(parts, joint.from, value);
  // The tree turns about the point of `from`; only a closure can see that the point of `to` is not quite there. Both go
  // where parameters take them.
  part.to = cut ? place_of(parts, joint.to, value)
                : place_at(parts, joint.to.body, written(joint.from, value) + tuned(joint.to, value));
  part.triad_from = triad_on(parts, part.from, joint.axis);
  const bool has_second = joint.type == JointType::universal || joint.type == JointType::rolling_disc ||
                          joint.type == JointType::knife_edge;
  part.triad_to = triad_on(parts, part.to, has_second ? joint.second_axis : joint.axis);
  if (joint.radius) part.radius = value(*joint.radius);
  if (joint.type == JointType::homokinetic) {
    const Eigen::Quaterniond bend = shortest_turn(vector_of(joint.axis), vector_of(joint.second_axis));
    part.triad_to = parts.bodies[part.to.body].axes.transpose() * bend * triad(vector_of(joint.axis));
  }
  if (cut) return part;
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k)
    part.freedoms.push_back({joint.freedoms[k].kind, vector_of(joint.freedoms[k].axis), coordinates[k]});
  return part;
}

/// Distance of two points at the reference, m.
double reference_distance(const Attachment& from, const Attachment& to, const Values& value) {
  return (reference_of(from, value) - reference_of(to, value)).norm();
}

ElementPart part_of(const Parts& parts, const Connection& connection, const Values& value) {
  ElementPart part;
  each_attachment(connection, [&](const Attachment& at) { part.from = place_of(parts, at, value); });
  with_ends(connection, [&](const Attachment& from, const Attachment& to) {
    part.from = place_of(parts, from, value);
    part.to = place_of(parts, to, value);
    part.reference = reference_distance(from, to, value);
  });
  if (const BetweenFrames* frames = std::get_if<BetweenFrames>(&connection)) {
    const Matrix3d axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frames->axes.data());
    part.axes_from = parts.bodies[part.from.body].axes.transpose() * axes;
    part.axes_to = parts.bodies[part.to.body].axes.transpose() * axes;
  }
  if (const AlongDirection* along = std::get_if<AlongDirection>(&connection)) {
    const Matrix3d axes = parts.bodies[part.from.body].axes;
    part.axis = axes.transpose() * vector_of(along->axis);
    part.gap = axes.transpose() * (reference_of(along->to, value) - reference_of(along->from, value));
  }
  return part;
}

PartRod rod_of(const Parts& parts, const Rod& rod, const Values& value) {
  PartRod part{place_of(parts, rod.from, value),
               place_of(parts, rod.to, value),
               rod.length ? value(*rod.length) : reference_distance(rod.from, rod.to, value),
               value(rod.mass),
               -1,
               -1};
  const std::vector<Motion>& motions = value.model.motions;
  for (std::size_t k = 0; k < motions.size(); ++k)
    if (rod.drive >= 0 && motions[k].joint.joint == rod.drive) part.motion = static_cast<int>(k);
  return part;
}

bool is_zero(const Quantity& quantity) { return quantity.expression < 0 && quantity.value == 0; }

/// Moving bodies, then the massive rods, then ground.
void add_bodies(Parts& parts, const Values& value) {
  const Model& model = value.model;
  parts.index_of.resize(model.bodies.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (static_cast<int>(b) == model.ground) continue;
    parts.index_of[b] = static_cast<int>(parts.bodies.size());
    parts.bodies.push_back(part_of(model.bodies[b], value));
  }
  const std::size_t first_rod = parts.bodies.size();
  std::size_t massive = 0;
  for (const Rod& rod : model.rods) massive += is_zero(rod.mass) ? 0 : 1;
  parts.bodies.resize(first_rod + massive + 1);
  parts.index_of[model.ground] = parts.ground();
  std::size_t next = first_rod;
  for (const Rod& rod : model.rods) {
    parts.rods.push_back(rod_of(parts, rod, value));
    if (is_zero(rod.mass)) continue;
    parts.rods.back().body = static_cast<int>(next);
    parts.bodies[next++] = rod_part(parts.rods.back().mass, parts.rods.back().length);
  }
}

}  // namespace

Matrix3d triad(const Vector3d& axis) {
  Matrix3d result;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axis[k]) != 1.0) continue;
    result << Vector3d::Unit((k + 1) % 3), axis[k] * Vector3d::Unit((k + 2) % 3), axis;
    return result;
  }
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d first = axis.cross(Vector3d::Unit(least)).normalized();
  result << first, axis.cross(first), axis;
  return result;
}

Parts make_parts(const Model& model, const Topology& topology, const Values& values) {
  Parts parts;
  parts.gravity = vector_of(model.gravity, values);
  add_bodies(parts, values);
  std::vector<bool> cut(model.joints.size());
  for (const Loop& loop : topology.loops)
    if (loop.joint >= 0) cut[loop.joint] = true;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const std::vector<int>& coordinates = values.table[j];
    const bool closes = cut[j] || (!coordinates.empty() && coordinates[0] < 0);  // a cut free joint is no closure
    parts.joints.push_back(joint_of(parts, model.joints[j], closes, coordinates, values));
  }
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    for (const Kind& element : kind.list(model))
      parts.elements[kKindIndex<Kind>].push_back(part_of(parts, connection_of(element), values));
  });
  for (const Tyre& tyre : model.tyres) {
    const Place centre = place_of(parts, tyre.centre, values);
    parts.tyres.push_back({centre, in_body(parts, centre, tyre.axis)});
  }
  return parts;
}

}  // namespace mbgen::cartesian
