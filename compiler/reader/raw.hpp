#pragma once
// Objects of the model format without a one-to-one struct in Model: filled by the tables, resolved by later functions.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/reader/fields.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {

/// The section of a kind of element, for the first kind in it.
template <class Kind>
struct SectionOf {
  const Value *section = nullptr;
};
template <class List>
struct SectionsOf;
template <class... Kind>
struct SectionsOf<Kinds<Kind...>> : SectionOf<Kind>... {};

// Elements that stand for others, in the order of their sections: see ComposedSection.
struct AntiRollBarFields;
struct BeamFields;
using Compositions = Kinds<AntiRollBarFields, BeamFields>;

/// The whole file: its sections, read in order since each needs the names of those before it.
struct FileFields : About, SectionsOf<ElementKinds>, SectionsOf<Compositions> {
  std::size_t document = 0;  ///< index into Documents
  const Value *format = nullptr, *name = nullptr, *gravity = nullptr, *include = nullptr;
  const Value *hardpoints = nullptr;
  const Value *tables = nullptr, *maps = nullptr;
  const Value *parameters = nullptr, *inputs = nullptr, *bodies = nullptr, *joints = nullptr, *rods = nullptr;
  const Value *tyre_data = nullptr, *motions = nullptr;
  const Value *axles = nullptr, *vehicle = nullptr;
  const Value *roads = nullptr;
  const Value *couplings = nullptr, *states = nullptr, *sampled = nullptr;
  const Value *values = nullptr, *sensors = nullptr, *delays = nullptr;
  const Value *outputs = nullptr, *shapes = nullptr, *initial = nullptr, *solver = nullptr, *instances = nullptr;
};

/// Mirror planes of subsystems.
enum class Mirror { xz, yz, xy };
constexpr std::array<std::string_view, 3> kMirrors = {"xz", "yz", "xy"};

/// A subsystem as placed by the model; entries with parameters are read after the parameters.
struct InstanceFields {
  std::optional<std::string> file, prefix, suffix;
  const Value *offset = nullptr, *rotation = nullptr, *parameters = nullptr, *connect = nullptr;
  std::optional<Mirror> mirror;
  std::optional<bool> parallel;
};

/// An axis by two points.
struct AxisFields {
  const Value *from = nullptr, *to = nullptr;
};

struct RotationFields {
  Vector3 axis{0, 0, 1};
  double angle = 0;
};

struct ParameterFields : Parameter, Presentation {
  Quantity quantity;
};

struct InputFields : Input, Presentation {
  std::optional<std::string> rate;  ///< name of the derivative
};

struct BodyFields : Body {
  const Value *point_list = nullptr, *written_com = nullptr;
  bool accepts_inertia = false;
};

/// A joint with axes as written, in body frames.
struct JointFields : Joint {
  std::optional<JointType> written_type;
  std::optional<Vector3> written_axis, axis_to, axis2;
  std::string sequence;
  std::optional<bool> marked_cut;
};

/// A rod with its length as written, possibly a function of time and inputs.
struct RodFields : Rod {
  std::optional<Quantity> written_length;
};

/// A state with its derivative as written: read after all initial values.
struct UserStateFields : UserState, Presentation {
  const Value *written = nullptr;
};

/// A reaction as normal force.
struct ReactionFields {
  std::optional<std::string> reaction;
  std::optional<ReactionOutput::What> quantity;
  std::optional<ReactionLoad::Direction> direction;
};

struct SampledValueFields : SampledValue, Presentation, ReactionFields {
  const Value *written = nullptr;
  double written_delay = 0;
};

/// A measured value: see read_sensors.
struct SensorFields : Presentation {
  std::string name;
  Where where;
  const Value *written = nullptr;
  double period = 0, delay = 0;  ///< s
  Quantity gain = 1.0, bias, noise, quantisation;
  std::optional<Quantity> filter, least, most;
  double seed = 1, initial = 0;
  std::string unit;
};

/// A value as it was some time ago: see read_delays.
struct DelayFields : Presentation {
  std::string name;
  Where where;
  const Value *written = nullptr;
  double period = 0, delay = 0;  ///< s
  double initial = 0;
  std::string unit;
};

struct TyreDataFields {
  std::string name;
  Where where;
  std::optional<TyreModel> written_model;
  const Value *coefficients = nullptr;
};

/// A rough road by its class.
struct IsoRoadFields {
  enum class Class { a, b, c, d, e, f, g, h };
  Class letter = Class::a;
  double seed = 1, length = 0, track = 0, coherence = 0, longest_wave = 0, shortest_wave = 0;
};

/// Heights along a road from a CSV file.
struct RoadProfileFields {
  std::string csv, x, z, right, left;  ///< the file and its columns
  double track = 0;
};

/// A road of an OpenCRG file.
struct CrgFields {
  std::string file;
  double smooth_begin = 0, smooth_end = 0;
  RoadBorder beyond_ends = RoadBorder::keep, beyond_sides = RoadBorder::keep;
};

struct RoadFields : Road {
  bool from_host = false;
  const Value *crg = nullptr;
  const Value *profile = nullptr;
  const Value *iso_8608 = nullptr;
  const Value *feature_map = nullptr, *patch_map = nullptr;
};

struct TyreFields : Tyre {
  std::optional<std::string> written_road;
  const Value *enveloping = nullptr, *written_parking = nullptr;
  std::optional<bool> written_turn_slip;
  std::string data;
  std::optional<std::string> tir;  ///< file
};

struct AxleWheelFields {
  std::optional<std::string> tyre;
  std::optional<Attachment> written_centre;
  std::optional<Vector3> written_axis;
  std::optional<double> written_radius;
  std::optional<std::vector<Attachment>> steering_axis;
};

