#include "workbench/kc/geometry.hpp"

#include <algorithm>
#include <limits>

namespace mbgen::kc {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
const DualVector kUp = {Dual(0), Dual(0), Dual(1)};

/// Caster, kingpin inclination, and where the steering axis meets the road.
void add_steering_axis(const WheelState& wheel, WheelGeometry& g) {
  const DualVector way = wheel.upper - wheel.lower;
  const Dual side(wheel.side);
  g.caster = atan2(-way[0], way[2]);
  g.kingpin_inclination = atan2(-(side * way[1]), way[2]);
  const DualVector on_road = wheel.lower + ((g.patch[2] - wheel.lower[2]) / way[2]) * way;
  const DualVector off = on_road - g.patch;
  g.caster_trail = dot(off, g.forward);
  g.scrub_radius = -(side * dot(off, g.left));
}

/// A vector mirrored about y = 0: a position or a direction of the wheel.
DualVector mirrored(DualVector vector, bool is_axis) {
  static constexpr int kSource[kRigInputs] = {kTravelRight, kTravelLeft, kSteer, 8, 9, 10, 11, 12, 3, 4, 5, 6, 7};
  static constexpr double kSign[kRigInputs] = {1, 1, -1, 1, -1, -1, 1, -1, 1, -1, -1, 1, -1};
  const DualVector from = vector;
  for (int c = 0; c < 3; ++c) {
    // The axis points to the left on both sides.
    const double sign = (c == 1) != is_axis ? -1 : 1;
    vector[c].value = sign * from[c].value;
    for (int i = 0; i < kRigInputs; ++i) vector[c].slope[i] = sign * kSign[i] * from[c].slope[kSource[i]];
  }
  return vector;
}

/// Slope of the path of a contact centre over its rise in opposite travel, seen from behind.
double sideways_slope(const WheelGeometry& wheel) {
  return along(wheel.patch[1], kOpposite) / along(wheel.patch[2], kOpposite);
}

}  // namespace

WheelGeometry geometry_of(const WheelState& wheel) {
  WheelGeometry g;
  const DualVector& a = wheel.axis;
  const Dual side(wheel.side), level = sqrt(a[0] * a[0] + a[1] * a[1]);
  g.forward = unit(cross(a, kUp));
  g.left = cross(kUp, g.forward);
  g.patch = wheel.centre - wheel.radius * cross(g.forward, unit(a));
  g.steer_angle = atan2(-a[0], a[1]);
  g.toe = side * atan2(a[0], a[1]);
  g.camber = -(side * atan2(a[2], level));
  g.caster = g.kingpin_inclination = g.caster_trail = g.scrub_radius = Dual(kNone);
  if (wheel.has_steering_axis) add_steering_axis(wheel, g);
  return g;
}

WheelState wheel_of(const Rig& rig, const RigPoint& point, int which) {
  const RigWheel& place = rig.wheels[static_cast<std::size_t>(which)];
  WheelState wheel;
  if (place.centre < 0) return wheel;
  const auto scalar = [&](int output) {
    Dual result(point.values[static_cast<std::size_t>(output)]);
    for (int i = 0; i < kRigInputs && point.slopes.size() > 0; ++i)
      result.slope[static_cast<std::size_t>(i)] = point.slopes(output, i);
    return result;
  };
  const auto vector = [&](int first) { return DualVector{scalar(first), scalar(first + 1), scalar(first + 2)}; };
  wheel.is_there = true;
  wheel.side = place.side;
  wheel.radius = place.radius;
  wheel.load = scalar(place.load);
  wheel.centre = vector(place.centre);
  wheel.axis = vector(place.axis);
  wheel.rim = vector(place.rim);
  wheel.has_steering_axis = place.lower >= 0;
  if (!wheel.has_steering_axis) return wheel;
  wheel.lower = vector(place.lower);
  wheel.upper = vector(place.upper);
  return wheel;
}

WheelState mirrored(const WheelState& wheel) {
  WheelState result = wheel;
  result.side = -wheel.side;
  result.centre = mirrored(wheel.centre, false);
  result.axis = mirrored(wheel.axis, true);
  result.rim = mirrored(wheel.rim, false);
  result.lower = mirrored(wheel.lower, false);
  result.upper = mirrored(wheel.upper, false);
  result.load = mirrored(DualVector{wheel.load, {}, {}}, false)[0];
  return result;
}

