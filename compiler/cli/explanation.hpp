#pragma once
// What mbgen made of a model, in words.

#include <string>

#include "compiler/compile.hpp"

namespace mbgen::cli {

/// Tree, cuts and why, loop blocks, what is redundant and why, freedoms, and where the operations go.
std::string explanation_text(const Compilation& compilation);

}  // namespace mbgen::cli
