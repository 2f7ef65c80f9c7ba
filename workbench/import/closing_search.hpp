#pragma once
// Search for joint positions at which loops close: data and interface.

#include <algorithm>
#include <set>

#include "workbench/import/chain.hpp"

namespace mbgen::importing {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOpen = 1e-6;        // m and rad, as the model's reader allows
constexpr double kLeftTurned = 5e-3;  // rad, accepted remaining gap

inline bool is_single(JointType type) { return type == JointType::revolute || type == JointType::prismatic; }

inline bool all_below(const std::vector<Gap>& gaps, double length, double angle) {
  return std::all_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return gap.is_below(length, angle); });
}

/// A loop, and the joints between its ends and the fixed bodies.
struct Closure {
  ChainLoop loop;
  std::set<int> moving_from = {}, moving_to = {};
};

/// Loops as functions of joint positions. Joints of several coordinates are split into single ones here.
struct Closing {
  std::vector<ChainJoint> joints = {};
  std::vector<Isometry3d> poses = {};
  std::vector<std::size_t> order = {};  ///< of the joints, outwards
  std::vector<Closure> closures = {};
  std::vector<int> movable = {};  ///< joints of one coordinate in a loop, without a leader
  double size = 1;                ///< m, length per radian in weighted sums

  ChainJoint& joint(int index) { return joints[static_cast<std::size_t>(index)]; }
  const ChainJoint& joint(int index) const { return joints[static_cast<std::size_t>(index)]; }
  const Isometry3d& pose(int body) const { return poses[static_cast<std::size_t>(body)]; }
  LoopEnds global(const Closure& closure) const {
    LoopEnds ends = closure.loop.ends;
    ends.from = pose(closure.loop.from) * ends.from;
    ends.to = pose(closure.loop.to) * ends.to;
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
  using Loops = std::vector<std::size_t>;  ///< indices into closures
  VectorXd residual(const Loops& loops) const {
    VectorXd values(6 * static_cast<Eigen::Index>(loops.size()));
    for (std::size_t i = 0; i < loops.size(); ++i)
      values.segment<6>(6 * static_cast<Eigen::Index>(i)) = weighed(gap_between(global(closures[loops[i]])));
    return values;
  }
  bool are_closed(const Loops& loops, double length, double angle) const {
    return std::all_of(loops.begin(), loops.end(),
                       [&](std::size_t loop) { return gap_between(global(closures[loop])).is_below(length, angle); });
  }
  /// Whether a joint, or a follower of it, changes the gap of a loop.
  bool moves(int leader, std::size_t loop) const {
    for (const auto& [index, factor] : followers(leader)) {
      if (closures[loop].moving_from.contains(index) != closures[loop].moving_to.contains(index)) return true;
    }
    return false;
  }

  /// A joint and its followers, with the derivatives of their relations.
  std::vector<std::pair<int, double>> followers(int leader) const {
    std::vector<std::pair<int, double>> list = {{leader, 1.0}};
    for (std::size_t next = 0; next < list.size(); ++next) {
      const double at = joint(list[next].first).position;
      for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].leader != list[next].first) continue;
        double slope = 0;
        for (std::size_t k = joints[i].relation.size(); k-- > 1;)
          slope = slope * at + static_cast<double>(k) * joints[i].relation[k];
        list.emplace_back(static_cast<int>(i), list[next].second * slope);
      }
    }
    return list;
  }

  /// Motion of the bodies behind a joint for a small change of its position.
  Isometry3d moving(int index, double change) const {
    const ChainJoint& moved = joint(index);
    const Isometry3d at = pose(moved.from) * moved.start;
    const Vector3d axis = at.linear() * moved.axis;
    Isometry3d turn = Isometry3d::Identity();
    if (moved.type == JointType::prismatic) {
      turn.translation() = change * axis;
    } else {
      turn.translate(at.translation()).rotate(Eigen::AngleAxisd(change, axis)).translate(-at.translation());
    }
    return turn;
  }

  /// Derivative of the loops' gaps by a joint's position, by central differences; zero for a joint outside a loop.
  VectorXd slope(int leader, const Loops& loops) const {
    constexpr double kStep = 1e-6;
    VectorXd column = VectorXd::Zero(6 * static_cast<Eigen::Index>(loops.size()));
    for (const auto& [index, factor] : followers(leader)) {
      if (!is_single(joint(index).type)) continue;
      const Isometry3d above = moving(index, kStep), below = moving(index, -kStep);
      for (std::size_t i = 0; i < loops.size(); ++i) {
        const Closure& closure = closures[loops[i]];
        const bool moves_from = closure.moving_from.contains(index);
        if (moves_from == closure.moving_to.contains(index)) continue;
        LoopEnds high = global(closure), low = high;
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

  VectorXd positions() const {
    VectorXd values(static_cast<Eigen::Index>(movable.size()));
    for (std::size_t k = 0; k < movable.size(); ++k) values[static_cast<Eigen::Index>(k)] = joint(movable[k]).position;
    return values;
  }
  void set(const VectorXd& values) {
    for (std::size_t k = 0; k < movable.size(); ++k) joint(movable[k]).position = values[static_cast<Eigen::Index>(k)];
    follow();
    place();
  }

  /// Sets followers to the positions given by their leaders. A leader may be a follower itself.
  void follow() {
    for (std::size_t pass = 0; pass < joints.size(); ++pass) {
      bool has_moved = false;
      for (ChainJoint& follower : joints) {
        if (follower.relation.empty()) continue;
        const double at = follower.leader >= 0 ? joint(follower.leader).position : 0;
        double wanted = 0;
        for (std::size_t k = follower.relation.size(); k-- > 0;) wanted = wanted * at + follower.relation[k];
        has_moved = has_moved || wanted != follower.position;
        follower.position = wanted;
      }
      if (!has_moved) return;
    }
  }

  void place() {
    for (const std::size_t index : order) {
      const ChainJoint& at = joints[index];
      Isometry3d frame = pose(at.from) * at.start;
      if (at.type == JointType::revolute) frame.rotate(Eigen::AngleAxisd(at.position, at.axis));
      if (at.type == JointType::prismatic) frame.translate(at.position * at.axis);
      poses[static_cast<std::size_t>(at.to)] = frame * at.end;
    }
  }
};

/// Closes the loops within the joints' limits. Result: whether all close, apart from accepted gaps.
bool search(Closing& closing);

}  // namespace mbgen::importing
