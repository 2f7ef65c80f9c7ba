#pragma once
// Programs differentiated along a direction, as C++: for the directional derivatives of an FMU.

#include <string>

#include "compiler/emit/interface_text.hpp"

namespace mbgen {

/// `<model>_directional.hpp`.
std::string directional_header_text(const EmitContext& context);

/// `<model>_directional.cpp`. programs: after the passes, not contracted; context.programs is not looked at.
std::string directional_source_text(const EmitContext& context, const Programs& programs);

}  // namespace mbgen
