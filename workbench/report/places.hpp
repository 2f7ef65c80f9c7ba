#pragma once
// Places on the bodies of a model: where elements are fixed to them, and the drawn extent of them.

#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {

/// A spring's end on the ground further away than so many sizes of all else stands for a force, as a hook in the sky
/// does: it does not say how large the model is, and such a spring is not drawn.
constexpr double kFarAway = 20;

/// A place that moves with a body.
struct BodyPlace {
  int body = -1;
  Vector3 at{};       ///< m, body frame
  double margin = 0;  ///< m: the drawing reaches so far around it
};

Vector3 values(const Vector3Quantity& vector);

/// Where an attachment is in the frame of its body.
Vector3 place_of(const Model& model, const Attachment& at);

double distance(const Vector3& a, const Vector3& b);

/// Everything that is fixed to a point of a body.
std::vector<Attachment> attachments(const Model& model);

/// The places that say how large a model is and how far it moves: attachments, ends of shapes, tyres, centres of mass.
/// Ends of springs on the ground that are far from all else are left out.
std::vector<BodyPlace> drawn_places(const Model& model);

}  // namespace mbgen
