#pragma once
// The connection of two frames in six freedoms: deflections, how forces against them act, and how they move.

#include <array>
#include <cmath>
#include <utility>

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/orientation.hpp"

namespace mbgen {
namespace detail {

/// Below this square of the sine the functions of an angle are series, exact to rounding with six terms.
constexpr double kSmallSineSquared = 1e-3;

/// A rotation by its rotation vector, with what takes an angular velocity to the rate of the vector.
template <class T>
struct TurnedBy {
  Vector<T> vector;  ///< theta: axis times angle, rad
  Vector<T> sines;   ///< axis times sine of the angle
  T curvature{0.0};  ///< h: (1 - angle/2 cot(angle/2)) / sine^2
};

/// The rotation vector of a rotation matrix up to kLargestBushingTurn, not a number beyond. Smooth through zero, where
/// angle/sine and h are their series in the square of the sine. sines: half the skew part of the matrix; cosine: of the
/// angle. Source: the exponential map of rotations, as in F. C. Park, "Computing the exponential and its derivative";
/// the series are those of asin(s)/s and of (1 - asin(s)/2 (1 + sqrt(1 - s^2))/s)/s^2.
template <class T>
TurnedBy<T> turned_by(const Vector<T>& sines, const T& cosine) {
  using mbgen::select;
  using std::atan2, std::sqrt;
  const T square = dot(sines, sines);
  const T half(0.5), one(1.0);
  // Small angle: a small sine, and not the sine of nearly half a turn.
  const T is_small = T(2.0 * kSmallSineSquared) - (square + (one - cosine));
  const T by_series =
      one +
      square * (T(1.0 / 6) +
                square * (T(3.0 / 40) + square * (T(5.0 / 112) + square * (T(35.0 / 1152) + square * T(63.0 / 2816)))));
  const T safe = select(is_small, one, square);
  const T sine = sqrt(safe);
  const T by_angle = atan2(sine, cosine) / sine;
  const T within = cosine - T(std::cos(kLargestBushingTurn));
  TurnedBy<T> turned;
  const T factor = select(within, select(is_small, by_series, by_angle), T(sqrt(within)));
  const T h_by_series =
      T(1.0 / 12) +
      square * (T(7.0 / 240) + square * (T(53.0 / 3360) + square * (T(823.0 / 80640) + square * T(12923.0 / 1774080))));
  turned.vector = factor * sines;
  turned.sines = sines;
  turned.curvature = select(is_small, h_by_series, T((one - half * (by_angle * (one + cosine))) / safe));
  return turned;
}

/// Rate of the rotation vector from the angular velocity, both in the axes that the rotation starts from: the inverse
/// of the left Jacobian of the exponential map.
template <class T>
Vector<T> rate_of_vector(const TurnedBy<T>& turned, const Vector<T>& spin) {
  return spin - T(0.5) * cross(turned.vector, spin) + turned.curvature * cross(turned.sines, cross(turned.sines, spin));
}

/// Moment whose power on the angular velocity is that of `forces` on the rate of the rotation vector: the transpose of
/// rate_of_vector.
template <class T>
Vector<T> moment_of_forces(const TurnedBy<T>& turned, const Vector<T>& forces) {
  return forces + T(0.5) * cross(turned.vector, forces) +
         turned.curvature * cross(turned.sines, cross(turned.sines, forces));
}

/// Deflections of a frame at `to` against one at `from`, which have the same axes at the reference, and their rates, in
/// the axes at `from`: displacements (m), then the components of the rotation vector (rad), each counted by its sense.
template <class T>
struct SixFreedoms {
  const Attachment &from, &to;
  const Matrix3& frame_axes;    ///< columns, GLOBAL axes at the reference
  std::array<double, 6> sense;  ///< 1, or -1 where a freedom counts the other way than its component
  SeenPlace<T> seen;
  TurnedBy<T> turned;
  std::array<T, 6> position, rate;

  SixFreedoms(const ForceWork<T>& work, const Attachment& a, const Attachment& b, const Matrix3& of,
              const std::array<double, 6>& counts)
      : from(a), to(b), frame_axes(of), sense(counts), seen(seen_place(work, a, b)) {
    const System<T>& system = work.system;
    const int on_from = seen.from.body, on_to = seen.to.body, frame = seen.frame;
    const auto in_from = [&](const Vector<T>& v) { return direction_up(system, work.k, frame, v, on_from); };
    const auto column = [&](const Vector3& axis) {
      return in_from(direction_in(system, work.k, on_to, constant<T>(axis), frame));
    };
    const Matrix<T> axes = columns();
    const Matrix<T> turn{column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
    const Vector<T> sines = T(0.5) * Vector<T>{turn.y.z - turn.z.y, turn.z.x - turn.x.z, turn.x.y - turn.y.x};
    const T cosine = T(0.5) * (turn.x.x + turn.y.y + turn.z.z - T(1.0));
    turned = turned_by(transposed_times(axes, sines), cosine);
    const Vector<T> spin_between = transposed_times(axes, in_from(spin_in(work, on_to, frame)) - seen.spin);
    const Vector<T> parts[] = {transposed_times(axes, seen.gap), turned.vector, transposed_times(axes, seen.drift),
                               rate_of_vector(turned, spin_between)};
    for (int i = 0; i < 6; ++i) {
      const T counted_so(sense[i]);
      position[i] = counted_so * component(parts[i / 3], i % 3);
      rate[i] = counted_so * component(parts[2 + i / 3], i % 3);
    }
  }

  /// The axes in those of the `from` body.
  Matrix<T> columns() const { return pose_rotation<T>(Pose{{}, frame_axes}); }

  /// Components as the freedoms count; first: 0 of displacements, 3 of turns.
  Vector<T> counted(const Vector<T>& v, int first) const {
    const auto way = [&](int i) { return T(sense[first + i]); };
    return Vector<T>{way(0) * v.x, way(1) * v.y, way(2) * v.z};
  }

  /// Forces against the deflections; turns: whether any is against a turn. Result: force and moment on `from`, in the
  /// frame's axes.
  std::pair<Vector<T>, Vector<T>> resist(ForceWork<T>& work, const std::array<T, 6>& forces, bool turns) const {
    std::array<T, 6> on_from;
    for (int i = 0; i < 6; ++i) on_from[i] = T(sense[i]) * forces[i];
    const Vector<T> force{on_from[0], on_from[1], on_from[2]};
    Vector<T> moment;
    if (turns) moment = moment_of_forces(turned, Vector<T>{on_from[3], on_from[4], on_from[5]});
    const Matrix<T> axes = columns();
    act_between(work, from, to, seen, axes * force, axes * moment);
    return {force, moment};
  }

  /// How the deflection in a freedom moves.
  std::vector<T> row(const ForceWork<T>& work, int freedom) const {
    const Matrix<T> axes = columns();
    const T way(sense[freedom]);
    Vector<T> along;
    (freedom % 3 == 0 ? along.x : freedom % 3 == 1 ? along.y : along.z) = way;
    return freedom < 3 ? row_between(work, seen, axes * along, Vector<T>{})
                       : row_between(work, seen, Vector<T>{}, axes * moment_of_forces(turned, along));
  }
};

}  // namespace detail
}  // namespace mbgen
