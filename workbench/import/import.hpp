#pragma once
// Interface of the import room: converts a robot in URDF, SDF or MJCF to a model in mbgen's JSON, with a list of the
// elements that could not be converted.

#include <string>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/import/request.hpp"

namespace mbgen {

struct ImportedModel {
  std::string name;                ///< of the model, from the robot's
  std::string format;              ///< "URDF", "SDF" or "MJCF"
  std::string json;                ///< the model, with comments, as input of read_model
  int bodies = 0, joints = 0;      ///< without the ground; including loop-closing joints
  int loops = 0;                   ///< joints that close loops
  Diagnostics notes;               ///< elements lost or changed, in order of position
  std::vector<std::string> files;  ///< all files read, the robot's first
};

/// Converts a robot; its root element selects the format: <robot> for URDF, <sdf> for SDF, <mujoco> for MJCF. Ensures:
/// joints are closed at the reference configuration, the robot's at zero joint positions. Fails: with every problem
/// found, in order of position; `notes_of_failure` then has the notes so far, since a lost element may be the cause.
Result<ImportedModel> import_robot(const ImportRequest& request, Diagnostics* notes_of_failure = nullptr);

}  // namespace mbgen
