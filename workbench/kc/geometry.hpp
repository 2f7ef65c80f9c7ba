#pragma once
// Geometry of a wheel, and of an axle of two, named after ISO 8855:2011 and the books in docs/use/kc.md. Global axes: x
// forward, y to the left, z up; the road is level.

#include "workbench/kc/dual.hpp"

namespace mbgen::kc {

/// A wheel on the rig, with derivatives if the point has them.
struct WheelState {
  bool is_there = false;
  double side = 1;  ///< 1 left, -1 right
  Dual radius;      ///< m, constant
  Dual load;        ///< N, of the pad
  DualVector centre, axis, rim;
  bool has_steering_axis = false;
  DualVector lower, upper;
};

/// Derived values of a wheel; angles in rad. The last four are NaN without a steering axis.
struct WheelGeometry {
  DualVector forward;  ///< unit, level, in the plane of the wheel: where it rolls
  DualVector left;     ///< unit, level, across
  DualVector patch;    ///< m: `radius` below the centre in the plane of the wheel, the contact centre
  Dual steer_angle, toe, camber, caster, kingpin_inclination, caster_trail, scrub_radius;
};

WheelGeometry geometry_of(const WheelState& wheel);

/// The wheel of a point of the rig.
WheelState wheel_of(const Rig& rig, const RigPoint& point, int which);

/// The wheel on the other side of a symmetric axle: its mirror about the plane y = 0, with mirrored inputs.
WheelState mirrored(const WheelState& wheel);

/// Angular velocity of the wheel body per unit of a direction, global axes.
Vector3 turn_along(const WheelState& wheel, const RigInputs& direction);

/// Velocity, per unit of a direction, of the wheel body's material at the patch; the wheel does not turn on its
/// carrier.
Vector3 carried_patch_along(const WheelState& wheel, const RigInputs& direction);

/// Both wheels of an axle.
struct AxleState {
  WheelState left, right;
  /// which: 0 left, 1 right.
  const WheelState& wheel(int which) const { return which == 0 ? left : right; }
};

/// Directions of travel: both wheels up, or the left one up and the right one down.
constexpr RigInputs kParallel{1, 1}, kOpposite{1, -1}, kSteering{0, 0, 1};

/// The centre about which the body rolls, from the paths of the contact centres in opposite travel; m above the line
/// through both, and from their middle to the left; zero if the normals of the paths lie in this line, NaN if they are
/// parallel otherwise.
struct RollCentre {
  double height, to_left;
};
RollCentre roll_centre(const AxleState& axle);

/// Distance between the contact centres, m.
double track_of(const AxleState& axle);

/// N m/rad, of the wheels' loads in opposite travel: t^2/2 times their mean rate.
double roll_rate(const AxleState& axle);

/// dx/dz in parallel travel, the mean of both wheels: of the contact centre carried with the wheel body, or of the
/// wheel's centre.
double longitudinal_slope(const AxleState& axle, TorqueSupport support);

/// Share of Ackermann's difference of the steer angles, counted from the angles at the start; 1 if the axles of all
/// wheels intersect in one point, NaN without steering. left, right: rad, to the left; track, wheelbase: m.
double ackermann(double left, double right, double track, double wheelbase);

/// Direction of a load at the wheel with unit size: along `forward` and `left` at the contact patch or the centre, or a
/// moment about z.
enum class Load { brake_force, drive_force, lateral_force, aligning_moment };
RigInputs load_direction(const WheelState& wheel, Load load);

}  // namespace mbgen::kc
