// Names of kinds in the model format.
#include <array>

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
    case JointType::point_on_line:
      return "point_on_line";
    case JointType::point_on_plane:
      return "point_on_plane";
    case JointType::parallel_axes:
      return "parallel_axes";
    case JointType::orientation:
      return "orientation";
    case JointType::homokinetic:
      return "homokinetic";
    case JointType::rolling_disc:
      return "rolling_disc";
    case JointType::rolling_ball:
      return "rolling_ball";
    case JointType::knife_edge:
      return "knife_edge";
  }
  return "unknown";
}

const char* name_of(RoadBorder border) {
  constexpr std::array kNames = {"keep", "zero", "repeat", "reflect", "refuse"};
  return kNames[static_cast<std::size_t>(border)];
}

}  // namespace mbgen
