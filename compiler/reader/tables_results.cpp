// Tables of fields: motions, outputs, initial state, solver; and the list of all kinds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <iterator>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/included.hpp"
#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/reader/tables/table_fields.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 3> kIntegrators = {"rk4", "abm4", "rosenbrock"};

}  // namespace

template <>
std::span<const Field<MotionFields>> fields<MotionFields>() {
  using F = MotionFields;
  static const std::array table = {
      field<F, &F::joint>(
          {.name = "joint", .shape = Shape::coordinate, .doc = "coordinate that is driven", .need = Need::required}),
      field<F, &F::angle>({.name = "angle",
                           .doc = "angle over t, of a rotation",
                           .unit = "rad",
                           .depends = Depends::motion,
                           .angle = true}),
      field<F, &F::displacement>({.name = "position",
                                  .doc = "displacement over t, of a translation",
                                  .unit = "m",
                                  .depends = Depends::motion}),
      field<F, &F::actuated_by>({.name = "actuated_by",
                                 .shape = Shape::paths,
                                 .doc = "actuators that give the motion: inverse dynamics finds their forces in place "
                                        "of the driving force"}),
  };
  return table;
}

template <>
std::span<const Field<InitialValueFields>> fields<InitialValueFields>() {
  using F = InitialValueFields;
  static const std::array table = {
      field<F, &F::value>({.name = "value",
                           .shape = Shape::quantity,
                           .doc = "of the coordinate or its velocity",
                           .unit = "rad, m, rad/s or m/s",
                           .need = Need::required,
                           .depends = Depends::nothing,
                           .angle = true,
                           .at_start = true}),
      field<F, &F::weight>({.name = "weight",
                            .shape = Shape::number,
                            .doc = "weight of its squared error, if values are inconsistent",
                            .fallback = 1,
                            .bound = Bound::positive,
                            .depends = Depends::nothing}),
      field<F, &F::locked>({.name = "locked",
                            .shape = Shape::boolean,
                            .doc = "the value is exact, only the others are changed",
                            .fallback = 0}),
  };
  return table;
}

template <>
std::span<const Field<OrientationFields>> fields<OrientationFields>() {
  using F = OrientationFields;
  static const std::array table = {
      field<F, &F::quaternion>({.name = "quaternion",
                                .shape = Shape::quaternion,
                                .doc = "w, x, y, z of the rotation of `to` relative to `from`, of any length but zero",
                                .depends = Depends::nothing}),
      field<F, &F::rotation_vector>(
          {.name = "rotation_vector",
           .shape = Shape::vector,
           .doc = "axis times angle of the rotation of `to` relative to `from`, in the axes of `from`",
           .unit = "rad",
           .depends = Depends::nothing}),
      field<F, &F::angular_velocity>({.name = "angular_velocity",
                                      .shape = Shape::vector,
                                      .doc = "of `to` relative to `from`, in the axes of `from`",
                                      .unit = "rad/s",
                                      .depends = Depends::nothing}),
  };
  return table;
}

template <>
std::span<const Field<InitialFields>> fields<InitialFields>() {
  using F = InitialFields;
  static const std::array table = {
      field<F, &F::equilibrium>({.name = "equilibrium",
                                 .shape = Shape::boolean,
                                 .doc = "start from static equilibrium, then set the velocities",
                                 .fallback = 0}),
      field<F, &F::positions>({.name = "positions",
                               .shape = Shape::values,
                               .doc = "coordinates at the start; the others are zero or follow from the closures; "
                                      "inconsistent values are changed as little as possible",
                               .unit = "rad or m",
                               .depends = Depends::nothing,
                               .angle = true,
                               .of = "initial_value"}),
      field<F, &F::velocities>({.name = "velocities",
                                .shape = Shape::values,
                                .doc = "velocities at the start",
                                .unit = "rad/s or m/s",
                                .depends = Depends::nothing,
                                .angle = true,
                                .of = "initial_value"}),
      field<F, &F::orientations>(
          {.name = "orientations",
           .shape = Shape::map,
           .doc = "initial orientations of spherical and free joints, by joint, instead of angles and their rates",
           .of = "initial_orientation"}),
  };
  return table;
}

template <>
std::span<const Field<SolverSettings>> fields<SolverSettings>() {
  using S = SolverSettings;
  const auto number = [](std::string_view name, std::string_view doc, std::string_view unit, double fallback,
                         Bound bound) { return constant_info(name, doc, unit, fallback, bound, Depends::nothing); };
  static const std::array table = {
      field<S, &S::integrator>({.name = "integrator",
                                .shape = Shape::word,
                                .doc = "Runge-Kutta of order 4, Adams-Bashforth-Moulton of order 4, or a linearly "
                                       "implicit method of order 3 for stiff models",
                                .fallback_word = "rk4",
                                .words = kIntegrators}),
      field<S, &S::step>(number("step", "time step", "s", 1e-3, Bound::positive)),
      field<S, &S::duration>(number("duration", "simulated time", "s", 1, Bound::not_negative)),
      field<S, &S::closure_tolerance>(
          number("closure_tolerance", "largest closure residual after projection", "m or 1", 1e-12, Bound::positive)),
      field<S, &S::tolerance>(
          number("tolerance", "relative tolerance recommended by an FMU to importers", "", 1e-6, Bound::positive)),
  };
  return table;
}

