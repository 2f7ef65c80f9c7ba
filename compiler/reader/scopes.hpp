#pragma once
// Instances: a file placed in a model as a subsystem. The model's own file with its includes is the first scope, each
// instance another: it has names of its own and stands somewhere, perhaps mirrored.

#include <string>
#include <vector>

#include "compiler/expressions/names.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {

/// Where a subsystem stands: x_model = origin + rotation * flip * x_file, flip a diagonal of 1 and -1.
/// A body frame of the file takes the flip along, so that it stays right-handed: body components of a vector
/// only change signs.
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
  std::vector<FileFields> files;       ///< in the order in which they are merged
  InstanceFields instance;             ///< as written by the parent
  NameMap<const Value*> connections;   ///< body of the subsystem -> text that names one of the parent
  Placement placement;                 ///< in the model
  bool keeps_direction = false;        ///< rotations of a mirrored joint are counted about the axis as written
};

}  // namespace mbgen::reading
