#pragma once
// Actuators: motors on coordinates, and cylinders between points.

#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Motor on a coordinate, or between two, or a cylinder between two points. Its force is an input, which inverse
/// dynamics finds. It acts along the coordinate (of `joint` less `relative_to`), or pushes its ends apart: force times
/// speed is the power that it gives.
struct Actuator {
  std::string name;
  Where where;
  std::optional<CoordinateReference> joint, relative_to;  ///< without `joint` it is between two points
  Attachment from, to;
  Quantity gear = 1.0;          ///< speed of the motor over rate of the coordinate, or of the length
  double weight = 1;            ///< of its squared force, where other actuators move the same directions
  std::optional<double> limit;  ///< of the motor's force, which is told beyond it and never clipped: N or N m
  int input = -1;               ///< index into Model::inputs of its force, N or N m; -1: none
};

template <>
struct KindOf<Actuator> : KindDefaults {
  using Element = Actuator;
  static constexpr const char *key = "actuator", *section = "actuators", *words = "actuator";
  static constexpr std::array quantities = {ElementQuantity{"force", "N", 1, "N m"},
                                            ElementQuantity{"speed", "m/s", 1, "rad/s"}, ElementQuantity{"power", "W"}};
  static constexpr const char* shows = "force of an actuator, its speed, or the power that it gives";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.actuators;
  }
  static Connection connection(const Actuator& element) {
    if (element.joint) return OnCoordinate{*element.joint, element.relative_to};
    return BetweenPoints{element.from, element.to};
  }
  template <class Use>
  static void fields(const Actuator& element, const Use& use) {
    use("gear", element.gear);
    use("weight", element.weight);
  }
  /// Removal by a rig: the element remains, without force.
  static void silence(Actuator& element) { element.input = -1; }
};

}  // namespace mbgen
