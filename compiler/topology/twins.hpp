#pragma once
// Equal parts of a mechanism that are not mirror images: axles, seats, legs, cells of a row.

#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Per tree body its twin, -1 without one; an involution. Twins are groups of joints on one body, with everything they
/// carry, with the same freedoms in the same positions and the same kinds of loops; of several equal groups, the first
/// two, the next two and so on. Numbers and axes are not compared.
std::vector<int> find_twins(const Topology& topology);

}  // namespace mbgen
