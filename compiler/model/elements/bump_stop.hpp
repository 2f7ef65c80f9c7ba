#pragma once
// Bump stops: unilateral elements with a clearance.

#include <optional>
#include <string>

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Stop with a clearance, over its travel s. With p = s - clearance, its force against the travel for p > 0 is
/// f = (stiffness(p) + force(p, dp/dt)) (1 + damping dp/dt), at least 0, else 0.
/// stiffness(p) is factor p^exponent, or a table. The travel is zero at the reference configuration.
struct BumpStop {
  enum class Side {
    compression,  ///< s: reduction of the distance, or motion of `to` against `axis`
    extension,    ///< s: increase of the distance, or motion of `to` along `axis`
    above,        ///< s: the coordinate, less `relative_to`
    below         ///< s: minus this
  };
  std::string name;
  Where where;
  /// two points; no bodies for a stop on a coordinate
  Attachment from, to;
  /// unit, GLOBAL axes at the reference, fixed to `from`; none: along the line between the points. With an axis, the
  /// forces on both bodies are at the point of `to`.
  std::optional<Vector3> axis;
  CoordinateReference joint;                            ///< joint -1: between points
  std::optional<CoordinateReference> relative_to = {};  ///< backlash: the force is opposite on this coordinate
  Side side = Side::compression;
  Quantity clearance;            ///< m or rad
  std::optional<Law> stiffness;  ///< N/m^exponent or N m/rad^exponent, or a table over the penetration
  double exponent = 1;           ///< >= 1
  Quantity damping;              ///< s/m or s/rad: relative increase of the force over the rate of penetration
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
    if (element.is_on_joint()) return OnCoordinate{element.joint, element.relative_to};
    if (element.axis) return AlongDirection{element.from, element.to, *element.axis};
    return BetweenPoints{element.from, element.to};
  }
  template <class Words>
  static std::string sentence(const Words& words, const BumpStop& element) {
    const std::string clearance = words.number(element.clearance);
    const bool is_on_this_side = element.side == BumpStop::Side::above || element.side == BumpStop::Side::compression;
    if (element.is_on_joint())
      return element.name + " pushes back where " + words.coordinate(element.joint, element.relative_to) + " is " +
             (is_on_this_side ? "above " : "below minus ") + clearance + " " + words.unit(element.joint) + ".";
    return element.name + " pushes " + words.body(element.from) + " and " + words.body(element.to) +
           (is_on_this_side ? " apart" : " together") + " where their ends have come " + clearance + " m " +
           (is_on_this_side ? "nearer" : "farther apart") + (element.axis ? ", along its axis," : "") +
           " than at the reference.";
  }
  /// Of a stop against compression at `from`, else at `to`.
  static Pad pad(const BumpStop& element) {
    if (element.side != BumpStop::Side::extension) return {element.from, element.to, element.axis};
    std::optional<Vector3> back = element.axis;
    if (back) back = {-(*back)[0], -(*back)[1], -(*back)[2]};
    return {element.to, element.from, back};
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
