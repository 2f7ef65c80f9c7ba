#pragma once
// Data of a motion for the page.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/generic/generic.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// Rows kept of a table: the first, the last and evenly spaced ones between, at least 10 ms apart if enough remain, at
/// most `most`.
std::vector<std::size_t> kept_rows(const std::vector<double>& time, std::size_t most);

/// States of the animation, frame by frame. Fails: see report_html.
Result<std::vector<GenericState>> motion_frames(const ReportSource& source, const std::string& file);

/// Animation of these states: name, kind "time", count, times (s) and poses: seven numbers per time and body of the
/// model, origin (m) and unit quaternion x y z w.
nlohmann::ordered_json motion_json(const GenericSolver& solver, const std::vector<GenericState>& frames);

/// All columns: rows, per column name, unit, group (coordinate, velocity, output, residual), smallest, largest and last
/// of all rows; data column by column. Behind them the forces of springs (group force), with extremes of the kept rows.
/// Requires: the result has all coordinates.
nlohmann::ordered_json table_json(const ReportSource& source, const std::vector<OtherResult>& others = {});

}  // namespace mbgen
