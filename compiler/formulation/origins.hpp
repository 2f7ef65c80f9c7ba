#pragma once
// Where the origin of a body lies on the axis of its revolute joint: any point of the axis serves.

#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// A coordinate of an origin that differs from the joint's point.
struct SlidOrigin {
  int component = -1;  ///< along the axis: 0 x, 1 y, 2 z; -1: the origin is the point of the joint
  double value = 0;    ///< m, global at the reference configuration
};

/// Per tree body, the point of the axis that leaves fewest numbers: mostly the foot of the centre of mass, where the
/// first moment and two second moments vanish. Bodies that turn about a coordinate axis on a body with mass or on
/// ground; the others keep the point of their joint, so that the axes of a ball meet in it.
std::vector<SlidOrigin> slid_origins(const Model& model, const Topology& topology);

}  // namespace mbgen
