#pragma once
// Actuators: what other sections must know before they are read.

#include <set>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Adds an input of its name for every actuator: its force. Requires: parameters and the model's own inputs are read.
void add_actuator_inputs(Reader& reader, const Entries& actuators);

/// The rods (indices into Model::rods) whose lengths actuators move. Requires: the names of rods are known.
std::set<int> actuated_rods(const Reader& reader, const Entries& actuators);

}  // namespace mbgen::reading
