// Tables of fields: instances, parameters, inputs, bodies, joints, rods.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// In the order of DisplayShape::Kind.
constexpr std::array<std::string_view, 3> kShapeKinds = {"box", "cylinder", "sphere"};

/// In the order of JointType.
constexpr std::array<std::string_view, 16> kJointTypes = {
    "revolute",    "prismatic",    "cylindrical",   "universal",      "spherical",     "planar",
    "free",        "fixed",        "point_on_line", "point_on_plane", "parallel_axes", "orientation",
    "homokinetic", "rolling_disc", "rolling_ball",  "knife_edge"};

constexpr std::array<std::string_view, 2> kCoordinateSenses = {"mirrored", "parallel"};

}  // namespace

template <>
std::span<const Field<InstanceFields>> fields<InstanceFields>() {
  using F = InstanceFields;
  static const std::array table = {
      field<F, &F::file>({.name = "file",
                          .shape = Shape::text,
                          .doc = "file of the subsystem, in the format of a model, relative to this file",
                          .need = Need::required}),
      field<F, &F::prefix>(
          {.name = "prefix",
           .shape = Shape::text,
           .doc =
               "put before every name of the subsystem; default: the instance's name and _, or nothing with a suffix"}),
      field<F, &F::suffix>({.name = "suffix", .shape = Shape::text, .doc = "put after every name of the subsystem"}),
      field<F, &F::connect>({.name = "connect",
                             .shape = Shape::names,
                             .doc = "bodies of the subsystem that are bodies of this file: the name here; their points "
                                    "in the subsystem are added"}),
      field<F, &F::parameters>({.name = "parameters",
                                .shape = Shape::overrides,
                                .doc = "values for parameters of the subsystem, over parameters of this file",
                                .depends = Depends::parameters,
                                .angle = true}),
      field<F, &F::mirror>({.name = "mirror",
                            .shape = Shape::word,
                            .doc = "mirror plane, in the subsystem's own axes, applied before rotation and offset; xz "
                                   "turns a left side into a right one",
                            .words = kMirrors}),
      field<F, &F::parallel>({.name = "coordinates",
                              .shape = Shape::word,
                              .doc = "meaning of equal coordinates of a mirrored joint: mirrored motions (default), or "
                                     "parallel ones: the axis keeps its direction",
                              .words = kCoordinateSenses}),
      field<F, &F::rotation>({.name = "rotation",
                              .shape = Shape::rotations,
                              .doc = "rotation about the subsystem's origin: one rotation, or a list whose matrices "
                                     "are multiplied left to right",
                              .of = "rotation"}),
      field<F, &F::offset>({.name = "offset",
                            .shape = Shape::position,
                            .doc = "position of the subsystem's origin, default [0, 0, 0]",
                            .unit = "m"}),
  };
  return table;
}

template <>
std::span<const Field<ParameterFields>> fields<ParameterFields>() {
  using F = ParameterFields;
  static const std::array table = joined(
      std::array{
          field<F, &F::quantity>({.name = "value",
                                  .shape = Shape::quantity,
                                  .doc = "value, may use parameters above it; it changes with tunable ones",
                                  .need = Need::required,
                                  .depends = Depends::parameters,
                                  .angle = true}),
          field<F, &F::unit>({.name = "unit", .shape = Shape::text, .doc = "unit, for people"}),
          field<F, &F::tunable>({.name = "tunable",
                                 .shape = Shape::boolean,
                                 .doc = "can be changed in the generated solver",
                                 .fallback = 0}),
          field<F, &F::at_start>({.name = "at_start",
                                  .shape = Shape::boolean,
                                  .doc = "used in the velocities of `initial` only; a fixed parameter of an FMU, set "
                                         "before its initialisation",
                                  .fallback = 0}),
      },
      presentation_fields<F>());
  return table;
}

template <>
std::span<const Field<InputFields>> fields<InputFields>() {
  using F = InputFields;
  static const std::array table = joined(
      std::array{
          field<F, &F::unit>({.name = "unit", .shape = Shape::text, .doc = "unit, for people"}),
          field<F, &F::default_value>({.name = "default",
                                       .shape = Shape::number,
                                       .doc = "value if the input is not set",
                                       .fallback = 0,
                                       .depends = Depends::nothing}),
          field<F, &F::rate>(
              {.name = "derivative",
               .shape = Shape::reference,
               .doc = "input that is its time derivative; without one the input is constant during a step",
               .of = "inputs"}),
      },
      presentation_fields<F>());
  return table;
}

