// Table of fields: outputs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/presentation.hpp"

namespace mbgen::reading {
namespace {

/// In the order of Letter.
constexpr std::array<std::string_view, 4> kComponents = {"x", "y", "z", "w"};
/// In the order of Turn.
constexpr std::array<std::string_view, 3> kTurns = {"first", "second", "third"};
/// In the order of BodySet.
constexpr std::array<std::string_view, 1> kBodySets = {"all"};
/// In the order of ReactionOutput::End.
constexpr std::array<std::string_view, 2> kEnds = {"to", "from"};

FieldInfo body_field(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::reference, .doc = doc, .of = "bodies"};
}

template <class Kind>
constexpr FieldInfo element_field() {
  using Of = KindOf<Kind>;
  return {.name = source_key(Of{}), .shape = Shape::reference, .doc = Of::shows, .of = Of::section};
}

/// The field for an element's name.
template <class Kind>
Field<OutputFields> element_row(KindOf<Kind>) {
  return field<OutputFields, &SourceName<Kind>::element>(element_field<Kind>());
}

/// "springs, joint springs": kinds of elements with potential energy.
std::string kinds_with_energy() {
  std::vector<std::string> kinds;
  each_kind([&](auto kind) {
    if (quantity_index(kind, kPotentialEnergy) >= 0) kinds.push_back(fmt::format("{}s", kind.words));
  });
  return enumeration(kinds);
}

/// Fields of an output's source.
std::vector<Field<OutputFields>> source_fields() {
  using F = OutputFields;
  static const std::string energy_doc = fmt::format("potential energy of all {} together", kinds_with_energy());
  std::vector<Field<F>> rows = {
      field<F, &F::unit>({.name = "unit", .shape = Shape::text, .doc = "unit; default: unit of the quantity"}),
      field<F, &F::expression>({.name = "expression",
                                .doc = "value over t, parameters, inputs, coordinates, states and outputs",
                                .sees_accelerations = true}),
      field<F, &F::point>({.name = "point", .shape = Shape::attachment, .doc = "motion of a point"}),
      field<F, &F::points>({.name = "points",
                            .shape = Shape::attachments,
                            .doc = "two points: their distance; three: the angle at the second one",
                            .most = 3}),
      field<F, &F::body>(body_field("body", "rotation, energy or momentum of a body")),
      field<F, &F::bodies>({.name = "bodies",
                            .shape = Shape::word,
                            .doc = "energy or momentum of all bodies and rods together",
                            .words = kBodySets}),
      field<F, &F::joint>({.name = "joint",
                           .shape = Shape::coordinate,
                           .doc = "motion of a coordinate, or angles of the wheel in a revolute joint"}),
  };
  const auto add = [&](const auto& is_asked) {
    each_element_source([&](auto kind) {
      if (is_asked(source_key(kind))) rows.push_back(element_row(kind));
    });
  };
  const auto is_tyre = [](std::string_view key) { return key == "tyre"; };
  const auto is_spring = [](std::string_view key) { return key.ends_with("spring"); };
  add(is_tyre);
  add(is_spring);
  rows.push_back(
      field<F, &F::elements>({.name = "elements", .shape = Shape::word, .doc = energy_doc, .words = kBodySets}));
  add([&](std::string_view key) { return !is_tyre(key) && !is_spring(key); });
  const Field<F> others[] = {
      field<F, &F::motion>({.name = "motion",
                            .shape = Shape::reference,
                            .doc = "generalised force that drives a motion",
                            .of = "motions"}),
      field<F, &F::reaction>({.name = "reaction",
                              .shape = Shape::reference,
                              .doc = "joint or rod; the output is its force or moment on its `to` body",
                              .of = "joints"}),
      field<F, &F::multiplier>({.name = "multiplier",
                                .shape = Shape::reference,
                                .doc = "multiplier of one equation of a cut joint, rod or coupling",
                                .of = "joints"}),
  };
  rows.insert(rows.end(), std::begin(others), std::end(others));
  return rows;
}

/// " of the spring (force, length, rate, potential_energy)," and so on.
std::string element_quantities() {
  std::string text;
  each_element_source([&](auto kind) {
    std::vector<std::string_view> names;
    for (const ElementQuantity& quantity : kind.quantities) names.push_back(quantity.name);
    text += fmt::format(" of the {} ({}),", kind.words, fmt::join(names, ", "));
  });
  return text;
}

/// Fields of the quantity.
auto quantity_fields() {
  using F = OutputFields;
  static const std::string doc = fmt::format(
      "quantity of the point or coordinate (position, velocity, acceleration), of the points (distance of two, angle "
      "of three), of the body (angle, rotation_vector, quaternion, angular_velocity, angular_acceleration, "
      "kinetic_energy, potential_energy, momentum, angular_momentum), of all bodies (kinetic_energy, potential_energy, "
      "momentum, angular_momentum),{} of the wheel of a tyre or of a revolute joint "
      "(toe, camber, steer_angle, caster, kingpin_inclination), of all elements (potential_energy) or of the reaction "
      "(force, moment); default: the first of each",
      element_quantities());
  return std::array{
      field<F, &F::quantity>({.name = "quantity", .shape = Shape::word, .doc = doc, .words = kQuantityWords}),
      field<F, &F::axis>({.name = "axis",
                          .shape = Shape::word,
                          .doc = "component of a vector; w: the scalar part of a quaternion, which is never negative",
                          .words = kComponents}),
      field<F, &F::in_body_axes>(
          {.name = "frame",
           .shape = Shape::word,
           .doc = "axes of the component: global (default), or of the point's body, of a reaction the body at `end`",
           .words = kFrames}),
      field<F, &F::axes_of>(body_field("axes_of", "body with the axes of the component, instead of `frame`")),
  };
}

/// Fields of details: reference body, observer, rotations.
auto detail_fields() {
  using F = OutputFields;
  return std::array{
      field<F, &F::relative_to>(
          body_field("relative_to",
                     "of a point: reference body.point; of a body: reference body of its rotation; of a wheel's "
                     "angles: body with the vehicle's axes (x forward, y to the left, z up); default: ground")),
      field<F, &F::observer>(
          body_field("observer",
                     "observer of the velocity or acceleration, with `relative_to`; default: the body of the axes, so "
                     "that the velocity is the rate of the component of the position")),
      field<F, &F::sequence>({.name = "sequence",
                              .shape = Shape::text,
                              .doc = "axes of the three rotations of an angle, each about the axes rotated by the "
                                     "previous ones, as \"zyx\" or \"zxz\"; default \"zyx\""}),
      field<F, &F::turn>(
          {.name = "turn", .shape = Shape::word, .doc = "rotation of the angle, one of three", .words = kTurns}),
      field<F, &F::about>({.name = "about",
                           .shape = Shape::attachment,
                           .doc = "reference point of an angular momentum; default: the centre of mass"}),
      field<F, &F::steering_axis>(
          {.name = "steering_axis", .shape = Shape::attachments, .doc = "lower and upper point of the steering axis"}),
      field<F, &F::end>({.name = "end",
                         .shape = Shape::word,
                         .doc = "body that a reaction acts on, default to; its moment is about the joint's point on "
                                "`to` at both",
                         .words = kEnds}),
      field<F, &F::equation>({.name = "equation",
                              .shape = Shape::equation,
                              .doc = "name of the equation of a multiplier, or its number from 0"}),
  };
}

}  // namespace

template <>
std::span<const Field<OutputFields>> fields<OutputFields>() {
  static const std::vector<Field<OutputFields>> table = [] {
    std::vector<Field<OutputFields>> rows = source_fields();
    const auto others = joined(joined(quantity_fields(), detail_fields()), presentation_fields<OutputFields>());
    rows.insert(rows.end(), others.begin(), others.end());
    return rows;
  }();
  return table;
}

}  // namespace mbgen::reading
