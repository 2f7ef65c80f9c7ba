#pragma once
// The share of one loop block in the accelerations, for counting partitions.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// The order of a traced program.
enum class TraceOrder {
  canonical,   ///< the same from every compiler
  as_recorded  ///< for counting: as many operations, in less time
};

/// The share of a loop block in the recursive accelerations, for counting: its joints, those that it moves on and the
/// units directly on it, without applied forces. Of the other blocks nothing is traced. partition: in place of `quasi`.
Program trace_block(const Model& model, const Topology& topology, const Analysis& analysis, int block,
                    const LoopPartition& partition, TraceOrder order);

}  // namespace mbgen