template <>
std::span<const Field<AxisFields>> fields<AxisFields>() {
  using F = AxisFields;
  static const std::array table = {
      field<F, &F::from>({.name = "from",
                          .shape = Shape::place,
                          .doc = "start of the axis, in global axes at the reference configuration",
                          .unit = "m",
                          .need = Need::required}),
      field<F, &F::to>({.name = "to",
                        .shape = Shape::place,
                        .doc = "end of the axis, at least 1e-6 m from its start",
                        .unit = "m",
                        .need = Need::required}),
  };
  return table;
}

template <>
std::span<const Field<RotationFields>> fields<RotationFields>() {
  using F = RotationFields;
  static const std::array table = {
      field<F, &F::axis>(
          {.name = "axis", .shape = Shape::axis, .doc = "axis of rotation", .need = Need::required, .by_points = true}),
      field<F, &F::angle>({.name = "angle",
                           .shape = Shape::number,
                           .doc = "angle of rotation",
                           .unit = "rad",
                           .need = Need::required,
                           .depends = Depends::nothing,
                           .angle = true}),
  };
  return table;
}

template <>
std::span<const Field<Pose>> fields<Pose>() {
  static const std::array table = {
      field<Pose, &Pose::origin>({.name = "origin",
                                  .shape = Shape::position,
                                  .doc = "origin of the body frame in the global frame, default [0, 0, 0]",
                                  .unit = "m"}),
      field<Pose, &Pose::rotation>(
          {.name = "rotation",
           .shape = Shape::rotations,
           .doc = "orientation of the body frame: one rotation, or a list whose matrices are multiplied left to right",
           .of = "rotation"}),
  };
  return table;
}

template <>
std::span<const Field<BodyFields>> fields<BodyFields>() {
  using F = BodyFields;
  static const std::array table = {
      field<F, &F::pose>({.name = "pose",
                          .shape = Shape::object,
                          .doc = "body frame in the global frame at the reference configuration; default: the same",
                          .of = "pose"}),
      field<F, &F::mass>({.name = "mass",
                          .doc = "mass; default: a massless body",
                          .unit = "kg",
                          .fallback = 0,
                          .bound = Bound::not_negative,
                          .depends = Depends::parameters}),
      field<F, &F::written_com>({.name = "com",
                                 .shape = Shape::position,
                                 .doc = "centre of mass in the body frame, default [0, 0, 0]",
                                 .unit = "m",
                                 .depends = Depends::parameters}),
      field<F, &F::inertia>(
          {.name = "inertia",
           .shape = Shape::inertia,
           .doc = "about the centre of mass in body axes: xx yy zz, or the matrix entries xx yy zz xy xz yz",
           .unit = "kg m^2",
           .depends = Depends::parameters}),
      field<F, &F::accepts_inertia>({.name = "accept_inertia",
                                     .shape = Shape::boolean,
                                     .doc = "true: a physically impossible inertia is accepted unless it is negative "
                                            "about an axis, with a note. Imported robots may need it",
                                     .fallback = 0}),
      field<F, &F::point_list>({.name = "points",
                                .shape = Shape::positions,
                                .doc = "named points in the body frame",
                                .unit = "m",
                                .depends = Depends::parameters}),
      field<F, &F::description>(prose_field("description", "for people")),
  };
  return table;
}

