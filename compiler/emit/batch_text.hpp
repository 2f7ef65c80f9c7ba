#pragma once
// The batch interface: many instances of a solver in lanes.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// `<model>_batch.hpp`. Requires: context.lanes > 0, as for the next.
std::string batch_interface_text(const EmitContext& context);

/// `<model>_batch.cpp`.
/// scalars: the solver's programs. Loops over subsystems are of numbers: here all code is straight.
std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars);

}  // namespace mbgen
