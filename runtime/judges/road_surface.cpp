#include "runtime/judges/road_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/expressions/jet.hpp"
#include "compiler/formats/crg_road.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Vector2d;
constexpr double kPi = std::numbers::pi;

/// A height and its slope along the road.
struct Profile {
  double height = 0, slope = 0;
};

/// Values of an expression at a point that moves along one axis of the road.
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

/// Unit height with ramps, by the distance from the nearer end.
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

/// Height of one track by the algorithm of de Boor and Cox: repeated interpolation until one value remains.
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

/// Coordinate within two borders, also for a point beyond them. is_outside: whether a border's own height is used
/// there.
double between_borders(RoadBorder border, double place, double first, double last, bool& is_outside) {
  is_outside = place < first || place > last;
  if (!is_outside || border == RoadBorder::keep || border == RoadBorder::zero || border == RoadBorder::refuse)
    return place;
  is_outside = false;
  const double size = last - first;
  double way = std::fmod(place - first, 2 * size);
  if (way < 0) way += 2 * size;
  if (way <= size) return first + way;
  return border == RoadBorder::repeat ? first + way - size : last - (way - size);
}

/// Whether a point is beyond a border without heights.
bool is_refused(RoadBorder border, double place, double first, double last) {
  constexpr double kRounding = 1e-8;  // m
  return border == RoadBorder::refuse && (place < first - kRounding || place > last + kRounding);
}

/// Height of a grid, with its borders and the smoothing of its ends.
double height_of_grid(const RoadGrid& grid, const Vector2d& at) {
  const CrgRoad& road = *grid.road;
  CrgPlace place = road_place(road, {at.x(), at.y()});
  if (is_refused(grid.ends, place.u, road.start, road.end()) ||
      is_refused(grid.sides, place.v, road.v.front(), road.v.back()))
    return std::nan("");
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
  if (grid.smooth_begin > 0 && from_start < grid.smooth_begin)
    height = std::lerp(road.line_height.front(), height, std::max(from_start, 0.0) / grid.smooth_begin);
  if (grid.smooth_end > 0 && to_end < grid.smooth_end)
    height = std::lerp(road.line_height.back(), height, std::max(to_end, 0.0) / grid.smooth_end);
  return height;
}

/// Its derivative along a direction of the road's axes, by differences of fourth order.
double slope_of_grid(const RoadGrid& grid, const Vector2d& at, const Vector2d& direction) {
  constexpr double kStep = 1e-4;  // m: heights are smooth between sections and columns
  const auto across = [&](double step) {
    return height_of_grid(grid, at + step * direction) - height_of_grid(grid, at - step * direction);
  };
  return (8 * across(kStep) - across(2 * kStep)) / (12 * kStep);
}

bool is_beside(const RoadStretch& stretch, double y, const Values& value) {
  return (stretch.right && y < value(*stretch.right)) || (stretch.left && y > value(*stretch.left));
}

bool covers(const RoadStretch& stretch, const Vector2d& at, const Values& value) {
  const double u = at.x() - value(stretch.from);
  return !is_beside(stretch, at.y(), value) && !(stretch.length && (u < 0 || u > value(*stretch.length)));
}

/// Adds the part of a road without its features, in the axes of the road.
void add_ground(const Road& road, const Vector2d& at, const Values& value, RoadSurface& surface) {
  if (road.height) {
    const Profile lengthwise = along_axis(value, *road.height, at, 0), across = along_axis(value, *road.height, at, 1);
    surface.height += lengthwise.height;
    surface.gradient += Vector2d(lengthwise.slope, across.slope);
  }
  for (const RoadGrid& grid : road.grids) {
    surface.height += height_of_grid(grid, at);
    surface.gradient +=
        Vector2d(slope_of_grid(grid, at, Vector2d::UnitX()), slope_of_grid(grid, at, Vector2d::UnitY()));
  }
  for (const RoadTracks& tracks : road.tracks) {
    const Profile right = along_track(tracks, *value.model.samples, at.x(), 0);
    const Profile on_left = along_track(tracks, *value.model.samples, at.x(), 1);
    const double across = (at.y() - tracks.right) / (tracks.left - tracks.right), share = std::clamp(across, 0.0, 1.0);
    surface.height += std::lerp(right.height, on_left.height, share);
    surface.gradient.x() += std::lerp(right.slope, on_left.slope, share);
    if (across == share) surface.gradient.y() += (on_left.height - right.height) / (tracks.left - tracks.right);
  }
}

/// Road under the cams of half a tyre's width.
struct SeenRoad {
  const Road& road;
  const Values& value;
  double strip;    ///< m
  double breadth;  ///< m, of the strip along the road

  /// Unit height of an obstacle at a point; for one with steps the fraction of the strip that lies on it.
  double share_of(const RoadFeature& feature, double x) const {
    const double u = x - value(feature.from);
    if (!feature.is_obstacle() || feature.ramp > 0) return shape(feature, u, value).height;
    const double first = std::max(u - breadth / 2, 0.0), last = std::min(u + breadth / 2, value(*feature.length));
    const double share = std::max(last - first, 0.0) / breadth;
    return feature.kind == RoadFeature::Kind::plank ? share : -share;
  }
  /// Height of the requested kinds of features, each weighted by the fraction of the strip above it.
  double features(const Vector2d& at, bool obstacles) const {
    double height = 0;
    for (const RoadFeature& feature : road.features) {
      if (feature.is_obstacle() != obstacles) continue;
      const double right = std::max(at.y() - strip / 2, feature.right ? value(*feature.right) : -1e300);
      const double left = std::min(at.y() + strip / 2, feature.left ? value(*feature.left) : 1e300);
      if (left > right) height += (left - right) / strip * value(feature.height) * share_of(feature, at.x());
    }
    return height;
  }
  double ground(const Vector2d& at) const {
    RoadSurface surface;
    add_ground(road, at, value, surface);
    return surface.height + features(at, false);
  }
  double height(const Vector2d& at) const { return ground(at) + features(at, true); }

