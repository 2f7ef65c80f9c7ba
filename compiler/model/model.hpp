#pragma once
// The door of the model room: JSON text -> Model, or every diagnostic at once. Plain structs, SI units, radians.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/model/diagnostic.hpp"
#include "compiler/model/expression.hpp"

namespace mbgen {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<double, 9>;  ///< row by row
using Vector3Quantity = std::array<Quantity, 3>;

/// Texts for people beside the name and unit of a value of the interface; without effect on the motion.
struct Presentation {
  std::string description = {};
  std::string display_unit;        ///< that it is shown in, of the same dimension as its unit; none: its unit
  std::optional<double> min, max;  ///< range that is meant, in its unit
  std::optional<double> nominal;   ///< usual magnitude, in its unit
};

/// Description, author, version and rights of a model, for people.
struct About {
  std::string description, author, version, copyright, licence;
};

/// Pose of a body frame in the global frame at the reference configuration: x_global = origin + rotation * x_body.
struct Pose {
  Vector3 origin{0, 0, 0};
  Matrix3 rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
};

struct Point {
  std::string name;
  Vector3Quantity position;  ///< m, body frame
};

struct Body {
  std::string name;
  Where where;
  Pose pose;
  Quantity mass;        ///< kg; zero is a massless body
  Vector3Quantity com;  ///< m, body frame
  /// kg m^2 about the centre of mass, body axes: xx yy zz xy xz yz (matrix entries)
  std::array<Quantity, 6> inertia;
  std::vector<Point> points;
  std::string description = {};
};

enum class JointType { revolute, prismatic, cylindrical, universal, spherical, planar, free, fixed };

enum class FreedomKind { revolute, prismatic };

/// Of a coordinate.
constexpr const char* unit_of(FreedomKind kind) { return kind == FreedomKind::revolute ? "rad" : "m"; }

/// As the model format writes them.
const char* name_of(JointType type);
const char* name_of(FreedomKind kind);

/// One elementary freedom of a joint, in the order the joint applies them (from the `from` body to the `to` body).
struct Freedom {
  std::string name;  ///< name of the coordinate, for example "chassis_rz"
  FreedomKind kind = FreedomKind::revolute;
  Vector3 axis{0, 0, 1};  ///< unit, in GLOBAL axes at the reference configuration
};

/// A point of a body.
struct Attachment {
  int body = -1;   ///< index into Model::bodies
  int point = -1;  ///< index into Body::points
};

/// Whether the user asks for a joint to be cut ("cut": true), kept in the tree ("cut": false) or leaves it to mbgen.
enum class CutMark { automatic, cut, tree };

struct Joint {
  std::string name;
  Where where;
  JointType type = JointType::revolute;
  Attachment from, to;
  /// unit, GLOBAL axes at the reference configuration; of a planar joint the normal, of a universal one the first axis
  Vector3 axis{0, 0, 1};
  /// universal: second axis, perpendicular to the first, GLOBAL axes at the reference
  Vector3 second_axis{0, 0, 1};
  CutMark cut = CutMark::automatic;
  std::vector<Freedom> freedoms;  ///< empty for fixed
  std::string description = {};
};

/// One equation of a closed loop: its name, and the unit of its multiplier.
struct ClosureRow {
  std::string_view name, unit;
};

/// The equations that a cut joint of this type closes, in their order; none for a free one. Source: theory.md
/// section 3.
std::span<const ClosureRow> closure_rows(JointType type);

/// The equation of a rod.
constexpr ClosureRow kRodRow{"distance", "N"};

/// A bar with a spherical joint at each end: a distance constraint with exact inertia (theory.md section 5).
struct Rod {
  std::string name;
  Where where;
  Attachment from, to;
  Quantity mass;                   ///< kg, uniform along the rod; zero is massless
  std::optional<Quantity> length;  ///< m; without it the reference distance
};

/// y(x) by points; outside the range the end segments (linear) or end slopes (cubic) are continued as straight lines.
struct Table {
  enum class Interpolation { linear, monotone_cubic };
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> x, y;  ///< x strictly increasing, at least two points
};

/// A characteristic: factor times argument, or a table over the argument.
using Law = std::variant<Quantity, Table>;

/// Spring and damper between two points, tension positive:
/// f = stiffness(l - l0) + damping(dl/dt) + preload + force(length, rate).
struct PointSpring {
  std::string name;
  Where where;
  Attachment from, to;
  std::optional<Law> stiffness;         ///< N/m, or a table of N over m
  std::optional<Law> damping;           ///< N s/m, or a table of N over m/s
  std::optional<Quantity> free_length;  ///< m; without it the reference distance
  Quantity preload;                     ///< N, tension positive
  /// expression; local 0 `length` (m), local 1 `rate` (m/s); N, tension positive
  std::optional<int> force;
};

/// Spring and damper on a coordinate, or on the difference of two (anti-roll bar):
/// x = z - z(relative_to), force on the coordinate, opposite on `relative_to`:
/// f = -(stiffness(x - free) + damping(dx/dt) + preload + force(x, dx/dt)).
struct JointSpring {
  std::string name;
  Where where;
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to;
  std::optional<Law> stiffness;  ///< N m/rad or N/m
  std::optional<Law> damping;    ///< N m s/rad or N s/m
  Quantity free;                 ///< rad or m
  Quantity preload;              ///< N m or N
  std::optional<int> force;      ///< expression; local 0 `position`, local 1 `rate`
};

/// Smooth friction on a coordinate:
/// f = -(coulomb + (stiction - coulomb) exp(-(v/v_stribeck)^2)) tanh(v/velocity) - viscous v.
struct JointFriction {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity coulomb;   ///< N m or N
  Quantity stiction;  ///< N m or N; the reader sets it to coulomb when absent
  Quantity viscous;   ///< N m s/rad or N s/m
  Quantity velocity;  ///< rad/s or m/s over which the sign is smoothed, > 0
  /// rad/s or m/s, > 0; the reader sets it to 10 * velocity when absent
  Quantity stribeck_velocity;
};

/// Polytropic air spring between two points: p V^n = const; the force (p - p_ambient) A(l) pushes the points apart.
struct AirSpring {
  std::string name;
  Where where;
  Attachment from, to;
  Quantity pressure;               ///< Pa absolute, at the reference length
  Quantity ambient;                ///< Pa absolute
  Quantity exponent;               ///< polytropic exponent
  std::optional<Quantity> length;  ///< m, reference length; without it the reference distance
  Law area;                        ///< m^2: constant, or a table over length (m)
  /// m^3 over length (m); without it volume0 + area(length0) * (l - length0)
  std::optional<Table> volume;
  Quantity volume0;  ///< m^3 at the reference length (used without `volume`)
};

/// Force and torque on a body at a point.
struct AppliedForce {
  std::string name;
  Where where;
  Attachment at;
  Vector3Quantity force;      ///< N
  Vector3Quantity torque;     ///< N m
  bool in_body_axes = false;  ///< components in body axes, else in global axes
};

/// Generalised force on a coordinate.
struct JointForce {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity force;  ///< N m or N
};

enum class TyreModel { pac89, pac2002 };

/// Tyre of a wheel body on a flat horizontal road (normal = global z).
struct Tyre {
  std::string name;
  Where where;
  Attachment centre;  ///< wheel centre, a point of the wheel body on its spin axis
  /// unit spin axis, GLOBAL axes at the reference; forward rolling is positive about it when it points left
  Vector3 axis{0, 1, 0};
  TyreModel model = TyreModel::pac2002;
  /// in the order of kPac2002Fields, or a0.. b0.. c0.. of pac89 (runtime header tyre.hpp)
  std::vector<Quantity> coefficients;
  /// +1: coefficients used as they are, -1: mirrored (tyre measured on the other side)
  double side = 1;
  double count = 1;      ///< 2 for twin tyres: all forces times count
  Quantity radius;       ///< m, unloaded
  Quantity stiffness;    ///< N/m, vertical, one tyre
  Quantity damping;      ///< N s/m, vertical, one tyre
  Quantity road_height;  ///< m, global z of the road
  Quantity friction;     ///< scales the friction (1 is the measured one)
  /// 1: moment = -coefficient * load * radius * tanh(speed / low_speed)
  Quantity rolling_resistance;
  Quantity relaxation_x, relaxation_y;  ///< m, relaxation lengths of the slips
  Quantity low_speed;                   ///< m/s, below it slip is damped so that the wheel comes to rest
};

/// How pictures show a body or a part of it; it has no effect on the motion. A box has its edges along the axes of the
/// body's frame.
struct DisplayShape {
  enum class Kind { box, cylinder, sphere };
  std::string name;
  Where where;
  Kind kind = Kind::box;
  Attachment from;           ///< corner of a box, end of a cylinder, centre of a sphere
  Attachment to;             ///< opposite corner or other end, on the same body; none for a sphere
  double radius = 0;         ///< m, of a cylinder or sphere
  std::array<int, 3> rgb{};  ///< 0 to 255 each; used where has_colour
  bool has_colour = false;
};

/// A driven coordinate: z(t) prescribed; first and second derivatives come from the expression.
struct Motion {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity position;  ///< rad or m, of t, parameters, inputs
};

struct PointOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  Attachment point;
  int axis = 0;               ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;  ///< components in the axes of the point's body, else global
};
struct CoordinateOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  CoordinateReference coordinate;
};
struct ExpressionOutput {
  Quantity value;
};  ///< over t, parameters, inputs, coordinates
struct TyreOutput {
  enum class What { load, longitudinal_force, lateral_force, aligning_moment, longitudinal_slip, lateral_slip };
  What what = What::load;
  int tyre = -1;  ///< index into Model::tyres
};
struct SpringOutput {
  enum class What { force, length, rate };
  What what = What::force;
  int point_spring = -1, air_spring = -1;  ///< one of them
};
struct DriveOutput {
  int motion = -1;
};  ///< generalised driving force of a motion

