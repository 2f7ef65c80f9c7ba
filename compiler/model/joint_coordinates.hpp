#pragma once
// Names and directions of joint coordinates, for the model reference. read_joints.cpp creates them.

#include <span>
#include <string_view>

#include "compiler/model/bodies.hpp"

namespace mbgen {

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
