#pragma once
// The joint whose axis is off, where the other axes of a loop agree.

#include <optional>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

constexpr double kMeantParallel = 0.785;  ///< rad: nearer to parallel than to across

struct Misalignment {
  int joint = -1;  ///< index into Model::joints
  FreedomKind kind = FreedomKind::revolute;
  double angle = 0;         ///< rad: of a pin to the direction that the others share, of a slide to the plane across it
  bool all_single = false;  ///< every joint of the loops has one freedom
};

/// The only joint of one freedom in these loops that does not fit the direction of all other pins, if it is only one.
std::optional<Misalignment> misaligned_joint(const Model& model, const Topology& topology,
                                             const std::vector<int>& loops);

}  // namespace mbgen
