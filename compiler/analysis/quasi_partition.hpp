#pragma once
// The partitions of loop blocks for the recursive form, whose columns are quasi-velocities where joints are balls.

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/findings.hpp"

namespace mbgen {

/// Sets BlockAnalysis::quasi and its candidates of every block: its partition over (quasi-)velocities, from the
/// partition over its joint rates. A block without balls keeps its partition; only the references of its rods' pivots
/// change, whose rows are not divided by the rods' lengths. The kinematics are computed once per configuration, and
/// only if a block has balls.
void set_quasi_partitions(NumericSystem& numbers, const std::vector<Configuration>& configurations, Analysis& analysis);

}  // namespace mbgen
