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

/// States of the animation, frame by frame, on a page of so many results. Fails: see report_html.
Result<std::vector<GenericState>> motion_frames(const ReportSource& source, const std::string& file,
                                                std::size_t results = 1);

/// Animation of these states: name, kind "time", count, times (s) and poses: seven numbers per time and body of the
/// model, origin (m) and unit quaternion x y z w.
nlohmann::ordered_json motion_json(const GenericSolver& solver, const std::vector<GenericState>& frames);

/// All columns: rows, per column name, unit, group (coordinate, velocity, output, residual), smallest, largest and last
/// of all rows; data column by column. Behind a column the columns of others with its name and unit, "NAME (LABEL)"
/// with the number of the result in other, from 1 on, at the rows of the first, NaN after their end. Behind them the
/// forces of springs (group force), with extremes of the kept rows. Requires: the result has all coordinates.
nlohmann::ordered_json table_json(const ReportSource& source, const std::vector<OtherResult>& others = {});

}  // namespace mbgen
