#pragma once
// Forces on coordinates.

#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Generalised force on a coordinate.
struct JointForce {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity force;  ///< N m or N
};

template <>
struct KindOf<JointForce> : KindDefaults {
  using Element = JointForce;
  static constexpr const char *key = "joint_force", *section = "joint_forces", *words = "joint force";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.joint_forces;
  }
  static Connection connection(const JointForce& element) { return OnCoordinate{element.joint, {}}; }
  template <class Use>
  static void fields(const JointForce& element, const Use& use) {
    use("force", element.force);
  }
  /// A rig takes it away: it stays, without force.
  static void silence(JointForce& element) { element.force = 0.0; }
};

}  // namespace mbgen