  /// x of the upper sides of the obstacles' edges.
  std::vector<double> edges() const {
    constexpr double kInside = 1e-9;  // m
    std::vector<double> places;
    for (const RoadFeature& feature : road.features) {
      if (!feature.is_obstacle()) continue;
      const bool stands_out = (feature.kind == RoadFeature::Kind::plank) == (value(feature.height) >= 0);
      const double half = feature.ramp > 0 ? 0 : breadth / 2, from = value(feature.from);
      const double inset = stands_out ? half + feature.ramp + kInside : -half - kInside;
      places.insert(places.end(), {from + inset, from + value(*feature.length) - inset});
    }
    return places;
  }
};

/// Height below the middle of a row of cams along `heading`, and its slope.
Profile envelope_of_row(const SeenRoad& seen, const TyreEnvelope& cams, double radius, const Vector2d& middle,
                        const Vector2d& heading) {
  struct Place {
    double s, height;
  };
  std::vector<Place> places;
  const double half = cams.base / 2 * radius, spacing = half / cams.steps, reach = half + cams.length * radius;
  double moment = 0, squares = 0;
  const auto look = [&](double s) {
    const Vector2d at = middle + s * heading;
    places.push_back({s, seen.height(at)});
    return seen.ground(at);
  };
  look(0);
  for (double s = spacing; s < reach - 1e-9 * spacing; s += spacing) {
    moment += s * (look(s) - look(-s));
    squares += 2 * s * s;
  }
  for (const double x : seen.edges())
    if (const double s = (x - middle.x()) / heading.x(); std::abs(s) < reach) look(s);
  const double ground_slope = moment / squares;
  const auto stand = [&](double cam) {
    double highest = -1e300;
    for (const Place& place : places) {
      const double share = std::abs(place.s - cam) / (cams.length * radius);
      if (share < 1)
        highest =
            std::max(highest, place.height - ground_slope * place.s +
                                  cams.height * radius * std::pow(1 - std::pow(share, cams.order), 1 / cams.order));
    }
    return highest;
  };
  const double rear = stand(-half), front = stand(half);
  return {(front + rear) / 2 - cams.height * radius, ground_slope + (front - rear) / (2 * half)};
}

/// The plane of the four cams, in the axes of the road.
void add_envelope(const SeenRoad& seen, const TyreEnvelope& cams, double radius, const Vector2d& at,
                  const Vector2d& heading, RoadSurface& surface) {
  const Vector2d left(-heading.y(), heading.x());
  const Profile on_left = envelope_of_row(seen, cams, radius, at + seen.strip / 2 * left, heading);
  const Profile on_right = envelope_of_row(seen, cams, radius, at - seen.strip / 2 * left, heading);
  surface.height += (on_left.height + on_right.height) / 2;
  surface.gradient += (on_left.slope + on_right.slope) / 2 * heading;
  surface.gradient += (on_left.height - on_right.height) / seen.strip * left;
}

}  // namespace

RoadSurface road_surface(const Tyre& tyre, const Vector2d& place, const Eigen::Vector3d& axis, const Values& value) {
  RoadSurface surface;
  surface.height = value(tyre.road_height);
  if (tyre.road < 0) return surface;
  const Road& road = value.model.roads[static_cast<std::size_t>(tyre.road)];
  const Vector2d along(std::cos(road.heading), std::sin(road.heading)), left(-along.y(), along.x());
  const auto in_road = [&](const Vector2d& v) { return Vector2d(along.dot(v), left.dot(v)); };
  const Vector2d at = in_road(place - Vector2d(road.origin[0], road.origin[1]));
  surface.height += road.origin[2];
  if (tyre.envelope) {
    const double radius = value(tyre.radius);
    const Vector2d heading = in_road(Vector2d(axis.y(), -axis.x()).normalized());
    const double strip = tyre.envelope->width / 2 * radius;
    const SeenRoad seen{road, value, strip, std::max(strip * std::abs(heading.y()), 1e-9)};
    add_envelope(seen, *tyre.envelope, radius, at, heading, surface);
  } else {
    surface.gradient = Vector2d(value(road.slope_x), value(road.slope_y));
    add_ground(road, at, value, surface);
    for (const RoadFeature& feature : road.features) {
      if (is_beside(feature, at.y(), value)) continue;
      const Profile profile = shape(feature, at.x() - value(feature.from), value);
      surface.height += value(feature.height) * profile.height;
      surface.gradient.x() += value(feature.height) * profile.slope;
    }
  }
  surface.gradient = surface.gradient.x() * along + surface.gradient.y() * left;
  if (road.friction) surface.friction = along_axis(value, *road.friction, at, 0).height;
  for (const RoadPatch& patch : road.patches)
    if (covers(patch, at, value)) surface.friction = value(patch.friction);
  return surface;
}

}  // namespace mbgen::cartesian
