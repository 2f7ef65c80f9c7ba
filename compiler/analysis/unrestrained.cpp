#include "compiler/analysis/unrestrained.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/configuration.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kNoMotion = 1e-9;  // of a motion of 1: m or rad
constexpr double kUpright = 0.7;    // cosine: less than 45 degrees from the vertical

Vector3d vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }

/// Velocity of a body: of its point at the origin, and turning.
struct Twist {
  Vector3d origin = Vector3d::Zero(), turning = Vector3d::Zero();
  Vector3d at(const Vector3d& point) const { return origin + turning.cross(point); }
};

/// The mechanism at its reference.
struct Scene {
  const Model& model;
  const Topology& topology;
  std::map<std::pair<int, int>, int> coordinates;  ///< tree coordinate of each joint and component

  Scene(const Model& m, const Topology& t) : model(m), topology(t) {
    for (int i = 0; i < t.size(); ++i) coordinates[{t.bodies[i].joint, t.bodies[i].component}] = i;
  }

  Vector3d at(const Attachment& end) const { return vector_of(reference_position(model, end)); }
  int carrier(int body) const { return topology.tree_body[body]; }

  /// Velocities of all tree bodies for velocities of a group's joints.
  std::vector<Twist> twists(const JointGroup& group, const VectorXd& speeds) const {
    std::vector<Twist> list(topology.bodies.size());
    std::size_t next = 0;
    for (int i = 0; i < topology.size(); ++i) {
      const TreeBody& body = topology.bodies[i];
      if (body.parent >= 0) list[i] = list[body.parent];
      if (next >= group.joints.size() || group.joints[next] != i) continue;
      const Vector3d axis = speeds[static_cast<Eigen::Index>(next++)] * vector_of(body.axis);
      if (body.kind == FreedomKind::prismatic) {
        list[i].origin += axis;
      } else {
        list[i].turning += axis;
        list[i].origin -= axis.cross(at(model.joints[body.joint].to));
      }
    }
    return list;
  }

  Vector3d velocity(const std::vector<Twist>& twists, const Attachment& end) const {
    const int body = carrier(end.body);
    return body < 0 ? Vector3d::Zero() : twists[body].at(at(end));
  }

  Vector3d turning(const std::vector<Twist>& twists, const Attachment& end) const {
    const int body = carrier(end.body);
    return body < 0 ? Vector3d::Zero() : twists[body].turning;
  }

  double stretch(const std::vector<Twist>& twists, const Attachment& from, const Attachment& to) const {
    const Vector3d line = at(to) - at(from), speed = velocity(twists, to) - velocity(twists, from);
    return line.norm() > 0 ? line.normalized().dot(speed) : speed.norm();
  }

  /// How far every element that could hold a motion takes part in it.
  std::vector<double> holds(const JointGroup& group, const VectorXd& speeds) const {
    const std::vector<Twist> moved = twists(group, speeds);
    const auto speed = [&](const CoordinateReference& coordinate) {
      const auto known = coordinates.find({coordinate.joint, coordinate.component});
      if (known == coordinates.end()) return 0.0;
      const auto found = std::find(group.joints.begin(), group.joints.end(), known->second);
      return found == group.joints.end() ? 0.0 : speeds[found - group.joints.begin()];
    };
    std::vector<double> list;
    for (const PointSpring& spring : model.springs) list.push_back(stretch(moved, spring.from, spring.to));
    for (const AirSpring& spring : model.air_springs) list.push_back(stretch(moved, spring.from, spring.to));
    for (const Bushing& bushing : model.bushings) {
      const Vector3d shift = velocity(moved, bushing.to) - velocity(moved, bushing.from);
      const Vector3d turn = turning(moved, bushing.to) - turning(moved, bushing.from);
      for (int i = 0; i < kBushingFreedoms; ++i) {
        const Vector3d axis(bushing.axes[i % 3], bushing.axes[3 + i % 3], bushing.axes[6 + i % 3]);
        list.push_back(bushing_acts(bushing, i) ? axis.dot(i < 3 ? shift : turn) : 0);
      }
    }
    for (const JointSpring& spring : model.joint_springs)
      list.push_back(speed(spring.joint) - (spring.relative_to ? speed(*spring.relative_to) : 0));
    for (const JointFriction& friction : model.frictions) list.push_back(speed(friction.joint));
    for (const JointForce& force : model.joint_forces) list.push_back(speed(force.joint));
    for (const AppliedForce& force : model.forces) {
      const bool turns = std::any_of(force.torque.begin(), force.torque.end(),
                                     [](const Quantity& q) { return q.expression >= 0 || q.value != 0; });
      const int body = carrier(force.at.body);
      for (int i = 0; i < 3; ++i) list.push_back(turns && body >= 0 ? moved[body].turning[i] : 0);
    }
    return list;
  }

  /// Whether both ends of a spring are on bodies that move.
  bool carries_springs(const std::vector<Twist>& moved) const {
    const auto moves = [&](const Attachment& end) {
      const int body = carrier(end.body);
      return body >= 0 && moved[body].turning.norm() > kNoMotion;
    };
    const auto both = [&](const auto& spring) { return moves(spring.from) && moves(spring.to); };
    return std::any_of(model.springs.begin(), model.springs.end(), both) ||
           std::any_of(model.air_springs.begin(), model.air_springs.end(), both) ||
           std::any_of(model.bushings.begin(), model.bushings.end(), both) ||
           std::any_of(model.joint_springs.begin(), model.joint_springs.end(), [&](const JointSpring& spring) {
             const Joint& joint = model.joints[spring.joint.joint];
             return moves(joint.from) && moves(joint.to);
           });
  }

