#pragma once
// The branch of the reference: the assembly mode that the model describes, among the closed configurations that random
// starts find. Rank, redundancy and partition belong to it (docs/method/redundancy.md).

#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Keeps every small block on the branch that continues from its reference. Where a random start closed a block, or one
/// of its loops, with more rank than it has at the reference, the block walks from the reference along its own
/// freedoms; when no place of the walks has that rank either, its random configurations are taken back (marked as not
/// closed) and places of the walks, closed for this block alone, are added. equations: per block. Result: per block,
/// ranks of the whole block above the rank of its branch, highest first.
std::vector<std::vector<RankCount>> stay_on_branch(NumericSystem& numbers,
                                                   const std::vector<std::vector<ClosureEquation>>& equations,
                                                   std::vector<Configuration>& configurations);

}  // namespace mbgen
