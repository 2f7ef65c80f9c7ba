#pragma once
// Plane of the road under a wheel with an enveloping contact, made by its cams. No search, no branches on values.
// Source: A. J. C. Schmeitz, "A Semi-Empirical Three-Dimensional Model of the Pneumatic Tyre Rolling over Arbitrarily
// Uneven Road Surfaces", Delft 2004 (tandem of cams with the outline of a superellipse); that cams stand on the line
// through the road below them, and that edges are looked at for themselves, is mbgen's own.
#include "compiler/formulation/roads/road.hpp"
#include "mbgen/tyres/magic_formula.hpp"

namespace mbgen {
namespace detail {

/// Where a wheel is on its road, in the axes of the road.
template <class T>
struct RoadPlace {
  T x, y;              ///< m, of the wheel centre
  T along_x, along_y;  ///< unit, the wheel's heading
};

constexpr double kInside = 1e-9;  ///< m: above the rounding of places, far below what a tyre feels

/// A line along the wheel's heading, below the middle of the left or the right half of its width.
template <class T>
struct EnvelopeRow {
  const ForceWork<T>& work;
  const Road& road;
  RoadPlace<T> place;
  T radius;   ///< m, unloaded
  T strip;    ///< m, width of the half
  T breadth;  ///< m, that this width takes up along the road's x, at least kInside

