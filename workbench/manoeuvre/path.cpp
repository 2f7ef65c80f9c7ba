#include "workbench/manoeuvre/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/manoeuvre/signal.hpp"

namespace mbgen {
namespace {

constexpr double kSpacing = 0.25;  // m

/// A section of a track by its length, width and right limit.
struct Stretch {
  double length = 0, width = 0, right = 0;  ///< m
};

/// The first, third and fifth stretch of a track; the driver changes lanes in the others.
std::vector<LaneSection> sections_of(const std::array<Stretch, 5>& stretches, double start, double sign) {
  std::vector<LaneSection> sections;
  const double middle = stretches[0].width / 2;
  double x = start;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& stretch = stretches[i];
    const double right = stretch.right - middle, left = right + stretch.width;
    if (i % 2 == 0) sections.push_back({x, x + stretch.length, sign > 0 ? left : -right, sign > 0 ? right : -left});
    x += stretch.length;
  }
  return sections;
}

/// The point at a distance along the circle of a point's curvature.
PathPoint along_arc(const PathPoint& from, double way) {
  const double half = from.curvature * way / 2;
  const double chord = half == 0 ? way : way * std::sin(half) / half;
  return {from.x + chord * std::cos(from.heading + half), from.y + chord * std::sin(from.heading + half),
          from.heading + 2 * half, from.curvature};
}

/// The last sampled distance before a given one: points stand at whole multiples of the spacing.
double point_before(double way) { return std::max(0.0, (std::floor(way / kSpacing) - 1) * kSpacing); }

double centre(const LaneSection& section) { return (section.left + section.right) / 2; }

}  // namespace

PathPoint Path::at(double way) const {
  const double last = static_cast<double>(points.size() - 1);
  const double place = std::clamp((way - first) / spacing, 0.0, last);
  const auto i = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
  const PathPoint &a = points[i], &b = points[i + 1];
  const double u = place - static_cast<double>(i), beyond = way - first - place * spacing;
  const PathPoint on{a.x + u * (b.x - a.x), a.y + u * (b.y - a.y), a.heading + u * (b.heading - a.heading),
                     a.curvature + u * (b.curvature - a.curvature)};
  return beyond == 0 ? on : along_arc(on, beyond);
}

double Path::nearest(double x, double y, double way) const {
  // Newton's method on the tangent: the spacing of samples is short relative to any radius.
  for (int i = 0; i < 4; ++i) {
    const PathPoint point = at(way);
    way += (x - point.x) * std::cos(point.heading) + (y - point.y) * std::sin(point.heading);
  }
  return way;
}

Path path_of_curvature(const std::function<double(double way)>& curvature, double from, double to) {
  Path path{kSpacing, {}, point_before(from)};
  PathPoint point{.x = path.first};
  for (double way = path.first; way < to + 2 * kSpacing; way += kSpacing) {
    point.curvature = curvature(way);
    path.points.push_back(point);
    const double middle = point.heading + kSpacing / 2 * curvature(way + kSpacing / 4);
    point.x += kSpacing * std::cos(middle);
    point.y += kSpacing * std::sin(middle);
    point.heading += kSpacing * curvature(way + kSpacing / 2);
  }
  return path;
}

Path circle_path(double straight, double radius, double transition) {
  return path_of_curvature([=](double way) { return smooth_step((way - straight) / transition).value / radius; },
                           straight, straight + transition);
}

Path lane_path(const std::vector<LaneSection>& sections) {
  // The lane change extends into the lanes, by 0.036 of the offset at their limits.
  constexpr double kInside = 0.25;  // of the way between the lanes
  Signal lateral;
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    const double between = sections[i + 1].from - sections[i].to;
    lateral.add_change(centre(sections[i + 1]) - centre(sections[i]), sections[i].to - kInside * between,
                       (1 + 2 * kInside) * between);
  }
  Path path{kSpacing, {}, point_before(sections.front().from)};
  for (double x = path.first; path.points.size() < 2 || x < sections.back().to;) {
    const Rates y = lateral.at(x);
    const double slope = std::hypot(1, y.rate);
    path.points.push_back({x, y.value, std::atan(y.rate), y.acceleration / (slope * slope * slope)});
    x += kSpacing / slope;
  }
  return path;
}

Path placed(Path path, double x, double y, double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  for (PathPoint& point : path.points)
    point = {x + c * point.x - s * point.y, y + s * point.x + c * point.y, heading + point.heading, point.curvature};
  return path;
}

std::vector<LaneSection> double_lane_change(double width, double start, double sign) {
  constexpr double kOffset = 3.5;
  return sections_of({{{15, 1.1 * width + 0.25, 0},
                       {30, 0, 0},
                       {25, 1.2 * width + 0.25, kOffset},
                       {25, 0, 0},
                       {30, 1.3 * width + 0.25, 0}}},
                     start, sign);
}

std::vector<LaneSection> obstacle_avoidance(double width, double start, double sign) {
  constexpr double kGap = 1, kLeastWidth = 3;
  const double first = 1.1 * width + 0.25;
  return sections_of({{{12, first, 0},
                       {13.5, 0, 0},
                       {11, width + 1, first + kGap},
                       {12.5, 0, 0},
                       {12, std::max(kLeastWidth, 1.3 * width + 0.25), 0}}},
                     start, sign);
}

}  // namespace mbgen
