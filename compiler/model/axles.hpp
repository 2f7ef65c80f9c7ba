#pragma once
// Axles: what a rig for kinematics and compliance needs to know beside the mechanism. Without effect on the motion.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A wheel of an axle.
struct AxleWheel {
  Attachment centre;        ///< point of the wheel body on its spin axis; no body: the axle has no wheel on this side
  Vector3 axis{0, 1, 0};    ///< unit spin axis, GLOBAL axes at the reference
  double radius = 0;        ///< m, from the centre to the contact patch
  Attachment lower, upper;  ///< points of the steering axis; no bodies: it is not known
  bool is_there() const { return centre.body >= 0; }
};

/// Part that carries the reaction of a torque about the spin axis of a wheel.
enum class TorqueSupport { carrier, body };

/// An axle of a vehicle that drives along global x at the reference, z up. With one wheel the other side is its mirror.
struct Axle {
  enum class End { front, rear };
  std::string name;
  Where where;
  int body = -1;  ///< index into Model::bodies of the body that the rig holds
  AxleWheel left, right;
  std::optional<CoordinateReference> steer;
  End end = End::front;
  std::optional<double> wheelbase;                   ///< m
  std::optional<double> centre_of_gravity_height;    ///< m, of the vehicle above the road
  std::optional<double> brake_share, drive_share;    ///< of the vehicle's force at this axle, 0 to 1
  TorqueSupport brakes_on = TorqueSupport::carrier;  ///< body: inboard brakes
  TorqueSupport drive_on = TorqueSupport::body;      ///< carrier: a rigid axle with its gear, a motor in the wheel
  std::vector<std::string> without;                  ///< forces and springs that the rig takes away
};

}  // namespace mbgen
