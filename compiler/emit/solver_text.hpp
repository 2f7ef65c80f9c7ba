#pragma once
// The solver: its programs, its tables, its functions.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// `<model>.cpp`. appendix: further text of the solver, after its namespace.
EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs,
                        const std::string& appendix = "");

/// The constants that the texts of a file use, under a heading; empty without any.
std::string constants_text(const ConstantNames& names, const std::string& scalar);

/// Members of the struct System, see mbgen/blocks.hpp and mbgen/batch.hpp. members: those that are its programs' and
/// their results'; scalar: type of its values.
std::string system_text(const EmitContext& context, const std::string& members, const std::string& scalar);

}  // namespace mbgen
