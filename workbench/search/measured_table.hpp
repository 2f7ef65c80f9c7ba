#pragma once
// Tables of measured values: CSV or MAT, with gaps.

#include <string>
#include <vector>

#include "workbench/results/results.hpp"

namespace mbgen {

/// A table as it stands in its file; a gap (an empty field, or "nan") is NaN.
struct MeasuredTable {
  std::string path;
  std::vector<Column> columns;
  std::vector<int> lines;  ///< of the file, per row; of a MAT file the number of the row

  /// "run.csv:12", the place of a row; of the header "run.csv:1".
  std::string place(std::size_t row) const;
  std::string header() const;
};

/// Reads a table. Fails: UserError with file and line for a row of another length than the header, a field that is
/// neither a number nor a gap, a heading that stands twice, no rows, and as read_text.
MeasuredTable read_measured_table(const std::string& path);

/// Index of the column of time ("t" or "time"), -1 without one.
int time_column(const MeasuredTable& table);

/// The values of a column in another unit; a heading without a unit is taken to have it. Fails: UserError with file and
/// line of the header for a unit that is unknown or of another dimension.
std::vector<double> in_unit(const MeasuredTable& table, const Column& column, const std::string& unit);

/// Times in s. Fails: UserError with file and line for a gap, a time that does not increase, or is below 0.
std::vector<double> times_of(const MeasuredTable& table);

}  // namespace mbgen
