// URDF: loops whose ends do not quite meet, as files with few digits leave them, are closed by moving the joints a
// little, as a start is assembled.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/algebra/dense.hpp"
#include "compiler/import/urdf.hpp"

namespace mbgen::importing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOpen = 1e-6;                          // m and rad, as the model's reader allows
constexpr double kNearly = 0.01, kNearlyTurned = 0.02;  // m and rad that joints may close
constexpr double kLeft = 2e-3, kLeftTurned = 5e-3;      // m and rad that may be left when no joint closes more

/// Gap of a loop: m, then rad.
struct Gap {
  Vector3d apart = Vector3d::Zero(), turned = Vector3d::Zero();
  bool is_below(double length, double angle) const { return apart.norm() <= length && turned.norm() <= angle; }
};

Gap gap_between(const LoopEnds& ends) {
  const Isometry3d between = ends.from.inverse() * ends.to;
  Gap gap;
  const Vector3d along = ends.axis * ends.axis.dot(between.translation());
  gap.apart = between.translation();
  if (ends.type == JointType::prismatic || ends.type == JointType::cylindrical) gap.apart -= along;
  if (ends.type == JointType::planar) gap.apart = along;
  const Eigen::AngleAxisd turn(between.linear());
  if (ends.type == JointType::fixed || ends.type == JointType::prismatic) {
    gap.turned = turn.angle() * turn.axis();
  } else if (ends.type != JointType::spherical) {
    const Vector3d axis = between.linear() * ends.axis, across = ends.axis.cross(axis);
    const double sine = across.norm();
    if (sine > 0) gap.turned = across * (std::atan2(sine, ends.axis.dot(axis)) / sine);
  }
  return gap;
}

/// The loops of a robot over the positions of its joints.
struct Closing {
  UrdfRobot& robot;
  const std::vector<UrdfLoop>& loops;
  std::vector<BodyDraft>& bodies;
  int root;
  std::vector<int> movable = {};  ///< joints that place a link and have one coordinate

  std::vector<Gap> gaps() {
    place_links(robot, root, bodies);
    const auto pose = [&](int link) { return bodies[static_cast<std::size_t>(robot.links[link].body)].pose; };
    std::vector<Gap> list;
    for (const UrdfJoint& joint : robot.joints) {
      const int index = static_cast<int>(&joint - robot.joints.data());
      if (robot.links[joint.child].placed_by == index || joint.type == JointType::free) continue;
      list.push_back(gap_between({joint.type, pose(joint.parent) * moved(joint), pose(joint.child), joint.axis}));
    }
    for (const UrdfLoop& loop : loops) {
      if (!loop.has_far_frame || loop.ends.type == JointType::free) continue;
      list.push_back(gap_between(
          {loop.ends.type, pose(loop.from) * loop.ends.from, pose(loop.to) * loop.ends.to, loop.ends.axis}));
    }
    return list;
  }

  VectorXd residual() {
    const std::vector<Gap> list = gaps();
    VectorXd values(6 * static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i)
      values.segment<6>(6 * static_cast<Eigen::Index>(i)) << list[i].apart, list[i].turned;
    return values;
  }

  double& position(int k) {
    return robot.joints[static_cast<std::size_t>(movable[static_cast<std::size_t>(k)])].reference;
  }

  /// Moves the joints by the least that brings the ends nearest to each other.
  void improve() {
    constexpr double kStep = 1e-6, kRank = 1e-6;
    const VectorXd at = residual();
    MatrixXd slopes(at.size(), static_cast<Eigen::Index>(movable.size()));
    for (int k = 0; k < static_cast<int>(movable.size()); ++k) {
      const double before = position(k);
      position(k) = before + kStep;
      const VectorXd above = residual();
      position(k) = before - kStep;
      slopes.col(k) = (above - residual()) / (2 * kStep);
      position(k) = before;
    }
    const VectorXd step = least_squares(slopes, at, kRank);
    for (int k = 0; k < static_cast<int>(movable.size()); ++k) position(k) -= step[k];
  }
};

bool all_below(const std::vector<Gap>& gaps, double length, double angle) {
  return std::all_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return gap.is_below(length, angle); });
}

}  // namespace

void close_loops(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, int root,
                 std::vector<BodyDraft>& bodies) {
  constexpr int kIterations = 8;   // converges quadratically
  constexpr double kMoved = 1e-7;  // rad or m, that a message tells
  Closing closing{robot, loops, bodies, root};
  const std::vector<Gap> written = closing.gaps();
  if (all_below(written, kOpen, kOpen) || !all_below(written, kNearly, kNearlyTurned)) return;
  std::vector<double> before;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    before.push_back(joint.reference);
    const bool has_one = joint.type == JointType::revolute || joint.type == JointType::prismatic;
    if (has_one && robot.links[joint.child].placed_by == static_cast<int>(i))
      closing.movable.push_back(static_cast<int>(i));
  }
  for (int i = 0; i < kIterations && !closing.movable.empty(); ++i) closing.improve();
  const std::vector<Gap> left = closing.gaps();
  if (!all_below(left, kLeft, kLeftTurned)) {
    for (std::size_t i = 0; i < before.size(); ++i) robot.joints[i].reference = before[i];
    place_links(robot, root, bodies);
    return;
  }
  double widest = 0, remaining = 0;
  for (const Gap& gap : written) widest = std::max(widest, gap.apart.norm());
  for (const Gap& gap : left) remaining = std::max(remaining, gap.apart.norm());
  std::string moves;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    const double move = joint.reference - before[i];
    if (std::abs(move) < kMoved) continue;
    moves += fmt::format("{}{} by {:.3g} {}", moves.empty() ? "" : ", ", quoted_text(joint.name), move,
                         joint.type == JointType::revolute ? "rad" : "m");
  }
  robot.is_closed_by_moving = true;
  note(reading, robot.links[static_cast<std::size_t>(root)].element->spot,
       fmt::format("loops are open by up to {:.3g} m as written: joints are moved to close them{}{}", widest,
                   moves.empty() ? "" : ", ", moves) +
           (remaining > kOpen
                ? fmt::format("; {:.3g} m that no joint closes are taken up by the points of the loops", remaining)
                : ""),
       "the coordinates of the model are zero there; --loops FILE with \"positions\" chooses another place");
}

}  // namespace mbgen::importing
