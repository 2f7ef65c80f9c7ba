// Names of elements in messages.
#include "compiler/reader/reader.hpp"

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
