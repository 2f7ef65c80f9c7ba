#pragma once
// The partitions of the loop blocks by counting: the analysis makes short lists by estimates, each candidate is traced.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Candidates that are counted in one model. A candidate costs part of one trace of the accelerations, a compilation
/// about twenty such traces: so many candidates leave its time below one and a half times.
constexpr int kMostCounted = 40;

/// A candidate that is closed under the mirror of the model is taken where it costs no more than this beyond the
/// cheapest: what left and right share can be computed in lanes.
constexpr double kSymmetryBonus = 0.01;

/// Sets `quasi` of every block with several candidates, with its counts: of its share in the accelerations, see
/// trace_block. Blocks of one structure are counted once and take the same coordinates, so that twins stay twins. No
/// clock decides: two runs count the same.
void choose_by_counting(const Model& model, const Topology& topology, Analysis& analysis);

}  // namespace mbgen
