#pragma once
// The legend of an emitted solver: its tree, loops and names, for whoever reads the file beside the equations.

#include <string>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// Comment lines for below the banner.
std::string legend_text(const EmitContext& context);

}  // namespace mbgen
