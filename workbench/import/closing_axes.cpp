// Axes of joints that close planar loops, made exactly parallel to the others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/import/closing.hpp"
#include "workbench/import/closing_search.hpp"

namespace mbgen::importing {
namespace {

/// Angle of two lines, rad.
double tilt_of(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

/// Joints of the tree between two bodies.
std::vector<const JointDraft*> way_between(const Assembly& assembly, int from, int to) {
  std::vector<const JointDraft*> above(assembly.bodies.size(), nullptr);
  for (const JointDraft& joint : assembly.joints)
    if (!joint.cut) above[static_cast<std::size_t>(joint.to)] = &joint;
  const auto way_up = [&](int body) {
    std::vector<const JointDraft*> way;
    for (const JointDraft* at = above[static_cast<std::size_t>(body)]; at && way.size() <= above.size();
         at = above[static_cast<std::size_t>(at->from)])
      way.push_back(at);
    return way;
  };
  std::vector<const JointDraft*> one = way_up(from), other = way_up(to);
  while (!one.empty() && !other.empty() && one.back() == other.back()) one.pop_back(), other.pop_back();
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

/// The direction that all axes of turns on a way share, across its slides; nothing on a way out of a plane.
std::optional<Vector3d> common_axis(const std::vector<const JointDraft*>& way) {
  std::optional<Vector3d> common;
  for (const JointDraft* joint : way)
    if (joint->type == JointType::revolute && !common) common = joint->axis;
  if (!common) return std::nullopt;
  const bool is_planar = std::ranges::all_of(way, [&](const JointDraft* joint) {
    if (joint->type == JointType::fixed) return true;
    if (joint->type == JointType::prismatic) return std::abs(joint->axis.dot(*common)) < kOpen;
    return joint->type == JointType::revolute && tilt_of(joint->axis, *common) < kOpen;
  });
  return is_planar ? common : std::nullopt;
}

}  // namespace

void align_closing_axes(Reading& reading, Spot spot, Assembly& assembly) {
  for (JointDraft& joint : assembly.joints) {
    if (!joint.cut || joint.type != JointType::revolute) continue;
    const std::optional<Vector3d> common = common_axis(way_between(assembly, joint.from, joint.to));
    const double tilt = common ? tilt_of(joint.axis, *common) : 0;
    if (tilt == 0 || tilt > kLeftTurned) continue;
    joint.axis = joint.axis.dot(*common) < 0 ? Vector3d(-*common) : *common;
    if (tilt > kOpen)
      note(reading, spot,
           fmt::format("axis of joint {} is turned by {:.3g} rad, parallel to all other axes of its planar loop",
                       quoted_text(joint.name), tilt));
  }
}

}  // namespace mbgen::importing
