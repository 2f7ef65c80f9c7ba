// URDF: loops whose ends do not meet as written are closed by moving the joints, as a start is assembled.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "compiler/algebra/dense.hpp"
#include "compiler/import/urdf.hpp"

namespace mbgen::importing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOpen = 1e-6;                      // m and rad, as the model's reader allows
constexpr double kLeft = 2e-3, kLeftTurned = 5e-3;  // m and rad that may be left when no joint closes more
constexpr std::size_t kMostLoops = 300;             // of which all are closed together

bool all_below(const std::vector<Gap>& gaps, double length, double angle) {
  return std::all_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return gap.is_below(length, angle); });
}

/// A loop of a robot: the frames that it brings together, in their links.
struct Closure {
  std::string name;
  int from = -1, to = -1;
  LoopEnds ends;
  std::set<int> moving_from = {}, moving_to = {};  ///< joints between the link and the root
};

bool has_one_coordinate(const UrdfJoint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::prismatic;
}

std::set<int> joints_above(const UrdfRobot& robot, int link) {
  std::set<int> joints;
  for (int at = robot.links[static_cast<std::size_t>(link)].placed_by; at >= 0;) {
    joints.insert(at);
    at = robot.links[static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(at)].parent)].placed_by;
  }
  return joints;
}

std::vector<Closure> closures_of(const UrdfRobot& robot, const std::vector<UrdfLoop>& loops) {
  std::vector<Closure> list;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    if (robot.links[static_cast<std::size_t>(joint.child)].placed_by == static_cast<int>(i)) continue;
    if (joint.type == JointType::free) continue;
    list.push_back(
        {joint.name, joint.parent, joint.child, {joint.type, moved(joint), Isometry3d::Identity(), joint.axis}});
  }
  for (const UrdfLoop& loop : loops) {
    if (loop.has_far_frame && loop.ends.type != JointType::free)
      list.push_back({loop.name, loop.from, loop.to, loop.ends});
  }
  for (Closure& closure : list) {
    closure.moving_from = joints_above(robot, closure.from);
    closure.moving_to = joints_above(robot, closure.to);
  }
  return list;
}

/// The loops of a robot over the positions of its joints.
struct Closing {
  UrdfRobot& robot;
  std::vector<BodyDraft>& bodies;
  int root;
  std::vector<Closure> closures;
  std::vector<int> movable = {};  ///< joints that place a link, have one coordinate and follow none
  double size = 1;                ///< m, that a radian is weighed with

