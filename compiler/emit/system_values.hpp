#pragma once
// Values of system.in: members of the struct System, through which kernels of the runtime call a solver.

#include <string>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/shapes.hpp"

namespace mbgen {

/// Names of a program and of its result. type: of the result; scope: of the function, with "::".
FrameValues system_member(const ShapedProgram& shaped, const std::string& type, const std::string& scope);

/// The members, see mbgen/blocks.hpp and mbgen/lanes/batch.hpp. members: rows of each program, as above; scalar: type
/// of its values.
FrameValues system_values(const EmitContext& context, const FrameRows& members, Scalar scalar);

}  // namespace mbgen