Vector3 turn_along(const WheelState& wheel, const RigInputs& direction) {
  const Vector3 a = value_of(wheel.axis), b = value_of(wheel.rim), c = cross(a, b);
  const Vector3 rate_a = along(wheel.axis, direction), rate_b = along(wheel.rim, direction);
  // w = a x a' + (w.a) a, and w.a = b'.(a x b) for b across a.
  const Vector3 across = cross(a, rate_a);
  const double spin = dot(rate_b, c);
  return {across[0] + spin * a[0], across[1] + spin * a[1], across[2] + spin * a[2]};
}

Vector3 carried_patch_along(const WheelState& wheel, const RigInputs& direction) {
  const Vector3 turn = turn_along(wheel, direction);
  const Vector3 centre = value_of(wheel.centre), patch = value_of(geometry_of(wheel).patch);
  const Vector3 arm = {patch[0] - centre[0], patch[1] - centre[1], patch[2] - centre[2]};
  const Vector3 turned = cross(turn, arm), rate = along(wheel.centre, direction);
  return {rate[0] + turned[0], rate[1] + turned[1], rate[2] + turned[2]};
}

RollCentre roll_centre(const AxleState& axle) {
  const WheelGeometry left = geometry_of(axle.left), right = geometry_of(axle.right);
  const double slope_left = sideways_slope(left), slope_right = sideways_slope(right);
  const double yl = left.patch[1].value, zl = left.patch[2].value, yr = right.patch[1].value, zr = right.patch[2].value;
  // Normals of the paths: z = zl - slope_left (y - yl), z = zr - slope_right (y - yr).
  constexpr double kParallelNormals = 1e-12, kOneLine = 1e-9;  // m over m, m
  const double divisor = slope_left - slope_right;
  if (!(std::abs(divisor) > kParallelNormals)) {
    const bool lie_in_road = std::abs(zl - zr - slope_left * (yr - yl)) < kOneLine;
    return lie_in_road ? RollCentre{0, 0} : RollCentre{kNone, kNone};
  }
  const double y = (zl - zr + slope_left * yl - slope_right * yr) / divisor;
  const double z = zl - slope_left * (y - yl);
  const double width = std::hypot(yl - yr, zl - zr), ty = (yl - yr) / width, tz = (zl - zr) / width;
  const double from_y = y - 0.5 * (yl + yr), from_z = z - 0.5 * (zl + zr);
  return {ty * from_z - tz * from_y, ty * from_y + tz * from_z};
}

double track_of(const AxleState& axle) {
  return geometry_of(axle.left).patch[1].value - geometry_of(axle.right).patch[1].value;
}

double roll_rate(const AxleState& axle) {
  const double track = track_of(axle);
  const double rate = 0.5 * (along(axle.left.load, kOpposite) - along(axle.right.load, kOpposite));
  return 0.5 * track * track * rate;
}

double longitudinal_slope(const AxleState& axle, TorqueSupport support) {
  double sum = 0;
  for (const WheelState* wheel : {&axle.left, &axle.right}) {
    const Vector3 way =
        support == TorqueSupport::carrier ? carried_patch_along(*wheel, kParallel) : along(wheel->centre, kParallel);
    sum += way[0] / way[2];
  }
  return 0.5 * sum;
}

double ackermann(double left, double right, double track, double wheelbase) {
  constexpr double kSteered = 1e-6;  // rad
  const bool is_to_left = left + right > 0;
  const double inner = is_to_left ? left : -right, outer = is_to_left ? right : -left;
  if (!(inner > kSteered)) return kNone;
  const double ideal = std::atan(1 / (1 / std::tan(inner) + track / wheelbase));
  return (inner - outer) / (inner - ideal);
}

RigInputs load_direction(const WheelState& wheel, Load load) {
  const WheelGeometry g = geometry_of(wheel);
  const Vector3 centre = value_of(wheel.centre), patch = value_of(g.patch);
  const int first = wheel.side > 0 ? kLoadsLeft : kLoadsRight;
  RigInputs direction{};
  if (load == Load::aligning_moment) {
    direction[static_cast<std::size_t>(first) + 4] = 1;
    return direction;
  }
  const Vector3 force = value_of(load == Load::lateral_force ? g.left : g.forward);
  const Vector3 arm = {patch[0] - centre[0], patch[1] - centre[1], patch[2] - centre[2]};
  Vector3 torque = cross(arm, force);
  if (load == Load::drive_force) torque = {0, 0, 0};
  for (std::size_t i = 0; i < 2; ++i) direction[static_cast<std::size_t>(first) + i] = force[i];
  for (std::size_t i = 0; i < 3; ++i) direction[static_cast<std::size_t>(first) + 2 + i] = torque[i];
  return direction;
}

}  // namespace mbgen::kc