  UrdfJoint& joint(int index) { return robot.joints[static_cast<std::size_t>(index)]; }
  Isometry3d pose(int link) const {
    return bodies[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(link)].body)].pose;
  }
  LoopEnds global(const Closure& closure) const {
    LoopEnds ends = closure.ends;
    ends.from = pose(closure.from) * ends.from;
    ends.to = pose(closure.to) * ends.to;
    return ends;
  }
  std::vector<Gap> gaps() const {
    std::vector<Gap> list;
    for (const Closure& closure : closures) list.push_back(gap_between(global(closure)));
    return list;
  }

  VectorXd weighed(const Gap& gap) const {
    VectorXd values(6);
    values << gap.apart, size * gap.turned;
    return values;
  }
  VectorXd residual(std::size_t count) const {
    VectorXd values(6 * static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
      values.segment<6>(6 * static_cast<Eigen::Index>(i)) = weighed(gap_between(global(closures[i])));
    return values;
  }

  /// A joint and those that follow it, with their factors.
  std::vector<std::pair<int, double>> followers(int leader) const {
    std::vector<std::pair<int, double>> list = {{leader, 1.0}};
    for (std::size_t next = 0; next < list.size(); ++next) {
      for (std::size_t i = 0; i < robot.joints.size(); ++i) {
        if (robot.joints[i].leader == list[next].first)
          list.emplace_back(static_cast<int>(i), list[next].second * robot.joints[i].multiplier);
      }
    }
    return list;
  }

  /// How a joint moves what hangs on it, for a small change of its position.
  Isometry3d moving(int index, double change) const {
    const UrdfJoint& moved = robot.joints[static_cast<std::size_t>(index)];
    const Isometry3d at = pose(moved.child);
    const Vector3d axis = at.linear() * moved.axis;
    Isometry3d turn = Isometry3d::Identity();
    if (moved.type == JointType::prismatic) {
      turn.translation() = change * axis;
    } else {
      turn.translate(at.translation()).rotate(Eigen::AngleAxisd(change, axis)).translate(-at.translation());
    }
    return turn;
  }

  /// Slope of the first gaps over a joint, by central differences; zero where it has no part.
  VectorXd slope(int leader, std::size_t count) const {
    constexpr double kStep = 1e-6;
    VectorXd column = VectorXd::Zero(6 * static_cast<Eigen::Index>(count));
    for (const auto& [index, factor] : followers(leader)) {
      if (!has_one_coordinate(robot.joints[static_cast<std::size_t>(index)])) continue;
      const Isometry3d above = moving(index, kStep), below = moving(index, -kStep);
      for (std::size_t i = 0; i < count; ++i) {
        const bool moves_from = closures[i].moving_from.contains(index),
                   moves_to = closures[i].moving_to.contains(index);
        if (moves_from == moves_to) continue;
        LoopEnds high = global(closures[i]), low = high;
        if (moves_from) {
          high.from = above * high.from;
          low.from = below * low.from;
        } else {
          high.to = above * high.to;
          low.to = below * low.to;
        }
        column.segment<6>(6 * static_cast<Eigen::Index>(i)) +=
            factor * (weighed(gap_between(high)) - weighed(gap_between(low))) / (2 * kStep);
      }
    }
    return column;
  }

  VectorXd positions() {
    VectorXd values(static_cast<Eigen::Index>(movable.size()));
    for (std::size_t k = 0; k < movable.size(); ++k) values[static_cast<Eigen::Index>(k)] = joint(movable[k]).reference;
    return values;
  }
  void set(const VectorXd& values) {
    for (std::size_t k = 0; k < movable.size(); ++k) joint(movable[k]).reference = values[static_cast<Eigen::Index>(k)];
    follow_leaders(robot);
    place_links(robot, root, bodies);
  }
};

/// A step within the limits: joints that would leave them stay at them, the others make up for it.
VectorXd bounded_step(const Closing& closing, const MatrixXd& slopes, const VectorXd& at, const VectorXd& positions,
                      double damping) {
  constexpr double kRank = 1e-6;
  const Eigen::Index joints = slopes.cols();
  VectorXd step = VectorXd::Zero(joints), target = at;
  std::vector<Eigen::Index> free(static_cast<std::size_t>(joints));
  for (Eigen::Index k = 0; k < joints; ++k) free[static_cast<std::size_t>(k)] = k;
  for (int round = 0; round < 6 && !free.empty(); ++round) {
    const auto count = static_cast<Eigen::Index>(free.size());
    MatrixXd system = MatrixXd::Zero(slopes.rows() + (damping > 0 ? count : 0), count);
    VectorXd wanted = VectorXd::Zero(system.rows());
    wanted.head(slopes.rows()) = -target;
    for (Eigen::Index k = 0; k < count; ++k) {
      system.col(k).head(slopes.rows()) = slopes.col(free[static_cast<std::size_t>(k)]);
      if (damping > 0) system(slopes.rows() + k, k) = damping;
    }
    const VectorXd part = least_squares(system, wanted, kRank);
    std::vector<Eigen::Index> inside;
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index i = free[static_cast<std::size_t>(k)];
      const UrdfJoint& joint =
          closing.robot.joints[static_cast<std::size_t>(closing.movable[static_cast<std::size_t>(i)])];
      const double bounded = std::clamp(positions[i] + part[k], joint.lower, joint.upper) - positions[i];
      step[i] = bounded;
      if (bounded == part[k])
        inside.push_back(i);
      else
        target += slopes.col(i) * bounded;
    }
    if (inside.size() == free.size()) break;
    free = inside;
  }
  return step;
}

