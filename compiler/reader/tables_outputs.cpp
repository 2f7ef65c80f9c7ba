// Table of fields: outputs.
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
/// In the order of Quantities.
constexpr std::array<std::string_view, 29> kQuantities = {"position",
                                                          "velocity",
                                                          "acceleration",
                                                          "load",
                                                          "longitudinal_force",
                                                          "lateral_force",
                                                          "aligning_moment",
                                                          "longitudinal_slip",
                                                          "lateral_slip",
                                                          "force",
                                                          "length",
                                                          "rate",
                                                          "moment",
                                                          "distance",
                                                          "angle",
                                                          "rotation_vector",
                                                          "quaternion",
                                                          "angular_velocity",
                                                          "angular_acceleration",
                                                          "kinetic_energy",
                                                          "potential_energy",
                                                          "momentum",
                                                          "angular_momentum",
                                                          "toe",
                                                          "camber",
                                                          "steer_angle",
                                                          "caster",
                                                          "kingpin_inclination",
                                                          "deflection"};
/// In the order of ReactionOutput::End.
constexpr std::array<std::string_view, 2> kEnds = {"to", "from"};

FieldInfo body_field(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::reference, .doc = doc, .of = "bodies"};
}

/// Fields of an output's source.
auto source_fields() {
  using F = OutputFields;
  return std::array{
      field<F, &F::unit>({.name = "unit", .shape = Shape::text, .doc = "unit; default: unit of the quantity"}),
      field<F, &F::expression>({.name = "expression", .doc = "value over t, parameters, inputs and coordinates"}),
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
      field<F, &F::joint>({.name = "joint", .shape = Shape::coordinate, .doc = "motion of a coordinate"}),
      field<F, &F::tyre>({.name = "tyre",
                          .shape = Shape::reference,
                          .doc = "state of a tyre, or angle of its wheel to a vehicle",
                          .of = "tyres"}),
      field<F, &F::spring>(
          {.name = "spring", .shape = Shape::reference, .doc = "state of a spring or air spring", .of = "springs"}),
      field<F, &F::joint_spring>({.name = "joint_spring",
                                  .shape = Shape::reference,
                                  .doc = "potential energy of a joint spring",
                                  .of = "joint_springs"}),
      field<F, &F::elements>({.name = "elements",
                              .shape = Shape::word,
                              .doc = "potential energy of all springs, joint springs, bushings and bump stops together",
                              .words = kBodySets}),
      field<F, &F::bushing>(
          {.name = "bushing",
           .shape = Shape::reference,
           .doc = "bushing; the output is its force or moment on `to` at its point, its deflection or its rotation "
                  "vector, in its axes on `from`, or its potential energy",
           .of = "bushings"}),
      field<F, &F::bump_stop>(
          {.name = "bump_stop",
           .shape = Shape::reference,
           .doc = "force of a bump stop, its deflection beyond the clearance, the rate of that, or its "
                  "potential energy",
           .of = "bump_stops"}),
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
}

/// Fields of its quantity.
auto quantity_fields() {
  using F = OutputFields;
  return std::array{
      field<F, &F::quantity>(
          {.name = "quantity",
           .shape = Shape::word,
           .doc =
               "quantity of the point or coordinate (position, velocity, acceleration), of the points (distance of "
               "two, angle of three), of the body (angle, rotation_vector, quaternion, angular_velocity, "
               "angular_acceleration, kinetic_energy, potential_energy, momentum, angular_momentum), of all bodies "
               "(kinetic_energy, potential_energy, momentum, angular_momentum), of the tyre (load, "
               "longitudinal_force, lateral_force, aligning_moment, longitudinal_slip, lateral_slip, toe, camber, "
               "steer_angle, caster, kingpin_inclination), of the spring (force, length, rate, potential_energy), of "
               "the bushing (force, moment, deflection, rotation_vector, potential_energy), of the bump stop "
               "(force, deflection, rate, potential_energy), of the joint spring or of all elements "
               "(potential_energy) or of the reaction (force, moment); default: "
               "the first of each",
           .words = kQuantities}),
      field<F, &F::axis>({.name = "axis",
                          .shape = Shape::word,
                          .doc = "component of a vector; w: the scalar part of a quaternion, which is never negative",
                          .words = kComponents}),
      field<F, &F::in_body_axes>(
          {.name = "frame",
           .shape = Shape::word,
           .doc = "axes of the component: global (default), or of the point's body, of a reaction the body at `end`",
           .words = kFrames}),
      field<F, &F::axes_of>(body_field("axes_of", "body in whose axes the component is, in place of `frame`")),
  };
}

/// Fields of its details: reference body, observer, rotations.
auto detail_fields() {
  using F = OutputFields;
  return std::array{
      field<F, &F::relative_to>(body_field("relative_to",
                                           "of a point: body.point that is subtracted; of a body: body that its "
                                           "rotation is relative to; of a wheel's angles: body whose axes are the "
                                           "vehicle's (x forward, y to the left, z up); default: ground")),
      field<F, &F::observer>(body_field("observer",
                                        "body from which the velocity or acceleration is seen, where `relative_to` "
                                        "stands; default: the body of the axes, so that the velocity is the rate of "
                                        "the component of the position")),
      field<F, &F::sequence>({.name = "sequence",
                              .shape = Shape::text,
                              .doc =
                                  "axes of the three rotations of an angle, each about the axes that the ones before "
                                  "it left, as \"zyx\" or \"zxz\"; default \"zyx\""}),
      field<F, &F::turn>({.name = "turn",
                          .shape = Shape::word,
                          .doc = "which of the three rotations the angle belongs to",
                          .words = kTurns}),
      field<F, &F::about>({.name = "about",
                           .shape = Shape::attachment,
                           .doc = "point that an angular momentum is about; default: the centre of mass"}),
      field<F, &F::steering_axis>({.name = "steering_axis",
                                   .shape = Shape::attachments,
                                   .doc = "lower and upper point of the axis that the wheel is steered about"}),
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
  static const std::array table =
      joined(joined(joined(source_fields(), quantity_fields()), detail_fields()), presentation_fields<OutputFields>());
  return table;
}

}  // namespace mbgen::reading
