#pragma once
// Orders of a program that `schedule` chooses from: straight code, and code with loops. Inside the passes room.

#include "compiler/passes/roll.hpp"
#include "compiler/passes/scheduled_program.hpp"

namespace mbgen {

/// Straight code: order, parts, calls and one unit a part; no facts of values.
Schedule straight_schedule(const Program& program, Division division, ValueOrder order);

/// Code with loops: order, parts, units with their stored values, and the places and operands of values.
Schedule rolled_schedule(const Program& program, const Rolling& rolling);

}  // namespace mbgen
