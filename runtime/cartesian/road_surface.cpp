#include "runtime/cartesian/road_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/model/crg_road.hpp"
#include "compiler/model/jet.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Vector2d;
constexpr double kPi = std::numbers::pi;

/// A height and its slope along the road.
struct Profile {
  double height = 0, slope = 0;
};

/// Values of an expression over a place that moves along one axis of the road.
struct MovingPlace {
  const Values& value;
  std::array<Jet<double>, 2> place;

  Jet<double> parameter(int i) const { return value.parameter(i); }
  Jet<double> input(int i) const { return value.input(i); }
  Jet<double> time() const { return value.time(); }
  Jet<double> position(const CoordinateReference& c) const { return value.position(c); }
  Jet<double> velocity(const CoordinateReference& c) const { return value.velocity(c); }
  Jet<double> local(int i) const { return place[static_cast<std::size_t>(i)]; }
};

/// Height of an expression and its derivative along axis 0 or 1.
Profile along_axis(const Values& value, int expression, const Vector2d& at, int axis) {
  MovingPlace moving{value, {Jet<double>(at.x()), Jet<double>(at.y())}};
  moving.place[static_cast<std::size_t>(axis)].first = 1;
  const Jet<double> jet = evaluate<Jet<double>>(value.model.expressions[static_cast<std::size_t>(expression)], moving);
  return {jet.value, jet.first};
}

/// Height 1 with its ramps, by the place from the nearer end.
Profile plateau(double u, double length, double ramp) {
  const bool is_leaving = u > length / 2;
  const double inside = is_leaving ? length - u : u;
  if (inside < 0) return {};
  if (inside >= ramp) return {1, 0};
  const double q = inside / ramp, rise = 6 * q * (1 - q) / ramp;
  return {q * q * (3 - 2 * q), is_leaving ? -rise : rise};
}

Profile wave(const RoadFeature& feature, double u, const Values& value) {
  const double first = 2 * kPi / value(*feature.wave_length);
  double angle = first * u, rate = first;
  if (feature.last_wave_length) {
    const double length = value(*feature.length), last = 2 * kPi / value(*feature.last_wave_length);
    if (u < 0 || u > length) return {};
    rate = first + (last - first) * u / length;
    angle = (first + rate) / 2 * u;
  }
  angle += value(feature.phase);
  return {std::sin(angle), rate * std::cos(angle)};
}

Profile shape(const RoadFeature& feature, double u, const Values& value) {
  if (!feature.length) return wave(feature, u, value);
  const double length = value(*feature.length);
  if (u < 0 || u > length) return {};
  if (feature.kind == RoadFeature::Kind::bump) {
    const double turn = 2 * kPi / length;
    return {(1 - std::cos(turn * u)) / 2, turn * std::sin(turn * u) / 2};
  }
  const Profile limit = plateau(u, length, feature.ramp);
  if (feature.kind == RoadFeature::Kind::plank) return limit;
  if (feature.kind == RoadFeature::Kind::pothole) return {-limit.height, -limit.slope};
  const Profile inner = wave(feature, u, value);
  return {limit.height * inner.height, limit.height * inner.slope + limit.slope * inner.height};
}

/// Height of one track by the algorithm of de Boor and Cox: corners are cut until one value is left.
Profile along_track(const RoadTracks& tracks, const std::vector<double>& samples, double x, int side) {
  double u = (x - tracks.from) / tracks.spacing;
  if (tracks.is_periodic) u -= tracks.count * std::floor(u / tracks.count);
  if (u < 0) return {along_track(tracks, samples, tracks.from, side).height, 0};
  if (!tracks.is_periodic && u > tracks.count - 1)
    return {along_track(tracks, samples, tracks.from + tracks.spacing * (tracks.count - 1), side).height, 0};
  const int whole = std::min(static_cast<int>(u), tracks.count - 1);
  const double t = u - whole;
  std::array<double, 4> d{};
  for (int k = 0; k < 4; ++k)
    d[static_cast<std::size_t>(k)] = samples[static_cast<std::size_t>(tracks.first + 2 * (whole + k) + side)];
  double slope = 0;
  for (int degree = 3; degree > 0; --degree) {
    if (degree == 1) slope = 3 * (d[1] - d[0]) / tracks.spacing;
    for (int k = 0; k < degree; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double share = (t + degree - 1 - k) / degree;
      d[i] = (1 - share) * d[i] + share * d[i + 1];
    }
  }
  return {d[0], slope};
}

/// A place between two borders, for one beyond them too. is_outside: whether a border's own height counts there.
double between_borders(RoadBorder border, double place, double first, double last, bool& is_outside) {
  is_outside = place < first || place > last;
  if (!is_outside || border == RoadBorder::keep || border == RoadBorder::zero) return place;
  is_outside = false;
  const double size = last - first;
  double way = std::fmod(place - first, 2 * size);
  if (way < 0) way += 2 * size;
  if (way <= size) return first + way;
  return border == RoadBorder::repeat ? first + way - size : last - (way - size);
}