/// A component of the force or moment that a joint or rod transmits from its `from` to its `to` body: the
/// sum of constraint, springs, friction, forces and drives of its coordinates. Moments are about the joint's point
/// on `to`, at both ends; a rod transmits none.
struct ReactionOutput {
  enum class What { force, moment };
  enum class End { to, from };
  What what = What::force;
  int joint = -1, rod = -1;   ///< one of them
  int axis = 0;               ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;  ///< components in the axes of the body at `end`, else global
  End end = End::to;          ///< the body that is acted on
};

/// Multiplier of one equation of a cut joint or rod (of a rod: its tension).
struct MultiplierOutput {
  int joint = -1, rod = -1;  ///< one of them
  int equation = 0;          ///< index into closure_rows of the joint
};

struct Output {
  std::string name;
  Where where;
  std::string unit;
  std::variant<ExpressionOutput, PointOutput, CoordinateOutput, TyreOutput, SpringOutput, DriveOutput, ReactionOutput,
               MultiplierOutput>
      source;
  Presentation shown = {};
};

struct Parameter {
  std::string name;
  Where where;
  double value = 0;  ///< with the tunable ones at theirs
  std::string unit;
  bool tunable = false;
  int expression =
      -1;  ///< index into Model::expressions: what it is of tunable ones; expressions that use it contain it
  bool at_start = false;  ///< acts on the velocities at the start only: an FMU takes it before the initialisation
  Presentation shown = {};
};

