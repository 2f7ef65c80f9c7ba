#include "workbench/results/results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace mbgen {
Result<Results> read_results(std::string_view bytes, const std::string& file, const char* hint) {
  if (bytes.empty()) return table_fault(file, 0, "the file is empty", hint);
  if (!is_mat(bytes)) {
    if (std::optional<Diagnostic> fault = no_text(bytes, file, hint)) return *std::move(fault);
  }
  Result<Results> results = is_mat(bytes) ? read_mat(bytes, file) : read_csv(bytes, file);
  if (!results) return results;
  const std::string& first = results->columns.front().heading.name;
  if (first != "t")
    return table_fault(file, 1, fmt::format("the first column must be \"t\", found {}", in_quotes(first)), hint);
  if (results->rows() == 0) return table_fault(file, 0, "the table has no rows", hint);
  std::set<std::string> names;
  for (const Column& column : results->columns) {
    if (names.insert(column.heading.name).second) continue;
    return table_fault(file, 1, fmt::format("column \"{}\" stands twice", column.heading.name));
  }
  for (const Column& column : results->columns) {
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      if (std::isfinite(column.values[row])) continue;
      return table_fault(file, 0, fmt::format("{}: row {} is not finite", column.heading.name, row + 1));
    }
  }
  const std::vector<double>& time = results->columns.front().values;
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (time[row] > time[row - 1]) continue;
    return table_fault(file, 0, fmt::format("t must increase, found {} after {}", time[row], time[row - 1]));
  }
  return results;
}

}  // namespace mbgen