/// An axle with its wheels as written.
struct AxleFields : Axle {
  std::string written_body;
  const Value *written_left = nullptr, *written_right = nullptr, *written_without = nullptr, *written_steer = nullptr;
};

/// The vehicle with names of inputs and of a parameter as written.
struct VehicleFields : Vehicle {
  std::optional<std::string> written_steer, written_drive, written_brake, written_speed;
};

struct MotionFields : Motion {
  std::optional<Quantity> angle, displacement;
  const Value *actuated_by = nullptr;  ///< names of actuators
};

enum class Quantities {
  position,
  velocity,
  acceleration,
  load,
  longitudinal_force,
  lateral_force,
  aligning_moment,
  longitudinal_slip,
  lateral_slip,
  force,
  length,
  rate,
  moment,
  distance,
  angle,
  rotation_vector,
  quaternion,
  angular_velocity,
  angular_acceleration,
  kinetic_energy,
  potential_energy,
  momentum,
  angular_momentum,
  toe,
  camber,
  steer_angle,
  caster,
  kingpin_inclination,
  deflection,
  speed,
  power
};

enum class Letter { x, y, z, w };

enum class Turn { first, second, third };

/// Bodies or elements of an output of several.
enum class BodySet { all };

/// Name of the element in an output of a kind.
template <class Kind>
struct SourceName {
  std::optional<std::string> element;
};
template <class List>
struct SourceNames;
template <class... Kind>
struct SourceNames<Kinds<Kind...>> : SourceName<Kind>... {};

struct OutputFields : Presentation, SourceNames<ElementKinds> {
  std::string name;
  Where where;
  std::string unit;
  std::optional<Quantity> expression;
  std::optional<Attachment> point;
  std::optional<CoordinateReference> joint;
  std::optional<std::vector<Attachment>> points, steering_axis;
  std::optional<Attachment> about;
  std::optional<BodySet> bodies, elements;
  std::optional<std::string> motion, reaction, multiplier, body, axes_of, observer, sequence;
  const Value *equation = nullptr, *relative_to = nullptr;
  std::optional<Turn> turn;
  std::optional<ReactionOutput::End> end;
  std::optional<Quantities> quantity;
  std::optional<Letter> axis;
  std::optional<bool> in_body_axes;
};

struct ShapeFields : DisplayShape {
  std::optional<double> written_radius;
  std::string colour;
};

struct InitialValueFields {
  Quantity value;
  double weight = 1;
  bool locked = false;
};

struct OrientationFields {
  std::optional<std::array<double, 4>> quaternion;
  std::optional<Vector3> rotation_vector, angular_velocity;
};

struct InitialFields {
  bool equilibrium = false;
  const Value *positions = nullptr, *velocities = nullptr, *orientations = nullptr;
};

// The tables, declared before their use.
template <>
std::span<const Field<FileFields>> fields<FileFields>();
template <>
std::span<const Field<InstanceFields>> fields<InstanceFields>();
template <>
std::span<const Field<ParameterFields>> fields<ParameterFields>();
template <>
std::span<const Field<InputFields>> fields<InputFields>();
template <>
std::span<const Field<BodyFields>> fields<BodyFields>();
template <>
std::span<const Field<Pose>> fields<Pose>();
template <>
std::span<const Field<RotationFields>> fields<RotationFields>();
template <>
std::span<const Field<AxisFields>> fields<AxisFields>();
template <>
std::span<const Field<JointFields>> fields<JointFields>();
template <>
std::span<const Field<RodFields>> fields<RodFields>();
template <>
std::span<const Field<Coupling>> fields<Coupling>();
template <>
std::span<const Field<UserStateFields>> fields<UserStateFields>();
template <>
std::span<const Field<SampledValueFields>> fields<SampledValueFields>();
template <>
std::span<const Field<SensorFields>> fields<SensorFields>();
template <>
std::span<const Field<DelayFields>> fields<DelayFields>();
template <>
std::span<const Field<TyreDataFields>> fields<TyreDataFields>();
template <>
std::span<const Field<RoadFields>> fields<RoadFields>();
template <>
std::span<const Field<IsoRoadFields>> fields<IsoRoadFields>();
template <>
std::span<const Field<CrgFields>> fields<CrgFields>();
template <>
std::span<const Field<RoadProfileFields>> fields<RoadProfileFields>();
template <>
std::span<const Field<RoadFeature>> fields<RoadFeature>();
template <>
std::span<const Field<RoadPatch>> fields<RoadPatch>();
template <>
std::span<const Field<TyreEnvelope>> fields<TyreEnvelope>();
template <>
std::span<const Field<TyrePatch>> fields<TyrePatch>();
template <>
std::span<const Field<TyreFields>> fields<TyreFields>();
template <>
std::span<const Field<AxleWheelFields>> fields<AxleWheelFields>();
template <>
std::span<const Field<AxleFields>> fields<AxleFields>();
template <>
std::span<const Field<VehicleFields>> fields<VehicleFields>();
template <>
std::span<const Field<MotionFields>> fields<MotionFields>();
template <>
std::span<const Field<OutputFields>> fields<OutputFields>();
template <>
std::span<const Field<ShapeFields>> fields<ShapeFields>();
template <>
std::span<const Field<InitialFields>> fields<InitialFields>();
template <>
std::span<const Field<InitialValueFields>> fields<InitialValueFields>();
template <>
std::span<const Field<OrientationFields>> fields<OrientationFields>();
template <>
std::span<const Field<SolverSettings>> fields<SolverSettings>();

}  // namespace mbgen::reading