/// Height of a grid, with its borders and the smoothing of its ends.
double height_of_grid(const RoadGrid& grid, const Vector2d& at) {
  const CrgRoad& road = *grid.road;
  CrgPlace place = road_place(road, {at.x(), at.y()});
  bool is_beyond = false, is_beside = false;
  place.u = between_borders(grid.ends, place.u, road.start, road.end(), is_beyond);
  place.v = between_borders(grid.sides, place.v, road.v.front(), road.v.back(), is_beside);
  double height = height_of(road, place);
  if (is_beside) height = grid.side_offset + (grid.sides == RoadBorder::zero ? 0 : height);
  if (is_beyond) {
    const double kept = grid.ends == RoadBorder::zero ? (is_beside ? grid.side_offset : 0) : height;
    height = grid.end_offset + kept;
  }
  const double from_start = place.u - road.start, to_end = road.end() - place.u;
  if (from_start < grid.smooth_begin)
    height = std::lerp(road.line_height.front(), height, std::max(from_start, 0.0) / grid.smooth_begin);
  if (to_end < grid.smooth_end)
    height = std::lerp(road.line_height.back(), height, std::max(to_end, 0.0) / grid.smooth_end);
  return height;
}

/// Its derivative along a direction of the road's axes, by difference.
double slope_of_grid(const RoadGrid& grid, const Vector2d& at, const Vector2d& direction) {
  constexpr double kStep = 1e-6;  // m: heights are linear between sections and columns
  return (height_of_grid(grid, at + kStep * direction) - height_of_grid(grid, at - kStep * direction)) / (2 * kStep);
}

bool is_beside(const RoadStretch& stretch, double y, const Values& value) {
  return (stretch.right && y < value(*stretch.right)) || (stretch.left && y > value(*stretch.left));
}

bool covers(const RoadStretch& stretch, const Vector2d& at, const Values& value) {
  const double u = at.x() - value(stretch.from);
  return !is_beside(stretch, at.y(), value) && !(stretch.length && (u < 0 || u > value(*stretch.length)));
}

}  // namespace

RoadSurface road_surface(const Tyre& tyre, const Vector2d& place, const Values& value) {
  RoadSurface surface;
  surface.height = value(tyre.road_height);
  if (tyre.road < 0) return surface;
  const Road& road = value.model.roads[static_cast<std::size_t>(tyre.road)];
  const Vector2d along(std::cos(road.heading), std::sin(road.heading)), left(-along.y(), along.x());
  const Vector2d from_origin = place - Vector2d(road.origin[0], road.origin[1]);
  const Vector2d at(along.dot(from_origin), left.dot(from_origin));
  surface.height += road.origin[2];
  surface.gradient = value(road.slope_x) * along + value(road.slope_y) * left;
  if (road.height) {
    const Profile lengthwise = along_axis(value, *road.height, at, 0), across = along_axis(value, *road.height, at, 1);
    surface.height += lengthwise.height;
    surface.gradient += lengthwise.slope * along + across.slope * left;
  }
  for (const RoadGrid& grid : road.grids) {
    surface.height += height_of_grid(grid, at);
    surface.gradient +=
        slope_of_grid(grid, at, Vector2d::UnitX()) * along + slope_of_grid(grid, at, Vector2d::UnitY()) * left;
  }
  for (const RoadTracks& tracks : road.tracks) {
    const Profile right = along_track(tracks, *value.model.samples, at.x(), 0);
    const Profile on_left = along_track(tracks, *value.model.samples, at.x(), 1);
    const double across = (at.y() - tracks.right) / (tracks.left - tracks.right), share = std::clamp(across, 0.0, 1.0);
    surface.height += std::lerp(right.height, on_left.height, share);
    surface.gradient += std::lerp(right.slope, on_left.slope, share) * along;
    if (across == share) surface.gradient += (on_left.height - right.height) / (tracks.left - tracks.right) * left;
  }
  for (const RoadFeature& feature : road.features) {
    if (is_beside(feature, at.y(), value)) continue;
    const Profile profile = shape(feature, at.x() - value(feature.from), value);
    surface.height += value(feature.height) * profile.height;
    surface.gradient += value(feature.height) * profile.slope * along;
  }
  if (road.friction) surface.friction = along_axis(value, *road.friction, at, 0).height;
  for (const RoadPatch& patch : road.patches)
    if (covers(patch, at, value)) surface.friction = value(patch.friction);
  return surface;
}

}  // namespace mbgen::cartesian
