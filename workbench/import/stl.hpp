#pragma once
// Bounding boxes of meshes in STL, ASCII or binary.

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace mbgen::importing {

/// An axis-aligned box of a mesh, in its units.
struct MeshBox {
  Eigen::Vector3d least, most;
};

/// Bounding box of a mesh. Result: nothing for bytes that are no STL, contain no triangle or a number that is not
/// finite.
std::optional<MeshBox> box_of_stl(std::string_view bytes);

}  // namespace mbgen::importing
