#pragma once
// Numerical vectors, rotations and poses.

#include "compiler/model/bodies.hpp"

namespace mbgen {

Matrix3 product(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& a);
Vector3 rotated(const Matrix3& rotation, const Vector3& vector);
Vector3 cross(const Vector3& a, const Vector3& b);
double dot(const Vector3& a, const Vector3& b);
double norm(const Vector3& a);
/// Angle between two vectors, 0 to pi.
double angle_between(const Vector3& a, const Vector3& b);

/// Transformation of a position from a body's frame to the global frame, and back.
Vector3 to_global(const Pose& pose, const Vector3& local);
Vector3 to_local(const Pose& pose, const Vector3& global);

/// A global direction in the axes of a body.
Vector3 to_body_axes(const Pose& pose, const Vector3& direction);

}  // namespace mbgen
