#include "compiler/formats/crg_road.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mbgen {
namespace {

struct Way {
  double x = 0, y = 0;
};
double dot(const Way& a, const Way& b) { return a.x * b.x + a.y * b.y; }
double cross(const Way& a, const Way& b) { return a.x * b.y - a.y * b.x; }

using Section = std::ptrdiff_t;

/// Position of a section of the reference line. Beyond the ends it is the end section, or the next one in a ring.
PlanePlace place_of(const CrgRoad& road, Section section) {
  const auto last = static_cast<Section>(road.sections()) - 1;
  if (road.closure.kind == CrgClosure::Kind::meeting && (section < 0 || section > last))
    section += section < 0 ? last : -last;
  const auto i = static_cast<std::size_t>(std::clamp<Section>(section, 0, last));
  return {road.x[i], road.y[i]};
}
Way between(const PlanePlace& from, const PlanePlace& to) { return {to.x - from.x, to.y - from.y}; }
Way way(const CrgRoad& road, Section from, Section to) { return between(place_of(road, from), place_of(road, to)); }

/// Interval of a grid and the fraction of it.
struct Share {
  std::size_t index = 0;
  double rest = 0;
};
Share share_in(double place, std::size_t points) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(points - 1));
  const std::size_t index = std::min(static_cast<std::size_t>(inside), points - 2);
  return {index, inside - static_cast<double>(index)};
}
double value_in(const std::vector<double>& values, const Share& at) {
  return std::lerp(values[at.index], values[at.index + 1], at.rest);
}

/// Direction of v at a section: perpendicular to the chord between the previous and the next section, scaled so that it
/// reaches v beside the interval.
Way across(const CrgRoad& road, Section section, Section interval) {
  const Way along = way(road, section - 1, section + 1), of_interval = way(road, interval, interval + 1);
  const double length = std::hypot(of_interval.x, of_interval.y) / dot(along, of_interval);
  return {-along.y * length, along.x * length};
}

/// Position straight on from a border of the road.
PlanePlace straight_on(double x, double y, double heading, double du, double v) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {x + c * du - s * v, y + s * du + c * v};
}
CrgPlace straight_back(double u, double x, double y, double heading, const PlanePlace& at) {
  const double c = std::cos(heading), s = std::sin(heading), dx = at.x - x, dy = at.y - y;
  return {u + c * dx + s * dy, c * dy - s * dx};
}

/// u within a closed line.
double u_on_line(const CrgRoad& road, double u) {
  const double first = road.start - road.closure.before, length = road.end() + road.closure.behind - first;
  if (road.closure.kind == CrgClosure::Kind::open || (u >= first && u <= first + length)) return u;
  return u - length * std::floor((u - first) / length);
}

/// Whether the search along a closed line crosses its seam, from its end to its start or back.
bool goes_over_seam(const CrgRoad& road, bool is_forward, const PlanePlace& at) {
  if (road.closure.kind != CrgClosure::Kind::apart) return road.closure.kind == CrgClosure::Kind::meeting;
  const auto last = static_cast<Section>(road.sections()) - 1;
  return is_forward ? dot(between(place_of(road, 0), at), way(road, 0, 1)) > 0
                    : dot(between(place_of(road, last), at), way(road, last - 1, last)) < 0;
}

/// End section of the interval beside a position, searched from one near by: forward, then backward.
Section interval_end(const CrgRoad& road, const PlanePlace& at, Section i) {
  const auto last = static_cast<Section>(road.sections()) - 1;
  int seams = 1;
  for (; dot(between(place_of(road, i), at), way(road, i - 1, i + 1)) > 0; ++i) {
    if (i < last) continue;
    if (!goes_over_seam(road, true, at) || seams-- == 0) break;
    i = 0;
  }
  for (; dot(between(place_of(road, i - 1), at), way(road, i - 2, i)) < 0; --i) {
    if (i > 1) continue;
    if (!goes_over_seam(road, false, at) || seams-- == 0) break;
    i = last + 1;
  }
  return i;
}

/// Coordinates beside the straight extensions of the ends, up to their intersection for a closed line.
CrgPlace beside_extension(const CrgRoad& road, bool is_behind, const PlanePlace& at) {
  const CrgPlace start = straight_back(road.start, road.x[0], road.y[0], road.heading[0], at);
  const CrgPlace end = straight_back(road.end(), road.end_x, road.end_y, road.end_heading, at);
  if (road.closure.kind == CrgClosure::Kind::open) return is_behind ? end : start;
  if (is_behind) return end.u > road.end() + road.closure.behind ? start : end;
  return start.u < road.start - road.closure.before ? end : start;
}

}  // namespace

