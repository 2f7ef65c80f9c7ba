#pragma once
// Outputs of a model, and display of values of its interface.

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "compiler/expressions/parameter.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// No body: global axes, or ground as observer or reference.
constexpr int kNoBody = -1;

/// Motion of a point, absolute or relative to another point.
struct PointOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  Attachment point;
  int axis = 0;                 ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;    ///< components in the axes of the point's body, else in those of `axes`
  int axes = kNoBody;           ///< body with the axes of the components
  Attachment relative_to = {};  ///< reference point; none: the origin of the global frame
  int observer = kNoBody;       ///< observer of the velocity or acceleration; used with relative_to
};

/// Rotation of a body relative to another one.
struct RotationOutput {
  enum class What { angle, rotation_vector, quaternion, angular_velocity, angular_acceleration };
  What what = What::angle;
  int body = -1;
  int relative_to = kNoBody;
  int axis = 0;  ///< 0 x, 1 y, 2 z, 3 w of a quaternion
  /// axes of the rotations of `angle`, each about the axes rotated by the previous ones
  std::array<int, 3> sequence{2, 1, 0};
  int turn = 0;            ///< which of them
  int axes = kNoBody;      ///< of the components of an angular velocity or acceleration
  int observer = kNoBody;  ///< observer of an angular acceleration
};

/// Energy and momentum of one body, or of all bodies and rods.
struct MomentumOutput {
  enum class What { kinetic_energy, potential_energy, momentum, angular_momentum };
  What what = What::kinetic_energy;
  int body = kNoBody;     ///< none: all bodies and rods
  Attachment about = {};  ///< point of an angular momentum; none: centre of mass of the bodies concerned
  int axis = 0;           ///< 0 x, 1 y, 2 z
  int axes = kNoBody;     ///< body with the axes of the components
};

/// Distance of two points, or the angle at the second one between the directions to the first and the third.
struct PointsOutput {
  std::array<Attachment, 3> points = {};  ///< third without a body: a distance
};

struct CoordinateOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  CoordinateReference coordinate;
};
struct ExpressionOutput {
  Quantity value;
};  ///< over t, parameters, inputs, coordinates
/// A quantity of an element.
struct ElementOutput {
  int kind = -1;     ///< place in ElementKinds
  int element = -1;  ///< index into the model's list of that kind
  int quantity = 0;  ///< index into the quantities of the kind
  int axis = 0;      ///< 0 x, 1 y, 2 z, of a quantity of three components, in the element's own axes
};
/// Angles of a wheel relative to the axes of a vehicle: x forward, y to the left, z up.
struct WheelOutput {
  enum class What { toe, camber, steer_angle, caster, kingpin_inclination };
  What what = What::toe;
  int tyre = -1;            ///< index into Model::tyres, or
  int joint = -1;           ///< of Model::joints: the revolute joint that the wheel turns in
  Vector3 axis{0, 1, 0};    ///< of the joint, unit, to the left, GLOBAL axes at the reference
  int vehicle = kNoBody;    ///< body with the vehicle's axes
  double side = 1;          ///< 1 for a wheel on the left of the vehicle or in its middle, -1 on its right
  Attachment lower, upper;  ///< points of the steering axis, for caster and kingpin inclination
};
/// Potential energy of all elastic elements: work of their elastic forces, J; zero of an element where its elastic
/// forces vanish, except a preload.
struct StoredEnergyOutput {};
struct DriveOutput {
  int motion = -1;
};  ///< generalised driving force of a motion

/// A component of the force or moment transmitted by a joint or rod from its `from` to its `to` body: the sum of
/// constraint, springs, friction, forces and drives of its coordinates. Moments are about the joint's point on `to`, at
/// both ends; a rod transmits none.
struct ReactionOutput {
  enum class What { force, moment };
  enum class End { to, from };
  What what = What::force;
  int joint = -1, rod = -1;   ///< one of them
  int axis = 0;               ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;  ///< components in the axes of the body at `end`, else global
  End end = End::to;          ///< the body that is acted on
};

/// Multiplier of one equation of a cut joint, rod (its tension) or coupling.
struct MultiplierOutput {
  int joint = -1, rod = -1;  ///< one of them, or
  int equation = 0;          ///< index into closure_rows of the joint
  int coupling = -1;         ///< this
};

struct Output {
  std::string name;
  Where where;
  std::string unit;
  std::variant<ExpressionOutput, PointOutput, CoordinateOutput, ElementOutput, StoredEnergyOutput, DriveOutput,
               ReactionOutput, MultiplierOutput, RotationOutput, MomentumOutput, PointsOutput, WheelOutput>
      source;
  Presentation shown = {};
};

/// Rounds of force elements at an instant: an element whose law looks at outputs is in the round after the latest of
/// them.
constexpr int kBeforeForces = -1;      ///< of outputs over positions, velocities and states
constexpr int kAfterForces = 1 << 30;  ///< of outputs over accelerations, reactions and multipliers

/// An output that expressions look at.
struct ObservedOutput {
  Output output;
  int round = kBeforeForces;  ///< of elements after which it is known
};

}  // namespace mbgen