  /// Whether all that turns lies with its centre of mass on the axis: a wheel, a rotor.
  bool is_rotor(const std::vector<Twist>& moved) const {
    for (const Body& body : model.bodies) {
      const int i = carrier(static_cast<int>(&body - model.bodies.data()));
      if (i < 0 || !(body.mass.value > 0) || moved[i].turning.norm() <= kNoMotion) continue;
      Vector3d centre = vector_of(body.pose.origin);
      for (int k = 0; k < 9; ++k) centre[k / 3] += body.pose.rotation[k] * body.com[k % 3].value;
      if (moved[i].at(centre).norm() > 1e-6 * moved[i].turning.norm()) return false;
    }
    return true;
  }
};

/// The body that a motion turns most, -1 where none turns.
int most_turned(const Scene& scene, const std::vector<Twist>& moved) {
  int most = -1;
  double largest = kNoMotion;
  for (std::size_t b = 0; b < scene.model.bodies.size(); ++b) {
    const int body = scene.carrier(static_cast<int>(b));
    if (body < 0 || moved[body].turning.norm() <= largest * (1 + kNoMotion)) continue;
    most = static_cast<int>(b);
    largest = moved[body].turning.norm();
  }
  return most;
}

/// A note where nothing holds this motion of a group.
void note_motion(const Scene& scene, const JointGroup& group, const VectorXd& speeds, Diagnostics& notes) {
  const std::vector<Twist> moved = scene.twists(group, speeds);
  const int body = most_turned(scene, moved);
  if (body < 0) return;
  const Vector3d turning = moved[scene.carrier(body)].turning.normalized();
  if (std::abs(turning.z()) < kUpright || scene.carries_springs(moved) || scene.is_rotor(moved)) return;
  Eigen::Index largest = 0;
  speeds.cwiseAbs().maxCoeff(&largest);
  const TreeBody& coordinate = scene.topology.bodies[group.joints[static_cast<std::size_t>(largest)]];
  notes.push_back(
      {scene.model.joints[coordinate.joint].where,
       fmt::format("nothing holds or drives body \"{}\" as it turns about a line near the vertical, coordinate "
                   "\"{}\"",
                   scene.model.bodies[body].name, coordinate.coordinate),
       "is a tie rod, a spring, a friction or a motion missing?",
       {}});
}

/// Velocities of a group's joints (rows) in its free directions (columns).
MatrixXd speeds_of(const std::vector<std::vector<double>>& rz) {
  MatrixXd speeds(static_cast<Eigen::Index>(rz.size()), static_cast<Eigen::Index>(rz.front().size()));
  for (Eigen::Index c = 0; c < speeds.rows(); ++c)
    for (Eigen::Index q = 0; q < speeds.cols(); ++q)
      speeds(c, q) = rz[static_cast<std::size_t>(c)][static_cast<std::size_t>(q)];
  return speeds;
}

/// Mixtures (columns) of a group's free directions in which no element takes part.
MatrixXd unrestrained_directions(const Scene& scene, const JointGroup& group, const MatrixXd& speeds) {
  MatrixXd holds;
  for (Eigen::Index q = 0; q < speeds.cols(); ++q) {
    const std::vector<double> column = scene.holds(group, speeds.col(q));
    holds.conservativeResize(static_cast<Eigen::Index>(column.size()), speeds.cols());
    for (std::size_t i = 0; i < column.size(); ++i) holds(static_cast<Eigen::Index>(i), q) = column[i];
  }
  if (holds.rows() == 0 || !(holds.cwiseAbs().maxCoeff() > kNoMotion))
    return MatrixXd::Identity(speeds.cols(), speeds.cols());
  return kernel(holds, kNoMotion);
}

}  // namespace

Diagnostics unrestrained_motions(const Model& model, const Topology& topology, const Analysis& analysis) {
  Diagnostics notes;
  const bool has_springs =
      !model.springs.empty() || !model.air_springs.empty() || !model.joint_springs.empty() || !model.bushings.empty();
  if (!has_springs && model.tyres.empty()) return notes;
  NumericSystem numbers(model, topology);
  System<double>& system = numbers.at(std::vector<double>(topology.bodies.size(), 0.0));
  const auto projections = frozen_directions(system, kinematics(system), analysis.blocks, analysis.driven);
  const Scene scene(model, topology);
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const JointGroup& group = topology.groups[g];
    const bool is_free = model.joints[topology.bodies[group.joints[0]].joint].type == JointType::free;
    if (projections[g].rz.front().empty() || (group.block < 0 && is_free)) continue;
    const MatrixXd speeds = speeds_of(projections[g].rz);
    if (!speeds.allFinite()) continue;
    const MatrixXd unrestrained = unrestrained_directions(scene, group, speeds);
    for (Eigen::Index q = 0; q < unrestrained.cols(); ++q)
      note_motion(scene, group, speeds * unrestrained.col(q).normalized(), notes);
  }
  return notes;
}

}  // namespace mbgen
