#pragma once
// Geometry of ropes: lengths by angles of tangents; their derivatives by motions of the bodies from complex steps.

#include <complex>
#include <limits>

#include "compiler/model/moving.hpp"
#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

using Complex = std::complex<double>;
using Complex3 = Eigen::Matrix<Complex, 3, 1>;

/// Imaginary part of a step: far below rounding, since no difference is taken.
constexpr double kRopeStep = 1e-40;
/// rad, see kLargestRopeTurn of the formulation.
constexpr double kFarRopeTurn = 3;
/// m: a leg that is shorter has no direction.
constexpr double kShortestLeg = 1e-12;

/// Without conjugation, unlike Eigen's.
inline Complex product(const Complex3& a, const Complex3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
inline Complex3 across(const Complex3& a, const Complex3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}
inline Complex length_of(const Complex3& a) { return std::sqrt(product(a, a)); }

/// The angle of a point of a plane, with the derivative of its real value.
inline Complex angle_of(const Complex& y, const Complex& x) {
  const double square = x.real() * x.real() + y.real() * y.real();
  return {std::atan2(y.real(), x.real()), (x.real() * y.imag() - y.real() * x.imag()) / square};
}

/// An angle, less whole turns, near another one; not a number far from it.
inline Complex near(const Complex& angle, double middle) {
  const Complex result = angle - 2 * M_PI * std::round((angle.real() - middle) / (2 * M_PI));
  return std::abs(result.real() - middle) > kFarRopeTurn ? Complex(std::numeric_limits<double>::quiet_NaN()) : result;
}

/// A station at an instant, moved by an imaginary motion of the bodies.
struct MovedStation {
  Complex3 centre, axis, first, second;  ///< two directions across the axis
  Complex radius, turned;                ///< signed by the rope's sense; rad, of the wheel
  Complex3 arrives, leaves;              ///< directions at the reference, as the carrier has them
  Complex in = 0, out = 0;               ///< rad: the rope's direction where it meets and leaves the circle
  bool is_circle = false;

  Complex angle(const Complex3& direction) const {
    return angle_of(product(direction, second), product(direction, first));
  }
  Complex3 touch(const Complex& at) const { return centre + radius * (std::sin(at) * first - std::cos(at) * second); }
};

/// Motion of each body: velocity of its centre of mass, and spin.
using Motions = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

/// A rope in one configuration of the bodies.
struct RopeInSpace {
  const AtWork& at;
  const Rope& rope;
  const std::vector<Moving>& bodies;
  bool is_reference = false;

  int index(int model_body) const { return at.c.parts.index_of[static_cast<std::size_t>(model_body)]; }

  std::vector<MovedStation> stations(const Motions& motions) const {
    std::vector<MovedStation> list;
    for (const RopeStation& station : rope.path) {
      MovedStation moved;
      const Place place = place_of(at.c.parts, station.at, at.value);
      const auto own = static_cast<std::size_t>(place.body), on = static_cast<std::size_t>(index(station.carrier));
      const Eigen::Vector3d arm = bodies[own].axes * place.arm;
      moved.centre = moving(bodies[own].position + arm, motions[own].first + motions[own].second.cross(arm));
      const auto carried_by = [&](std::size_t body, const Vector3& global) {
        const Eigen::Vector3d seen(global[0], global[1], global[2]);
        const Eigen::Vector3d now = bodies[body].axes * at.c.parts.bodies[body].axes.transpose() * seen;
        return moving(now, motions[body].second.cross(now));
      };
      moved.axis = carried_by(own, station.axis);  // the rope tilts its wheel, whose joint tilts the carrier
      moved.arrives = carried_by(on, station.arrives);
      moved.leaves = carried_by(on, station.leaves);
      const Eigen::Vector3d axis = moved.axis.real();
      int least = 0;
      axis.cwiseAbs().minCoeff(&least);
      moved.first = across(moved.axis, Complex3(Eigen::Vector3d::Unit(least).cast<Complex>()));
      moved.first /= length_of(moved.first);
      moved.second = across(moved.axis, moved.first);
      moved.is_circle = station.is_circle();
      moved.radius = station.kind == RopeStation::Kind::point ? 0.0 : station.sense * at.value(station.radius);
      if (station.has_wheel() && station.separates())
        moved.turned = {is_reference ? 0.0 : station.wheel_sense * at.value.position(station.wheel),
                        kRopeStep * axis.dot(motions[own].second - motions[on].second)};
      list.push_back(moved);
    }
    return list;
  }

  static Complex3 moving(const Eigen::Vector3d& value, const Eigen::Vector3d& rate) {
    return value.cast<Complex>() + Complex(0, kRopeStep) * rate.cast<Complex>();
  }
};

/// Angle of the rope on a circle whose neighbour lies along `line`, at a distance `offset` from the other tangent.
inline Complex tangent_angle(const MovedStation& s, const Complex3& line, const Complex& offset) {
  const Complex3 flat = line - product(line, s.axis) * s.axis;
  const Complex sine = offset / length_of(flat);
  if (!(std::abs(sine.real()) <= 1)) return std::numeric_limits<double>::quiet_NaN();  // within the circle
  return s.angle(flat) + std::asin(sine);
}

inline Complex straight_length(MovedStation& a, MovedStation& b) {
  const Complex3 line = b.centre - a.centre;
  const Complex cosine = a.is_circle && b.is_circle ? product(a.axis, b.axis) : 1.0;
  const Complex ra = a.is_circle ? a.radius : 0.0, rb = b.is_circle ? b.radius : 0.0;
  if (a.is_circle) a.out = tangent_angle(a, line, ra - cosine * rb);
  if (b.is_circle) b.in = tangent_angle(b, line, cosine * ra - rb);
  return length_of((b.is_circle ? b.touch(b.in) : b.centre) - (a.is_circle ? a.touch(a.out) : a.centre));
}

/// Length over an obstacle; wrap: on it, not a number for an end within the obstacle.
inline Complex length_over(const RopeStation& station, const MovedStation& a, const MovedStation& c,
                           const MovedStation& b, double& wrap) {
  const Complex3 p = a.centre - c.centre, q = b.centre - c.centre, line = b.centre - a.centre;
  const bool is_sphere = station.kind == RopeStation::Kind::sphere;
  const auto flat = [&](const Complex3& v) { return is_sphere ? v : Complex3(v - product(v, c.axis) * c.axis); };
  const Complex dp = length_of(flat(p)), dq = length_of(flat(q)),
                radius = static_cast<double>(station.sense) * c.radius;
  const Complex free = std::acos(radius / dp) + std::acos(radius / dq);
  const Complex about =
      is_sphere ? std::acos(product(p, q) / (dp * dq))
                : near(static_cast<double>(station.sense) * (c.angle(flat(q)) - c.angle(flat(p))), station.wrap);
  const bool is_outside = dp.real() >= radius.real() && dq.real() >= radius.real();
  wrap = is_outside ? (about - free).real() : std::numeric_limits<double>::quiet_NaN();
  if (wrap < 0) wrap = 0;
  if (!(about.real() >= free.real()) && !std::isnan(about.real())) return length_of(line);
  const Complex wound =
      dp * std::sin(std::acos(radius / dp)) + dq * std::sin(std::acos(radius / dq)) + radius * (about - free);
  const Complex height = is_sphere ? 0.0 : product(line, c.axis);
  return std::sqrt(wound * wound + height * height);
}

/// Spans of a rope in space, per span; wraps per station.
struct SpansInSpace {
  std::vector<Complex> length, reach;
  std::vector<double> wrap, least;
  std::vector<double> wraps;
  std::vector<double> rooms;  ///< per leg, negative or NaN where the rope has no way
};

inline SpansInSpace spans_in_space(const RopeInSpace& space, const Motions& motions) {
  const Rope& rope = space.rope;
  std::vector<MovedStation> stations = space.stations(motions);
  const auto count = static_cast<std::size_t>(rope.spans);
  SpansInSpace spans{
      std::vector<Complex>(count),          std::vector<Complex>(count),           std::vector<double>(count),
      std::vector<double>(count, HUGE_VAL), std::vector<double>(rope.path.size()), {}};
  const std::vector<RopeLeg> legs = legs_of(rope);
  for (const RopeLeg& leg : legs) {
    const auto g = static_cast<std::size_t>(leg.span);
    if (leg.over < 0) {
      const Complex straight = straight_length(stations[leg.from], stations[leg.to]);
      spans.length[g] += straight;
      spans.rooms.push_back(straight.real() - kShortestLeg);
      continue;
    }
    const auto over = static_cast<std::size_t>(leg.over);
    spans.length[g] +=
        length_over(rope.path[over], stations[leg.from], stations[over], stations[leg.to], spans.wraps[over]);
    spans.wrap[g] += spans.wraps[over];
    spans.rooms.push_back(spans.wraps[over]);
  }
  for (const RopeLeg& leg : legs) {
    const auto g = static_cast<std::size_t>(leg.span);
    const RopeStation &from = rope.path[leg.from], &to = rope.path[leg.to];
    const MovedStation &a = stations[leg.from], &b = stations[leg.to];
    if (from.separates()) spans.reach[g] += a.radius * (near(a.out - a.angle(a.leaves), 0) - a.turned);
    if (to.separates()) spans.reach[g] -= b.radius * (near(b.in - b.angle(b.arrives), 0) - b.turned);
    if (to.kind != RopeStation::Kind::pulley) continue;
    const Complex wrap = near(static_cast<double>(to.sense) * (b.out - b.in), to.wrap);
    spans.wraps[leg.to] = wrap.real();
    spans.wrap[g] += wrap.real();
    spans.least[g] = std::min(spans.least[g], wrap.real());
    if (!to.separates()) spans.length[g] += static_cast<double>(to.sense) * b.radius * wrap;
  }
  for (std::size_t g = 0; g < count; ++g) spans.reach[g] += spans.length[g];
  return spans;
}

}  // namespace mbgen::cartesian
