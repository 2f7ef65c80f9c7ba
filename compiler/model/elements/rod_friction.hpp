#pragma once
// Friction in the ends of rods.

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Smooth friction in the ball joint at a rod's end, against the rotation of the body there relative to the rod's line.
struct RodFriction : FrictionLaw {
  std::string name;
  Where where;
  int rod = -1;          ///< index into Model::rods
  bool at_from = false;  ///< the ball joint is on the body of `from`, else on the body of `to`
};

template <>
struct KindOf<RodFriction> : KindDefaults {
  using Element = RodFriction;
  static constexpr const char *key = "rod_friction", *section = "frictions", *words = "friction";
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
