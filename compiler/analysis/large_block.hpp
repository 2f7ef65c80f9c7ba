#pragma once
// Decisions for a large loop block: by sparse elimination over its closed configurations (docs/evidence/growth.md).

#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/part.hpp"

namespace mbgen {

/// The view of all loops of large block `b`: ranks by elimination; no Jacobians and no singular values.
/// Requires: it is closed at the reference.
PartView large_view(const NumericSystem& numbers, std::size_t b, const std::vector<Configuration>& configurations);

/// Findings on the block, its redundant equations included; pivots of rows scaled to largest entry 1 stand for
/// singular values.
Certificate certify_large(const Topology& topology, std::size_t b, const PartView& whole,
                          const std::vector<ClosureEquation>& equations,
                          const std::vector<Configuration>& configurations);

/// Partition of a large block. driven: local columns that must stay independent; free: others that are to.
BlockAnalysis choose_large_partition(const LoopBlock& block, std::size_t b, const PartView& whole,
                                     const std::vector<int>& driven, const std::vector<Configuration>& configurations,
                                     const std::vector<int>& free = {});

/// One diagnostic when an equation without pivot at the reference does not follow from the others elsewhere.
Diagnostics large_contradictions(const Model& model, const Topology& topology, std::size_t b,
                                 const std::vector<ClosureEquation>& equations,
                                 const std::vector<Configuration>& configurations);

}  // namespace mbgen
