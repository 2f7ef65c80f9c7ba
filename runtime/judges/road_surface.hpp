#pragma once
// The road under a wheel, global axes.

#include <Eigen/Core>

#include "runtime/judges/values.hpp"

namespace mbgen::cartesian {

/// The road at a point: height, slopes of its tangent plane, and factor of friction.
struct RoadSurface {
  double height = 0;  ///< m, global z
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  double friction = 1;
};

/// The road of a tyre below a point, or the plane from its envelope there. place: global x and y, m; axis: of the
/// wheel, unit, to the left.
RoadSurface road_surface(const Tyre& tyre, const Eigen::Vector2d& place, const Eigen::Vector3d& axis,
                         const Values& value);

}  // namespace mbgen::cartesian
