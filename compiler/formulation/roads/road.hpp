#pragma once
// Roads: height, slopes and friction at a place. No branches on values, so that symbols can pass.

#include <numbers>

#include "compiler/formulation/roads/road_grid.hpp"

namespace mbgen {
namespace detail {

/// A value along the road with its slope.
template <class T>
struct Course {
  T value{0.0}, slope{0.0};
};

/// 1 over a stretch, 0 before and behind it, with smooth ramps inside it, or steps. u: from its beginning.
template <class T>
Course<T> plank_course(const T& u, const T& length, double ramp) {
  using mbgen::select;
  if (ramp == 0) return {select(u, select(length - u, T(1.0), T(0.0)), T(0.0)), T(0.0)};
  const T up = within(T(1 / ramp) * u, T(0.0), T(1.0)), down = within(T(1 / ramp) * (length - u), T(0.0), T(1.0));
  const auto step = [](const T& q) { return q * q * (T(3.0) - T(2.0) * q); };
  return {step(up) + step(down) - T(1.0), T(6 / ramp) * (up * (T(1.0) - up) - down * (T(1.0) - down))};
}

/// Waves of height 1 along the road, of a sine or a sweep: see RoadFeature.
template <class T>
Course<T> wave_course(const ForceWork<T>& work, const RoadFeature& feature, const T& u) {
  using std::cos, std::sin;
  constexpr double kTurn = 2 * std::numbers::pi;
  const T number = T(1.0) / work.value(*feature.wave_length);
  T turns = number * u, rate = number;
  if (feature.kind == RoadFeature::Kind::sweep) {
    const T length = work.value(*feature.length);
    const T growth = (T(1.0) / work.value(*feature.last_wave_length) - number) / length;
    const T inside = within(u, T(0.0), length);
    turns = inside * (number + T(0.5) * growth * inside);
    rate = number + growth * inside;
  }
  const T angle = T(kTurn) * turns + work.value(feature.phase);
  return {sin(angle), T(kTurn) * rate * cos(angle)};
}

/// A feature of height 1 as a course along the road.
template <class T>
Course<T> feature_course(const ForceWork<T>& work, const RoadFeature& feature, const T& x) {
  using Kind = RoadFeature::Kind;
  using std::cos, std::sin;
  const T u = x - work.value(feature.from);
  if (feature.kind == Kind::bump) {
    const T pi_per_length = T(std::numbers::pi) / work.value(*feature.length);
    const T angle = within(pi_per_length * u, T(0.0), T(std::numbers::pi));
    const T sine = sin(angle);
    return {sine * sine, T(2.0) * pi_per_length * sine * cos(angle)};
  }
  const bool is_wave = feature.kind == Kind::sine || feature.kind == Kind::sweep;
  if (!feature.length) return wave_course(work, feature, u);
  Course<T> plank = plank_course(u, work.value(*feature.length), feature.ramp);
  if (!is_wave) return feature.kind == Kind::plank ? plank : Course<T>{-plank.value, -plank.slope};
  const Course<T> wave = wave_course(work, feature, u);
  return {plank.value * wave.value, plank.value * wave.slope + plank.slope * wave.value};
}

/// `inside` where y lies between the sides of a stretch, else `outside`.
template <class T>
T between_sides(const ForceWork<T>& work, const RoadStretch& stretch, const T& y, const T& inside, const T& outside) {
  using mbgen::select;
  T value = inside;
  if (stretch.left) value = select(work.value(*stretch.left) - y, value, outside);
  if (stretch.right) value = select(y - work.value(*stretch.right), value, outside);
  return value;
}

template <class T>
RoadHeight<T> feature_height(const ForceWork<T>& work, const RoadFeature& feature, const T& x, const T& y) {
  const Course<T> course = feature_course(work, feature, x);
  const T height = between_sides(work, feature, y, work.value(feature.height), T(0.0));
  return {height * course.value, height * course.slope, T(0.0)};
}

/// The uniform B-splines of degree 3 at 0 <= t <= 1 and their derivatives.
template <class T>
struct SplineWeights {
  T value[4], slope[4];
};

template <class T>
SplineWeights<T> spline_weights(const T& t) {
  const T s = T(1.0) - t, tt = t * t, ss = s * s, sixth = T(1.0 / 6);
  SplineWeights<T> w;
  w.value[0] = sixth * (ss * s);
  w.value[3] = sixth * (tt * t);
  w.value[1] = T(2.0 / 3) + tt * (T(0.5) * t - T(1.0));
  w.value[2] = T(2.0 / 3) + ss * (T(0.5) * s - T(1.0));
  w.slope[0] = T(-0.5) * ss;
  w.slope[3] = T(0.5) * tt;
  w.slope[1] = t * (T(1.5) * t - T(2.0));
  w.slope[2] = s * (T(2.0) - T(1.5) * s);
  return w;
}

/// Height of the tracks of a road, in its axes.
template <class T>
RoadHeight<T> tracks_height(const ForceWork<T>& work, const RoadTracks& tracks, const T& x, const T& y) {
  using mbgen::select;
  using std::floor;
  const double last = tracks.count - 1;
  const T u = T(1 / tracks.spacing) * (x - T(tracks.from));
  const T place =
      tracks.is_periodic ? T(u - T(tracks.count) * floor(T(1.0 / tracks.count) * u)) : within(u, T(0.0), T(last));
  const T whole = floor(place);
  const SplineWeights<T> w = spline_weights(T(place - whole));
  Course<T> sides[2];  // right, left
  for (int side = 0; side < 2; ++side)
    for (int k = 0; k < 4; ++k) {
      const T c = sample(*work.system.model.samples, T(T(2.0) * whole + T(tracks.first + 2 * k + side)));
      sides[side].value = sides[side].value + w.value[k] * c;
      sides[side].slope = sides[side].slope + w.slope[k] * c;
    }
  const double width = tracks.left - tracks.right;
  const T raw = T(1 / width) * (y - T(tracks.right)), share = within(raw, T(0.0), T(1.0));
  const T rise = sides[1].value - sides[0].value;
  const T along = T(1 / tracks.spacing) * (sides[0].slope + share * (sides[1].slope - sides[0].slope));
  const auto in_range = [](const T& value, const T& at, double most) {
    return T(select(at, T(select(T(most) - at, value, T(0.0))), T(0.0)));
  };
  return {sides[0].value + share * rise, tracks.is_periodic ? along : in_range(along, u, last),
          in_range(T(T(1 / width) * rise), raw, 1)};
}

/// Height above the plane of the road's origin, in the road's axes.
template <class T>
RoadHeight<T> height_of_road(const ForceWork<T>& work, const Road& road, const T& x, const T& y) {
  RoadHeight<T> height{T(0.0), work.value(road.slope_x), work.value(road.slope_y)};
  if (road.height) {
    using S = Slope<T>;
    const S along = with_locals(work, *road.height, S(x, T(1.0)), S(y));
    const T across = with_locals(work, *road.height, S(x), S(y, T(1.0))).slope;
    height = height + RoadHeight<T>{along.value, along.slope, across};
  }
  for (const RoadTracks& tracks : road.tracks) height = height + tracks_height(work, tracks, x, y);
  for (const RoadGrid& grid : road.grids) height = height + grid_height(*work.system.model.samples, grid, x, y);
  for (const RoadFeature& feature : road.features) height = height + feature_height(work, feature, x, y);
  return height;
}

/// Factor of the friction of tyres.
template <class T>
T friction_of_road(const ForceWork<T>& work, const Road& road, const T& x, const T& y) {
  using mbgen::select;
  T friction = road.friction ? with_locals(work, *road.friction, x, y) : T(1.0);
  for (const RoadPatch& patch : road.patches) {
    const T outside = friction, u = x - work.value(patch.from);
    friction = between_sides(work, patch, y, work.value(patch.friction), outside);
    if (!patch.length) continue;
    friction = select(work.value(*patch.length) - u, friction, outside);
    friction = select(u, friction, outside);
  }
  return friction;
}

/// A place in the axes of a road, m.
template <class T>
struct RoadPosition {
  T x, y;
};

/// A global place in the axes of a road.
template <class T>
RoadPosition<T> on_road(const Road& road, const T& x, const T& y) {
  const T cosine(std::cos(road.heading)), sine(std::sin(road.heading));
  const T dx = x - T(road.origin[0]), dy = y - T(road.origin[1]);
  return {cosine * dx + sine * dy, cosine * dy - sine * dx};
}

}  // namespace detail
}  // namespace mbgen
