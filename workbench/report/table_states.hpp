#pragma once
// States of a motion from its table.

#include <cstddef>
#include <vector>

#include "runtime/state/state.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// States at some rows. Velocities missing in the table are zero, auxiliary states have their initial values of the
/// model. Requires: the table has all coordinates.
std::vector<GenericState> table_states(const ReportSource& source, const std::vector<std::size_t>& rows);

}  // namespace mbgen
