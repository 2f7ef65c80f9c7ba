#pragma once
// Poles of angles that no other chart takes away: those of balls with an angle that something in the model is on.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// A spherical or free joint of the tree whose angles are meant themselves.
struct RealPole {
  int joint = -1;          ///< index into Model::joints
  std::string coordinate;  ///< the angle that something is on
  std::string user;        ///< what is on it: "motion steer"
};

/// The poles of a model, in the order of the tree.
std::vector<RealPole> real_poles(const Model& model, const Topology& topology);

}  // namespace mbgen
