#pragma once
// Friction along springs.

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Friction along the line of a spring between two points: its leaves, its bush.
struct SpringFriction : FrictionLaw {
  std::string name;
  Where where;
  int spring = -1;  ///< index into Model::springs
};

template <>
struct KindOf<SpringFriction> : KindDefaults {
  using Element = SpringFriction;
  static constexpr const char *key = "spring_friction", *section = "frictions", *words = "friction";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.spring_frictions;
  }
  static Connection connection(const SpringFriction& element) { return AlongSpring{element.spring}; }
  static constexpr auto& bounds = kFrictionBounds;
  template <class Use>
  static void fields(const SpringFriction& element, const Use& use) {
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