CrgRoad closed_as_asked(CrgRoad road) {
  constexpr double kTolerance = 1e-4, kLeastCosine = 0.5, kParallel = 1e-7;  // m, 1, 1
  CrgClosure& closure = road.closure = {};
  if (entry_of(road.options, "REFLINE_CONTINUATION") != 1) return road;
  const Way first{std::cos(road.heading[0]), std::sin(road.heading[0])},
      last{std::cos(road.end_heading), std::sin(road.end_heading)}, gap{road.x[0] - road.end_x, road.y[0] - road.end_y};
  const double cosine = dot(first, last), sine = cross(first, last);
  closure.gap = std::hypot(gap.x, gap.y);
  if (cosine <= kLeastCosine || road.sections() < 4) return road;
  if (closure.gap <= entry_of(road.options, "CHECK_TOL").value_or(kTolerance)) {
    closure.kind = CrgClosure::Kind::meeting;
    return road;
  }
  if (dot(gap, first) <= 0 || dot(gap, last) <= 0) return road;  // end and start overlap
  closure.kind = CrgClosure::Kind::apart;
  closure.before = dot(gap, last) / 2, closure.behind = dot(gap, first) / 2;
  if (std::abs(sine) <= kParallel) return road;
  const double behind = cross(first, gap) / sine, before = cross(last, gap) / sine;
  if (behind >= 0 && before <= 0) closure.before = -before, closure.behind = behind;
  return road;
}

PlanePlace plane_place(const CrgRoad& road, CrgPlace at) {
  at.u = u_on_line(road, at.u);
  if (at.u < road.start) return straight_on(road.x[0], road.y[0], road.heading[0], at.u - road.start, at.v);
  if (at.u > road.end()) return straight_on(road.end_x, road.end_y, road.end_heading, at.u - road.end(), at.v);
  const auto [index, rest] = share_in((at.u - road.start) / road.increment, road.sections());
  const auto i = static_cast<Section>(index);
  const PlanePlace from = place_of(road, i), to = place_of(road, i + 1);
  const Way here = across(road, i, i), there = across(road, i + 1, i);
  return {std::lerp(from.x + at.v * here.x, to.x + at.v * there.x, rest),
          std::lerp(from.y + at.v * here.y, to.y + at.v * there.y, rest)};
}

CrgPlace road_place(const CrgRoad& road, PlanePlace at) {
  Section nearest = 0;
  double least = INFINITY;
  for (Section k = 0; k < static_cast<Section>(road.sections()); ++k) {
    const Way to = between(place_of(road, k), at);
    if (dot(to, to) < least) least = dot(to, to), nearest = k;
  }
  const Section i = interval_end(road, at, std::max<Section>(nearest, 1));
  const Way interval = way(road, i - 1, i), to = between(place_of(road, i - 1), at),
            left = between(place_of(road, i), at);
  const Way first = way(road, i - 2, i), second = way(road, i - 1, i + 1);
  const double behind = dot(first, to) / dot(first, interval), ahead = -dot(second, left) / dot(second, interval);
  const double u = road.start + road.increment * (static_cast<double>(i - 1) + behind / (behind + ahead));
  if (road.closure.kind != CrgClosure::Kind::meeting && (u < road.start || u > road.end()))
    return beside_extension(road, u > road.end(), at);
  return {u, cross(interval, to) / std::hypot(interval.x, interval.y)};
}

double height_of(const CrgRoad& road, CrgPlace at) {
  const std::size_t columns = road.v.size();
  at.u = u_on_line(road, at.u);
  const Share u = share_in((at.u - road.start) / road.increment, road.sections());
  const double v = std::clamp(at.v, road.v.front(), road.v.back());
  const auto behind = std::upper_bound(road.v.begin(), road.v.end() - 1, v);
  const auto column = static_cast<std::size_t>(std::max(behind, road.v.begin() + 1) - road.v.begin() - 1);
  const double side = (v - road.v[column]) / (road.v[column + 1] - road.v[column]);
  const auto in_section = [&](std::size_t section) {
    const double* heights = &road.heights[section * columns + column];
    return std::lerp(heights[0], heights[1], side);
  };
  const double banking = road.banking.empty() ? 0 : value_in(road.banking, u);
  return std::lerp(in_section(u.index), in_section(u.index + 1), u.rest) + value_in(road.line_height, u) + banking * v;
}

CrgCourse course_of(const CrgRoad& road, CrgPlace at) {
  constexpr double kShortest = 0.5, kStraight = 1e-10;  // m, 1/m
  at.u = u_on_line(road, at.u);
  const auto i = static_cast<Section>(share_in((at.u - road.start) / road.increment, road.sections()).index);
  const auto step = std::max<Section>(1, static_cast<Section>(std::min(kShortest / road.increment, 1e9)));
  const auto last = static_cast<Section>(road.sections()) - 1;
  const double heading = road.heading[static_cast<std::size_t>(i)];
  const bool is_ring = road.closure.kind == CrgClosure::Kind::meeting && step < last;
  if (!is_ring && step > i) return {road.heading[0], 0};
  if (!is_ring && i + step > last) return {road.end_heading, 0};
  const double length = road.increment * static_cast<double>(step);
  const double curvature = cross(way(road, i - step, i), way(road, i, i + step)) / (length * length * length);
  return {heading, std::abs(curvature) > kStraight ? 1 / (1 / curvature - at.v) : curvature};
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
