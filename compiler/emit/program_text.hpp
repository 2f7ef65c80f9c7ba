#pragma once
// A straight-line program as C++ functions.

#include <string>

#include "compiler/emit/shapes.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// Definitions of one program: the struct of its result (when the shape has members), the struct of values that cross
/// its parts (when there are several), one static function per part and the function that calls them.
/// Each section starts with its title and ends with its operation count. Unlabelled values of one use are written into
/// the expression that uses them; a value is a statement otherwise, named by its label or numbered in its section.
/// Fails: throws std::logic_error when a slot of the program has no place in the shape.
std::string program_text(const Program& program, const Schedule& schedule, const ProgramShape& shape);

}  // namespace mbgen
