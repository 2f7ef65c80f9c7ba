#pragma once
// Friction in the ends of rods.

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Friction in the ball at an end of a rod, against the turn of the body there relative to the rod's line; smooth.
struct RodFriction : FrictionLaw {
  std::string name;
  Where where;
  int rod = -1;          ///< index into Model::rods
  bool at_from = false;  ///< the ball is on the body of `from`, else on that of `to`
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
    use("coulomb", element.coulomb);
    use("stiction", element.stiction);
    use("viscous", element.viscous);
    use("velocity", element.velocity);
    use("stribeck_velocity", element.stribeck_velocity);
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    use("elastic", element.elastic);
  }
};

}  // namespace mbgen
