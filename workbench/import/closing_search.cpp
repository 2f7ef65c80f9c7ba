// Closing of loops: damped Gauss-Newton steps within the joints' limits, no larger than the gaps explain.
#include "workbench/import/closing_search.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "compiler/algebra/dense.hpp"

namespace mbgen::importing {
namespace {

constexpr double kLeft = 2e-3;  // m, accepted remaining gap
constexpr double kSame = 1e-4;  // relative; a sum of squares is lower if it is lower by this

using Loops = Closing::Loops;
using Columns = std::vector<std::size_t>;  ///< indices into Closing::movable

/// A step within the limits: joints at their limits are fixed, the others compensate.
VectorXd bounded_step(const Closing& closing, const Columns& columns, const MatrixXd& slopes, const VectorXd& at,
                      const VectorXd& positions, double damping) {
  constexpr double kRank = 1e-6;
  VectorXd step = VectorXd::Zero(slopes.cols()), target = at;
  std::vector<Eigen::Index> free(columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) free[k] = static_cast<Eigen::Index>(k);
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
      const std::size_t column = columns[static_cast<std::size_t>(i)];
      const ChainJoint& joint = closing.joint(closing.movable[column]);
      const double position = positions[static_cast<Eigen::Index>(column)];
      const double bounded = std::clamp(position + part[k], joint.lower, joint.upper) - position;
      step[i] = bounded;
      if (std::abs(bounded - part[k]) <= 1e-15)
        inside.push_back(i);
      else
        target += slopes.col(i) * bounded;
    }
    if (inside.size() == free.size()) break;
    free = inside;
  }
  return step;
}

/// Largest move of a joint that a gap explains, rad or size of the linkage: at a dead centre of arms of length l a gap
/// d takes a turn of (d/l)^(1/2).
double explained_move(const Closing& closing, double gap) {
  constexpr double kShortestArm = 0.01;  // of the size
  return std::sqrt(gap / (kShortestArm * closing.size));
}

/// Largest move of a joint from these positions, rad or size of the linkage.
double largest_move(const Closing& closing, const VectorXd& from) {
  const VectorXd moved = (closing.positions() - from).cwiseAbs();
  double largest = 0;
  for (Eigen::Index k = 0; k < moved.size(); ++k) {
    const ChainJoint& joint = closing.joint(closing.movable[static_cast<std::size_t>(k)]);
    largest = std::max(largest, joint.type == JointType::revolute ? moved[k] : moved[k] / closing.size);
  }
  return largest;
}

