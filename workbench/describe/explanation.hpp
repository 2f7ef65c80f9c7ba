#pragma once
// The structure that mbgen found in a model, in words.

#include <string>

#include "compiler/compile.hpp"

namespace mbgen {

/// Tree, cuts and their reasons, loop blocks, redundant equations and their reasons, left and right, freedoms,
/// elements that give way, stop or stick, states, operations by part.
std::string explanation_text(const Compilation& compilation);

}  // namespace mbgen
