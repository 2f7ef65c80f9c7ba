#pragma once
// Outputs of a model, and how values of its interface are shown.

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "compiler/expressions/parameter.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// No body: of axes the global ones, of an observer and of a reference ground.
constexpr int kNoBody = -1;

/// Motion of a point, absolute or relative to another point.
struct PointOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  Attachment point;
  int axis = 0;                 ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;    ///< components in the axes of the point's body, else in those of `axes`
  int axes = kNoBody;           ///< body in whose axes the components are
  Attachment relative_to = {};  ///< point that is subtracted; none: the origin of the global frame
  int observer = kNoBody;       ///< body from which the velocity or acceleration is seen; used with relative_to
};

/// Rotation of a body relative to another one.
struct RotationOutput {
  enum class What { angle, rotation_vector, quaternion, angular_velocity, angular_acceleration };
  What what = What::angle;
  int body = -1;
  int relative_to = kNoBody;
  int axis = 0;  ///< 0 x, 1 y, 2 z, 3 w of a quaternion
  std::array<int, 3> sequence{2, 1,
                              0};  ///< axes of the rotations of `angle`, each about the axes that the last one left
  int turn = 0;                    ///< which of them
  int axes = kNoBody;              ///< of the components of an angular velocity or acceleration
  int observer = kNoBody;          ///< body from which an angular acceleration is seen
};

/// Energy and momentum of one body, or of all bodies and rods.
struct MomentumOutput {
  enum class What { kinetic_energy, potential_energy, momentum, angular_momentum };
  What what = What::kinetic_energy;
  int body = kNoBody;     ///< none: all bodies and rods
  Attachment about = {};  ///< of an angular momentum; none: the centre of mass of what counts
  int axis = 0;           ///< 0 x, 1 y, 2 z
  int axes = kNoBody;     ///< body in whose axes the components are
};

/// Distance of two points, or the angle at the second one between the directions to the first and the third.
struct PointsOutput {
  std::array<Attachment, 3> points = {};  ///< the third has no body: a distance
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
/// Angles of a wheel to the axes of a vehicle: x forward, y to the left, z up.
struct WheelOutput {
  enum class What { toe, camber, steer_angle, caster, kingpin_inclination };
  What what = What::toe;
  int tyre = -1;            ///< index into Model::tyres
  int vehicle = kNoBody;    ///< body whose axes are the vehicle's
  double side = 1;          ///< 1 for a wheel on the left of the vehicle or in its middle, -1 on its right
  Attachment lower, upper;  ///< points of the steering axis, for caster and kingpin inclination
};
struct SpringOutput {
  enum class What { force, length, rate };
  What what = What::force;
  int point_spring = -1, air_spring = -1;  ///< one of them
};
/// A component in the bushing's axes on `from`: what acts on `to` at its point, or the deflection.
struct BushingOutput {
  enum class What { force, moment, deflection, rotation_vector };
  What what = What::force;
  int bushing = -1;  ///< index into Model::bushings
  int axis = 0;      ///< 0 x, 1 y, 2 z; of a mirrored bushing counted as its freedoms are
};
struct BumpStopOutput {
  enum class What { force, deflection, rate };  ///< deflection: beyond the clearance, negative before
  What what = What::force;
  int stop = -1;  ///< index into Model::bump_stops
};
/// Potential energy of springs, joint springs, bushings and bump stops: work of their elastic forces, J, zero where a
/// spring has its natural length, a joint spring is at `free`, and a bushing or a bump stop has no deflection.
struct StoredEnergyOutput {
  enum class Of { all, spring, joint_spring, bushing, bump_stop };
  Of of = Of::all;
  int element = -1;  ///< index into the list of the model; -1 for all
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
  std::variant<ExpressionOutput, PointOutput, CoordinateOutput, TyreOutput, SpringOutput, DriveOutput, ReactionOutput,
               MultiplierOutput, RotationOutput, MomentumOutput, PointsOutput, WheelOutput, BushingOutput,
               BumpStopOutput, StoredEnergyOutput>
      source;
  Presentation shown = {};
};

}  // namespace mbgen
