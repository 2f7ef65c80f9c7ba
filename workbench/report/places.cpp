#include "workbench/report/places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/model/vectors.hpp"

namespace mbgen {

Vector3 values(const Vector3Quantity& vector) { return {vector[0].value, vector[1].value, vector[2].value}; }

Vector3 place_of(const Model& model, const Attachment& at) {
  return values(model.bodies[at.body].points[at.point].position);
}

double distance(const Vector3& a, const Vector3& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

namespace {

std::vector<Attachment> joint_ends(const Model& model) {
  std::vector<Attachment> list;
  for (const Joint& joint : model.joints) {
    if (joint.type != JointType::free) list.push_back(joint.from);
    list.push_back(joint.to);
  }
  for (const Rod& rod : model.rods) list.insert(list.end(), {rod.from, rod.to});
  return list;
}

/// Of elements between two points.
std::vector<Attachment> spring_ends(const Model& model) {
  std::vector<Attachment> list;
  each_element(model, [&](const auto& element) {
    with_ends(connection_of(element), [&](const Attachment& from, const Attachment& to) {
      list.insert(list.end(), {from, to});
    });
  });
  return list;
}

/// The places except spring ends far from all others. springs: number of spring ends, which come first.
std::vector<BodyPlace> without_far_hooks(const Model& model, std::vector<BodyPlace> places, std::size_t springs) {
  const auto global = [&](const BodyPlace& place) { return to_global(model.bodies[place.body].pose, place.at); };
  Box box;
  for (std::size_t p = springs; p < places.size(); ++p) box.add(global(places[p]), places[p].margin);
  const double size = box.diagonal();
  if (!(size > 0)) return places;
  const Vector3 centre = box.centre();
  const auto is_far = [&](const BodyPlace& place) {
    return place.body == model.ground && distance(global(place), centre) > kFarAway * size;
  };
  places.erase(std::remove_if(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(springs), is_far),
               places.begin() + static_cast<std::ptrdiff_t>(springs));
  return places;
}

}  // namespace

std::vector<Attachment> attachments(const Model& model) {
  std::vector<Attachment> list = joint_ends(model);
  const std::vector<Attachment> springs = spring_ends(model);
  list.insert(list.end(), springs.begin(), springs.end());
  return list;
}

std::vector<BodyPlace> drawn_places(const Model& model) {
  std::vector<BodyPlace> places;
  const auto add = [&](const Attachment& at, double margin = 0) {
    places.push_back({at.body, place_of(model, at), margin});
  };
  for (const Attachment& at : spring_ends(model)) add(at);
  const std::size_t springs = places.size();
  for (const Attachment& at : joint_ends(model)) add(at);
  for (const DisplayShape& shape : model.shapes) {
    add(shape.from);
    if (shape.kind != DisplayShape::Kind::sphere) add(shape.to);
  }
  for (const Tyre& tyre : model.tyres) add(tyre.centre, tyre.radius.value);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].mass.value > 0) places.push_back({static_cast<int>(b), values(model.bodies[b].com)});
  }
  return without_far_hooks(model, std::move(places), springs);
}

}  // namespace mbgen
