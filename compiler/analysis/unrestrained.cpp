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

  /// Whether both ends of a spring are on bodies that move.
  bool carries_springs(const std::vector<Twist>& moved) const {
    const auto moves = [&](const Attachment& end) {
      const int body = carrier(end.body);
      return body >= 0 && moved[body].turning.norm() > kNoMotion;
    };
    bool carries = false;
    each_elastic([&](const auto& element) {
      const Connection connection = connection_of(element);
      const auto both = [&](const Attachment& from, const Attachment& to) {
        carries = carries || (moves(from) && moves(to));
      };
      with_ends(connection, both);
      if (const OnCoordinate* on = std::get_if<OnCoordinate>(&connection))
        both(model.joints[on->joint.joint].from, model.joints[on->joint.joint].to);
    });
    return carries;
  }

  /// Calls use(element) for every element that holds its bodies and stores energy.
  template <class Use>
  void each_elastic(const Use& use) const {
    each_element(model, [&](const auto& element) {
      if constexpr (KindOf<std::decay_t<decltype(element)>>::is_elastic) use(element);
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

/// How far an element takes part in a motion of a group, by where it acts.
struct Participation {
  const Scene& scene;
  const JointGroup& group;
  const VectorXd& speeds;
  std::vector<Twist> moved;

  void add(const BetweenPoints& at, std::vector<double>& list) const {
    const Vector3d line = scene.at(at.to) - scene.at(at.from), speed = drift(at);
    list.push_back(line.norm() > 0 ? line.normalized().dot(speed) : speed.norm());
  }
  void add(const AlongDirection& at, std::vector<double>& list) const {
    const Vector3d line = scene.at(at.to) - scene.at(at.from);
    list.push_back(vector_of(at.axis).dot(drift(at) - scene.turning(moved, at.from).cross(line)));
  }
  void add(const BetweenFrames& at, std::vector<double>& list) const {
    const Vector3d turn = scene.turning(moved, at.to) - scene.turning(moved, at.from);
    for (int i = 0; i < 6; ++i) {
      const Vector3d axis(at.axes[i % 3], at.axes[3 + i % 3], at.axes[6 + i % 3]);
      list.push_back(at.acts[i] ? axis.dot(i < 3 ? drift(at) : turn) : 0);
    }
  }
  void add(const OnCoordinate& at, std::vector<double>& list) const {
    list.push_back(speed(at.joint) - (at.relative_to ? speed(*at.relative_to) : 0));
  }
  /// A torque holds, a force moves.
  void add(const OnBody& at, std::vector<double>& list) const {
    const Vector3d turn = scene.turning(moved, at.at);
    for (int i = 0; i < 3; ++i) list.push_back(at.turns ? turn[i] : 0);
  }
  /// Lines between neighbours, and the turns of wheels that it takes along.
  void add(const ThroughPoints& at, std::vector<double>& list) const {
    for (std::size_t i = 0; i + 1 < at.points.size(); ++i) add(BetweenPoints{at.points[i], at.points[i + 1]}, list);
    for (std::size_t i = 0; i < at.points.size(); ++i)
      list.push_back(vector_of(at.turns[i]).dot(scene.turning(moved, at.points[i])));
  }
  void add(const AlongSpring& at, std::vector<double>& list) const {
    const PointSpring& spring = scene.model.springs[at.spring];
    add(BetweenPoints{spring.from, spring.to}, list);
  }
  /// The turn of the body at the end against the rod, across the rod's line.
  void add(const InRodEnd& at, std::vector<double>& list) const {
    const Rod& rod = scene.model.rods[at.rod];
    const Vector3d line = scene.at(rod.to) - scene.at(rod.from), along = line.normalized();
    const Vector3d turn = scene.turning(moved, at.at_from ? rod.from : rod.to);
    const Vector3d across = turn - along.dot(turn) * along - along.cross(drift(rod)) / line.norm();
    for (int i = 0; i < 3; ++i) list.push_back(across[i]);
  }

 private:
  template <class Ends>
  Vector3d drift(const Ends& at) const {
    return scene.velocity(moved, at.to) - scene.velocity(moved, at.from);
  }
  double speed(const CoordinateReference& coordinate) const {
    const auto known = scene.coordinates.find({coordinate.joint, coordinate.component});
    if (known == scene.coordinates.end()) return 0;
    const auto found = std::find(group.joints.begin(), group.joints.end(), known->second);
    return found == group.joints.end() ? 0 : speeds[found - group.joints.begin()];
  }
};

/// How far every element that could hold a motion takes part in it.
std::vector<double> participations(const Scene& scene, const JointGroup& group, const VectorXd& speeds) {
  const Participation participation{scene, group, speeds, scene.twists(group, speeds)};
  std::vector<double> list;
  each_element(scene.model, [&](const auto& element) {
    std::visit([&](const auto& at) { participation.add(at, list); }, connection_of(element));
  });
  return list;
}

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
    const std::vector<double> column = participations(scene, group, speeds.col(q));
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
  const Scene scene(model, topology);
  bool has_springs = false;
  scene.each_elastic([&](const auto&) { has_springs = true; });
  if (!has_springs && model.tyres.empty()) return notes;
  NumericSystem numbers(model, topology);
  System<double>& system = numbers.at(std::vector<double>(topology.bodies.size(), 0.0));
  const auto projections = frozen_directions(system, kinematics(system), analysis.blocks, analysis.driven);
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
