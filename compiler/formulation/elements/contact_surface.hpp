#pragma once
// Surfaces of contacts: distance of a point from them, and their axes at the nearest point. No search, no branches on
// values.

#include <cmath>

#include "compiler/formulation/elements/seen_place.hpp"
#include "compiler/formulation/roads/road.hpp"

namespace mbgen {
namespace detail {

/// m: beyond it a point counts as outside of an edge, and its direction counts.
inline constexpr double kOutside = 1e-12;

/// A surface near a point, in the axes of its body.
template <class T>
struct ContactSurface {
  T distance{0.0};          ///< m, negative inside
  Vector<T> normal;         ///< unit, out of the body at the nearest point
  Vector<T> first, second;  ///< unit, along the surface
  T friction{1.0};          ///< factor of the coefficients
};

/// Directions without trigonometry: the shortest turn from `pole` to `normal`, applied to a perpendicular of `pole`. It
/// jumps where the normal is opposite to the pole, and nowhere else. All unit vectors.
template <class T>
Vector<T> turned_with(const Vector<T>& normal, const Vector<T>& pole, const Vector<T>& across) {
  using mbgen::max;
  const T along = max(T(1.0) + dot(pole, normal), T(kOutside));
  return across - (dot(across, normal) / along) * (pole + normal);
}

/// Length of a vector, not zero.
template <class T>
T safe_length(const T& squares) {
  using std::sqrt;
  return sqrt(squares + T(1e-6 * kOutside * kOutside));
}

/// Distance from a body of several slabs, of the point at `beyond` from each of them, m: outside of it the distance
/// from the nearest face, edge or corner, inside from the nearest face. share: derivative of the distance by each.
template <class T, std::size_t count>
T distance_from_slabs(const std::array<T, count>& beyond, std::array<T, count>& share) {
  using mbgen::max, mbgen::min, mbgen::select;
  T farthest = beyond[0], squares(0.0);
  for (std::size_t i = 1; i < count; ++i) farthest = max(farthest, beyond[i]);
  std::array<T, count> outside;
  for (std::size_t i = 0; i < count; ++i) {
    outside[i] = max(beyond[i], T(0.0));
    squares = squares + outside[i] * outside[i];
  }
  const T length = safe_length(squares), is_outside = farthest - T(kOutside);
  T not_taken(1.0);
  for (std::size_t i = 0; i < count; ++i) {
    const T is_nearest = i + 1 < count ? T(select(beyond[i] - farthest, not_taken, T(0.0))) : not_taken;
    not_taken = not_taken - is_nearest;
    share[i] = select(is_outside, outside[i] / length, is_nearest);
  }
  return select(is_outside, length, farthest);
}

/// Of a sphere, cylinder or box, in its axes. at: of the point.
template <class T>
ContactSurface<T> surface_of_shape(const ForceWork<T>& work, const SurfaceContact& contact, const Vector<T>& at) {
  using mbgen::abs, mbgen::select;
  const auto sign = [](const T& x) { return T(select(x, T(1.0), T(-1.0))); };
  const auto value = [&](const Quantity& q, const char* meaning) { return work.value(q, meaning, contact.name); };
  ContactSurface<T> surface;
  if (contact.shape == SurfaceContact::Shape::box) {
    std::array<T, 3> beyond, share;
    const T* place[] = {&at.x, &at.y, &at.z};
    for (std::size_t i = 0; i < 3; ++i)
      beyond[i] = abs(*place[i]) - T(0.5) * value(contact.size[i], i == 0 ? "size_x" : i == 1 ? "size_y" : "size_z");
    surface.distance = distance_from_slabs(beyond, share);
    surface.normal = {share[0] * sign(at.x), share[1] * sign(at.y), share[2] * sign(at.z)};
    return surface;
  }
  const T radius = value(contact.other_radius, "to_radius");
  if (contact.shape == SurfaceContact::Shape::sphere) {
    const T length = safe_length(dot(at, at));
    surface.distance = length - radius;
    surface.normal = (T(1.0) / length) * at;
    return surface;
  }
  const T around = safe_length(at.x * at.x + at.y * at.y);
  std::array<T, 2> beyond{around - radius, T(0.0)}, share{T(1.0), T(0.0)};
  surface.distance = beyond[0];
  if (contact.length) {
    beyond[1] = abs(at.z) - T(0.5) * value(*contact.length, "length");
    surface.distance = distance_from_slabs(beyond, share);
  }
  surface.normal = {share[0] * at.x / around, share[0] * at.y / around, share[1] * sign(at.z)};
  return surface;
}

/// The plane that touches a road vertically below a place, global.
template <class T>
ContactSurface<T> road_below(const ForceWork<T>& work, const Road& road, const Vector<T>& below,
                             const Vector<T>& point) {
  using std::sqrt;
  const auto [x, y] = on_road(road, below.x, below.y);
  const T cosine(std::cos(road.heading)), sine(std::sin(road.heading));
  const RoadHeight<T> height = height_of_road(work, road, x, y);
  const T by_x = cosine * height.by_x - sine * height.by_y, by_y = sine * height.by_x + cosine * height.by_y;
  const T steepness = T(1.0) / sqrt(T(1.0) + by_x * by_x + by_y * by_y);
  ContactSurface<T> surface;
  surface.normal = {-(steepness * by_x), -(steepness * by_y), steepness};
  surface.distance = dot(surface.normal, point - Vector<T>{below.x, below.y, T(road.origin[2]) + height.z});
  surface.friction = friction_of_road(work, road, x, y);
  return surface;
}

/// The surface of a contact near the centre of the sphere. gap: of the centre from the point of the other body, or from
/// the global origin, in the axes of the body. A road is looked at below the centre, then below the foot of the
/// perpendicular found there: with the road's curvature c (1/m) and the radius r of the sphere, the distance errs by
/// terms of (r c)^2 times the slope's change.
template <class T>
ContactSurface<T> contact_surface(const ForceWork<T>& work, const SurfaceContact& contact, const Vector<T>& gap) {
  ContactSurface<T> surface;
  const Matrix<T> axes = pose_rotation<T>(Pose{{}, contact.axes});
  if (contact.shape == SurfaceContact::Shape::plane) {
    surface.distance = dot(axes.z, gap);
    surface.normal = axes.z, surface.first = axes.x, surface.second = axes.y;
    return surface;
  }
  if (contact.shape == SurfaceContact::Shape::road) {
    const Road& road = work.system.model.roads[static_cast<std::size_t>(contact.road)];
    surface = road_below(work, road, gap, gap);
    if (!road.is_level() || !road.features.empty())
      surface = road_below(work, road, gap - surface.distance * surface.normal, gap);
    const Vector<T> up{T(0.0), T(0.0), T(1.0)};
    surface.first = turned_with(surface.normal, up, Vector<T>{T(1.0), T(0.0), T(0.0)});
    surface.second = turned_with(surface.normal, up, Vector<T>{T(0.0), T(1.0), T(0.0)});
    return surface;
  }
  surface = surface_of_shape(work, contact, transposed_times(axes, gap));
  // A pole across no face and no plane of symmetry of the shapes.
  const Vector<T> pole{T(0.48), T(0.6), T(0.64)}, across{T(0.8), T(0.0), T(-0.6)};
  const Vector<T> normal = surface.normal;
  surface.normal = axes * normal;
  if (!contact.has_friction()) return surface;
  surface.first = axes * turned_with(normal, pole, across);
  surface.second = axes * turned_with(normal, pole, cross(pole, across));
  return surface;
}

}  // namespace detail
}  // namespace mbgen
