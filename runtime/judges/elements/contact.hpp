#pragma once
// Contacts: nearest points of surfaces by cases, and their law, in global axes.

#include <Eigen/Geometry>

#include "mbgen/solver/bristle.hpp"
#include "runtime/judges/elements/bump_stop.hpp"
#include "runtime/judges/road_surface.hpp"

namespace mbgen::cartesian {

/// A contact at one instant, global axes.
struct ContactAtWork {
  Eigen::Vector3d point, normal, friction = Eigen::Vector3d::Zero();  ///< m, 1, N on the body of `from`
  double penetration = 0, rate = 0, slip = 0, force = 0;              ///< m, m/s, m/s, N along the normal
  Eigen::Vector2d xd = Eigen::Vector2d::Zero();                       ///< m/s, of the bristles
};

/// Distance of a point from a surface, m, and the direction away from it.
struct NearestPoint {
  double distance = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double friction = 1;
};

/// To a box of these half edges, in its axes.
inline NearestPoint nearest_on_box(const Eigen::Vector3d& at, const Eigen::Vector3d& half) {
  const Eigen::Vector3d on_box = at.cwiseMax(-half).cwiseMin(half), gap = at - on_box;
  if (gap.norm() > 1e-12) return {gap.norm(), gap.normalized()};
  Eigen::Index face = 0;
  const double depth = (half - at.cwiseAbs()).minCoeff(&face);
  return {-depth, Eigen::Vector3d::Unit(face) * (at[face] < 0 ? -1 : 1)};
}

/// To a cylinder about z, infinite without a length: in the half plane of the point a rectangle.
inline NearestPoint nearest_on_cylinder(const Eigen::Vector3d& at, double radius, const std::optional<double>& length) {
  const double around = std::hypot(at.x(), at.y());
  const Eigen::Vector3d out = Eigen::Vector3d(at.x(), at.y(), 0) / around;
  if (!length) return {around - radius, out};
  const NearestPoint in_plane = nearest_on_box({around, 0, at.z()}, {radius, 1e300, *length / 2});
  return {in_plane.distance, in_plane.normal.x() * out + in_plane.normal.z() * Eigen::Vector3d::UnitZ()};
}

/// To a road: the plane that touches it below the foot of the perpendicular on the plane that touches it below.
inline NearestPoint nearest_on_road(const SurfaceContact& contact, const Eigen::Vector3d& at, const Values& value) {
  Tyre probe;
  probe.road = contact.road;
  NearestPoint nearest;
  Eigen::Vector3d below = at;
  for (int look = 0; look < 2; ++look) {
    const RoadSurface road = road_surface(probe, below.head<2>(), Eigen::Vector3d::UnitY(), value);
    nearest.normal = Eigen::Vector3d(-road.gradient.x(), -road.gradient.y(), 1).normalized();
    nearest.distance = nearest.normal.dot(at - Eigen::Vector3d(below.x(), below.y(), road.height));
    nearest.friction = road.friction;
    below = at - nearest.distance * nearest.normal;
  }
  return nearest;
}

/// The shape's axes (columns, global).
inline Eigen::Matrix3d contact_axes(const AtWork& at, const SurfaceContact& contact) {
  const Eigen::Matrix3d axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(contact.axes.data());
  if (contact.shape == SurfaceContact::Shape::road) return Eigen::Matrix3d::Identity();
  const int body = part_of(at, contact).to.body;
  return at.bodies[body].axes * at.c.parts.bodies[static_cast<std::size_t>(body)].axes.transpose() * axes;
}

/// gap: of the centre from the point of the other body, in the shape's axes; on a road global.
inline NearestPoint nearest_of(const SurfaceContact& contact, const Eigen::Vector3d& gap, const Values& value) {
  const auto half = [&](int i) { return value(contact.size[static_cast<std::size_t>(i)]) / 2; };
  switch (contact.shape) {
    case SurfaceContact::Shape::road:
      return nearest_on_road(contact, gap, value);
    case SurfaceContact::Shape::sphere:
      return {gap.norm() - value(contact.other_radius), gap.normalized()};
    case SurfaceContact::Shape::cylinder: {
      std::optional<double> length;
      if (contact.length) length = value(*contact.length);
      return nearest_on_cylinder(gap, value(contact.other_radius), length);
    }
    case SurfaceContact::Shape::box:
      return nearest_on_box(gap, {half(0), half(1), half(2)});
    default:
      return {gap.z(), Eigen::Vector3d::UnitZ()};
  }
}

/// The rotation that takes one direction to another by the shortest way.
inline Eigen::Matrix3d shortest_turn_to(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

/// Axes of the bristles along the surface, in the shape's axes.
inline Eigen::Matrix<double, 3, 2> bristle_axes(const SurfaceContact& contact, const Eigen::Vector3d& normal) {
  const bool is_shape = contact.shape >= SurfaceContact::Shape::sphere;
  const Eigen::Vector3d pole = is_shape ? Eigen::Vector3d(0.48, 0.6, 0.64) : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d first = is_shape ? Eigen::Vector3d(0.8, 0, -0.6) : Eigen::Vector3d::UnitX();
  Eigen::Matrix<double, 3, 2> axes;
  axes << first, pole.cross(first);
  return shortest_turn_to(pole, normal) * axes;
}

/// Friction per N of normal force against a sliding velocity, of bristles with a deflection, and its rate.
inline void rub(const SurfaceContact& contact, const Values& value, const Eigen::Vector2d& velocity,
                const Eigen::Vector2d& deflection, Eigen::Vector2d& force, Eigen::Vector2d& rate) {
  const double mu = value(contact.friction), mu_static = value(contact.stiction), bristle = value(contact.bristle);
  const double fading = std::exp(-std::pow(velocity.norm() / value(contact.stribeck_velocity), 2));
  const double limit = mu + (mu_static - mu) * fading;
  const double end = contact.has_stiction() ? bristle * limit / mu_static : bristle;
  const double lag = *contact.lag, elastic = value(contact.elastic);
  rate = velocity;
  if (lag * velocity.norm() > end) rate *= end / (lag * velocity.norm());
  const double share = deflection.norm() / end;
  if (share > elastic && rate.dot(deflection) > 0) {
    const double s = std::min((share - elastic) / (1 - elastic), 1.0);
    const Eigen::Vector2d along = deflection.normalized();
    rate -= s * s * (3 - 2 * s) * share * along.dot(rate) * along;
  }
  force = -mu_static / bristle * (deflection + value(contact.bristle_damping) * rate);
  const double most = std::max(limit, mu_static / bristle * deflection.norm());  // damping adds nothing beyond it
  if (force.norm() > most) force *= most / force.norm();
}

inline ContactAtWork contact_at_work(const AtWork& at, const SurfaceContact& contact) {
  const ElementPart& part = part_of(at, contact);
  const End centre = end_of(at.bodies, part.from);
  const bool is_road = contact.shape == SurfaceContact::Shape::road;
  const Eigen::Vector3d origin =
      is_road ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : end_of(at.bodies, part.to).position;
  const Eigen::Matrix3d axes = contact_axes(at, contact);
  const NearestPoint nearest = nearest_of(contact, axes.transpose() * (centre.position - origin), at.value);
  ContactAtWork work;
  work.normal = axes * nearest.normal;
  work.penetration = at.value(contact.radius) - nearest.distance;
  work.point = centre.position - (at.value(contact.radius) - work.penetration / 2) * work.normal;
  Eigen::Vector3d sliding = centre.velocity + centre.spin.cross(work.point - centre.position);
  if (!is_road) {
    const Moving& other = at.bodies[part.to.body];
    sliding -= other.velocity + other.spin.cross(work.point - other.position);
  }
  work.rate = -work.normal.dot(sliding);
  work.force = stop_force(contact.push, at.value, work.penetration, work.rate);
  if (!contact.has_friction()) return work;
  const Eigen::Matrix<double, 3, 2> along = axes * bristle_axes(contact, nearest.normal);
  const auto first = state_of_element(at.c.model, contact);
  const Eigen::Vector2d slip = along.transpose() * sliding, deflection(at.x[first], at.x[first + 1]);
  work.slip = slip.norm();
  const double lag = *contact.lag;
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  rub(contact, at.value, slip, deflection, force, work.xd);
  if (work.penetration <= 0) work.xd = -deflection / (4 * (lag > 0 ? lag : kShortestBristleLag));
  work.friction = nearest.friction * work.force * (along * force);
  return work;
}

inline void apply(const AtWork& at, const SurfaceContact& contact, Forces& forces) {
  const ContactAtWork work = contact_at_work(at, contact);
  const ElementPart& part = part_of(at, contact);
  const auto add = [&](int body, const Eigen::Vector3d& force) {
    const Eigen::Vector3d arm = work.point - at.bodies[body].position;
    forces.loads.push_back({body, (Vector6d() << force, arm.cross(force)).finished()});
  };
  const Eigen::Vector3d force = work.force * work.normal + work.friction;
  add(part.from.body, force);
  if (contact.shape != SurfaceContact::Shape::road) add(part.to.body, -force);
  if (!contact.has_friction()) return;
  const auto first = state_of_element(at.c.model, contact);
  for (Eigen::Index i = 0; i < 2; ++i) forces.xd[first + static_cast<std::size_t>(i)] = work.xd[i];
}

inline double shown(const AtWork& at, const Forces&, const SurfaceContact& contact, int quantity, int axis) {
  const ContactAtWork work = contact_at_work(at, contact);
  const double scalars[] = {work.force, work.friction.norm(), work.penetration, work.rate, work.slip};
  constexpr int kScalars = 5;
  return quantity < kScalars ? scalars[quantity] : (work.force * work.normal + work.friction)[axis];
}

inline double energy_of(const AtWork& at, const SurfaceContact& contact) {
  const double depth = contact_at_work(at, contact).penetration;
  if (depth <= 0) return 0;
  // Work of a power law: final force times penetration, over the exponent plus one.
  return stop_force(contact.push, at.value, depth, 0) * depth / (contact.push.exponent + 1);
}

}  // namespace mbgen::cartesian
