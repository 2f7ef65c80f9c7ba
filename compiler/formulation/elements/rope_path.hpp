#pragma once
// Geometry of ropes: tangents between circles in space, wraps on cylinders and spheres, and the loads of a tension
// of 1.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/formulation/vector.hpp"
#include "compiler/model/model.hpp"

namespace mbgen::detail {

/// rad: directions that have turned further, about an axis, than this from the reference are not counted.
inline constexpr double kLargestRopeTurn = 3;

/// A station of a rope, in some axes; radius: positive where the rope runs round in the positive sense, 0 for a point.
template <class T>
struct RopePlace {
  Vector<T> centre, axis;
  T radius{0.0};
  bool is_circle = false;
};

/// Force and moment about the centre of a station, for a tension of 1 N.
template <class T>
struct RopePull {
  Vector<T> force, moment;
};

/// The line from the centre of one circle to the other in the plane of one of them, and the rope's direction there.
template <class T>
struct RopeTangent {
  Vector<T> across;        ///< p: the line in the plane, m
  T square, offset, root;  ///< p.p; a: distance of the rope from it; sqrt(p.p - a a)
  Vector<T> direction;     ///< unit
  /// sensitivity of the direction's angle to the line: dangle = turning . dline
  Vector<T> turning(const Vector<T>& axis) const {
    return (T(1.0) / square) * (cross(axis, across) - (offset / root) * across);
  }
};

template <class T>
RopeTangent<T> rope_tangent(const Vector<T>& line, const Vector<T>& axis, const T& offset) {
  using std::sqrt;
  RopeTangent<T> t;
  t.across = line - dot(line, axis) * axis;
  t.square = dot(t.across, t.across);
  t.offset = offset;
  t.root = sqrt(t.square - offset * offset);
  t.direction = (T(1.0) / t.square) * (t.root * t.across + offset * cross(axis, t.across));
  return t;
}

/// Angle from one direction to another about an axis, near `middle`; not a number where it is kLargestRopeTurn off.
/// length: of the product of both.
template <class T>
T rope_angle(const Vector<T>& axis, const Vector<T>& from, const Vector<T>& to, double middle, const T& length) {
  using mbgen::select;
  using std::atan2, std::sqrt;
  const auto exact = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
  const T c(exact(std::cos(middle))), s(exact(std::sin(middle)));
  const T cosine = dot(from, to), sine = dot(axis, cross(from, to));
  const T turned_cosine = cosine * c + sine * s, turned_sine = sine * c - cosine * s;
  const T within = turned_cosine - T(std::cos(kLargestRopeTurn)) * length;
  return T(middle) + select(within, T(atan2(turned_sine, turned_cosine)), T(sqrt(within)));
}

/// m: a straight piece that is shorter has no direction.
inline constexpr double kShortestRopePiece = 1e-12;

/// A straight piece of a rope between two stations, or one over an obstacle.
template <class T>
struct RopePiece {
  T length{0.0};              ///< m
  Vector<T> leaves, arrives;  ///< unit, in the planes of the circles
  T wrap{0.0};                ///< rad, on an obstacle
  T room{0.0};                ///< negative, or NaN, where there is no such piece
};

/// Whether a tangent of two circles lies in the plane of both by structure.
template <class T>
bool is_plane(const RopePlace<T>& a, const RopePlace<T>& b, const Vector<T>& line) {
  const auto in_plane = [&](const RopePlace<T>& p) { return !p.is_circle || is_zero(dot(line, p.axis)); };
  if (!in_plane(a) || !in_plane(b)) return false;
  if (!a.is_circle || !b.is_circle) return true;
  const Vector<T> tilt = cross(a.axis, b.axis);
  return is_zero(tilt.x) && is_zero(tilt.y) && is_zero(tilt.z);
}

/// Piece between two points or circles. Each tangent point is where the other circle's projection into the plane says;
/// loads are the derivatives of the length, so that a constant tension does no work along closed ways. For a rope that
/// leaves the plane by an angle, they differ from the rope's direction by the square of it.
template <class T>
RopePiece<T> straight_piece(const RopePlace<T>& a, const RopePlace<T>& b, RopePull<T>& on_a, RopePull<T>& on_b) {
  const Vector<T> line = b.centre - a.centre;
  RopePiece<T> piece;
  if (!a.is_circle && !b.is_circle) {
    piece.length = norm(line);
    piece.leaves = piece.arrives = (T(1.0) / piece.length) * line;
    on_a.force = on_a.force + piece.leaves;
    on_b.force = on_b.force - piece.leaves;
    return piece;
  }
  const bool both = a.is_circle && b.is_circle;
  const T cosine = both ? dot(a.axis, b.axis) : T(1.0);
  std::optional<RopeTangent<T>> at_a, at_b;
  if (a.is_circle) at_a = rope_tangent(line, a.axis, both ? a.radius - cosine * b.radius : a.radius);
  if (b.is_circle) at_b = rope_tangent(line, b.axis, both ? cosine * a.radius - b.radius : -b.radius);
  if (is_plane(a, b, line)) {
    const RopeTangent<T>& one = at_a ? *at_a : *at_b;
    piece.length = one.root;
    piece.leaves = piece.arrives = one.direction;
    on_a.force = on_a.force + one.direction;
    on_b.force = on_b.force - one.direction;
    if (at_a) on_a.moment = on_a.moment + a.radius * a.axis;
    if (at_b) on_b.moment = on_b.moment - b.radius * b.axis;
    return piece;
  }
  const auto arm = [](const RopePlace<T>& p, const std::optional<RopeTangent<T>>& t) {
    return t ? p.radius * cross(t->direction, p.axis) : Vector<T>{};
  };
  const Vector<T> arm_a = arm(a, at_a), arm_b = arm(b, at_b), span = line + arm_b - arm_a;
  piece.length = norm(span);
  const Vector<T> along = (T(1.0) / piece.length) * span;
  piece.leaves = at_a ? at_a->direction : along;
  piece.arrives = at_b ? at_b->direction : along;
  on_a.force = on_a.force + along;
  on_b.force = on_b.force - along;
  on_a.moment = on_a.moment + cross(arm_a, along);
  on_b.moment = on_b.moment - cross(arm_b, along);
  // The tangent points move with the line between the centres and with the tilt of the axes.
  const auto rest = [&](const RopePlace<T>& p, const Vector<T>& direction) {
    return p.radius * (T(1.0) - dot(along, direction));
  };
  T tilting(0.0);
  const auto add = [&](const RopePlace<T>& p, const RopeTangent<T>& t, const T& other, RopePull<T>& own, int way) {
    const T share = rest(p, t.direction);
    const Vector<T> force = (T(way) * share) * t.turning(p.axis);
    on_a.force = on_a.force + force;
    on_b.force = on_b.force - force;
    own.moment = own.moment + cross(line, force);
    if (both) tilting = tilting + share * other / t.root;
  };
  if (at_a) add(a, *at_a, b.radius, on_a, 1);
  if (at_b) add(b, *at_b, a.radius, on_b, -1);
  if (both) {
    const Vector<T> moment = tilting * cross(b.axis, a.axis);
    on_a.moment = on_a.moment - moment;
    on_b.moment = on_b.moment + moment;
  }
  return piece;
}

/// Loads of a piece over an obstacle that pulls its ends along two directions.
template <class T>
void pull_over(const RopePlace<T>& a, const RopePlace<T>& obstacle, const RopePlace<T>& b, const Vector<T>& leaves,
               const Vector<T>& arrives, RopePull<T>& on_a, RopePull<T>& on_it, RopePull<T>& on_b) {
  on_a.force = on_a.force + leaves;
  on_b.force = on_b.force - arrives;
  on_it.force = on_it.force + (arrives - leaves);
  on_it.moment =
      on_it.moment + (cross(b.centre - obstacle.centre, arrives) - cross(a.centre - obstacle.centre, leaves));
}

template <class T>
Vector<T> either(const T& condition, const Vector<T>& a, const Vector<T>& b) {
  using mbgen::select;
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

/// Piece over a cylinder without friction: straight on the developed surface, or beside the cylinder straight in space.
/// middle: angle from one end to the other about its axis, in the rope's sense, at the reference.
template <class T>
RopePiece<T> cylinder_piece(const RopePlace<T>& a, const RopePlace<T>& c, const RopePlace<T>& b, double middle,
                            int sense, RopePull<T>& on_a, RopePull<T>& on_it, RopePull<T>& on_b) {
  using mbgen::select, mbgen::max;
  using std::atan2, std::sqrt;
  const RopeTangent<T> to = rope_tangent(c.centre - a.centre, c.axis, -c.radius);
  const RopeTangent<T> from = rope_tangent(b.centre - c.centre, c.axis, c.radius);
  const T radius = T(sense) * c.radius;
  const T about = rope_angle(T(sense) * c.axis, -to.across, from.across, middle, T(sqrt(to.square * from.square)));
  RopePiece<T> piece;
  const T wrap = about - T(atan2(to.root, radius)) - T(atan2(from.root, radius));
  const Vector<T> line = b.centre - a.centre;
  const T straight = norm(line), height = dot(line, c.axis), plane = to.root + from.root + radius * wrap;
  const T wound = sqrt(plane * plane + height * height);
  const Vector<T> direct = (T(1.0) / straight) * line;
  const auto wound_along = [&](const Vector<T>& u) { return (T(1.0) / wound) * (plane * u + height * c.axis); };
  piece.length = select(wrap, wound, straight);
  piece.leaves = either(wrap, wound_along(to.direction), direct);
  piece.arrives = either(wrap, wound_along(from.direction), direct);
  piece.wrap = max(wrap, T(0.0));
  piece.room = wrap * wrap;
  pull_over(a, c, b, piece.leaves, piece.arrives, on_a, on_it, on_b);
  return piece;
}

/// Piece over a sphere without friction, in the plane of its ends and its centre, or straight beside it.
template <class T>
RopePiece<T> sphere_piece(const RopePlace<T>& a, const RopePlace<T>& c, const RopePlace<T>& b, RopePull<T>& on_a,
                          RopePull<T>& on_it, RopePull<T>& on_b) {
  using mbgen::select, mbgen::max;
  using std::atan2, std::sqrt;
  constexpr double kLeast = 1e-60;  // m^4: no plane
  const Vector<T> p = a.centre - c.centre, q = b.centre - c.centre, normal = cross(p, q);
  const T& radius = c.radius;
  const T pp = dot(p, p), qq = dot(q, q), rr = radius * radius;
  const T size = sqrt(max(dot(normal, normal), T(kLeast))), reciprocal = T(1.0) / size;
  const T to = sqrt(pp - rr), from = sqrt(qq - rr);
  const T wrap = T(atan2(size, dot(p, q))) - T(atan2(to, radius)) - T(atan2(from, radius));
  const Vector<T> line = b.centre - a.centre;
  const T straight = norm(line);
  const Vector<T> direct = (T(1.0) / straight) * line;
  RopePiece<T> piece;
  piece.length = select(wrap, T(to + from + radius * wrap), straight);
  piece.leaves = either(wrap, (T(1.0) / pp) * ((radius * reciprocal) * cross(normal, p) - to * p), direct);
  piece.arrives = either(wrap, (T(1.0) / qq) * (from * q + (radius * reciprocal) * cross(normal, q)), direct);
  piece.wrap = max(wrap, T(0.0));
  piece.room = wrap * wrap;
  pull_over(a, c, b, piece.leaves, piece.arrives, on_a, on_it, on_b);
  return piece;
}

/// One span of tension. reach: length, and the rope on both end circles from where it lay at the reference, m.
template <class T>
struct RopeSpan {
  T length{0.0}, reach{0.0};       ///< m
  T wrap{0.0};                     ///< rad, of all its stations, that at its end too
  std::optional<T> least;          ///< rad, smallest wrap of its pulleys
  std::vector<RopePull<T>> pulls;  ///< per station of the path
};

/// A rope at one configuration.
template <class T>
struct RopeShape {
  std::vector<RopeSpan<T>> spans;
  std::vector<T> wraps;  ///< per station, rad
  std::vector<T> rooms;  ///< per leg, see RopePiece
};

/// The piece of a leg; adds its loads to those of its span.
template <class T>
RopePiece<T> piece_of(const Rope& rope, const RopeLeg& leg, const std::vector<RopePlace<T>>& places,
                      std::vector<RopePull<T>>& pulls) {
  const RopePlace<T>&a = places[leg.from], &b = places[leg.to];
  if (leg.over < 0) {
    RopePiece<T> piece = straight_piece(a, b, pulls[leg.from], pulls[leg.to]);
    piece.room = piece.length - T(kShortestRopePiece);
    return piece;
  }
  const auto over = static_cast<std::size_t>(leg.over);
  const RopeStation& station = rope.path[over];
  return station.kind == RopeStation::Kind::sphere
             ? sphere_piece(a, places[over], b, pulls[leg.from], pulls[over], pulls[leg.to])
             : cylinder_piece(a, places[over], b, station.wrap, station.sense, pulls[leg.from], pulls[over],
                              pulls[leg.to]);
}

/// Adds the wrap of the station at which a leg ends to its span.
template <class T>
void add_wrap(const RopeStation& station, const RopePlace<T>& place, const T& wrap, RopeSpan<T>& span) {
  using mbgen::min;
  if (station.kind != RopeStation::Kind::pulley) return;
  span.wrap = span.wrap + wrap;
  span.least = span.least ? T(min(*span.least, wrap)) : wrap;
  if (station.separates()) return;
  span.length = span.length + T(station.sense) * place.radius * wrap;
}

/// Lays a rope over its stations. arc(station, direction, at_reference): rope on a circle that separates tensions, from
/// its place at the reference to the tangent point, counted along the rope and less the turn of its wheel, m.
template <class T, class Arc>
RopeShape<T> rope_shape(const Rope& rope, const std::vector<RopePlace<T>>& places, const Arc& arc) {
  const std::vector<RopeLeg> legs = legs_of(rope);
  RopeShape<T> shape;
  RopeSpan<T> none;
  none.pulls.resize(rope.path.size());
  shape.spans.assign(static_cast<std::size_t>(rope.spans), none);
  shape.wraps.assign(rope.path.size(), T(0.0));
  std::vector<RopePiece<T>> pieces;
  for (const RopeLeg& leg : legs) {
    pieces.push_back(piece_of(rope, leg, places, shape.spans[static_cast<std::size_t>(leg.span)].pulls));
    shape.rooms.push_back(pieces.back().room);
    if (leg.over >= 0) shape.wraps[static_cast<std::size_t>(leg.over)] = pieces.back().wrap;
  }
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const RopeLeg& leg = legs[k];
    const std::size_t before = (k + legs.size() - 1) % legs.size();
    const RopeStation &from = rope.path[leg.from], &to = rope.path[leg.to];
    if (from.kind == RopeStation::Kind::pulley)
      shape.wraps[leg.from] = rope_angle(T(from.sense) * places[leg.from].axis, pieces[before].arrives,
                                         pieces[k].leaves, from.wrap, T(1.0));
    RopeSpan<T>& span = shape.spans[static_cast<std::size_t>(leg.span)];
    span.length = span.length + pieces[k].length;
    span.wrap = span.wrap + pieces[k].wrap;
    if (from.separates()) span.reach = span.reach + arc(leg.from, pieces[k].leaves, from.leaves);
    if (to.separates()) span.reach = span.reach - arc(leg.to, pieces[k].arrives, to.arrives);
  }
  for (const RopeLeg& leg : legs)
    add_wrap(rope.path[leg.to], places[leg.to], shape.wraps[leg.to], shape.spans[static_cast<std::size_t>(leg.span)]);
  for (RopeSpan<T>& span : shape.spans) span.reach = span.reach + span.length;
  return shape;
}

}  // namespace mbgen::detail
