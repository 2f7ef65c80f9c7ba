// Geometry of the reference configuration, as far as the reader's checks need it.
#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

const Body& body_of(const Model& model, int index) { return model.bodies[static_cast<std::size_t>(index)]; }

}  // namespace

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
  Vector3 position = rotated(body.pose.rotation, {local[0].value, local[1].value, local[2].value});
  for (std::size_t i = 0; i < 3; ++i) position[i] += body.pose.origin[i];
  return position;
}

}  // namespace mbgen
