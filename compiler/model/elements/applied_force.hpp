#pragma once
// Forces and torques on bodies.

#include <algorithm>

#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Force and torque on a body at a point.
struct AppliedForce {
  std::string name;
  Where where;
  Attachment at;
  Vector3Quantity force;      ///< N
  Vector3Quantity torque;     ///< N m
  bool in_body_axes = false;  ///< components in body axes, else in global axes
};

template <>
struct KindOf<AppliedForce> : KindDefaults {
  using Element = AppliedForce;
  static constexpr const char *key = "force", *section = "forces", *words = "force";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.forces;
  }
  static Connection connection(const AppliedForce& element) {
    const auto acts = [](const Quantity& component) { return component.expression >= 0 || component.value != 0; };
    return OnBody{element.at, std::any_of(element.torque.begin(), element.torque.end(), acts)};
  }
  template <class Use>
  static void fields(const AppliedForce& element, const Use& use) {
    use("force", element.force);
    use("torque", element.torque);
  }
  /// A rig takes it away: it stays, without force.
  static void silence(AppliedForce& element) { element.force = element.torque = {0.0, 0.0, 0.0}; }
};

}  // namespace mbgen