/// Brings the ends of the first loops as near to each other as Gauss-Newton steps from here can; damped where they
/// overshoot. Result: the sum of squares that is left.
double close_first(Closing& closing, std::size_t count) {
  constexpr int kIterations = 60;
  constexpr double kDone = 1e-26, kGain = 1e-10, kLargest = 1.0;
  VectorXd at = closing.residual(count);
  double cost = at.squaredNorm(), damping = 0;
  for (int i = 0; i < kIterations && cost > kDone; ++i) {
    MatrixXd slopes(at.size(), static_cast<Eigen::Index>(closing.movable.size()));
    for (Eigen::Index k = 0; k < slopes.cols(); ++k)
      slopes.col(k) = closing.slope(closing.movable[static_cast<std::size_t>(k)], count);
    const VectorXd before = closing.positions();
    const double old = cost;
    for (int attempt = 0; attempt < 12; ++attempt) {
      VectorXd step = bounded_step(closing, slopes, at, before, damping);
      const double largest = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0;
      if (largest > kLargest) step *= kLargest / largest;
      closing.set(before + step);
      const VectorXd now = closing.residual(count);
      if (now.squaredNorm() < cost) {
        at = now;
        cost = now.squaredNorm();
        damping *= 0.1;
        break;
      }
      damping = damping > 0 ? 4 * damping : 1e-3 * closing.size;
    }
    if (cost == old) closing.set(before);
    if (cost > (1 - kGain) * old) break;
    if (damping < 1e-9 * closing.size) damping = 0;
  }
  return cost;
}

/// Joints that move loop `last` and none before it; all that move it where there is none.
std::vector<std::size_t> own_joints(const Closing& closing, std::size_t last) {
  const auto moves = [&](std::size_t k, std::size_t loop) {
    const Closure& closure = closing.closures[loop];
    for (const auto& [index, factor] : closing.followers(closing.movable[k]))
      if (closure.moving_from.contains(index) != closure.moving_to.contains(index)) return true;
    return false;
  };
  std::vector<std::size_t> own, all;
  for (std::size_t k = 0; k < closing.movable.size(); ++k) {
    if (!moves(k, last)) continue;
    all.push_back(k);
    bool is_own = true;
    for (std::size_t loop = 0; loop < last && is_own; ++loop) is_own = !moves(k, loop);
    if (is_own) own.push_back(k);
  }
  return own.empty() ? all : own;
}

bool are_closed(const Closing& closing, std::size_t count, double length, double angle) {
  std::vector<Gap> gaps = closing.gaps();
  gaps.resize(count);
  return all_below(gaps, length, angle);
}

/// Closes one loop more; where the nearest way leads nowhere, from other places of the joints that it alone has, near
/// ones first.
void close_next(Closing& closing, std::size_t count) {
  constexpr int kTries = 40;
  double best = close_first(closing, count);
  if (are_closed(closing, count, kOpen, kOpen)) return;
  const VectorXd start = closing.positions();
  VectorXd nearest = start;
  const std::vector<std::size_t> own = own_joints(closing, count - 1);
  std::mt19937 random(static_cast<unsigned>(count));
  for (int i = 1; i <= kTries; ++i) {
    VectorXd guess = start;
    for (const std::size_t k : own) {
      const UrdfJoint& joint = closing.joint(closing.movable[k]);
      const double reach = (joint.type == JointType::revolute ? 3.14 : closing.size) * i / kTries;
      // Not a distribution of the library, whose numbers are its own.
      const double share = 2.0 * random() / static_cast<double>(std::mt19937::max()) - 1;
      const auto index = static_cast<Eigen::Index>(k);
      guess[index] = std::clamp(guess[index] + reach * share, joint.lower, joint.upper);
    }
    closing.set(guess);
    const double cost = close_first(closing, count);
    if (cost < best) {
      best = cost;
      nearest = closing.positions();
    }
    if (are_closed(closing, count, kOpen, kOpen)) return;
  }
  closing.set(nearest);
}