template <>
std::span<const Field<JointFields>> fields<JointFields>() {
  using F = JointFields;
  static const std::array table = {
      field<F, &F::written_type>({.name = "type",
                                  .shape = Shape::word,
                                  .doc = "freedoms of the joint; a single one is the coordinate of the joint's name, "
                                         "several add _tx, _ty, _tz along and _rx, _ry, _rz about their axes to it (of "
                                         "a universal joint with axes that are no letters _r1, _r2). Those from "
                                         "point_on_line on have no coordinate and always close a loop",
                                  .need = Need::required,
                                  .words = kJointTypes}),
      field<F, &F::from>({.name = "from",
                          .shape = Shape::attachment,
                          .doc = "point of the body that carries the joint",
                          .need = Need::required}),
      field<F, &F::to>({.name = "to",
                        .shape = Shape::attachment,
                        .doc =
                            "point of the moved body, at the same place at the reference; on the line or in the plane "
                            "of a point_on_line or point_on_plane; centre of a rolling_disc or rolling_ball, point of "
                            "a knife_edge",
                        .need = Need::required}),
      field<F, &F::written_axis>(
          {.name = "axis",
           .shape = Shape::axis,
           .doc = "axis in the frame of `from`; of a planar joint or a point_on_plane the normal, of a "
                  "point_on_line the line, of a homokinetic joint the shaft; of a rolling_disc, rolling_ball or "
                  "knife_edge the normal of the plane through the point of `from`, to the side of the disc or ball",
           .by_points = true}),
      field<F, &F::axis_to>({.name = "axis_to",
                             .shape = Shape::axis,
                             .doc = "the same axis in the frame of `to`, checked against `axis`",
                             .by_points = true}),
      field<F, &F::axis2>(
          {.name = "axis2",
           .shape = Shape::axis,
           .doc = "second axis of a universal joint, perpendicular to the first, in the frame of `from`; of a "
                  "homokinetic joint the shaft of `to`, likewise; default: `axis`; of a rolling_disc its axle, of a "
                  "knife_edge the line of the blade, both of `to` and likewise in the frame of `from`",
           .by_points = true}),
      field<F, &F::radius>(
          {.name = "radius",
           .doc = "radius of a rolling_disc or rolling_ball; default: the distance to the plane at the reference",
           .unit = "m",
           .bound = Bound::positive,
           .depends = Depends::parameters}),
      field<F, &F::sequence>({.name = "sequence",
                              .shape = Shape::text,
                              .doc = "order of the rotations of a spherical or free joint: x, y, z in any order",
                              .fallback_word = "zyx"}),
      field<F, &F::marked_cut>(
          {.name = "cut",
           .shape = Shape::boolean,
           .doc = "true: the joint closes a loop; false: it stays in the tree; absent: mbgen chooses"}),
      field<F, &F::description>(prose_field("description", "for people")),
  };
  return table;
}

template <>
std::span<const Field<RodFields>> fields<RodFields>() {
  using F = RodFields;
  static const std::array table = {
      field<F, &F::from>({.name = "from", .shape = Shape::attachment, .doc = "one end", .need = Need::required}),
      field<F, &F::to>(
          {.name = "to", .shape = Shape::attachment, .doc = "other end, on another body", .need = Need::required}),
      field<F, &F::mass>({.name = "mass",
                          .doc = "mass, uniform along the rod",
                          .unit = "kg",
                          .fallback = 0,
                          .bound = Bound::not_negative,
                          .depends = Depends::parameters}),
      field<F, &F::written_length>({.name = "length",
                                    .doc = "length; if it depends on t or inputs, the rod is a massless actuator, and "
                                           "its length minus the reference length is the driven coordinate of the "
                                           "rod's name and _length; default: the distance of the ends at the reference",
                                    .unit = "m",
                                    .bound = Bound::positive,
                                    .depends = Depends::motion}),
  };
  return table;
}

template <>
std::span<const Field<ShapeFields>> fields<ShapeFields>() {
  using F = ShapeFields;
  static const std::array table = {
      field<F, &F::kind>({.name = "type",
                          .shape = Shape::word,
                          .doc = "shape that is drawn; a box has its edges along the axes of the body's frame",
                          .need = Need::required,
                          .words = kShapeKinds}),
      field<F, &F::from>({.name = "from",
                          .shape = Shape::attachment,
                          .doc = "corner of a box, end of a cylinder, centre of a sphere",
                          .need = Need::required}),
      field<F, &F::to>({.name = "to",
                        .shape = Shape::attachment,
                        .doc = "opposite corner of a box, other end of a cylinder, on the same body"}),
      field<F, &F::written_radius>({.name = "radius",
                                    .shape = Shape::number,
                                    .doc = "radius of a cylinder or sphere",
                                    .unit = "m",
                                    .bound = Bound::positive}),
      field<F, &F::colour>({.name = "colour", .shape = Shape::text, .doc = "\"#rrggbb\"; default: the body's"}),
  };
  return table;
}

}  // namespace mbgen::reading
