#pragma once
// Springs and dampers between two points.

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Spring and damper between two points, tension positive:
/// f = stiffness(l - l0) + damping(dl/dt) + preload + force(length, rate).
struct PointSpring {
  std::string name;
  Where where;
  Attachment from, to;
  std::optional<Law> stiffness;         ///< N/m, or a table of N over m
  std::optional<Law> damping;           ///< N s/m, or a table of N over m/s
  std::optional<Quantity> free_length;  ///< m; without it the reference distance
  Quantity preload;                     ///< N, tension positive
  /// expression; local 0 `length` (m), local 1 `rate` (m/s); N, tension positive
  std::optional<int> force;
};

template <>
struct KindOf<PointSpring> : KindDefaults {
  using Element = PointSpring;
  static constexpr const char *key = "spring", *section = "springs", *words = "spring";
  static constexpr bool is_elastic = true, has_length = true;
  static constexpr std::array quantities = {ElementQuantity{"force", "N"}, ElementQuantity{"length", "m"},
                                            ElementQuantity{"rate", "m/s"}, ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows = "state of a spring or air spring";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.springs;
  }
  static Connection connection(const PointSpring& element) { return BetweenPoints{element.from, element.to}; }
  static constexpr std::array bounds = {FieldBound{"stiffness", QuantityBound::not_negative},
                                        FieldBound{"damping", QuantityBound::not_negative},
                                        FieldBound{"free_length", QuantityBound::not_negative}};
  template <class Use>
  static void fields(const PointSpring& element, const Use& use) {
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    use("free_length", element.free_length);
    use("preload", element.preload);
    use("force", element.force);
  }
  /// A rig takes it away: it stays, without force.
  static void silence(PointSpring& element) {
    element.stiffness.reset();
    element.damping.reset();
    element.force.reset();
    element.preload = 0.0;
  }
};

}  // namespace mbgen
