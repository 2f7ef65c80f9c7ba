#pragma once
// Friction along springs.

#include "compiler/model/elements/friction_law.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Friction along the line of a spring between two points, as of leaves or a bush.
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
    use_friction_fields(element, use);
  }
};

}  // namespace mbgen
