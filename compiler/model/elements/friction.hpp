#pragma once
// Friction on coordinates, along springs and in the ends of rods.

#include <optional>

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Friction on a coordinate, or between two (clutch): at the rate of `joint` less `relative_to`, its force on
/// `joint`, and opposite on `relative_to`.
struct JointFriction : FrictionLaw {
  std::string name;
  Where where;
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to = {};
};

template <>
struct KindOf<JointFriction> : FrictionDefaults {
  using Element = JointFriction;
  static constexpr const char* key = "friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.frictions;
  }
  static Connection connection(const JointFriction& element) {
    return OnCoordinate{element.joint, element.relative_to};
  }
  template <class Words>
  static std::string sentence(const Words& words, const JointFriction& element) {
    return sticks(element.name, "on " + words.coordinate(element.joint, element.relative_to), element);
  }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const JointFriction& element, const Use& use) {
    use_friction_fields(element, use);
  }
};

/// Friction along the line of a spring between two points, as in a leaf spring or a bush.
struct SpringFriction : FrictionLaw {
  std::string name;
  Where where;
  int spring = -1;  ///< index into Model::springs
};

template <>
struct KindOf<SpringFriction> : FrictionDefaults {
  using Element = SpringFriction;
  static constexpr const char* key = "spring_friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.spring_frictions;
  }
  static Connection connection(const SpringFriction& element) { return AlongSpring{element.spring}; }
  template <class Words>
  static std::string sentence(const Words& words, const SpringFriction& element) {
    return sticks(element.name, "along " + words.along({element.spring}), element);
  }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const SpringFriction& element, const Use& use) {
    use_friction_fields(element, use);
  }
};

/// Smooth friction in the ball joint at a rod's end, against the rotation of the body there relative to the rod's line.
struct RodFriction : FrictionLaw {
  std::string name;
  Where where;
  int rod = -1;          ///< index into Model::rods
  bool at_from = false;  ///< the ball joint is on the body of `from`, else on the body of `to`
};

template <>
struct KindOf<RodFriction> : FrictionDefaults {
  using Element = RodFriction;
  static constexpr const char* key = "rod_friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.rod_frictions;
  }
  static Connection connection(const RodFriction& element) { return InRodEnd{element.rod, element.at_from}; }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const RodFriction& element, const Use& use) {
    use_friction_fields(element, use);
  }
};

}  // namespace mbgen
