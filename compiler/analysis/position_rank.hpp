#pragma once
// Position rank of a block: without the rows that hold velocities alone (rolling, blades).

#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Rank of the position equations of block `b`; of all its equations if it has no others. whole: of the block; rank: of
/// all its rows.
int position_rank(const NumericSystem& numbers, std::size_t b, const PartView& whole, int rank,
                  const std::vector<Configuration>& configurations);

}  // namespace mbgen
