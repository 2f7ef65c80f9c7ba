// Closing of loops for all formats: the chain in the form of the search, and texts about its result.
#include "workbench/import/closing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "workbench/import/closing_search.hpp"

namespace mbgen::importing {
namespace {

constexpr std::size_t kMostLoops = 300;  // largest number of loops closed at once

/// Adds a joint as single-coordinate joints with bodies between them: three translations and three rotations for a free
/// one.
void add_parts(Closing& closing, const ChainJoint& joint) {
  struct Part {
    JointType type;
    Vector3d axis;
  };
  std::vector<Part> parts;
  const auto ways = [&](const Vector3d& axis) { parts.push_back({JointType::prismatic, axis}); };
  const auto turns = [&](const Vector3d& axis) { parts.push_back({JointType::revolute, axis}); };
  if (joint.type == JointType::free)
    for (int i = 0; i < 3; ++i) ways(Vector3d::Unit(i));
  if (joint.type == JointType::planar) {
    ways(joint.axis.unitOrthogonal());
    ways(joint.axis.cross(joint.axis.unitOrthogonal()));
    turns(joint.axis);
  }
  if (joint.type == JointType::free || joint.type == JointType::spherical)
    for (int i = 0; i < 3; ++i) turns(Vector3d::Unit(i));
  int from = joint.from;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ChainJoint part{.name = {}, .type = parts[i].type, .from = from, .to = joint.to, .axis = parts[i].axis};
    if (i == 0) part.start = joint.start;
    if (i + 1 == parts.size()) {
      part.end = joint.end;
    } else {
      part.to = static_cast<int>(closing.poses.size());
      closing.poses.push_back(closing.pose(joint.from) * joint.start);
    }
    from = part.to;
    closing.joints.push_back(std::move(part));
  }
}

/// Joints between a body and the fixed bodies. above: the joint of each body.
std::set<int> joints_above(const Closing& closing, const std::vector<int>& above, int body) {
  std::set<int> joints;
  for (int at = above[static_cast<std::size_t>(body)]; at >= 0;) {
    if (!joints.insert(at).second) break;
    at = above[static_cast<std::size_t>(closing.joint(at).from)];
  }
  return joints;
}

/// The chain in the form of the search: its joints first, in their order, so that their indices are kept.
Closing closing_of(const Chain& chain) {
  Closing closing;
  closing.poses = chain.poses;
  for (const ChainJoint& joint : chain.joints) {
    closing.joints.push_back(joint);
    // The single-coordinate joints replace it.
    const bool has_parts =
        joint.type == JointType::free || joint.type == JointType::planar || joint.type == JointType::spherical;
    if (has_parts) closing.joints.back().from = closing.joints.back().to = -1;
  }
  for (const ChainJoint& joint : chain.joints) add_parts(closing, joint);
  std::vector<int> above(closing.poses.size(), -1);
  std::vector<std::vector<int>> below(closing.poses.size());
  for (std::size_t i = 0; i < closing.joints.size(); ++i) {
    if (closing.joints[i].to < 0) continue;
    above[static_cast<std::size_t>(closing.joints[i].to)] = static_cast<int>(i);
    below[static_cast<std::size_t>(closing.joints[i].from)].push_back(static_cast<int>(i));
  }
  std::vector<int> reached;
  for (std::size_t body = 0; body < above.size(); ++body)
    if (above[body] < 0) reached.push_back(static_cast<int>(body));
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const int joint : below[static_cast<std::size_t>(reached[next])]) {
      closing.order.push_back(static_cast<std::size_t>(joint));
      reached.push_back(closing.joint(joint).to);
    }
  }
  for (const ChainLoop& loop : chain.loops) {
    closing.closures.push_back({loop, joints_above(closing, above, loop.from), joints_above(closing, above, loop.to)});
  }
  return closing;
}

/// Joints that can move and belong to a loop.
void choose_movable(Closing& closing) {
  for (std::size_t i = 0; i < closing.joints.size(); ++i) {
    const ChainJoint& joint = closing.joints[i];
    if (!is_single(joint.type) || joint.to < 0 || !joint.relation.empty() || joint.lower > joint.upper) continue;
    for (std::size_t loop = 0; loop < closing.closures.size(); ++loop) {
      if (!closing.moves(static_cast<int>(i), loop)) continue;
      closing.movable.push_back(static_cast<int>(i));
      break;
    }
  }
}

