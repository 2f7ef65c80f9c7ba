#pragma once
// Forces that a result does not hold, from its coordinates.

#include <cstddef>
#include <vector>

#include "workbench/report/sources.hpp"

namespace mbgen {

/// The force of each spring and air spring at some rows, "NAME.force" in N, tension positive for springs as the model
/// defines outputs of them. Left out: those whose numbers depend on inputs, which a result does not hold.
/// Requires: the result has all coordinates; without their velocities the list is empty.
std::vector<Column> element_forces(const ReportSource& source, const std::vector<std::size_t>& rows);

}  // namespace mbgen
