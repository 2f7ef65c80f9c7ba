#include "workbench/import/chain.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen::importing {

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
  } else if (ends.type == JointType::universal) {
    const Vector3d far = between.linear() * ends.far, across = ends.axis.cross(far);
    // Parallel axes are a right angle off, about any direction across.
    gap.turned = (across.norm() > 0 ? across.normalized() : ends.axis.unitOrthogonal()) *
                 std::asin(std::clamp(ends.axis.dot(far), -1.0, 1.0));
  } else if (ends.type != JointType::spherical) {
    const Vector3d axis = between.linear() * ends.axis, across = ends.axis.cross(axis);
    const double sine = across.norm();
    if (sine > 0) gap.turned = across * (std::atan2(sine, ends.axis.dot(axis)) / sine);
  }
  return gap;
}

}  // namespace mbgen::importing
