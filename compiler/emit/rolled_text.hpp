#pragma once
// A large program as C++ functions with loops over equal subsystems.

#include <optional>
#include <string>

#include "compiler/emit/layout.hpp"
#include "compiler/passes/roll.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// The loops of a program that has more operations and outputs than its shape lets stand straight, when they save at
/// least half of them; nothing for other programs, nor against a clock. The rule is in docs/evidence/growth.md.
std::optional<Rolling> rolled(const Program& program, const ProgramShape& shape);

/// Definitions of one program, as program_text gives them, with the loops of `rolling`. Values that cross slices, loops
/// or parts are in one array of `work`, the values of a slice side by side; constants and places that are no linear
/// function of the slice come from a table.
std::string rolled_text(const Program& program, const ProgramShape& shape, const Rolling& rolling);

}  // namespace mbgen
