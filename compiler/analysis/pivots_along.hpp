#pragma once
// The order of pivots of a large loop block with one freedom, looked at along the whole motion of that freedom.

#include <vector>

#include "compiler/analysis/configuration.hpp"
#include "compiler/formulation/loop_partition.hpp"

namespace mbgen {

/// Orders the pivots by the fine structure under the free coordinate, if the given order comes near zero somewhere
/// along the motion and the other one keeps farther away: once the free coordinate is known, the dependent Jacobian is
/// block triangular, each leg of a walking machine a chain of small systems, and two equations for two coordinates have
/// four orders. Requires: a block that is large and closed at the reference. Blocks with another number of freedoms
/// keep their order. Source: Dulmage and Mendelsohn.
void order_along_motion(NumericSystem& numbers, std::size_t b, const Configuration& reference,
                        LoopPartition& partition);

}  // namespace mbgen
