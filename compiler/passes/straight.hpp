#pragma once
// Straight code: its order, and its division into parts. Inside the passes room.

#include "compiler/passes/scheduled_program.hpp"

namespace mbgen {

/// Order, parts, calls and one unit a part; no facts of values.
Schedule straight_schedule(const Program& program, Division division, ValueOrder order);

}  // namespace mbgen