/// Minimises the gaps of loops over these joints from the present positions by damped Gauss-Newton steps. Result: the
/// remaining sum of squares.
double close_some(Closing& closing, const Loops& loops, const Columns& columns) {
  constexpr int kIterations = 200;
  constexpr double kDone = 1e-26, kGain = 1e-10, kLargest = 1.0;
  VectorXd at = closing.residual(loops);
  double cost = at.squaredNorm(), damping = 0;
  for (int i = 0; i < kIterations && cost > kDone; ++i) {
    MatrixXd slopes(at.size(), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index k = 0; k < slopes.cols(); ++k)
      slopes.col(k) = closing.slope(closing.movable[columns[static_cast<std::size_t>(k)]], loops);
    const VectorXd before = closing.positions();
    const double old = cost;
    for (int attempt = 0; attempt < 12; ++attempt) {
      const VectorXd step = bounded_step(closing, columns, slopes, at, before, damping);
      const double largest = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0;
      const double limit = std::min(kLargest, explained_move(closing, std::sqrt(cost)));
      const double share = largest > limit ? limit / largest : 1;
      VectorXd next = before;
      for (std::size_t k = 0; k < columns.size(); ++k)
        next[static_cast<Eigen::Index>(columns[k])] += share * step[static_cast<Eigen::Index>(k)];
      closing.set(next);
      const VectorXd now = closing.residual(loops);
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

/// Joints that move one of the loops.
Columns joints_of(const Closing& closing, const Loops& loops) {
  Columns columns;
  for (std::size_t k = 0; k < closing.movable.size(); ++k) {
    const auto is_moved = [&](std::size_t loop) { return closing.moves(closing.movable[k], loop); };
    if (std::any_of(loops.begin(), loops.end(), is_moved)) columns.push_back(k);
  }
  return columns;
}

/// Joints that move the last loop only.
Columns own_joints(const Closing& closing, const Loops& loops) {
  Columns own;
  for (const std::size_t k : joints_of(closing, {loops.back()})) {
    const auto is_moved = [&](std::size_t loop) { return closing.moves(closing.movable[k], loop); };
    if (std::none_of(loops.begin(), loops.end() - 1, is_moved)) own.push_back(k);
  }
  return own;
}

/// Closes loops from the present positions, then from random positions of `spread` joints, near ones first; keeps the
/// best, of equal ones the first. Result: whether they close.
bool close_from_many(Closing& closing, const Loops& loops, const Columns& columns, const Columns& spread, int tries) {
  const VectorXd start = closing.positions();
  VectorXd nearest = start;
  double best = -1;
  std::mt19937 random(static_cast<unsigned>(loops.size()));
  for (int i = 0; i <= tries; ++i) {
    VectorXd guess = start;
    for (const std::size_t k : spread) {
      const ChainJoint& joint = closing.joint(closing.movable[k]);
      const double reach = (joint.type == JointType::revolute ? 3.14 : closing.size) * i / tries;
      // Distributions of the standard library differ between implementations.
      const double share = 2.0 * random() / static_cast<double>(std::mt19937::max()) - 1;
      const auto index = static_cast<Eigen::Index>(k);
      guess[index] = std::clamp(guess[index] + reach * share, joint.lower, joint.upper);
    }
    closing.set(guess);
    const double cost = close_some(closing, loops, columns);
    if (closing.are_closed(loops, kOpen, kOpen)) return true;
    if (best >= 0 && cost >= (1 - kSame) * best) continue;
    best = cost;
    nearest = closing.positions();
  }
  closing.set(nearest);
  return false;
}

/// Closes the last loop by its own joints; by all joints if these are not sufficient.
void close_next(Closing& closing, const Loops& loops) {
  constexpr int kTries = 40;
  const Columns own = own_joints(closing, loops), all = joints_of(closing, loops);
  if (!own.empty() && close_from_many(closing, {loops.back()}, own, own, kTries)) return;
  const int tries = std::max(4, kTries / static_cast<int>(loops.size()));
  close_from_many(closing, loops, all, own.empty() ? joints_of(closing, {loops.back()}) : own, tries);
}

/// Groups of loops with common joints: no joint moves loops of two groups.
std::vector<Loops> groups_of(const Closing& closing) {
  std::vector<std::size_t> group_of(closing.closures.size());
  for (std::size_t loop = 0; loop < group_of.size(); ++loop) group_of[loop] = loop;
  for (const int joint : closing.movable) {
    std::optional<std::size_t> first;
    for (std::size_t loop = 0; loop < group_of.size(); ++loop) {
      if (!closing.moves(joint, loop)) continue;
      if (!first) first = loop;
      std::replace(group_of.begin(), group_of.end(), std::size_t{group_of[loop]}, std::size_t{group_of[*first]});
    }
  }
  std::map<std::size_t, Loops> groups;
  for (std::size_t loop = 0; loop < group_of.size(); ++loop) groups[group_of[loop]].push_back(loop);
  std::vector<Loops> list;
  for (auto& [name, loops] : groups) list.push_back(std::move(loops));
  return list;
}

/// Closes loops one after the other from the present positions.
double close_each(Closing& closing, const Loops& loops, const Columns& columns) {
  Loops some;
  for (const std::size_t loop : loops) {
    some.push_back(loop);
    close_next(closing, some);
  }
  return close_some(closing, loops, columns);
}

/// Closes all loops of a group together; if that fails, one after the other. A gap that the points of the loops can
/// take up moves the joints no further than it explains.
void close_group(Closing& closing, const Loops& loops) {
  const Columns columns = joints_of(closing, loops);
  const VectorXd start = closing.positions();
  const double open = closing.residual(loops).norm();
  const bool is_small = closing.are_closed(loops, kLeft, kLeftTurned);
  const auto is_too_far = [&](const VectorXd& from, double gap) {
    return largest_move(closing, from) > explained_move(closing, gap);
  };
  const double together = close_some(closing, loops, columns);
  if (is_small && is_too_far(start, open)) return closing.set(start);
  if (closing.are_closed(loops, kOpen, kOpen)) return;
  const VectorXd nearest = closing.positions();
  const bool is_left = closing.are_closed(loops, kLeft, kLeftTurned);
  closing.set(start);
  const double each = close_each(closing, loops, columns);
  // Far places must close most of a gap that the points can take up.
  const double least_gain = is_left ? 0.75 : kSame;
  const bool is_unexplained = is_left && is_too_far(nearest, std::sqrt(together));
  if (is_unexplained || each >= (1 - least_gain) * together) closing.set(nearest);
}

}  // namespace

bool search(Closing& closing) {
  VectorXd inside = closing.positions();
  for (Eigen::Index k = 0; k < inside.size(); ++k) {
    const ChainJoint& joint = closing.joint(closing.movable[static_cast<std::size_t>(k)]);
    inside[k] = std::clamp(inside[k], joint.lower, joint.upper);
  }
  closing.set(inside);
  for (const Loops& loops : groups_of(closing)) close_group(closing, loops);
  return all_below(closing.gaps(), kLeft, kLeftTurned);
}

}  // namespace mbgen::importing
