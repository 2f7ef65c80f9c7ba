#pragma once
// Vectors, rotations and inertias over a scalar T that may be symbolic: no comparisons, structural zeros fold away.

#include <array>
#include <cmath>
#include <vector>

#include "compiler/model/model.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// Three components in the axes named by the holder.
template <class T>
struct Vector {
  T x{0.0}, y{0.0}, z{0.0};
};

/// General 3x3 matrix by columns; for rotations the columns are the rotated axes.
template <class T>
struct Matrix {
  Vector<T> x, y, z;
};

/// Symmetric 3x3 matrix, for example an inertia (matrix entries, so products of inertia carry their minus sign).
template <class T>
struct Symmetric {
  T xx{0.0}, yy{0.0}, zz{0.0}, xy{0.0}, xz{0.0}, yz{0.0};
};

/// Six components about an origin. Motion: velocity of the point at the origin and angular velocity. Force: force and
/// moment.
template <class T>
struct Spatial {
  Vector<T> linear, angular;
};

/// Ten-parameter inertia about an origin: mass, first moment (integral of r dm), inertia (integral of r.r I - r r' dm).
template <class T>
struct Inertia {
  T mass{0.0};
  Vector<T> moment;
  Symmetric<T> inertia;
};

template <class T>
Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vector<T> operator-(const Vector<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Vector<T> operator*(const T& s, const Vector<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.z * b.z + a.y * b.y;
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm(const Vector<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class T>
Vector<T> constant(const Vector3& a) {
  return {T(a[0]), T(a[1]), T(a[2])};
}

template <class T>
Matrix<T> identity() {
  return {{T(1.0), T(0.0), T(0.0)}, {T(0.0), T(1.0), T(0.0)}, {T(0.0), T(0.0), T(1.0)}};
}
template <class T>
Vector<T> operator*(const Matrix<T>& m, const Vector<T>& a) {
  return {m.x.x * a.x + m.z.x * a.z + m.y.x * a.y, m.x.y * a.x + m.z.y * a.z + m.y.y * a.y,
          m.x.z * a.x + m.z.z * a.z + m.y.z * a.y};
}
template <class T>
Matrix<T> operator*(const Matrix<T>& a, const Matrix<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
Matrix<T> operator-(const Matrix<T>& a, const Matrix<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Matrix<T> transpose(const Matrix<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// m' a
template <class T>
Vector<T> transposed_times(const Matrix<T>& m, const Vector<T>& a) {
  return {dot(m.x, a), dot(m.y, a), dot(m.z, a)};
}

template <class T>
Symmetric<T> operator+(const Symmetric<T>& a, const Symmetric<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class T>
Vector<T> operator*(const Symmetric<T>& s, const Vector<T>& a) {
  return {s.xx * a.x + s.xz * a.z + s.xy * a.y, s.xy * a.x + s.yz * a.z + s.yy * a.y,
          s.xz * a.x + s.zz * a.z + s.yz * a.y};
}
/// r s r'
template <class T>
Symmetric<T> rotated(const Matrix<T>& r, const Symmetric<T>& s) {
  const Vector<T> x = s * Vector<T>{r.x.x, r.y.x, r.z.x};  // s times the rows of r
  const Vector<T> y = s * Vector<T>{r.x.y, r.y.y, r.z.y};
  const Vector<T> z = s * Vector<T>{r.x.z, r.y.z, r.z.z};
  const Vector<T> row_x{r.x.x, r.y.x, r.z.x}, row_y{r.x.y, r.y.y, r.z.y}, row_z{r.x.z, r.y.z, r.z.z};
  return {dot(row_x, x), dot(row_y, y), dot(row_z, z), dot(row_x, y), dot(row_x, z), dot(row_y, z)};
}
/// scale (a.a I - a a'): the inertia of a point mass `scale` at a about the origin.
template <class T>
Symmetric<T> point_inertia(const T& scale, const Vector<T>& a) {
  const T xx = scale * (a.x * a.x), yy = scale * (a.y * a.y), zz = scale * (a.z * a.z);
  const Vector<T> s = scale * a;
  return {yy + zz, xx + zz, xx + yy, -(s.x * a.y), -(s.x * a.z), -(s.y * a.z)};
}

template <class T>
Spatial<T> operator+(const Spatial<T>& a, const Spatial<T>& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}
template <class T>
Spatial<T> operator-(const Spatial<T>& a, const Spatial<T>& b) {
  return {a.linear - b.linear, a.angular - b.angular};
}
template <class T>
Spatial<T> operator*(const T& s, const Spatial<T>& a) {
  return {s * a.linear, s * a.angular};
}
/// Power of a force on a motion about the same origin.
template <class T>
T dot(const Spatial<T>& a, const Spatial<T>& b) {
  return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}
/// Velocity of the point at `place` under a motion about the origin.
template <class T>
Vector<T> velocity_at(const Spatial<T>& motion, const Vector<T>& place) {
  return motion.linear + cross(motion.angular, place);
}
/// A force acting at `place`, as force and moment about the origin.
template <class T>
Spatial<T> force_at(const Vector<T>& force, const Vector<T>& place) {
  return {force, cross(place, force)};
}

template <class T>
Inertia<T> operator+(const Inertia<T>& a, const Inertia<T>& b) {
  return {a.mass + b.mass, a.moment + b.moment, a.inertia + b.inertia};
}
/// Momentum about the origin of a motion about the origin (also the force that a unit acceleration needs).
template <class T>
Spatial<T> operator*(const Inertia<T>& m, const Spatial<T>& motion) {
  return {m.mass * motion.linear + cross(motion.angular, m.moment),
          cross(m.moment, motion.linear) + m.inertia * motion.angular};
}
/// The same mass seen from another frame: r rotates into its axes, `place` is the old origin there.
template <class T>
Inertia<T> moved(const Matrix<T>& r, const Vector<T>& place, const Inertia<T>& m) {
  const Vector<T> moment = r * m.moment;  // about the old origin, new axes
  const Vector<T> sum =
      moment + moment + m.mass * place;  // place s' + s place' summed symmetrically: J += sum.place I - sym
  const Symmetric<T> j = rotated(r, m.inertia);
  const T half(0.5);
  const T xx = sum.x * place.x, yy = sum.y * place.y, zz = sum.z * place.z;
  const auto mixed = [&](const T& ax, const T& ay, const T& px, const T& py) { return half * (ax * py + ay * px); };
  return {m.mass,
          moment + m.mass * place,
          {j.xx + (yy + zz), j.yy + (xx + zz), j.zz + (xx + yy), j.xy - mixed(sum.x, sum.y, place.x, place.y),
           j.xz - mixed(sum.x, sum.z, place.x, place.z), j.yz - mixed(sum.y, sum.z, place.y, place.z)}};
}

/// w~ w~ + alpha~: acceleration of a body point relative to the origin is this times its position.
template <class T>
Matrix<T> acceleration_gradient(const Vector<T>& w, const Vector<T>& alpha) {
  const T xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const T xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  return {{-(yy + zz), xy + alpha.z, xz - alpha.y},
          {xy - alpha.z, -(xx + zz), yz + alpha.x},
          {xz + alpha.y, yz - alpha.x, -(xx + yy)}};
}

/// Rotation by an angle about a constant unit axis.
template <class T>
Matrix<T> rotation(const Vector3& axis, const T& angle) {
  using std::cos;
  using std::sin;
  const T c = cos(angle), s = sin(angle);
  const auto diagonal = [&](double a) {
    return std::abs(a) == 1.0 ? T(1.0) : a == 0.0 ? c : T(a * a) + T(1 - a * a) * c;
  };
  const auto mixed = [&](double a, double b) { return a * b == 0.0 ? T(0.0) : T(a * b) - T(a * b) * c; };
  const T sx = T(axis[0]) * s, sy = T(axis[1]) * s, sz = T(axis[2]) * s;
  const T xy = mixed(axis[0], axis[1]), xz = mixed(axis[0], axis[2]), yz = mixed(axis[1], axis[2]);
  return {{diagonal(axis[0]), xy + sz, xz - sy},
          {xy - sz, diagonal(axis[1]), yz + sx},
          {xz + sy, yz - sx, diagonal(axis[2])}};
}

/// Rotation by a quarter turn about a constant unit axis, without the rounding of its cosine.
template <class T>
Matrix<T> quarter_turn(const Vector3& a) {
  return {{T(a[0] * a[0]), T(a[0] * a[1] + a[2]), T(a[0] * a[2] - a[1])},
          {T(a[0] * a[1] - a[2]), T(a[1] * a[1]), T(a[1] * a[2] + a[0])},
          {T(a[0] * a[2] + a[1]), T(a[1] * a[2] - a[0]), T(a[2] * a[2])}};
}

}  // namespace mbgen
