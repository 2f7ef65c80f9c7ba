// Names of kinds of joints, as the model format writes them.
#include "compiler/model/model.hpp"

namespace mbgen {

const char* name_of(FreedomKind kind) { return kind == FreedomKind::revolute ? "revolute" : "prismatic"; }

const char* name_of(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::prismatic:
      return "prismatic";
    case JointType::cylindrical:
      return "cylindrical";
    case JointType::universal:
      return "universal";
    case JointType::spherical:
      return "spherical";
    case JointType::planar:
      return "planar";
    case JointType::free:
      return "free";
    case JointType::fixed:
      return "fixed";
  }
  return "unknown";
}

}  // namespace mbgen
