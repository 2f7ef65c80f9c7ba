#pragma once
// Behaviour of a model that its author may not expect: joints that its loops lock, assembly modes that it is not
// in, loads whose division the equations choose.

#include "compiler/analysis/analysis.hpp"

namespace mbgen {

/// One note for loops that cannot move together, one for the other joints that a block locks, one for assembly modes in
/// which a block has fewer freedoms, one where no partition is chosen at run time, those of add_shared_loads, and
/// one for free directions without an actuator; nothing is wrong. Where: at the joint or rod that closes the first of
/// the loops.
Diagnostics analysis_notes(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
