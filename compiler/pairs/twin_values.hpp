#pragma once
// Equal operations of equal parts of a mechanism: which value is another one's twin.

#include <span>

#include "compiler/pairs/mirror_images.hpp"

namespace mbgen {

/// The twins of a program: pairs of a value and its twin, the later one crossed, signs all 1; other values are unknown.
/// Found by structure, from twin inputs on: users of twins that are the same operation, with other operands that are
/// one value, twins, constants or alike themselves. Any twins are sound: those that need what the others give are left
/// out, and inputs of parts that are not equal have few twins among their users.
PairedValues twin_values(const Program& program, std::span<const TwinInput> inputs);

}  // namespace mbgen
