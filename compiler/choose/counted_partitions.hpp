#pragma once
// Choice of the loop blocks' partitions by operation count: the analysis makes short lists from estimates, each
// candidate is traced.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Largest number of candidates counted in one model. A candidate costs part of one trace of the accelerations, a
/// compilation about twenty such traces: the limit keeps its time below 1.5 times the time without candidates.
constexpr int kMostCounted = 40;

/// Additional cost accepted for a candidate that is invariant under the mirror symmetry of the model: common operations
/// of left and right can be computed in lanes.
constexpr double kSymmetryBonus = 0.01;

/// Sets `quasi` of every block with several candidates, with their counts in the block's share of the accelerations,
/// see trace_block. Blocks of one structure are counted once and get the same coordinates, so that twins stay twins.
/// The choice does not depend on measured times: it is reproducible.
void choose_by_counting(const Model& model, const Topology& topology, Analysis& analysis);

}  // namespace mbgen
