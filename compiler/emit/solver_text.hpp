#pragma once
// The solver: its programs, its tables, its functions.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/frame.hpp"

namespace mbgen {

/// `<model>.cpp`. for_importers: with the functions that an FMU asks for besides.
EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs, bool for_importers);

/// Names of a program and of its result in the struct System. type: of the result; scope: of the function, with "::".
FrameValues system_member(const ShapedProgram& shaped, const std::string& type, const std::string& scope);

/// Values of system.in, the members of the struct System: see mbgen/blocks.hpp and mbgen/batch.hpp. members: of each
/// program, as above; scalar: type of its values.
FrameValues system_values(const EmitContext& context, const FrameRows& members, const std::string& scalar);

}  // namespace mbgen
