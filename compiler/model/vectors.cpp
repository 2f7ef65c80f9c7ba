#include "compiler/model/vectors.hpp"

#include <cmath>

namespace mbgen {

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) result[3 * row + column] += a[3 * row + k] * b[3 * k + column];
    }
  }
  return result;
}

Matrix3 transposed(const Matrix3& a) { return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}; }

Vector3 rotated(const Matrix3& rotation, const Vector3& vector) {
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = rotation[3 * i] * vector[0] + rotation[3 * i + 1] * vector[1] + rotation[3 * i + 2] * vector[2];
  }
  return result;
}

Vector3 sum(const Vector3& a, const Vector3& b, double factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector3 times(const Vector3& a, double factor) { return {factor * a[0], factor * a[1], factor * a[2]}; }

Vector3 from_to(const Vector3& from, const Vector3& to) { return {to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double norm(const Vector3& a) { return std::hypot(a[0], a[1], a[2]); }

Vector3 normalised(const Vector3& a) {
  const double length = norm(a);
  return {a[0] / length, a[1] / length, a[2] / length};
}

double angle_between(const Vector3& a, const Vector3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Vector3 to_global(const Pose& pose, const Vector3& local) {
  Vector3 global = pose.origin;
  for (int i = 0; i < 9; ++i) global[i / 3] += pose.rotation[i] * local[i % 3];
  return global;
}

Vector3 to_local(const Pose& pose, const Vector3& global) {
  Vector3 arm{};
  for (int i = 0; i < 3; ++i) arm[i] = global[i] - pose.origin[i];
  return to_body_axes(pose, arm);
}

Vector3 to_body_axes(const Pose& pose, const Vector3& direction) {
  Vector3 local{};
  for (int i = 0; i < 9; ++i) local[i % 3] += pose.rotation[i] * direction[i / 3];
  return local;
}

}  // namespace mbgen
