#include "compiler/report/places.hpp"

#include <cmath>

namespace mbgen {

Vector3 values(const Vector3Quantity& vector) { return {vector[0].value, vector[1].value, vector[2].value}; }

Vector3 place_of(const Model& model, const Attachment& at) {
  return values(model.bodies[at.body].points[at.point].position);
}

double distance(const Vector3& a, const Vector3& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

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

std::vector<Attachment> attachments(const Model& model) {
  std::vector<Attachment> list;
  for (const Joint& joint : model.joints) {
    if (joint.type != JointType::free) list.push_back(joint.from);
    list.push_back(joint.to);
  }
  const auto both = [&](const auto& elements) {
    for (const auto& element : elements) {
      list.push_back(element.from);
      list.push_back(element.to);
    }
  };
  both(model.rods);
  both(model.springs);
  both(model.air_springs);
  return list;
}

std::vector<BodyPlace> drawn_places(const Model& model) {
  std::vector<BodyPlace> places;
  const auto add = [&](const Attachment& at, double margin = 0) {
    places.push_back({at.body, place_of(model, at), margin});
  };
  for (const Attachment& at : attachments(model)) add(at);
  for (const DisplayShape& shape : model.shapes) {
    add(shape.from);
    if (shape.kind != DisplayShape::Kind::sphere) add(shape.to);
  }
  for (const Tyre& tyre : model.tyres) add(tyre.centre, tyre.radius.value);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].mass.value > 0) places.push_back({static_cast<int>(b), values(model.bodies[b].com)});
  }
  return places;
}

}  // namespace mbgen
