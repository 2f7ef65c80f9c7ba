#pragma once
// The redundancy certificate: ranks and residuals of a block at its closed configurations.

#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Ranks, margins, singular configurations and freedoms of a whole block; its redundant equations are left to
/// certify_redundant.
Certificate certify(const Topology& topology, const LoopBlock& block, const PartView& whole,
                    const std::vector<Configuration>& configurations);

/// The redundant equations of a block (local rows) with their largest residuals over `steps` finite steps.
void certify_redundant(Certificate& certificate, const std::vector<int>& redundant,
                       const std::vector<ClosureEquation>& equations, int steps, const Eigen::VectorXd& residual);

/// Counts configurations of other assembly modes, which have more rank than the branch of the reference.
void add_other_modes(Certificate& certificate, const std::vector<RankCount>& others);

/// How often each rank was seen, highest first.
std::vector<RankCount> rank_counts(const std::vector<int>& ranks);

/// Ranks of all blocks together, over the configurations in which all are closed; highest first.
std::vector<RankCount> ranks_together(const std::vector<PartView>& views,
                                      const std::vector<Configuration>& configurations);

}  // namespace mbgen
