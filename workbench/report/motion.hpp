#pragma once
// A motion as the page reads it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/generic/generic.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// Rows that are kept of a table: the first, evenly spaced ones and the last; none closer than 10 ms where that leaves
/// enough, and no more than `most`.
std::vector<std::size_t> kept_rows(const std::vector<double>& time, std::size_t most);

/// The states that the page shows one after the other. Fails: see report_html.
Result<std::vector<GenericState>> motion_frames(const ReportSource& source, const std::string& file);

/// An animation of these: name, kind "time", count, times (s) and poses: per time and body of the model seven numbers,
/// origin (m) and unit quaternion x y z w.
nlohmann::ordered_json motion_json(const GenericSolver& solver, const std::vector<GenericState>& frames);

/// All columns: rows, per column name, unit, group (coordinate, velocity, output, residual), smallest, largest and last
/// of all rows; data column by column. Behind them the forces of springs (group force), with extremes of the kept rows.
/// Requires: the result has all coordinates.
nlohmann::ordered_json table_json(const ReportSource& source);

}  // namespace mbgen
