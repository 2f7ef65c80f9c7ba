#pragma once
// Meshes in STL, ASCII or binary: the box around them.

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace mbgen::importing {

/// A box along the axes of a mesh, in its units.
struct MeshBox {
  Eigen::Vector3d least, most;
};

/// The box around all corners of a mesh. Result: nothing for bytes that are no STL, or hold no triangle or a number
/// that is not finite.
std::optional<MeshBox> box_of_stl(std::string_view bytes);

}  // namespace mbgen::importing
