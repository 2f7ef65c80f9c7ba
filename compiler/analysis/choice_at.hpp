#pragma once
// Partitions of loop blocks at one position: how those chosen over many stand there, and others chosen for it alone.

#include <optional>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// Smallest frozen pivot of all blocks over what it is elsewhere, at a position of every coordinate, rad or m. Below
/// kPivotThreshold the partition of its block stands badly there.
double weakest_pivot(const Model& model, const Topology& topology, const Analysis& analysis,
                     const std::vector<double>& z);

/// The analysis with the partitions of all blocks chosen for one position, loops closed. Redundant equations stay the
/// same ones where the others hold the rank, so that multipliers do.
/// Result: none where a block has lost rank there, or nearly: no choice helps then.
/// Cost: as the analysis of one configuration.
std::optional<Analysis> chosen_at(const Model& model, const Topology& topology, const Analysis& analysis,
                                  const std::vector<double>& z);

/// The analysis with these coordinates among the independent ones of their loop blocks, others of the block with the
/// best pivots at one position, loops closed. Everything else stays, also the partition of the recursive form.
/// coordinates: tree coordinates in blocks, not driven. Result: none where they do not determine their loops there,
/// with others or alone.
std::optional<Analysis> with_independent(const Model& model, const Topology& topology, const Analysis& analysis,
                                         const std::vector<double>& z, const std::vector<int>& coordinates);

}  // namespace mbgen
