#pragma once
// States of a motion from its table.

#include <cstddef>
#include <vector>

#include "runtime/state/state.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// The states at some rows. Velocities that the table lacks are zero, auxiliary states where the model starts them.
/// Requires: the table has all coordinates.
std::vector<GenericState> table_states(const ReportSource& source, const std::vector<std::size_t>& rows);

}  // namespace mbgen
