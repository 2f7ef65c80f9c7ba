#pragma once
// Courses on a level plane that a driver follows, and lanes with limits.

#include <functional>
#include <vector>

#include "workbench/manoeuvre/metrics.hpp"

namespace mbgen {

/// A place with the direction of the course.
struct PathPoint {
  double x = 0, y = 0;   ///< m
  double heading = 0;    ///< rad, to the left of x
  double curvature = 0;  ///< 1/m, to the left
};

/// Points at equal distances along a course; beyond its ends it goes on with the curvature that it has there.
struct Path {
  double spacing = 0;  ///< m
  std::vector<PathPoint> points;
  double first = 0;  ///< m, way of the first point

  /// Some metres after its start, between points by straight lines.
  PathPoint at(double way) const;
  /// The way of the nearest point, from `way` before on.
  double nearest(double x, double y, double way) const;
};

/// By its curvature over the way, with points from one way to another, m; straight along x before.
Path path_of_curvature(const std::function<double(double way)>& curvature, double from, double to);

/// Straight, then into a circle over a transition whose curvature grows smoothly. radius: m, negative to the right.
Path circle_path(double straight, double radius, double transition);

/// By y over x: changes from centre to centre of the sections of a track, a little longer than the ways between them.
Path lane_path(const std::vector<LaneSection>& sections);

/// The same course from another place on.
Path placed(Path path, double x, double y, double heading);

/// Sections of ISO 3888-1 (1999, clause 5) and ISO 3888-2 (2011, table 1) for a vehicle of a width, m, from x = start
/// on. The middle of the first section is y = 0; right limits are in line but for the other lane. sign: 1 to the left,
/// -1 to the right.
std::vector<LaneSection> double_lane_change(double width, double start, double sign);
std::vector<LaneSection> obstacle_avoidance(double width, double start, double sign);

}  // namespace mbgen
