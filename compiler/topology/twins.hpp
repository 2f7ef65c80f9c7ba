#pragma once
// Equal parts of a mechanism that are no mirror images: axles, seats, legs, cells of a row.

#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Per tree body its twin, -1 without one; its own inverse. Twins are groups of joints on one body, with all that moves
/// on them, that have the same freedoms in the same places and are closed by the same kinds of loops; of several, the
/// first two, the next two and so on. Numbers are not compared, and axes are not.
std::vector<int> find_twins(const Topology& topology);

}  // namespace mbgen
