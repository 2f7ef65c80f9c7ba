#pragma once
// Springs and dampers on coordinates.

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Spring and damper on a coordinate, or on the difference of two (anti-roll bar):
/// x = z - z(relative_to), force on the coordinate, opposite on `relative_to`:
/// f = -(stiffness(x - free) + damping(dx/dt) + preload + force(x, dx/dt)).
struct JointSpring {
  std::string name;
  Where where;
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to;
  std::optional<Law> stiffness;  ///< N m/rad or N/m
  std::optional<Law> damping;    ///< N m s/rad or N s/m
  Quantity free;                 ///< rad or m
  Quantity preload;              ///< N m or N
  std::optional<int> force;      ///< expression; local 0 `position`, local 1 `rate`
};

template <>
struct KindOf<JointSpring> : KindDefaults {
  using Element = JointSpring;
  static constexpr const char *key = "joint_spring", *section = "joint_springs", *words = "joint spring";
  static constexpr bool is_elastic = true;
  static constexpr std::array quantities = {ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows = "potential energy of a joint spring";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.joint_springs;
  }
  static Connection connection(const JointSpring& element) { return OnCoordinate{element.joint, element.relative_to}; }
  static constexpr std::array bounds = {FieldBound{"stiffness", QuantityBound::not_negative},
                                        FieldBound{"damping", QuantityBound::not_negative}};
  template <class Use>
  static void fields(const JointSpring& element, const Use& use) {
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    use("free", element.free);
    use("preload", element.preload);
    use("force", element.force);
  }
  /// A rig takes it away: it stays, without force.
  static void silence(JointSpring& element) {
    element.stiffness.reset();
    element.damping.reset();
    element.force.reset();
    element.preload = 0.0;
  }
};

}  // namespace mbgen
