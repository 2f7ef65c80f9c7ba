#pragma once
// Rank, dependent coordinates and elimination order of one loop block from its Jacobians at many closed configurations.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "compiler/analysis/findings.hpp"

namespace mbgen {

/// Generic rank: the largest over the samples. jacobians: free of units; columns: candidates for dependence (empty:
/// all).
int generic_rank(const std::vector<Eigen::MatrixXd>& jacobians, const std::vector<int>& columns);

/// Smallest pivot that the runtime's full pivoting takes, median over the samples; a scale, so two digits are enough.
double typical_pivot(const std::vector<Eigen::MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                     const LateRows& late = {});

/// The rows of velocities alone of a block (local), where the generic rank leaves some of them out; `late.equations` is
/// empty where it does not. jacobians: as in choose_partition, driven: likewise.
LateRows late_rows(const std::vector<Eigen::MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                   const std::vector<int>& velocity_rows);

/// Makes a candidate the partition of its block.
void take(BlockAnalysis& block, const PartitionCandidate& candidate);

/// Chooses dependent coordinates and leading equations: well conditioned over all samples, then cheapest by an
/// estimate; with a short list of others (BlockAnalysis::candidates). driven: local columns that must stay independent.
/// like: of a block of the same structure, whose pivots candidates take where they hold as well, so that programs of
/// twins are alike. late: rows that are left out before others. Requires: `rank` is reached without the driven columns.
BlockAnalysis choose_partition(const std::vector<Eigen::MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                               std::span<const PartitionCandidate> like = {}, const LateRows& late = {});

}  // namespace mbgen
