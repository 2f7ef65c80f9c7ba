#pragma once
// Signs of twins: of two equal operations, one may be subtracted where the other one is added.

#include <array>
#include <vector>

#include "compiler/pairs/mirror_images.hpp"

namespace mbgen {

/// Twins with their signs, so that both lanes have the same operations: where numbers of the model differ in sign,
/// so do their values; constants absorb signs as far as they can. twin: per value, kNoValue without one. beside: per
/// value that is the earlier twin, operands of the other one beside its own. An addition may have a subtraction for a
/// twin.
PairedValues with_signs(const Program& program, const std::vector<ValueId>& twin,
                        const std::vector<std::array<ValueId, 3>>& beside);

}  // namespace mbgen
