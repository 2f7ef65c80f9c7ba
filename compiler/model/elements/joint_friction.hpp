#pragma once
// Friction on coordinates.

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Friction on a coordinate.
struct JointFriction : FrictionLaw {
  std::string name;
  Where where;
  CoordinateReference joint;
};

template <>
struct KindOf<JointFriction> : KindDefaults {
  using Element = JointFriction;
  static constexpr const char *key = "friction", *section = "frictions", *words = "friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.frictions;
  }
  static Connection connection(const JointFriction& element) { return OnCoordinate{element.joint, {}}; }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const JointFriction& element, const Use& use) {
    use_friction_fields(element, use);
  }
};

}  // namespace mbgen
