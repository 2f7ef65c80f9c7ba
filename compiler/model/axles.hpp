#pragma once
// Axles: data for a rig for kinematics and compliance, without effect on the motion.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A wheel of an axle.
struct AxleWheel {
  Attachment centre;        ///< point of the wheel body on its spin axis; no body: no wheel on this side
  Vector3 axis{0, 1, 0};    ///< unit spin axis, GLOBAL axes at the reference
  double radius = 0;        ///< m, from the centre to the contact patch
  Attachment lower, upper;  ///< points of the steering axis; no bodies: unknown
  bool is_there() const { return centre.body >= 0; }
};

/// Part that carries the reaction of a torque about the spin axis of a wheel.
enum class TorqueSupport { carrier, body };

/// An axle of a vehicle, with global x forward and z up at the reference. With one wheel the other side is its mirror
/// image.
struct Axle {
  enum class End { front, rear };
  std::string name;
  Where where;
  int body = -1;  ///< index into Model::bodies of the body fixed by the rig
  AxleWheel left, right;
  std::optional<CoordinateReference> steer;  ///< the coordinate that steers, or
  int steering_input = -1;                   ///< index into Model::inputs, which a driven coordinate follows
  End end = End::front;
  std::optional<double> wheelbase;                   ///< m
  std::optional<double> centre_of_gravity_height;    ///< m, of the vehicle above the road
  std::optional<double> brake_share, drive_share;    ///< share of the vehicle's force, 0 to 1
  TorqueSupport brakes_on = TorqueSupport::carrier;  ///< body: inboard brakes
  TorqueSupport drive_on = TorqueSupport::body;      ///< carrier: a rigid axle with its gear, a motor in the wheel
  std::vector<std::string> without;                  ///< forces and springs removed by the rig
};

}  // namespace mbgen