/// Largest distance of a body from the last one, m; 1 if all coincide.
double size_of(const std::vector<Isometry3d>& poses) {
  double size = 0;
  for (const Isometry3d& pose : poses) size = std::max(size, (pose.translation() - poses.back().translation()).norm());
  return size > 0 ? size : 1;
}

/// Moved joints for a message.
std::string moves_text(const std::vector<ChainJoint>& before, const std::vector<ChainJoint>& now) {
  constexpr double kMoved = 1e-7;  // rad or m
  constexpr int kShown = 6;
  std::string moves;
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double move = now[i].position - before[i].position;
    if (std::abs(move) < kMoved || ++count > kShown) continue;
    moves += fmt::format(", {} by {:.3g} {}", quoted_text(now[i].name), move,
                         now[i].type == JointType::revolute ? "rad" : "m");
  }
  return count > kShown ? moves + fmt::format(" and {} more", count - kShown) : moves;
}

/// Gap without rounding errors.
double without_rounding(double gap) { return gap < kOpen * 1e-3 ? 0 : gap; }

/// Largest gaps, m and rad.
std::pair<double, double> widest_of(const std::vector<Gap>& gaps) {
  std::pair<double, double> widest;
  for (const Gap& gap : gaps)
    widest = {std::max(widest.first, gap.apart.norm()), std::max(widest.second, gap.turned.norm())};
  return widest;
}

/// Gaps for a message: only the length, if nothing is turned.
std::string gap_text(double apart, double turned) {
  if (turned <= kOpen) return fmt::format("{:.3g} m", apart);
  return fmt::format("{:.3g} m and {:.3g} rad", without_rounding(apart), turned);
}

/// Records the gaps that remain open, by loop.
void report_open(const Closing& closing, Closed& closed) {
  const std::vector<Gap> gaps = closing.gaps();
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].is_below(kOpen, kOpen)) continue;
    closed.left_open[closing.closures[i].loop.name] = fmt::format(
        "where the joints bring them nearest to each other, within their limits, {:.3g} m and {:.3g} rad are left",
        without_rounding(gaps[i].apart.norm()), without_rounding(gaps[i].turned.norm()));
  }
}

/// Whether all followers have the positions given by their leaders.
bool are_led(const Closing& closing) {
  Closing led = closing;
  led.follow();
  for (std::size_t i = 0; i < led.joints.size(); ++i)
    if (std::abs(led.joints[i].position - closing.joints[i].position) > kOpen) return false;
  return true;
}

}  // namespace

Closed close_chain(Chain& chain) {
  Closed closed;
  Closing closing = closing_of(chain);
  const std::vector<Gap> written = closing.gaps();
  if (written.size() > kMostLoops || (all_below(written, kOpen, kOpen) && are_led(closing))) return closed;
  closing.size = size_of(chain.poses);
  choose_movable(closing);
  if (closing.movable.empty() && are_led(closing)) return closed;
  std::tie(closed.widest, closed.widest_turned) = widest_of(written);
  if (!search(closing)) {
    report_open(closing, closed);
    return closed;
  }
  std::tie(closed.remaining, closed.remaining_turned) = widest_of(closing.gaps());
  closed.has_moved = true;
  closed.moves = moves_text(chain.joints, closing.joints);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) chain.joints[i].position = closing.joints[i].position;
  std::copy_n(closing.poses.begin(), chain.poses.size(), chain.poses.begin());
  return closed;
}

void note_moves(Reading& reading, Spot spot, const Closed& closed, const std::string& hint) {
  const bool is_open = closed.widest > kOpen || closed.widest_turned > kOpen;
  std::string text = is_open
                         ? "loops are open by up to " + gap_text(closed.widest, closed.widest_turned) + " as written"
                         : "relations between joints do not hold as written";
  if (!closed.moves.empty())
    text += (is_open ? ": joints are moved to close them" : ": joints are moved") + closed.moves;
  if (closed.remaining > kOpen || closed.remaining_turned > kOpen)
    text += fmt::format("; {} that no joint closes are taken up by the points of the loops",
                        gap_text(closed.remaining, closed.remaining_turned));
  note(reading, spot, text, closed.moves.empty() ? "" : hint);
}

}  // namespace mbgen::importing
