#pragma once
// Loads whose division among joints is no question of equilibrium: equations of closures that repeat each other.

#include "compiler/analysis/analysis.hpp"

namespace mbgen {

/// One note for two joints that hold the same two bodies twice, as a door has its hinges. One for a block in which
/// outputs, frictions or driving forces that the model asks for are not unique: a self-stress, forces of the closures
/// that are in equilibrium alone, changes them. Components that no self-stress changes are not named. Seen at the
/// reference. Where: at the joint or rod that closes the first loop. Cost: cubic in the block.
void add_shared_loads(const Model& model, const Topology& topology, const Analysis& analysis, Diagnostics& notes);

}  // namespace mbgen