namespace {

/// Kinds after those of elements.
std::vector<ObjectKind> other_kinds() {
  static const std::string output_doc =
      fmt::format("a result; exactly one of {} and {}",
                  fmt::join(kOutputSources.begin(), kOutputSources.end() - 1, ", "), kOutputSources.back());
  return {
      kind_of<RoadFields>(
          "road",
          "a road: its height is the sum of `height` and all features, over the plane z of its origin; x "
          "along it, y to the left"),
      kind_of<IsoRoadFields>("iso_road", "a rough road by the power spectral density of ISO 8608"),
      kind_of<RoadProfileFields>("road_profile",
                                 "heights at equal distances along a road, interpolated by a cubic spline, level "
                                 "outside; one column for both sides, or a left and a right track"),
      kind_of<CrgFields>(
          "crg_road",
          "a road from an OpenCRG file; it is straight beyond its ends, and has the border's height beyond a border"),
      kind_of<RoadFeature>("road_feature", "an obstacle on a road, a gap in it, or waves"),
      kind_of<RoadPatch>("road_patch", "a part of a road with its own friction"),
      kind_of<AxleFields>("axle",
                          "an axle on a rig for kinematics and compliance; x forward, y to the left and z up at the "
                          "reference"),
      kind_of<AxleWheelFields>("axle_wheel", "a wheel of an axle; exactly one of tyre and centre", {"tyre", "centre"}),
      kind_of<VehicleFields>("vehicle", "the vehicle and its inputs, for manoeuvres"),
      kind_of<MotionFields>("motion", "a driven coordinate; exactly one of angle and position", {"angle", "position"}),
      kind_of<OutputFields>("output", output_doc, {std::begin(kOutputSources), std::end(kOutputSources)}),
      kind_of<ShapeFields>("shape", "how a part of a body is drawn"),
      kind_of<InitialFields>("initial", "initial state"),
      kind_of<InitialValueFields>("initial_value", "an initial value, and its weight if values are inconsistent"),
      kind_of<OrientationFields>("initial_orientation",
                                 "initial orientation of a spherical or free joint; at most one of quaternion and "
                                 "rotation_vector, without both the angles of positions are used"),
      kind_of<SolverSettings>("solver", "time integration"),
      kind_of<TableFields>("table", "a characteristic by points, exactly one of table and csv", {"table", "csv"}),
      kind_of<NamedTableFields>("named_table", "a curve for expressions, exactly one of table and csv",
                                {"table", "csv"}),
      kind_of<MapFields>("map", "a table of two variables for expressions: either csv, or x, y and z"),
  };
}

}  // namespace

std::vector<ObjectKind> object_kinds() {
  std::vector<ObjectKind> kinds = {
      kind_of<FileFields>("model", "a multibody system; SI units, angles in rad"),
      kind_of<IncludeFields>("include", "an included file with changes"),
      kind_of<InstanceFields>("instance", "a subsystem: a file placed in this one"),
      kind_of<ParameterFields>("parameter", "a named constant"),
      kind_of<InputFields>("input", "a value given to the solver"),
      kind_of<BodyFields>("body", "a rigid body"),
      kind_of<Pose>("pose", "a frame in the global frame"),
      kind_of<RotationFields>("rotation", "a rotation about an axis"),
      kind_of<AxisFields>("axis_by_points", "an axis from one point to another"),
      kind_of<JointFields>("joint", "a joint"),
      kind_of<RodFields>("rod", "a bar with a spherical joint at each end"),
  };
  const auto add = [&](std::vector<ObjectKind> more) {
    kinds.insert(kinds.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  each_composition([&](auto composition) { add(section_of(composition).kinds()); });
  add({
      kind_of<Coupling>("coupling", "a relation between coordinates; exactly one of relation and curve",
                        {"relation", "curve"},
                        {{"curve", "joint"}, {"curve", "follows"}, {"joint", "curve"}, {"follows", "curve"}}),
      kind_of<UserStateFields>("state", "a state of your own, integrated with the motion"),
      kind_of<SampledValueFields>(
          "sampled_value",
          "a value that is set at t = 0, period, 2 period and so on; exactly one of value and reaction",
          {"value", "reaction"}),
      kind_of<SensorFields>("sensor", "a measured value, set at t = 0, period, 2 period and so on"),
      kind_of<DelayFields>("delay", "a value as it was some time ago"),
  });
  each_section([&]<class Kind>(KindOf<Kind>) { add(section_of(Leader<Kind>()).kinds()); });
  add(other_kinds());
  return kinds;
}

}  // namespace mbgen::reading
