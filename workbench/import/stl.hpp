#pragma once
// Bounding boxes of meshes in STL, ASCII or binary.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "workbench/import/request.hpp"

namespace mbgen::importing {

/// An axis-aligned box of a mesh, in its units.
struct MeshBox {
  Eigen::Vector3d least, most;
};

/// Bounding box of a mesh. Result: nothing for bytes that are no STL, contain no triangle or a number that is not
/// finite.
std::optional<MeshBox> box_of_stl(std::string_view bytes);

/// Bounding box of a mesh that `file` names, found beside that by its path or its name alone; for package://NAME/ and
/// model://NAME/ also by the rest of the path. Nothing where there is no STL.
std::optional<MeshBox> box_of_mesh(const ImportRequest& request, const std::string& file, const std::string& name);

}  // namespace mbgen::importing
