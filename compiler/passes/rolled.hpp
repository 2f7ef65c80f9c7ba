#pragma once
// Code with loops: its units, and the array of values that cross them. Inside the passes room.

#include "compiler/passes/roll.hpp"
#include "compiler/passes/scheduled_program.hpp"

namespace mbgen {

/// Order, parts, units with their stored values, and the places and operands of values.
Schedule rolled_schedule(const Program& program, const Rolling& rolling);

}  // namespace mbgen
