#pragma once
// Bump stops: elements that push after a clearance is used up, and never pull.

#include <optional>
#include <string>

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Stop that engages when its travel s has used up a clearance. With p = s - clearance, while p > 0,
/// f = (stiffness(p) + force(p, dp/dt)) (1 + damping dp/dt), at least 0, against the travel; else nothing.
/// stiffness(p) is factor p^exponent, or a table. The travel is zero at the reference configuration.
struct BumpStop {
  enum class Side {
    compression,  ///< s: what the distance of the points falls by, or the way of `to` against `axis`
    extension,    ///< s: what the distance grows by, or the way of `to` along `axis`
    above,        ///< s: the coordinate
    below         ///< s: minus the coordinate
  };
  std::string name;
  Where where;
  /// two points; no bodies where it is on a coordinate
  Attachment from, to;
  /// unit, GLOBAL axes at the reference, moves with `from`; none: along the line between the points. With it, both
  /// bodies are pushed at the point of `to`.
  std::optional<Vector3> axis;
  CoordinateReference joint;  ///< joint -1: between points
  Side side = Side::compression;
  Quantity clearance;            ///< m or rad
  std::optional<Law> stiffness;  ///< N/m^exponent or N m/rad^exponent, or a table over the penetration
  double exponent = 1;           ///< >= 1
  Quantity damping;              ///< s/m or s/rad: share of the force per speed of the penetration
  std::optional<int> force;      ///< expression; local 0 `penetration`, local 1 `rate`; N or N m

  bool is_on_joint() const { return side == Side::above || side == Side::below; }
};

template <>
struct KindOf<BumpStop> : KindDefaults {
  using Element = BumpStop;
  static constexpr const char *key = "bump_stop", *section = "bump_stops", *words = "bump stop";
  static constexpr bool is_elastic = true;
  static constexpr Drawing drawing = Drawing::pad;
  /// deflection: beyond the clearance, negative before
  static constexpr std::array quantities = {
      ElementQuantity{"force", "N", 1, "N m"}, ElementQuantity{"deflection", "m", 1, "rad"},
      ElementQuantity{"rate", "m/s", 1, "rad/s"}, ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows =
      "force of a bump stop, its deflection beyond the clearance, the rate of that, or its potential energy";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.bump_stops;
  }
  static Connection connection(const BumpStop& element) {
    if (element.is_on_joint()) return OnCoordinate{element.joint, {}};
    if (element.axis) return AlongDirection{element.from, element.to, *element.axis};
    return BetweenPoints{element.from, element.to};
  }
  static constexpr std::array bounds = {FieldBound{"stiffness", QuantityBound::not_negative},
                                        FieldBound{"damping", QuantityBound::not_negative}};
  template <class Use>
  static void fields(const BumpStop& element, const Use& use) {
    constexpr const char* sides[] = {"compression", "extension", "above", "below"};
    use("side", sides[static_cast<int>(element.side)]);
    use("clearance", element.clearance);
    use("stiffness", element.stiffness);
    use("exponent", element.exponent);
    use("damping", element.damping);
    use("force", element.force);
  }
};

}  // namespace mbgen
