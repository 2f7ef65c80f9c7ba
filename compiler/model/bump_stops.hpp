#pragma once
// Bump stops: elements that push after a clearance is used up, and never pull.

#include <optional>
#include <string>

#include "compiler/model/elements.hpp"

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

}  // namespace mbgen
