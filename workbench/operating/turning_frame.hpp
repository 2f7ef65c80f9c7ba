#pragma once
// Coordinates of a plane motion in the tree: a rotation about gravity that translations carry.

#include <array>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

struct TurningFrame {
  int turning = -1;           ///< rotating tree coordinate
  std::array<int, 2> across;  ///< translations across its axis; the second is a quarter turn ahead of the first
};

/// Frames in which gravity, and the normal of flat roads, is constant: rotations about an axis along gravity that are
/// supported by translations only, with two independent ones across the axis. independent: coordinates.
std::vector<TurningFrame> turning_frames(const Model& model, const Topology& topology,
                                         const std::vector<int>& independent);

}  // namespace mbgen
