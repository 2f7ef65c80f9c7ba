// Geometry of the reference configuration.
#include <cmath>

#include "compiler/model/model.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {

const Freedom& freedom_of(const Model& model, const CoordinateReference& coordinate) {
  const Joint& joint = model.joints[static_cast<std::size_t>(coordinate.joint)];
  return joint.freedoms[static_cast<std::size_t>(coordinate.component)];
}

Vector3 reference_position(const Model& model, const Attachment& attachment) {
  if (attachment.body < 0 || attachment.point < 0) return {NAN, NAN, NAN};
  const Body& body = model.bodies[static_cast<std::size_t>(attachment.body)];
  const Vector3Quantity& local = body.points[static_cast<std::size_t>(attachment.point)].position;
  Vector3 position = rotated(body.pose.rotation, {local[0].value, local[1].value, local[2].value});
  for (std::size_t i = 0; i < 3; ++i) position[i] += body.pose.origin[i];
  return position;
}

}  // namespace mbgen
