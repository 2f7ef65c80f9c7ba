#pragma once
// Rolling without slip and knife edges (theory.md section 3): rows that hold velocities alone, beside the one that
// holds a rim or a ball on its plane. An end is one of the two kinds of loop ends; `at(end, place)` is the same body
// there.

#include <algorithm>
#include <vector>

#include "compiler/formulation/vector.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

namespace detail {

/// A direction or place that moves, base frame.
template <class T>
struct MovingVector {
  Vector<T> value, rate;
};

template <class T>
MovingVector<T> cross(const MovingVector<T>& a, const MovingVector<T>& b) {
  return {cross(a.value, b.value), cross(a.rate, b.value) + cross(a.value, b.rate)};
}

/// Length of axle x normal, or of blade x normal, below which their direction is lost: a disc lies flat.
constexpr double kLeastLean = 1e-4;

/// The unit vector along a vector; it shrinks where that is shorter than kLeastLean, so that the pivots of its rows
/// tell.
template <class T>
MovingVector<T> unit(const MovingVector<T>& v) {
  using std::max;
  const T scale = T(1.0) / max(norm(v.value), T(kLeastLean));
  const Vector<T> direction = scale * v.value;
  return {direction, scale * (v.rate - dot(direction, v.rate) * direction)};
}

/// A direction that is fixed on the body of an end.
template <class T, template <class> class End>
MovingVector<T> fixed_on(const End<T>& end, const Vector<T>& direction) {
  return {direction, cross(end.velocity.angular, direction)};
}

/// Velocity along a direction of the material of `from` relative to the material of `to`, at a place that moves over
/// both: the second derivative has the acceleration of the material that passes there. The residual is zero.
template <class T, template <class> class End>
auto slip_row(const End<T>& from, const End<T>& to, const MovingVector<T>& place, const MovingVector<T>& along) {
  const End<T> there_from = at(from, place.value), there_to = at(to, place.value);
  const Vector<T> passed_from = place.rate - point_velocity(there_from);
  const Vector<T> passed_to = place.rate - point_velocity(there_to);
  auto row = coincidence(there_from, there_to, along.value);
  row.residual = T(0.0);
  row.acceleration =
      row.acceleration +
      dot(along.value, cross(from.velocity.angular, passed_from) - cross(to.velocity.angular, passed_to)) +
      dot(along.rate, passed_to - passed_from);
  return row;
}

/// The rows of rolling and blades: `from` carries the plane through its place with the normal on_from.z, `to` the
/// centre and the axle or blade on_to.z. Directions: normal; forward, where positive turns about the axle roll to; to
/// the left of that. The lowest point of the rim moves with the tilt of the disc, but across the normal: the rate of
/// the height is the velocity of the material there.
template <class T, template <class> class End>
auto rolling_rows(ClosureKind kind, const End<T>& from, const End<T>& to, const Matrix<T>& on_from,
                  const Matrix<T>& on_to, const T& radius) {
  const MovingVector<T> normal = fixed_on(from, on_from.z), axle = fixed_on(to, on_to.z);
  const MovingVector<T> centre{to.place, point_velocity(to)};
  const auto from_centre = [&](const T& length, const MovingVector<T>& direction) {
    return MovingVector<T>{centre.value + length * direction.value, centre.rate + length * direction.rate};
  };
  if (kind == ClosureKind::knife_edge) {
    const MovingVector<T> across = unit(cross(normal, axle));
    return std::vector{slip_row(from, to, centre, across)};
  }
  MovingVector<T> contact = from_centre(-radius, normal);
  MovingVector<T> first = fixed_on(from, on_from.x), second = fixed_on(from, on_from.y);
  if (kind == ClosureKind::rolling_disc) {
    first = unit(cross(axle, normal));
    second = cross(normal, first);
    contact = from_centre(radius, cross(axle, first));
  }
  std::vector rows{slip_row(from, to, contact, normal), slip_row(from, to, contact, first),
                   slip_row(from, to, contact, second)};
  rows[0].residual = dot(normal.value, from.place - contact.value);
  return rows;
}

}  // namespace detail
}  // namespace mbgen
