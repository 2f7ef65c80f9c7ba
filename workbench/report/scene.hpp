#pragma once
// The animation's view of a model: bodies as shapes, and the elements between them.

#include <nlohmann/json_fwd.hpp>

#include "compiler/model/model.hpp"

namespace mbgen {

/// The diagonal of the box around all that is drawn at the reference, m.
double model_size(const Model& model);

/// As JSON:
///   bodies: name and shapes of each body of the model; a shape is a tyre {at, axis, radius, width}, box {at, size},
///     cylinder or tube {from, to, radius} or sphere {at, radius}, in the body's frame, m, perhaps with a colour
///   links: rods and elements between two points: name, kind (rod, spring, damper, strut, or as the model format calls
///     its kind), [body, place] of both ends, radius
///   joints: and marks of elements: name, kind, body, place and axis in its frame, radius; axes of an element with a
///     frame, mark "pad" of an end that another one comes to
///   up: unit vector; road: height of a flat road without a name, or null; floor: where a grid is drawn, or null
///   centre and size: of all points at the reference; follow: body that the camera goes with, or -1
/// Shapes come from Model::shapes; a body without any is drawn by its tyre, else as tubes from its centre of mass to
/// the points that something is fixed to, and as the box of its mass and inertia where that is far lighter than metal.
nlohmann::ordered_json scene_json(const Model& model);

}  // namespace mbgen
