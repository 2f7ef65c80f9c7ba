#pragma once
// The door of the import room: a robot in URDF or MJCF -> a model in mbgen's JSON, with a list of the elements that
// could not be carried over.

#include <string>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/import/request.hpp"

namespace mbgen {

struct ImportedModel {
  std::string name;                ///< of the model, from the robot's
  std::string format;              ///< "URDF" or "MJCF"
  std::string json;                ///< the model, with comments, in the format that read_model takes
  int bodies = 0, joints = 0;      ///< without the ground; with the joints that close loops
  int loops = 0;                   ///< joints that close loops
  Diagnostics notes;               ///< elements not carried over, or not as they stand, in order of position
  std::vector<std::string> files;  ///< every file that was read, the robot's first
};

/// Translates a robot. The root element says which format it has: <robot> is URDF, <mujoco> is MJCF.
/// Ensures: joints meet at the reference configuration, which is the robot's at zero joint positions.
/// Fails: with every problem found, in order of position.
Result<ImportedModel> import_robot(const ImportRequest& request);

}  // namespace mbgen
