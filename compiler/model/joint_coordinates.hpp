#pragma once
// Names and directions of the coordinates of joints, as the model reference tells them. read_joints.cpp makes them.

#include <span>
#include <string_view>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// Coordinates of a type of joint, by the fields that are written.
struct JointCoordinates {
  JointType type;
  std::string_view written;     ///< fields that the names depend on, as in a model; empty where there are none
  std::string_view names;       ///< in the order in which they act; NAME is that of the joint
  std::string_view directions;  ///< of each, in the frame of `from`: "along x, about axis"
};

/// Every type of joint, those of whose coordinates the names depend on the axis more than once.
std::span<const JointCoordinates> joint_coordinates();

}  // namespace mbgen
