// Conversion between tree coordinates and bodies: placement along the tree, coordinates from poses.

#include <Eigen/Geometry>

#include "compiler/algebra/turns.hpp"
#include "runtime/judges/mechanism.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {
namespace {

using namespace cartesian;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Displacement of a body from the reference configuration: the point at r moves to turn * r + shift.
struct Displaced {
  Matrix3d turn = Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();
  Vector3d spin = Vector3d::Zero();
  Vector3d point = Vector3d::Zero(),
           velocity = Vector3d::Zero();  ///< present position of a point of the body, and its velocity

  Vector3d place(const Vector3d& reference) const { return turn * reference + shift; }
  Vector3d velocity_at(const Vector3d& place) const { return velocity + spin.cross(place - point); }
};

/// The displacement of a joint's child: first by the joint, at the reference, then with the parent.
Displaced beyond(const Displaced& parent, const TreeBody& body, const Vector3d& pin, double z, double zd) {
  const Vector3d axis(body.axis[0], body.axis[1], body.axis[2]);
  const Vector3d now = parent.turn * axis;
  Displaced child = parent;
  if (body.kind == FreedomKind::revolute) {
    const Matrix3d turn(Eigen::AngleAxisd(z, axis));
    child.turn = parent.turn * turn;
    child.point = parent.place(pin);
    child.shift = child.point - child.turn * pin;
    child.velocity = parent.velocity_at(child.point);
    child.spin = parent.spin + zd * now;
  } else {
    child.shift = parent.shift + z * now;
    child.point = child.place(pin);
    child.velocity = parent.velocity_at(child.point) + zd * now;
  }
  return child;
}

CartesianBody placed(const Part& part, const Displaced& displaced) {
  const Vector3d position = displaced.place(part.centre);
  return {position, Quaterniond(Matrix3d(displaced.turn * part.axes)).normalized(), displaced.velocity_at(position),
          displaced.spin};
}

/// A rod between its end points, without spin.
CartesianBody placed_rod(const End& from, const End& to) {
  const Vector3d gap = to.position - from.position, rate = to.velocity - from.velocity;
  const double square = gap.squaredNorm();
  CartesianBody rod{(from.position + to.position) / 2, shortest_turn(Vector3d::UnitX(), gap),
                    (from.velocity + to.velocity) / 2, Vector3d::Zero()};
  if (square > 0) rod.spin = gap.cross(rate) / square;
  return rod;
}

}  // namespace

std::vector<Moving> CartesianMechanism::bodies(const CartesianState& state) const {
  std::vector<Moving> result;
  for (const CartesianBody& body : state.bodies)
    result.push_back({body.attitude.toRotationMatrix(), body.position, body.velocity, body.spin});
  Moving ground;
  ground.axes = parts.bodies.back().axes;
  result.push_back(ground);
  return result;
}

CartesianState CartesianSystem::place(const GenericState& state) const {
  const CartesianMechanism& c = *mechanism_;
  const auto pin_of = [&](const Place& at) -> Vector3d {
    return c.parts.bodies[at.body].centre + c.parts.bodies[at.body].axes * at.arm;
  };
  std::vector<std::vector<int>> coordinates(c.model.joints.size());
  for (int i = 0; i < c.topology.size(); ++i) coordinates[c.topology.bodies[i].joint].push_back(i);
  std::vector<Displaced> tree(c.model.bodies.size());
  for (const TreeJoint& tree_joint : c.topology.tree_joints) {
    const PartJoint& joint = c.parts.joints[tree_joint.joint];
    const Vector3d on_parent = pin_of(tree_joint.reversed ? joint.to : joint.from);
    const Vector3d on_child = pin_of(tree_joint.reversed ? joint.from : joint.to);
    Displaced displaced = tree[tree_joint.parent];
    displaced.shift += displaced.turn * (on_parent - on_child);  // the two points meet
    for (const int i : coordinates[tree_joint.joint])
      displaced = beyond(displaced, c.topology.bodies[i], on_child, state.z[i], state.zd[i]);
    tree[tree_joint.child] = displaced;
  }
  CartesianState result;
  result.x = state.x;
  result.t = state.t;
  for (std::size_t b = 0; b < c.model.bodies.size(); ++b) {
    if (static_cast<int>(b) == c.model.ground) continue;
    result.bodies.push_back(placed(c.parts.bodies[c.parts.index_of[b]], tree[b]));
  }
  result.bodies.resize(c.moving());
  const std::vector<Moving> bodies = c.bodies(result);
  for (const PartRod& rod : c.parts.rods)
    if (rod.body >= 0) result.bodies[rod.body] = placed_rod(end_of(bodies, rod.from), end_of(bodies, rod.to));
  return result;
}

GenericState CartesianSystem::joint_state(const CartesianState& state, const GenericState& guess) const {
  GenericState result = guess;
  result.x = state.x;
  result.t = state.t;
  const std::vector<Moving> bodies = mechanism_->bodies(state);
  for (std::size_t j = 0; j < mechanism_->parts.joints.size(); ++j)
    for (const JointCoordinate& coordinate : mechanism_->coordinates_of(static_cast<int>(j), bodies, guess.z)) {
      result.z[coordinate.index] = coordinate.row.residual;
      result.zd[coordinate.index] = coordinate.zd;
    }
  return result;
}

std::vector<double> CartesianSystem::joint_accelerations(const CartesianState& state, const GenericState& z,
                                                         const Eigen::VectorXd& qdd) const {
  std::vector<double> zdd(mechanism_->topology.bodies.size());
  const std::vector<Moving> bodies = mechanism_->bodies(state);
  const auto part = [&](int body, const Vector6d& columns) {
    return body == mechanism_->moving() ? 0.0 : columns.dot(qdd.segment<6>(6 * body));
  };
  for (std::size_t j = 0; j < mechanism_->parts.joints.size(); ++j)
    for (const JointCoordinate& c : mechanism_->coordinates_of(static_cast<int>(j), bodies, z.z))
      zdd[c.index] = part(c.row.from, c.row.on_from) + part(c.row.to, c.row.on_to) - c.row.bias;
  return zdd;
}

void CartesianSystem::displace(CartesianState& state, const Eigen::VectorXd& dq) const {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Vector3d turn = dq.segment<3>(6 * b + 3);
    const double angle = turn.norm();
    state.bodies[b].position += dq.segment<3>(6 * b);
    if (angle == 0) continue;
    const Quaterniond rotation(Eigen::AngleAxisd(angle, turn / angle));
    state.bodies[b].attitude = (rotation * state.bodies[b].attitude).normalized();
  }
}

Eigen::VectorXd CartesianSystem::velocities(const CartesianState& state) const {
  Eigen::VectorXd qd(6 * state.bodies.size());
  for (std::size_t b = 0; b < state.bodies.size(); ++b)
    qd.segment<6>(6 * b) << state.bodies[b].velocity, state.bodies[b].spin;
  return qd;
}

void CartesianSystem::set_velocities(CartesianState& state, const Eigen::VectorXd& qd) const {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    state.bodies[b].velocity = qd.segment<3>(6 * b);
    state.bodies[b].spin = qd.segment<3>(6 * b + 3);
  }
}

}  // namespace mbgen
