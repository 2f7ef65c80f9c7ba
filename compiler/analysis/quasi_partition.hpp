#pragma once
// The partition of a loop block for the recursive form, whose columns are quasi-velocities where joints are balls.

#include "compiler/analysis/analysis.hpp"
#include "compiler/analysis/sampling.hpp"

namespace mbgen {

/// Partition of block `b` over its (quasi-)velocities, from that of its joint rates. A block without balls keeps its
/// partition; only the references of its rods' pivots change, whose rows are not divided by the rods' lengths.
LoopPartition quasi_partition(NumericSystem& numbers, std::size_t b, const std::vector<Configuration>& configurations,
                              const BlockAnalysis& analysis, const std::vector<bool>& driven);

}  // namespace mbgen