struct Input {
  std::string name;
  Where where;
  std::string unit;
  double default_value = 0;
  int derivative = -1;  ///< index into Model::inputs of its rate of change; -1: it counts as constant
  Presentation shown = {};
};

/// A value that a coordinate or its velocity is to have at the start.
struct InitialValue {
  CoordinateReference coordinate;
  double value = 0;  ///< rad or m, or per second
  Where where;
  double weight = 1;    ///< of its squared error, where the values asked for do not fit together
  bool locked = false;  ///< the start keeps it, at any error of the others
  int expression = -1;  ///< index into Model::expressions, over parameters that act at the start; -1: constant
};

struct Initial {
  bool equilibrium = false;                         ///< start from static equilibrium, then give `velocities`
  std::vector<InitialValue> positions, velocities;  ///< the rest is zero or follows from the closures
};

struct SolverSettings {
  enum class Integrator { rk4, abm4 };
  Integrator integrator = Integrator::rk4;
  double step = 1e-3;                ///< s
  double duration = 1;               ///< s
  double closure_tolerance = 1e-12;  ///< m or 1, largest residual that projection leaves
  double tolerance = 1e-6;           ///< relative, for importers that integrate the model with a method of their own

  /// Whether a step uses the steps before it.
  bool is_multistep() const { return integrator == Integrator::abm4; }
};

/// A multibody system as the user described it, names resolved and every number checked.
struct Model {
  std::string name;
  std::string file;                ///< as given to read_model
  std::vector<std::string> files;  ///< that and every file it includes, in the order of reading, each once
  /// 16 hex digits over the content (includes too), for the banner and manifest
  std::string hash;
  About about;
  Diagnostics notes;                         ///< entries of its files that it does not use; nothing is wrong
  Vector3Quantity gravity{0.0, 0.0, -9.81};  ///< m/s^2, global
  std::vector<Parameter> parameters;
  std::vector<Input> inputs;
  std::vector<Expression> expressions;
  /// index into bodies of the body named "ground"; -1 when there is none
  int ground = -1;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Rod> rods;
  std::vector<PointSpring> springs;
  std::vector<JointSpring> joint_springs;
  std::vector<JointFriction> frictions;
  std::vector<AirSpring> air_springs;
  std::vector<AppliedForce> forces;
  std::vector<JointForce> joint_forces;
  std::vector<Tyre> tyres;
  std::vector<Motion> motions;
  std::vector<Output> outputs;
  std::vector<DisplayShape> shapes;
  Initial initial;
  SolverSettings solver;
};

/// Global position of a point at the reference configuration and default parameters, m; NaN for an attachment that
/// could not be read.
Vector3 reference_position(const Model& model, const Attachment& attachment);

/// Reads and checks a model.
/// text: JSON with comments; file_name: its path, used in messages and as the base of `include` paths.
/// Ensures: names resolve, numbers are finite and in range, joints close at the reference configuration.
/// Fails: with every syntactic and semantic problem found, in order of position.
Result<Model> read_model(std::string_view text, const std::string& file_name);

/// Reads a model from a file. Fails as read_model, and when the file cannot be read, is empty or larger than 64 MB.
Result<Model> read_model_file(const std::string& path);

/// JSON Schema (draft 2020-12) of the model format, made from the reader's own table of fields.
std::string model_schema();

}  // namespace mbgen
