#pragma once
// Equal operations of equal parts of a mechanism: which value is another one's twin.

#include <span>

#include "compiler/pairs/mirror_images.hpp"

namespace mbgen {

/// The twins of a program: pairs of a value and its twin, the later one crossed, signs all 1; other values are unknown.
/// Found by structure, from twin inputs on: users of twins with the same operation, whose other operands are one value,
/// twins, constants or similar themselves. Any twins are sound. Twins that depend on each other are left out, and
/// inputs of unequal parts have few twins among their users.
PairedValues twin_values(const Program& program, std::span<const TwinInput> inputs);

}  // namespace mbgen
