#pragma once
// Bodies of a model, joints and rods between them, and their shapes in pictures.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/expression.hpp"
#include "compiler/text/diagnostic.hpp"

namespace mbgen {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<double, 9>;  ///< row by row
using Vector3Quantity = std::array<Quantity, 3>;

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

enum class JointType {
  revolute,
  prismatic,
  cylindrical,
  universal,
  spherical,
  planar,
  free,
  fixed,
  point_on_line,   ///< the point of `to` on a line of `from`
  point_on_plane,  ///< the point of `to` in a plane of `from`
  parallel_axes,
  orientation,   ///< no turn between the bodies
  homokinetic,   ///< constant-velocity joint of two shafts that intersect
  rolling_disc,  ///< the rim of a disc rolls on a plane of `from` without slip
  rolling_ball,  ///< likewise a ball
  knife_edge     ///< a blade on a plane of `from`: its point has no velocity across it
};

/// Types that consist of equations only: no coordinates, never in the tree.
constexpr bool closes_only(JointType type) { return type >= JointType::point_on_line; }

/// Types with three rotations: angles of a sequence.
constexpr bool is_ball(JointType type) { return type == JointType::spherical || type == JointType::free; }

/// Types with a second axis, on `to`; optional for a homokinetic joint.
constexpr bool has_second_axis(JointType type) {
  return type == JointType::universal || type == JointType::rolling_disc || type == JointType::knife_edge;
}

/// Types with nonholonomic equations: rolling and blades.
constexpr bool holds_velocities(JointType type) { return type >= JointType::rolling_disc; }

enum class FreedomKind { revolute, prismatic };

/// Unit of a coordinate.
constexpr const char* unit_of(FreedomKind kind) { return kind == FreedomKind::revolute ? "rad" : "m"; }

/// Name in the model format.
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

/// Request of the user: the joint is cut ("cut": true), in the tree ("cut": false), or mbgen decides.
enum class CutMark { automatic, cut, tree };

struct Joint {
  std::string name;
  Where where;
  JointType type = JointType::revolute;
  Attachment from, to;
  /// unit, GLOBAL axes at the reference configuration; planar joint, point_on_plane: the normal; universal: the first
  /// axis; homokinetic: the shaft of `from`; rolling and knife_edge: the normal of the plane through the point of
  /// `from`, towards the disc or ball
  Vector3 axis{0, 0, 1};
  /// universal: second axis, perpendicular to the first; homokinetic: the shaft of `to`; rolling_disc: the axle, on
  /// `to`; knife_edge: the line of the blade, on `to`; GLOBAL axes at the reference
  Vector3 second_axis{0, 0, 1};
  std::optional<Quantity> radius;  ///< m, of a rolling_disc or rolling_ball, about the point of `to`
  CutMark cut = CutMark::automatic;
  /// index into Model::joints: for a driven joint that is cut, the fixed joint that closes its loop; the driven joint
  /// is then in the tree, with a massless body instead of the cut one; else -1
  int closure = -1;
  std::vector<Freedom> freedoms;  ///< empty for fixed joints, and for closes_only
  std::string description = {};
};

/// One equation of a closed loop: its name, and the unit of its multiplier.
struct ClosureRow {
  std::string_view name, unit;
  bool of_velocities = false;  ///< no function of positions has it as derivative (nonholonomic)
};

/// Equations of a cut joint of this type, in their order; none for a free one. Source: theory.md section 3.
std::span<const ClosureRow> closure_rows(JointType type);

/// The equation of a rod.
constexpr ClosureRow kRodRow{"distance", "N"};

/// The equation of a coupling: the unit of its multiplier is energy over the unit of the relation, which is unknown.
constexpr ClosureRow kCouplingRow{"relation", ""};

/// A bar with a spherical joint at each end: a distance constraint with exact inertia (theory.md section 5).
struct Rod {
  std::string name;
  Where where;
  Attachment from, to;
  Quantity mass;  ///< kg, uniform along the rod; zero: massless
  /// m; default: the reference distance; with a drive: the length at drive position zero
  std::optional<Quantity> length;
  /// index into Model::joints: slide whose driven coordinate is added to the length; -1: constant length
  int drive = -1;
};

/// Shape of a body or a part of it in pictures; without effect on the motion. The edges of a box are along the axes of
/// the body's frame.
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

/// Coordinates of a type of joint, depending on its fields.
struct JointCoordinates {
  JointType type;
  std::string_view written;     ///< fields with effect on the names, as in a model; empty if there are none
  std::string_view names;       ///< in their order in the joint; NAME is the joint's name
  std::string_view directions;  ///< of each, in the frame of `from`: "along x, about axis"
};

/// Every type of joint; several times for names that depend on the axis.
std::span<const JointCoordinates> joint_coordinates();

}  // namespace mbgen
