#pragma once
// Places on the bodies of a model: attachments of elements, and extent of the drawing.

#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {

/// Distance, in sizes of the rest of the model, beyond which a spring's end on the ground stands for a force, like a
/// hook in the sky: it does not count for the model's size, and the spring is not drawn.
constexpr double kFarAway = 20;

/// A body-fixed place.
struct BodyPlace {
  int body = -1;
  Vector3 at{};       ///< m, body frame
  double margin = 0;  ///< m: radius drawn around it
};

Vector3 values(const Vector3Quantity& vector);

/// Position of an attachment in its body's frame.
Vector3 place_of(const Model& model, const Attachment& at);

double distance(const Vector3& a, const Vector3& b);

/// All attachments to points of bodies.
std::vector<Attachment> attachments(const Model& model);

/// Places that define size and motion of a model: attachments, ends of shapes, tyres, centres of mass, without ends of
/// springs on the ground that are far from all others.
std::vector<BodyPlace> drawn_places(const Model& model);

}  // namespace mbgen
