#pragma once
// The programs of accelerations in the matrix form: the nine steps of the paper.

#include "compiler/analysis/analysis.hpp"
#include "compiler/trace/projections.hpp"

namespace mbgen {

/// Same slots as Programs::accelerations or accelerations_chosen.
Program trace_matrix_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                   Partition partition);

}  // namespace mbgen
