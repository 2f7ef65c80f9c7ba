// Geometry of the reference configuration, as far as the reader's checks need it.
#include <cmath>

#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

const Body& body_of(const Model& model, int index) { return model.bodies[static_cast<std::size_t>(index)]; }

}  // namespace

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

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double norm(const Vector3& a) { return std::hypot(a[0], a[1], a[2]); }

double angle_between(const Vector3& a, const Vector3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

std::string attachment_text(const Model& model, const Attachment& attachment) {
  const Body& body = body_of(model, attachment.body);
  return body.name + "." + body.points[static_cast<std::size_t>(attachment.point)].name;
}

bool is_rotation(const Model& model, const CoordinateReference& coordinate) {
  return freedom_of(model, coordinate).kind == FreedomKind::revolute;
}

const std::string& coordinate_name(const Model& model, const CoordinateReference& coordinate) {
  return freedom_of(model, coordinate).name;
}

}  // namespace mbgen::reading

namespace mbgen {

const Freedom& freedom_of(const Model& model, const CoordinateReference& coordinate) {
  const Joint& joint = model.joints[static_cast<std::size_t>(coordinate.joint)];
  return joint.freedoms[static_cast<std::size_t>(coordinate.component)];
}

Vector3 reference_position(const Model& model, const Attachment& attachment) {
  if (attachment.body < 0 || attachment.point < 0)
    return {reading::kUnreadable, reading::kUnreadable, reading::kUnreadable};
  const Body& body = model.bodies[static_cast<std::size_t>(attachment.body)];
  const Vector3Quantity& local = body.points[static_cast<std::size_t>(attachment.point)].position;
  Vector3 position = reading::rotated(body.pose.rotation, {local[0].value, local[1].value, local[2].value});
  for (std::size_t i = 0; i < 3; ++i) position[i] += body.pose.origin[i];
  return position;
}

}  // namespace mbgen
