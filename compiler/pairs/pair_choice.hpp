#pragma once
// Which values are worth computing as pairs.

#include <vector>

#include "compiler/pairs/sums_of_sides.hpp"

namespace mbgen {

/// Operations that are done on pairs.
bool is_done_in_lanes(Op op);

/// Per value: whether its pair, or the pair of which it is the image, is computed in lanes, one operation for both
/// sides. The choice has the fewest operations, including packing and extraction: a minimum cut.
std::vector<bool> chosen_pairs(const Program& program, const PairedValues& values, const SumsOfSides& sums);

}  // namespace mbgen
