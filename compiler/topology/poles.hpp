#pragma once
// Poles of angles that no change of chart removes: of ball joints with a law on one of their angles.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// A spherical or free joint of the tree with fixed angles.
struct RealPole {
  int joint = -1;          ///< index into Model::joints
  std::string coordinate;  ///< angle with a law on it
  std::string user;        ///< this law: "motion steer"
};

/// The poles of a model, in the order of the tree.
std::vector<RealPole> real_poles(const Model& model, const Topology& topology);

}  // namespace mbgen
