#pragma once
// Loop blocks that are solved on their opened tree.

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Marks the large blocks with more freedoms than twice their closure equations, such as a ring or a track: on the
/// opened tree they cost as many operations as joints times the square of the equations, by their freedoms the cube of
/// these. Each body of such a block has inertia along its own joint, so that the opened tree is determined, and no rod
/// of it has mass.
void mark_opened(const Model& model, Topology& topology);

}  // namespace mbgen
