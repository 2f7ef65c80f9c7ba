#pragma once
// Structure of a model as found by mbgen, in words.

#include <string>

#include "compiler/compile.hpp"

namespace mbgen {

/// Tree, cuts and their reasons, loop blocks, redundant equations and their reasons, left and right, freedoms,
/// compliant elements, stops and sticking frictions, states, operations by part.
std::string explanation_text(const Compilation& compilation);

}  // namespace mbgen
