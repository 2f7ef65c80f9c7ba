#pragma once
// Rotations as people read them: angles of a sequence, unit quaternion, rotation vector. Finite for every rotation
// matrix, with finite derivatives in double precision, and without a decision that needs a comparison of T.

#include "compiler/formulation/vector.hpp"

namespace mbgen {

/// w, x, y, z of a unit quaternion.
template <class T>
struct Quaternion {
  T w{1.0};
  Vector<T> v;
};

namespace detail {

/// Keeps quotients and roots of zero away: far below the rounding of entries of a rotation matrix, and its square is a
/// double.
constexpr double kTiny = 1e-30;

template <class T>
const T& component(const Vector<T>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
template <class T>
const T& entry(const Matrix<T>& m, int row, int column) {
  return component(column == 0 ? m.x : column == 1 ? m.y : m.z, row);
}

template <class T>
Quaternion<T> select(const T& condition, const Quaternion<T>& a, const Quaternion<T>& b) {
  using mbgen::select;
  return {select(condition, a.w, b.w),
          {select(condition, a.v.x, b.v.x), select(condition, a.v.y, b.v.y), select(condition, a.v.z, b.v.z)}};
}

}  // namespace detail

/// Angle of one turn of the sequence r = R_i(first) R_j(second) R_k(third), rad: each about the axes that the turns
/// before it left. The second is in [-pi/2, pi/2], or in [0, pi] where the third axis is the first one; the others are
/// in [-pi, pi]. In a singular position only a sum of first and third is determined: the first is any angle there, and
/// the three make up r as everywhere.
template <class T>
T angle_of_turn(const Matrix<T>& r, const std::array<int, 3>& sequence, int turn) {
  using detail::entry, detail::kTiny;
  using std::atan2, std::cos, std::sin, std::sqrt;
  const int i = sequence[0], j = sequence[1], k = 3 - i - j;
  const bool returns = sequence[2] == i;
  const T sign(j == (i + 1) % 3 ? 1.0 : -1.0);
  const T y = returns ? entry(r, j, i) : -sign * entry(r, j, k);
  const T x = returns ? -sign * entry(r, k, i) : entry(r, k, k);
  if (turn == 1) {
    const T across = sqrt(x * x + y * y + T(kTiny * kTiny));
    return returns ? atan2(across, entry(r, i, i)) : atan2(sign * entry(r, i, k), across);
  }
  const T first = atan2(y, x + T(kTiny));  // not pi where both are zero and have a sign
  if (turn == 0) return first;
  // After removal of the first rotation, row j of the matrix is row j of the third rotation.
  const T c = cos(first), s = sign * sin(first);
  const auto left = [&](int column) { return c * entry(r, j, column) + s * entry(r, k, column); };
  return returns ? atan2(-sign * left(k), left(j)) : atan2(sign * left(i), left(j));
}

/// The quaternion with w >= 0 of a rotation matrix. The largest of four ways counts, so no digits are lost at any
/// angle. Source: S. W. Shepperd, "Quaternion from rotation matrix", Journal of Guidance and Control 1 (1978).
template <class T>
Quaternion<T> quaternion_of(const Matrix<T>& r) {
  const T one(1.0);
  const Vector<T> across{r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};  // 4 w v
  const T xy = r.x.y + r.y.x, xz = r.x.z + r.z.x, yz = r.y.z + r.z.y;
  const T w = one + r.x.x + r.y.y + r.z.z, x = one + r.x.x - r.y.y - r.z.z;  // 4 w w, 4 x x
  const T y = one - r.x.x + r.y.y - r.z.z, z = one - r.x.x - r.y.y + r.z.z;
  const Quaternion<T> by_w{w, across}, by_x{across.x, {x, xy, xz}}, by_y{across.y, {xy, y, yz}},
      by_z{across.z, {xz, yz, z}};
  const Quaternion<T> first = detail::select(T(w - x), by_w, by_x), second = detail::select(T(y - z), by_y, by_z);
  const T larger_of_first = select(T(w - x), w, x), larger_of_second = select(T(y - z), y, z);
  const Quaternion<T> q = detail::select(T(larger_of_first - larger_of_second), first, second);
  using std::sqrt;
  const T scale = select(q.w, one, T(-1.0)) / sqrt(q.w * q.w + dot(q.v, q.v));
  return {scale * q.w, scale * q.v};
}

/// Axis times angle, rad, the angle in [0, pi].
template <class T>
Vector<T> rotation_vector(const Matrix<T>& r) {
  using std::atan2, std::sqrt;
  const Quaternion<T> q = quaternion_of(r);
  // The square of this is a number in single precision too, and what it is to a sine below it does not matter: an angle
  // over its sine is one.
  constexpr double kSmallSine = 1e-18;
  const T sine = sqrt(dot(q.v, q.v) + T(kSmallSine * kSmallSine));
  return (T(2.0) * atan2(sine, q.w) / sine) * q.v;
}

}  // namespace mbgen
