#pragma once
// Anti-roll bars as a composition: each stands for bodies, joints, rods and a joint spring of the model format.

#include "compiler/reader/elements/composed.hpp"

namespace mbgen::reading {

/// A bar NAME becomes the bodies NAME_left and NAME_right in revolute joints of these names, whose axis goes from the
/// right pivot to the left one; the joint spring NAME between both; the rods NAME_link_left and NAME_link_right. Its
/// points are hardpoints: NAME_pivot_left, NAME_arm_left, NAME_link_left, and on the right. Problems have the places of
/// the bar's own fields; a bar with a problem stands for nothing. Requires: hardpoints are read, instances are placed.
void compose_bars(Reader& reader, const Entries& bars, ComposedParts& made);

}  // namespace mbgen::reading