  T x_at(const T& s) const { return place.x + place.along_x * s; }
  T y_at(const T& s) const { return place.y + place.along_y * s; }
};

/// Share of a row's strip that lies between the sides of a stretch.
template <class T>
T share_between_sides(const EnvelopeRow<T>& row, const RoadStretch& stretch, const T& y) {
  const auto part = [&](const T& inside) { return within(inside / row.strip + T(0.5), T(0.0), T(1.0)); };
  T share(1.0);
  if (stretch.left) share = share + part(row.work.value(*stretch.left) - y) - T(1.0);
  if (stretch.right) share = share + part(y - row.work.value(*stretch.right)) - T(1.0);
  return share;
}

/// A feature of height 1 as the row sees it. Steps of an obstacle count by how much of the strip lies behind them, so
/// that they are none for a wheel that runs along them.
template <class T>
T course_below(const EnvelopeRow<T>& row, const RoadFeature& feature, const T& x) {
  if (!feature.is_obstacle() || feature.ramp > 0) return feature_course(row.work, feature, x).value;
  const T u = x - row.work.value(feature.from), length = row.work.value(*feature.length);
  const auto behind = [&](const T& inside) { return within(T(inside / row.breadth + T(0.5)), T(0.0), T(1.0)); };
  const T share = behind(u) + behind(T(length - u)) - T(1.0);
  return feature.kind == RoadFeature::Kind::plank ? share : T(-share);
}

/// Height of the features of a row's road, m: either the obstacles, or all others.
template <class T>
T height_of_features(const EnvelopeRow<T>& row, bool of_obstacles, const T& x, const T& y) {
  T height(0.0);
  for (const RoadFeature& feature : row.road.features) {
    if (feature.is_obstacle() != of_obstacles) continue;
    const T share = share_between_sides(row, feature, y);
    height = height + row.work.value(feature.height) * share * course_below(row, feature, x);
  }
  return height;
}

/// Height of a row's road without its obstacles, m.
template <class T>
T height_of_ground(const EnvelopeRow<T>& row, const T& x, const T& y) {
  using S = Slope<T>;
  T height = height_of_features(row, false, x, y);
  if (row.road.height) height = height + with_locals(row.work, *row.road.height, x, y);
  for (const RoadTracks& tracks : row.road.tracks) height = height + tracks_height(row.work, tracks, x, y).z;
  for (const RoadGrid& grid : row.road.grids) {
    const std::vector<double>& samples = *row.work.system.model.samples;
    height = height + height_on_grid(GridTables<T>{samples, grid}, S(x), S(y)).value;
  }
  return height;
}

/// A place of a row that cams may stand on.
template <class T>
struct EnvelopePoint {
  T s;       ///< m, from below the wheel centre along the heading
  T height;  ///< m
};

/// Edges of obstacles, just inside the higher side, so that the road there is the upper one; edges beyond the cams are
/// moved to their ends. So the cam stands on the edge itself while it passes, for any evaluation points.
template <class T>
void add_edges(const EnvelopeRow<T>& row, const T& reach, std::vector<EnvelopePoint<T>>& points) {
  using mbgen::select;
  const T along = magic::away_from_zero<T>(row.place.along_x, T(1e-9));
  for (const RoadFeature& feature : row.road.features) {
    if (!feature.is_obstacle()) continue;
    const T from = row.work.value(feature.from), to = from + row.work.value(*feature.length);
    const T height = row.work.value(feature.height);
    const T half = feature.ramp > 0 ? T(0.0) : T(0.5) * row.breadth;
    const T inside = select(feature.kind == RoadFeature::Kind::plank ? height : T(-height),
                            T(half + T(feature.ramp + kInside)), T(-half - T(kInside)));
    for (const T& edge : {T(from + inside), T(to - inside)}) {
      const T s = within(T((edge - row.place.x) / along), T(-reach), reach);
      const T x = row.x_at(s), y = row.y_at(s);
      points.push_back({s, height_of_ground(row, x, y) + height_of_features(row, true, x, y)});
    }
  }
}

/// Height and slope of the road under a row of cams.
template <class T>
struct EnvelopeLine {
  T height;  ///< m, below the wheel centre, in the axes of the road
  T slope;   ///< 1, along the heading
};

/// How far the outline of a cam reaches down, over its half axis upwards. share: how far from its middle, over its half
/// axis along the road; beyond 1 it ends.
template <class T>
T cam_outline(const TyreEnvelope& cams, const T& share) {
  using std::pow;
  constexpr double kLeast = 1e-12;  // its derivative is infinite at the ends
  const T rest = max(T(1.0) - T(pow(share, T(cams.order))), T(kLeast));
  return pow(rest, T(1 / cams.order));
}

/// The line of a row: below two cams, each as low as the road lets it. They stand upright on the line that fits the
/// ground below them, so that a slope is seen as it is.
template <class T>
EnvelopeLine<T> envelope_line(const EnvelopeRow<T>& row, const TyreEnvelope& cams) {
  const double spacing = cams.spacing();
  const int last = cams.last_sample();
  std::vector<EnvelopePoint<T>> samples, edges;
  T tilt(0.0);
  double squares = 0;
  for (int i = -last; i <= last; ++i) {
    const T s = T(spacing * i) * row.radius, x = row.x_at(s), y = row.y_at(s);
    const T ground = height_of_ground(row, x, y);
    samples.push_back({s, ground + height_of_features(row, true, x, y)});
    tilt = tilt + T(i) * ground;
    squares += i * i;
  }
  add_edges(row, T(T(0.5 * cams.base + cams.length) * row.radius), edges);
  const T ground_slope = tilt / (T(spacing * squares) * row.radius);
  const auto stand = [&](double middle) {
    std::vector<T> heights;
    const auto add = [&](const EnvelopePoint<T>& point, const T& outline) {
      heights.push_back(point.height - ground_slope * point.s + outline);
    };
    for (int i = -last; i <= last; ++i)
      if (const double place = spacing * i - middle; std::abs(place) < cams.length)
        add(samples[i + last], T(cams.height * cam_outline<double>(cams, std::abs(place) / cams.length)) * row.radius);
    for (const EnvelopePoint<T>& edge : edges) {
      const T share = abs(T(edge.s - T(middle) * row.radius)) / (T(cams.length) * row.radius);
      add(edge, T(cams.height) * row.radius * cam_outline(cams, share));
    }
    T highest = heights[0];
    for (const T& height : heights) highest = max(highest, height);
    return highest;
  };
  const T rear = stand(-0.5 * cams.base), front = stand(0.5 * cams.base);
  return {T(0.5) * (rear + front) - T(cams.height) * row.radius,
          ground_slope + (front - rear) / (T(cams.base) * row.radius)};
}

/// The plane that a tyre's envelope makes of a road: at the place of the wheel centre, in the axes of the road.
template <class T>
RoadHeight<T> height_of_envelope(const ForceWork<T>& work, const Tyre& tyre, const Road& road,
                                 const RoadPlace<T>& centre) {
  const TyreEnvelope& cams = *tyre.envelope;
  const T radius = work.value(tyre.radius, "radius", tyre.name);
  const T strip = T(0.5 * cams.width) * radius;
  const T breadth = max(T(strip * T(abs(centre.along_y))), T(kInside));
  const auto line_at = [&](double side) {
    const T y = T(side) * strip;
    const RoadPlace<T> place{centre.x - y * centre.along_y, centre.y + y * centre.along_x, centre.along_x,
                             centre.along_y};
    return envelope_line(EnvelopeRow<T>{work, road, place, radius, strip, breadth}, cams);
  };
  const EnvelopeLine<T> left = line_at(0.5), right = line_at(-0.5);
  const T along = T(0.5) * (left.slope + right.slope), across = (left.height - right.height) / strip;
  return {T(0.5) * (left.height + right.height), along * centre.along_x - across * centre.along_y,
          along * centre.along_y + across * centre.along_x};
}

}  // namespace detail
}  // namespace mbgen
