#pragma once
// Actuators: what other sections must know before they are read.

#include <set>

#include "compiler/reader/elements/composed.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Adds an input of its name for every actuator: its force. Requires: parameters and the model's own inputs are read.
void add_actuator_inputs(Reader& reader, const Entries& actuators);

/// The rods (indices into Model::rods) whose lengths actuators move. Requires: the names of rods are known.
std::set<int> actuated_rods(const Reader& reader, const Entries& actuators);

/// The rotor of an actuator with `rotor_inertia` is a body NAME_rotor on ground. A coupling of this name turns it `gear`
/// times as fast as the coordinate, which thus feels gear^2 J and nothing else. An actuator with a problem has none.
void compose_rotors(Reader& reader, const Entries& actuators, ComposedParts& made);

/// Lets actuators of motions act on their coordinates, and marks the motions that actuators give. Requires: motions and
/// actuators are read.
void act_on_motions(Reader& reader, const Entries& actuators, const Entries& motions);

}  // namespace mbgen::reading
