#pragma once
// Geometry of a wheel, and of an axle of two, named after ISO 8855:2011 and the books in docs/use/kc.md. Global axes: x
// forward, y to the left, z up; the road is level.

#include "workbench/kc/dual.hpp"

namespace mbgen::kc {

/// A wheel on the rig, with derivatives where the point has them.
struct WheelState {
  bool is_there = false;
  double side = 1;  ///< 1 left, -1 right
  Dual radius;      ///< m, constant
  Dual load;        ///< N, of the pad
  DualVector centre, axis, rim;
  bool has_steering_axis = false;
  DualVector lower, upper;
};

/// Derived values of a wheel; angles in rad. Of the last four NaN without a steering axis.
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

/// Velocity, per unit of a direction, of the place of the wheel body that is at the patch: the wheel does not turn on
/// its carrier.
Vector3 carried_patch_along(const WheelState& wheel, const RigInputs& direction);

/// Both wheels of an axle.
struct AxleState {
  WheelState left, right;
  /// which: 0 left, 1 right.
  const WheelState& wheel(int which) const { return which == 0 ? left : right; }
};

/// Directions of travel: both wheels up, or the left one up and the right one down.
constexpr RigInputs kParallel{1, 1}, kOpposite{1, -1}, kSteering{0, 0, 1};

/// The place about which the body rolls, from the ways of the contact centres in opposite travel; m above the line
/// through both, and from their middle to the left; zero where the normals of the ways lie in that line, NaN where they
/// are parallel else.
struct RollCentre {
  double height, to_left;
};
RollCentre roll_centre(const AxleState& axle);

/// m, between the contact centres.
double track_of(const AxleState& axle);

/// N m/rad, of the wheels' loads in opposite travel: t^2/2 times their mean rate.
double roll_rate(const AxleState& axle);

/// dx/dz of a wheel's place in parallel travel, the mean of both wheels: of the contact centre carried with the wheel
/// body, or of the wheel's centre.
double longitudinal_slope(const AxleState& axle, TorqueSupport support);

/// Share of Ackermann's difference of the angles by which wheels are steered from their angles at the start; 1 where
/// the axles of all wheels meet in one point, NaN where nothing is steered. angles: rad, to the left; track, wheelbase:
/// m.
double ackermann(double left, double right, double track, double wheelbase);

/// Direction in which a load at the wheel moves with unit force: along `forward` and `left` at the contact patch or the
/// centre, or a moment about z.
enum class Load { brake_force, drive_force, lateral_force, aligning_moment };
RigInputs load_direction(const WheelState& wheel, Load load);

}  // namespace mbgen::kc
