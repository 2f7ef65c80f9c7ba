#pragma once
// Friction on coordinates.

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
struct KindOf<JointFriction> : KindDefaults {
  using Element = JointFriction;
  static constexpr const char *key = "friction", *section = "frictions", *words = "friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.frictions;
  }
  static Connection connection(const JointFriction& element) {
    return OnCoordinate{element.joint, element.relative_to};
  }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const JointFriction& element, const Use& use) {
    use_friction_fields(element, use);
  }
};

}  // namespace mbgen
