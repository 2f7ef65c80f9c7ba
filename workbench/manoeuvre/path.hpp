#pragma once
// Courses on a level plane that a driver follows, and lanes with limits.

#include <functional>
#include <vector>

#include "workbench/manoeuvre/metrics.hpp"

namespace mbgen {

/// A point of a course with its direction.
struct PathPoint {
  double x = 0, y = 0;   ///< m
  double heading = 0;    ///< rad, to the left of x
  double curvature = 0;  ///< 1/m, to the left
};

/// Points at equal distances along a course, continued with constant curvature beyond its ends.
struct Path {
  double spacing = 0;  ///< m
  std::vector<PathPoint> points;
  double first = 0;  ///< m, way of the first point

  /// The point at a distance from the start, by linear interpolation.
  PathPoint at(double way) const;
  /// Distance of the nearest point, searched from `way` on.
  double nearest(double x, double y, double way) const;
};

/// Path by its curvature over distance, with points between two distances, m; straight along x before.
Path path_of_curvature(const std::function<double(double way)>& curvature, double from, double to);

/// A straight, a transition of smoothly growing curvature, and a circle. radius: m, negative to the right.
Path circle_path(double straight, double radius, double transition);

/// Path by y over x: lane changes between the centres of sections, slightly longer than the gaps between the sections.
Path lane_path(const std::vector<LaneSection>& sections);

/// The same course from another pose.
Path placed(Path path, double x, double y, double heading);

/// Sections of ISO 3888-1 (1999, clause 5) and ISO 3888-2 (2011, table 1) for a vehicle of a width, m, from x = start
/// on. The middle of the first section is y = 0; the right limits are aligned, except in the other lane. sign: 1 to the
/// left, -1 to the right.
std::vector<LaneSection> double_lane_change(double width, double start, double sign);
std::vector<LaneSection> obstacle_avoidance(double width, double start, double sign);

}  // namespace mbgen
