#pragma once
// Kinds of elements: names, attachment, quantities for outputs, fields; used by all floors.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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
/// in the ball at an end of a rod (index into Model::rods), or
struct InRodEnd {
  int rod = -1;
  bool at_from = false;
};
/// along the lines through several points, in this order.
struct ThroughPoints {
  std::vector<Attachment> points;
  std::vector<Vector3> turns;  ///< of each: the axis about which a turn of its body acts too, else zero
};
using Connection = std::variant<BetweenPoints, AlongDirection, BetweenFrames, OnCoordinate, OnBody, AlongSpring,
                                InRodEnd, ThroughPoints>;

/// Calls use(from, to) for an element between two points, and for each line of an element through several.
template <class Use>
void with_ends(const Connection& connection, const Use& use) {
  std::visit(
      [&](const auto& at) {
        if constexpr (requires { at.from, at.to; }) use(at.from, at.to);
        if constexpr (requires { at.points; })
          for (std::size_t i = 0; i + 1 < at.points.size(); ++i) use(at.points[i], at.points[i + 1]);
      },
      connection);
}

/// Calls use(attachment) for the points at which an element itself is attached to bodies.
template <class Use>
void each_attachment(const Connection& connection, const Use& use) {
  with_ends(connection, [&](const Attachment& from, const Attachment& to) { use(from), use(to); });
  if (const OnBody* body = std::get_if<OnBody>(&connection)) use(body->at);
}

/// A quantity of an element for outputs, by its name in the model format.
struct ElementQuantity {
  const char* name;
  const char* unit;
  int components = 1;               ///< 3: an axis says which
  const char* unit_of_turn = unit;  ///< for an element on a rotational coordinate
};

/// An auxiliary state of an element.
struct HiddenState {
  std::string suffix;          ///< of its name, behind the name of the element
  double size = 1e-4;          ///< typical magnitude
  const char* unit = nullptr;  ///< none: of the coordinate that the element acts on, of others m
};

/// Auxiliary states at rest: slips and bristles keep any value, relaxing ones have the values at which their rates are
/// zero.
enum class StateNature { slip, bristle, relaxing };

/// Bound of a number, see mbgen/bounds.hpp.
enum class QuantityBound { positive, not_negative, share };

/// Bound of a field, by the last part of its name.
struct FieldBound {
  const char* field;
  QuantityBound bound;
};

/// Picture of an element in a report: a link between its two ends, a pad at the end that is hit, or a mark of a frame.
/// Elements without ends are not drawn.
enum class Drawing { link, pad, frame };

/// A pad at `at`, towards `other` or along an axis (unit, GLOBAL axes at the reference).
struct Pad {
  Attachment at, other;
  std::optional<Vector3> axis;
};

/// The last quantity in the table of a kind with energy.
constexpr const char* kPotentialEnergy = "potential_energy";

/// A kind of element, specialised beside its struct, with
///   key, section, words   its name and its section in the model format, its name for people
///   list(model)           its list in a Model
///   connection(element)   where it acts
///   fields(element, use)  calls use(name, value) for its quantities, laws, tables and force expressions, and for
///                         numbers, words and directions that distinguish it
/// for a kind in StatefulKinds
///   nature, states(element, use)   calls use(HiddenState) for its auxiliary states
/// for a kind that may lose its way
///   holds(model, index, names)     appends the names of the places of an element, at each of which it must hold
/// for a kind that a rig can remove
///   silence(element)      sets its force to zero
///   smooth(element)       takes its friction away, in a kind with other forces beside it
/// for people
///   sentence(words, element)       what it does, with its states; "" for nothing. words: see explained_elements.cpp
///   pad(element)                   where a pad is drawn
///   draw_lines, draw_shapes(canvas, element)   lines between bodies, shapes on bodies. canvas: see
///   element_pictures.cpp
template <class Kind>
struct KindOf;

/// Defaults of most kinds.
struct KindDefaults {
  static constexpr const char* source = nullptr;  ///< output field for an element, if not `key`
  static constexpr const char* shows = "";        ///< description of its outputs; given by the first kind of a `source`
  static constexpr bool is_elastic = false;       ///< connects its bodies elastically and has potential energy
  static constexpr bool has_length = false;       ///< expressions may use its length.NAME and rate.NAME
  static constexpr Drawing drawing = Drawing::link;
  static constexpr std::array<ElementQuantity, 0> quantities = {};
  static constexpr std::array<FieldBound, 0> bounds = {};  ///< of its fields, as the reader holds them
};

}  // namespace mbgen
