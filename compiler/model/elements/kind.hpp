#pragma once
// A kind of element as every floor sees it: its words, where it acts, what it shows, which fields it has.

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// An element acts along the line between two points, or
struct BetweenPoints {
  Attachment from, to;
};
/// between two points along an axis that moves with `from` (unit, GLOBAL axes at the reference), or
struct AlongDirection {
  Attachment from, to;
  Vector3 axis;
};
/// along and about the axes of a frame on `from` (columns, GLOBAL axes at the reference), in some of the six freedoms,
/// or
struct BetweenFrames {
  Attachment from, to;
  Matrix3 axes;
  std::array<bool, 6> acts;
};
/// along a coordinate, or the difference of two, or
struct OnCoordinate {
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to;
};
/// on one body at a point, or
struct OnBody {
  Attachment at;
  bool turns = false;  ///< with a torque
};
/// along the line of a spring (index into Model::springs), or
struct AlongSpring {
  int spring = -1;
};
/// in the ball at an end of a rod (index into Model::rods).
struct InRodEnd {
  int rod = -1;
  bool at_from = false;
};
using Connection =
    std::variant<BetweenPoints, AlongDirection, BetweenFrames, OnCoordinate, OnBody, AlongSpring, InRodEnd>;

/// Calls use(from, to) where an element acts between two points.
template <class Use>
void with_ends(const Connection& connection, const Use& use) {
  std::visit(
      [&](const auto& at) {
        if constexpr (requires { at.from, at.to; }) use(at.from, at.to);
      },
      connection);
}

/// Calls use(attachment) for the points by which an element itself holds on to bodies.
template <class Use>
void each_attachment(const Connection& connection, const Use& use) {
  with_ends(connection, [&](const Attachment& from, const Attachment& to) { use(from), use(to); });
  if (const OnBody* body = std::get_if<OnBody>(&connection)) use(body->at);
}

/// A value that an element shows, as the model format names it.
struct ElementQuantity {
  const char* name;
  const char* unit;
  int components = 1;               ///< 3: an axis says which
  const char* unit_of_turn = unit;  ///< of an element on a coordinate that turns
};

/// Bound of a number, see mbgen/bounds.hpp.
enum class QuantityBound { positive, not_negative, share };

/// Bound of a field, by the last part of its name.
struct FieldBound {
  const char* field;
  QuantityBound bound;
};

/// How a report draws an element: as a link between its two ends, as a pad at one end that the other comes to, or as
/// the mark of a frame. Elements without ends are not drawn.
enum class Drawing { link, pad, frame };

/// The last quantity of a kind that shows it.
constexpr const char* kPotentialEnergy = "potential_energy";

/// A kind of element, specialised beside its struct, with
///   key, section, words   its name in the model format, its section there, and for people
///   list(model)           its list in a Model
///   connection(element)   where it acts
///   fields(element, use)  calls use(name, value) for its quantities, laws, tables and force expressions, and for
///                         numbers, words and directions that tell it apart
/// and where a rig can take it away
///   silence(element)      leaves it without force
template <class Kind>
struct KindOf;

/// Defaults of most kinds.
struct KindDefaults {
  static constexpr const char* source = nullptr;  ///< field of an output that names an element, where it is not `key`
  static constexpr const char* shows = "";        ///< its outputs, for people; the first kind of a `source` tells it
  static constexpr bool is_elastic = false;       ///< it holds its bodies and stores energy
  static constexpr bool has_length = false;       ///< expressions see length.NAME and rate.NAME of it
  static constexpr Drawing drawing = Drawing::link;
  static constexpr std::array<ElementQuantity, 0> quantities = {};
  static constexpr std::array<FieldBound, 0> bounds = {};  ///< of its fields, as the reader holds them
};

}  // namespace mbgen
