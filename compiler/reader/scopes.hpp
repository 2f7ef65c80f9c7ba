#pragma once
// Instances: a file placed in a model as a subsystem. The first scope is the model's own file with its includes; each
// instance is another scope with its own names and pose, possibly mirrored.

#include <string>
#include <vector>

#include "compiler/expressions/names.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {

/// Pose of a subsystem: x_model = origin + rotation * flip * x_file, flip a diagonal of 1 and -1. A body frame of the
/// file includes the flip, so that it remains right-handed: body components of a vector only change signs.
struct Placement {
  Vector3 origin{0, 0, 0};
  Matrix3 rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vector3 flip{1, 1, 1};
};

struct Scope {
  std::string path;                    ///< of instances, as "front.left"; empty for the model
  std::string file;                    ///< of the subsystem
  std::size_t parent = 0;              ///< index into Reader::scopes
  Visibility visible = {{0, {}, {}}};  ///< its own level first
  std::vector<FileFields> files;       ///< in the order of merging
  InstanceFields instance;             ///< as written by the parent
  NameMap<const Value*> connections;   ///< body of the subsystem -> text with the name of a body of the parent
  Placement placement;                 ///< in the model
  bool keeps_direction = false;        ///< rotations of a mirrored joint are positive about the axis as written
};

}  // namespace mbgen::reading
