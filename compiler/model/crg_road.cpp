#include "compiler/model/crg_road.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen {
namespace {

struct Way {
  double x = 0, y = 0;
};
double dot(const Way& a, const Way& b) { return a.x * b.x + a.y * b.y; }
double cross(const Way& a, const Way& b) { return a.x * b.y - a.y * b.x; }

/// Way from one section of the reference line to another; sections beyond the ends are those at the ends.
Way way(const CrgRoad& road, std::size_t from, std::size_t to) {
  const std::size_t last = road.sections() - 1;
  from = std::min(from, last), to = std::min(to, last);
  return {road.x[to] - road.x[from], road.y[to] - road.y[from]};
}
Way way_to(const CrgRoad& road, std::size_t from, const PlanePlace& at) {
  return {at.x - road.x[from], at.y - road.y[from]};
}
std::size_t before(std::size_t section) { return section > 0 ? section - 1 : 0; }

/// Interval of a grid and the share of it.
struct Share {
  std::size_t index = 0;
  double rest = 0;
};
Share share_in(double place, std::size_t points) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(points - 1));
  const std::size_t index = std::min(static_cast<std::size_t>(inside), points - 2);
  return {index, inside - static_cast<double>(index)};
}
double between(const std::vector<double>& values, const Share& at) {
  return std::lerp(values[at.index], values[at.index + 1], at.rest);
}

/// The line through a section on which v is counted: across the way from the section before to the one behind, and so
/// long that it reaches v beside the interval.
Way across(const CrgRoad& road, std::size_t section, std::size_t interval) {
  const Way along = way(road, before(section), section + 1), of_interval = way(road, interval, interval + 1);
  const double length = std::hypot(of_interval.x, of_interval.y) / dot(along, of_interval);
  return {-along.y * length, along.x * length};
}

/// From a border of the road, straight on.
PlanePlace straight_on(double x, double y, double heading, double du, double v) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {x + c * du - s * v, y + s * du + c * v};
}
CrgPlace straight_back(double u, double x, double y, double heading, const PlanePlace& at) {
  const double c = std::cos(heading), s = std::sin(heading), dx = at.x - x, dy = at.y - y;
  return {u + c * dx + s * dy, c * dy - s * dx};
}

}  // namespace

PlanePlace plane_place(const CrgRoad& road, CrgPlace at) {
  if (at.u < road.start) return straight_on(road.x[0], road.y[0], road.heading[0], at.u - road.start, at.v);
  if (at.u > road.end()) return straight_on(road.end_x, road.end_y, road.end_heading, at.u - road.end(), at.v);
  const auto [i, rest] = share_in((at.u - road.start) / road.increment, road.sections());
  const Way here = across(road, i, i), there = across(road, i + 1, i);
  return {std::lerp(road.x[i] + at.v * here.x, road.x[i + 1] + at.v * there.x, rest),
          std::lerp(road.y[i] + at.v * here.y, road.y[i + 1] + at.v * there.y, rest)};
}

CrgPlace road_place(const CrgRoad& road, PlanePlace at) {
  const std::size_t last = road.sections() - 1;
  std::size_t i = 1;  // the interval ends there
  double nearest = INFINITY;
  for (std::size_t k = 0; k <= last; ++k) {
    const Way to = way_to(road, k, at);
    if (dot(to, to) < nearest) nearest = dot(to, to), i = std::max<std::size_t>(k, 1);
  }
  while (i < last && dot(way_to(road, i, at), way(road, i - 1, i + 1)) > 0) ++i;
  while (i > 1 && dot(way_to(road, i - 1, at), way(road, before(i - 1), i)) < 0) --i;
  const Way interval = way(road, i - 1, i), to = way_to(road, i - 1, at), left = way_to(road, i, at);
  const Way first = way(road, before(i - 1), i), second = way(road, i - 1, i + 1);
  const double behind = dot(first, to) / dot(first, interval), ahead = -dot(second, left) / dot(second, interval);
  const double u = road.start + road.increment * (static_cast<double>(i - 1) + behind / (behind + ahead));
  if (u < road.start) return straight_back(road.start, road.x[0], road.y[0], road.heading[0], at);
  if (u > road.end()) return straight_back(road.end(), road.end_x, road.end_y, road.end_heading, at);
  return {u, cross(interval, to) / std::hypot(interval.x, interval.y)};
}

double height_of(const CrgRoad& road, CrgPlace at) {
  const std::size_t columns = road.v.size();
  const Share u = share_in((at.u - road.start) / road.increment, road.sections());
  const double v = std::clamp(at.v, road.v.front(), road.v.back());
  const auto behind = std::upper_bound(road.v.begin(), road.v.end() - 1, v);
  const auto column = static_cast<std::size_t>(std::max(behind, road.v.begin() + 1) - road.v.begin() - 1);
  const double side = (v - road.v[column]) / (road.v[column + 1] - road.v[column]);
  const auto in_section = [&](std::size_t section) {
    const double* heights = &road.heights[section * columns + column];
    return std::lerp(heights[0], heights[1], side);
  };
  const double banking = road.banking.empty() ? 0 : between(road.banking, u);
  return std::lerp(in_section(u.index), in_section(u.index + 1), u.rest) + between(road.line_height, u) + banking * v;
}

CrgCourse course_of(const CrgRoad& road, CrgPlace at) {
  constexpr double kShortest = 0.5, kStraight = 1e-10;  // m, 1/m
  const std::size_t i = share_in((at.u - road.start) / road.increment, road.sections()).index;
  const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(std::min(kShortest / road.increment, 1e9)));
  if (step > i) return {road.heading[0], 0};
  if (i + step >= road.sections()) return {road.end_heading, 0};
  const double length = road.increment * static_cast<double>(step);
  const double curvature = cross(way(road, i - step, i), way(road, i, i + step)) / (length * length * length);
  return {road.heading[i], std::abs(curvature) > kStraight ? 1 / (1 / curvature - at.v) : curvature};
}

CrgRoad turned_and_moved(CrgRoad road, const CrgMove& move) {
  const double c = std::cos(move.angle), s = std::sin(move.angle);
  const auto place = [&](double& x, double& y) {
    const double dx = x - move.from.x, dy = y - move.from.y;
    x = move.to.x + c * dx - s * dy;
    y = move.to.y + s * dx + c * dy;
  };
  for (std::size_t i = 0; i < road.sections(); ++i) place(road.x[i], road.y[i]);
  place(road.end_x, road.end_y);
  for (double& each : road.heading) each += move.angle;
  road.end_heading += move.angle;
  for (double& each : road.line_height) each += move.rise;
  return road;
}

}  // namespace mbgen
