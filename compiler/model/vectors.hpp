#pragma once
// Numerical vectors, rotations, poses and boxes.

#include <algorithm>
#include <cmath>

#include "compiler/model/bodies.hpp"

namespace mbgen {

Matrix3 product(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& a);
Vector3 rotated(const Matrix3& rotation, const Vector3& vector);
/// a + factor b.
Vector3 sum(const Vector3& a, const Vector3& b, double factor = 1);
Vector3 times(const Vector3& a, double factor);
Vector3 from_to(const Vector3& from, const Vector3& to);
Vector3 cross(const Vector3& a, const Vector3& b);
double dot(const Vector3& a, const Vector3& b);
double norm(const Vector3& a);
/// Of length 1. Requires: a is not zero.
Vector3 normalised(const Vector3& a);
/// Angle between two vectors, 0 to pi.
double angle_between(const Vector3& a, const Vector3& b);

/// Transformation of a position from a body's frame to the global frame, and back.
Vector3 to_global(const Pose& pose, const Vector3& local);
Vector3 to_local(const Pose& pose, const Vector3& global);

/// A global direction in the axes of a body.
Vector3 to_body_axes(const Pose& pose, const Vector3& direction);

/// Smallest axis-aligned box around all added points.
struct Box {
  Vector3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  bool is_empty() const { return low[0] > high[0]; }
  /// margin: the point is the centre of a cube with edges of twice this.
  void add(const Vector3& point, double margin = 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i] - margin);
      high[i] = std::max(high[i], point[i] + margin);
    }
  }
  Vector3 centre() const { return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}; }
  /// Length of the diagonal; 0 for an empty box.
  double diagonal() const { return is_empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

}  // namespace mbgen
