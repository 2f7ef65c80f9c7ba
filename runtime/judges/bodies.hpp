#pragma once
// The state of a mechanism in Cartesian coordinates.

#include <Eigen/Geometry>
#include <vector>

namespace mbgen {

/// Pose and motion of one body, global axes.
struct CartesianBody {
  Eigen::Vector3d position;     ///< of the centre of mass, m
  Eigen::Quaterniond attitude;  ///< body axes in global axes, unit
  Eigen::Vector3d velocity;     ///< of the centre of mass, m/s
  Eigen::Vector3d spin;         ///< angular velocity, rad/s
};

/// All moving bodies: the bodies of the model except ground, massless ones included, then the rods with mass.
struct CartesianState {
  std::vector<CartesianBody> bodies;
  std::vector<double> x;  ///< auxiliary states, as GenericState::x
  double t = 0;           ///< s
};

}  // namespace mbgen
