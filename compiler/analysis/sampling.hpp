#pragma once
// Closed configurations of a mechanism, found from random positions around the reference.

#include <vector>

#include "compiler/analysis/configuration.hpp"

namespace mbgen {

/// The reference configuration first, then up to `wanted` more from deterministic random starts of growing distance.
/// Large blocks walk from the reference along a mixture of their freedoms instead, there and back again, with the
/// equations closed that have a pivot at the reference: residuals of the others show their redundancy.
std::vector<Configuration> closed_configurations(NumericSystem& numbers, int wanted);

}  // namespace mbgen