/// Joints that can move, their start within the limits where they have a part in a loop.
void choose_movable(Closing& closing) {
  for (std::size_t i = 0; i < closing.robot.joints.size(); ++i) {
    UrdfJoint& joint = closing.robot.joints[i];
    const bool places = closing.robot.links[static_cast<std::size_t>(joint.child)].placed_by == static_cast<int>(i);
    if (!has_one_coordinate(joint) || !places || joint.leader >= 0 || joint.lower > joint.upper) continue;
    bool has_part = false;
    for (const auto& [index, factor] : closing.followers(static_cast<int>(i))) {
      for (const Closure& closure : closing.closures)
        has_part = has_part || closure.moving_from.contains(index) != closure.moving_to.contains(index);
    }
    if (has_part) closing.movable.push_back(static_cast<int>(i));
  }
}

/// The largest distance of a link from the last one, m; 1 where all are at one place.
double size_of(const std::vector<BodyDraft>& bodies) {
  double size = 0;
  for (const BodyDraft& body : bodies)
    size = std::max(size, (body.pose.translation() - bodies.back().pose.translation()).norm());
  return size > 0 ? size : 1;
}

/// The moves that a message tells.
std::string moves_text(const UrdfRobot& robot, const std::vector<double>& before) {
  constexpr double kMoved = 1e-7;  // rad or m
  constexpr int kShown = 6;
  std::string moves;
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    const double move = joint.reference - before[i];
    if (std::abs(move) < kMoved || ++count > kShown) continue;
    moves += fmt::format(", {} by {:.3g} {}", quoted_text(joint.name), move,
                         joint.type == JointType::revolute ? "rad" : "m");
  }
  return count > kShown ? moves + fmt::format(" and {} more", count - kShown) : moves;
}

/// Rounding is no gap.
double rounded(double gap) { return gap < kOpen * 1e-3 ? 0 : gap; }

/// The gaps that stay open, by loop.
void tell_open(Closing& closing) {
  const std::vector<Gap> gaps = closing.gaps();
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].is_below(kOpen, kOpen)) continue;
    closing.robot.left_open[closing.closures[i].name] = fmt::format(
        "where the joints bring them nearest to each other, within their limits, {:.3g} m and {:.3g} rad are left",
        rounded(gaps[i].apart.norm()), rounded(gaps[i].turned.norm()));
  }
}

}  // namespace

void close_loops(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, int root,
                 std::vector<BodyDraft>& bodies) {
  Closing closing{robot, bodies, root, closures_of(robot, loops)};
  const std::vector<Gap> written = closing.gaps();
  if (all_below(written, kOpen, kOpen) || written.size() > kMostLoops) return;
  closing.size = size_of(bodies);
  choose_movable(closing);
  if (closing.movable.empty()) return;
  std::vector<double> before;
  for (const UrdfJoint& joint : robot.joints) before.push_back(joint.reference);
  const VectorXd start = closing.positions();
  VectorXd inside = start;
  for (Eigen::Index k = 0; k < inside.size(); ++k) {
    const UrdfJoint& joint = closing.joint(closing.movable[static_cast<std::size_t>(k)]);
    inside[k] = std::clamp(inside[k], joint.lower, joint.upper);
  }
  closing.set(inside);
  close_first(closing, closing.closures.size());
  const auto is_done = [&] { return all_below(closing.gaps(), kLeft, kLeftTurned); };
  if (!is_done()) {
    closing.set(inside);
    for (std::size_t count = 1; count <= closing.closures.size(); ++count) close_next(closing, count);
  }
  if (!is_done()) {
    tell_open(closing);
    for (std::size_t i = 0; i < before.size(); ++i) robot.joints[i].reference = before[i];
    place_links(robot, root, bodies);
    return;
  }
  double widest = 0, remaining = 0;
  for (const Gap& gap : written) widest = std::max(widest, gap.apart.norm());
  for (const Gap& gap : closing.gaps()) remaining = std::max(remaining, gap.apart.norm());
  robot.is_closed_by_moving = true;
  note(reading, robot.links[static_cast<std::size_t>(root)].element->spot,
       fmt::format("loops are open by up to {:.3g} m as written: joints are moved to close them{}", widest,
                   moves_text(robot, before)) +
           (remaining > kOpen
                ? fmt::format("; {:.3g} m that no joint closes are taken up by the points of the loops", remaining)
                : ""),
       "the coordinates of the model are zero there; --loops FILE with \"positions\" chooses another place");
}

}  // namespace mbgen::importing
