#include "tests/system/oracle/reference_mechanism.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "compiler/model/moving.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }
Vector3d vector_of(const Vector3Quantity& q) { return {q[0].value, q[1].value, q[2].value}; }

Matrix3d axes_of(const Body& body) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.pose.rotation.data());
}

Vector3d place_of(const Body& body, const Vector3Quantity& point) {
  return vector_of(body.pose.origin) + axes_of(body) * vector_of(point);
}

Vector3d place_of(const Model& model, const Attachment& at) {
  return place_of(model.bodies[at.body], model.bodies[at.body].points[at.point].position);
}

RigidMass mass_of(const Body& body) {
  const auto j = [&](int k) { return body.inertia[k].value; };
  Matrix3d inertia;
  inertia << j(0), j(3), j(4), j(3), j(1), j(5), j(4), j(5), j(2);
  return {body.mass.value, place_of(body, body.com), axes_of(body) * inertia * axes_of(body).transpose()};
}

Matrix3d point_inertia(double mass, const Vector3d& arm) {
  return mass * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
}

/// Two rigid bodies as one.
RigidMass joined(const RigidMass& a, const RigidMass& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0) return {0, a.com, a.inertia + b.inertia};
  RigidMass sum{mass, (a.mass * a.com + b.mass * b.com) / mass, a.inertia + b.inertia};
  sum.inertia += point_inertia(a.mass, a.com - sum.com) + point_inertia(b.mass, b.com - sum.com);
  return sum;
}

FreedomKind kind_of(mbgen::FreedomKind kind) {
  return kind == mbgen::FreedomKind::revolute ? FreedomKind::revolute : FreedomKind::prismatic;
}

ClosureKind kind_of(mbgen::ClosureKind kind) {
  switch (kind) {
    case mbgen::ClosureKind::spherical:
      return ClosureKind::spherical;
    case mbgen::ClosureKind::revolute:
      return ClosureKind::revolute;
    case mbgen::ClosureKind::prismatic:
      return ClosureKind::prismatic;
    case mbgen::ClosureKind::universal:
      return ClosureKind::universal;
    case mbgen::ClosureKind::cylindrical:
      return ClosureKind::cylindrical;
    case mbgen::ClosureKind::planar:
      return ClosureKind::planar;
    case mbgen::ClosureKind::fixed:
      return ClosureKind::fixed;
    case mbgen::ClosureKind::coupling:
      return ClosureKind::coupling;
    case mbgen::ClosureKind::point_on_line:
      return ClosureKind::point_on_line;
    case mbgen::ClosureKind::point_on_plane:
      return ClosureKind::point_on_plane;
    case mbgen::ClosureKind::parallel_axes:
      return ClosureKind::parallel_axes;
    case mbgen::ClosureKind::orientation:
      return ClosureKind::orientation;
    case mbgen::ClosureKind::homokinetic:
      return ClosureKind::homokinetic;
    case mbgen::ClosureKind::rolling_disc:
      return ClosureKind::rolling_disc;
    case mbgen::ClosureKind::rolling_ball:
      return ClosureKind::rolling_ball;
    case mbgen::ClosureKind::knife_edge:
      return ClosureKind::knife_edge;
    case mbgen::ClosureKind::rod:
      break;
  }
  return ClosureKind::rod;
}

struct DefaultParameters {
  const Model& model;
  double parameter(int i) const { return model.parameters[i].value; }
};

/// Derivatives along one direction give those by two coordinates: 2 f_ij = f_(i+j)(i+j) - f_ii - f_jj.
ReferenceRelation relation_of(const Model& model, const Topology& topology, const Coupling& coupling) {
  ReferenceRelation relation;
  for (const CoordinateReference& c : coupling.coordinates)
    relation.coordinates.push_back(tree_coordinate(topology, c));
  relation.derivative = [&model, &coupling](const std::vector<double>& at, const std::vector<int>& by) {
    const auto along = [&](const std::vector<int>& moved) {
      std::vector<Jet<double>> positions(at.begin(), at.end());
      for (const int i : moved) positions[i].first = 1;
      return evaluate_relation(model, coupling, positions, DefaultParameters{model});
    };
    if (by.size() < 2) return by.empty() ? along({}).value : along(by).first;
    if (by[0] == by[1]) return along({by[0]}).second;
    return (along(by).second - along({by[0]}).second - along({by[1]}).second) / 2;
  };
  return relation;
}

ReferenceClosure closure_of(const Model& model, const Topology& topology, const Loop& loop) {
  ReferenceClosure closure;
  closure.name = loop.name;
  closure.kind = kind_of(loop.kind);
  closure.from = loop.body_from;
  closure.to = loop.body_to;
  closure.ancestor = loop.ancestor;
  if (loop.coupling >= 0) {
    closure.relation = relation_of(model, topology, model.couplings[loop.coupling]);
    return closure;
  }
  const bool is_rod = closure.kind == ClosureKind::rod;
  const Attachment& from = is_rod ? model.rods[loop.rod].from : model.joints[loop.joint].from;
  const Attachment& to = is_rod ? model.rods[loop.rod].to : model.joints[loop.joint].to;
  closure.at_from = place_of(model, from);
  closure.at_to = place_of(model, to);
  if (is_rod) {
    const Rod& rod = model.rods[loop.rod];
    closure.mass = rod.mass.value;
    closure.length = rod.length ? rod.length->value : (closure.at_to - closure.at_from).norm();
    return closure;
  }
  const Joint& joint = model.joints[loop.joint];
  closure.axis = vector_of(joint.axis);
  const bool has_second = joint.type == JointType::universal || holds_velocities(joint.type);
  closure.second_axis = vector_of(has_second ? joint.second_axis : joint.axis);
  if (joint.radius) closure.radius = joint.radius->value;
  if (joint.type == JointType::rolling_disc) closure.carriage = topology.bodies[loop.body_to].parent;
  if (joint.type == JointType::knife_edge) closure.carriage = loop.body_to;
  return closure;
}

}  // namespace

ReferenceMechanism reference_mechanism(const Model& model, const Topology& topology) {
  ReferenceMechanism mechanism;
  mechanism.name = model.name;
  mechanism.gravity = vector_of(model.gravity);
  for (const TreeBody& body : topology.bodies) {
    // A joint of the tree turns about the point of its `from` body.
    const Vector3d pin = place_of(model, model.joints[body.joint].from);
    const Vector3d at_to = place_of(model, model.joints[body.joint].to);
    mechanism.bodies.push_back({body.name, body.parent, body.joint, body.model_body, kind_of(body.kind),
                                vector_of(body.axis), pin, RigidMass{0, pin, Matrix3d::Zero()}, body.reversed, at_to});
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (topology.tree_body[b] == kGround) continue;
    RigidMass& mass = mechanism.bodies[topology.tree_body[b]].mass;
    mass = joined(mass, mass_of(model.bodies[b]));
  }
  for (const Loop& loop : topology.loops) mechanism.closures.push_back(closure_of(model, topology, loop));
  return mechanism;
}

ReferencePoint reference_point(const Model& model, const Topology& topology, int body, int point) {
  return {topology.tree_body[body], place_of(model, {body, point}), axes_of(model.bodies[body])};
}

Perpendiculars perpendiculars(const Vector3d& axis) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d first = axis.cross(Vector3d::Unit(least)).normalized();
  return {first, axis.cross(first)};
}

}  // namespace mbgen::foreign
