#pragma once
// A motion as the page reads it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compiler/report/sources.hpp"

namespace mbgen {

/// Rows that are kept of a table: the first, evenly spaced ones and the last; none closer than 10 ms where that leaves
/// enough, and no more than `most`.
std::vector<std::size_t> kept_rows(const std::vector<double>& time, std::size_t most);

/// An animation: name, kind "time", count, times (s) and poses: per time and body of the model seven numbers, origin
/// (m) and unit quaternion x y z w. Fails: see report_html.
Result<nlohmann::ordered_json> motion_json(const ReportSource& source, const std::string& file);

/// All columns: rows, per column name, unit, group (coordinate, velocity, output, residual), smallest, largest and last
/// of all rows; data column by column. Behind them the forces of springs (group force), with extremes of the kept rows.
/// Requires: the result has all coordinates.
nlohmann::ordered_json table_json(const ReportSource& source);

}  // namespace mbgen
