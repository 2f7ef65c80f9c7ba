#include "workbench/sweep/sweep_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "compiler/text/json_text.hpp"
#include "workbench/motion/simulation_text.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

/// Largest number of rows shown; of a longer table, half of them from each end.
constexpr std::size_t kShownRows = 40;

using Row = std::vector<std::string>;

/// A column of a manoeuvre's numbers.
struct ManoeuvreColumn {
  std::string name, unit;
  bool is_of(const ManoeuvreResult& result) const { return result.name == name && result.unit == unit; }
};

/// All numbers that a case has, in the order of the cases' own: one that others lack comes after its neighbour.
std::vector<ManoeuvreColumn> columns_of(const CaseResults& results) {
  std::vector<ManoeuvreColumn> columns;
  for (const auto& [index, result] : results) {
    auto place = columns.begin();
    for (const ManoeuvreResult& number : result.of_manoeuvre) {
      const auto is_it = [&](const ManoeuvreColumn& column) { return column.is_of(number); };
      auto found = std::find_if(columns.begin(), columns.end(), is_it);
      if (found == columns.end()) found = columns.insert(place, {number.name, number.unit});
      place = found + 1;
    }
  }
  return columns;
}

/// The value of a column in a case; nothing where the case lacks it.
std::optional<double> value_of(const ManoeuvreColumn& column, const CaseResult& result) {
  if (!result.has_values()) return {};
  for (const ManoeuvreResult& number : result.of_manoeuvre)
    if (column.is_of(number)) return number.value;
  return {};
}

Row header(const Study& study, const std::vector<ManoeuvreColumn>& columns) {
  Row row{"case"};
  for (const SweepAxis& axis : study.grid.axes) {
    row.push_back(fmt::format("{} [{}]", axis.name, axis.unit.empty() ? "1" : axis.unit));
  }
  for (const Metric& metric : study.metrics.list) row.push_back(metric.name);
  for (const ManoeuvreColumn& column : columns) row.push_back(fmt::format("{} [{}]", column.name, column.unit));
  row.emplace_back("status");
  return row;
}

/// format_string: for numbers.
Row row_of(const Study& study, const std::vector<ManoeuvreColumn>& columns, long index, const CaseResult& result,
           const char* format_string) {
  Row row{fmt::format("{}", index + 1)};
  for (const double value : study.grid.values_of(index)) row.push_back(fmt::format("{}", value));
  for (const double value : result.metrics) {
    row.push_back(result.has_values() ? fmt::format(fmt::runtime(format_string), value) : "");
  }
  for (const ManoeuvreColumn& column : columns) {
    const std::optional<double> value = value_of(column, result);
    row.push_back(value ? fmt::format(fmt::runtime(format_string), *value) : "");
  }
  row.push_back(result.status);
  return row;
}

std::string csv_line(const Row& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) line += (i > 0 ? "," : "") + csv_field(row[i]);
  return line + "\n";
}

/// Columns of numbers aligned right, the last column, text, aligned left.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t c = 0; c + 1 < row.size(); ++c) text += fmt::format("{:>{}}  ", row[c], widths[c]);
    text += row.back() + "\n";
  }
  return text;
}

long warnings_of(const CaseResults& results) {
  return std::count_if(results.begin(), results.end(), [](const auto& entry) { return entry.second.is_warned(); });
}

/// A line on the case with the largest energy error among the cases with a warning; empty without a warning.
std::string worst_text(const Study& study, const CaseResults& results) {
  const std::pair<const long, CaseResult>* worst = nullptr;
  for (const auto& entry : results) {
    const bool is_worse =
        worst == nullptr || std::abs(entry.second.energy_error) > std::abs(worst->second.energy_error);
    if (entry.second.is_warned() && is_worse) worst = &entry;
  }
  if (worst == nullptr) return {};
  std::vector<std::string> values;
  const std::vector<double> at = study.grid.values_of(worst->first);
  for (std::size_t a = 0; a < at.size(); ++a) values.push_back(fmt::format("{} = {}", study.grid.axes[a].name, at[a]));
  return fmt::format("  the worst warning is in case {}, {}\n", worst->first + 1, fmt::join(values, ", "));
}

}  // namespace

long failures_of(const CaseResults& results) {
  return std::count_if(results.begin(), results.end(), [](const auto& entry) { return !entry.second.has_values(); });
}

std::string results_csv(const Study& study, const CaseResults& results) {
  const std::vector<ManoeuvreColumn> columns = columns_of(results);
  std::string text = csv_line(header(study, columns));
  for (const auto& [index, result] : results) text += csv_line(row_of(study, columns, index, result, "{}"));
  return text;
}

std::string results_text(const Study& study, const CaseResults& results, const std::string& file) {
  const std::vector<ManoeuvreColumn> columns = columns_of(results);
  std::vector<Row> rows{header(study, columns)};
  std::size_t place = 0;
  const bool is_long = results.size() > kShownRows;
  for (const auto& [index, result] : results) {
    const bool is_head = !is_long || place < kShownRows / 2, is_tail = place + kShownRows / 2 >= results.size();
    ++place;
    if (!is_head && !is_tail) continue;
    rows.push_back(row_of(study, columns, index, result, "{:.6g}"));
  }
  if (is_long) rows.insert(rows.begin() + 1 + kShownRows / 2, Row(rows.front().size(), "..."));
  const long warnings = warnings_of(results);
  return aligned(rows) + fmt::format("\n{}: {} case{}, {} failed, {}engine {}; table in {}\n{}", study.model.name,
                                     results.size(), results.size() == 1 ? "" : "s", failures_of(results),
                                     warnings > 0 ? fmt::format("{} with a warning, ", warnings) : "",
                                     study.choice.name, file, worst_text(study, results));
}

std::string results_json(const Study& study, const CaseResults& results, const std::string& file) {
  using Json = nlohmann::ordered_json;
  const std::vector<ManoeuvreColumn> columns = columns_of(results);
  Json varied = Json::array(), metrics = Json::array(), cases = Json::array(), numbers = Json::array();
  for (const SweepAxis& axis : study.grid.axes) varied.push_back({{"name", axis.name}, {"unit", axis.unit}});
  for (const Metric& metric : study.metrics.list) metrics.push_back(metric.name);
  for (const ManoeuvreColumn& column : columns) numbers.push_back({{"name", column.name}, {"unit", column.unit}});
  for (const auto& [index, result] : results) {
    Json values = Json::array();
    for (const double value : result.metrics) values.push_back(result.has_values() ? Json(value) : Json());
    Json one = {{"case", index + 1},
                {"values", study.grid.values_of(index)},
                {"metrics", std::move(values)},
                {"status", result.status},
                {"energy_error", result.has_values() ? Json(result.energy_error) : Json()}};
    for (const ManoeuvreColumn& column : columns) {
      const std::optional<double> value = value_of(column, result);
      one["manoeuvre"].push_back(value ? Json(*value) : Json());
    }
    cases.push_back(std::move(one));
  }
  Json all = {{"model", study.model.name},
              {"engine", study.choice.name},
              {"varied", varied},
              {"metrics", metrics},
              {"cases", cases},
              {"failed", failures_of(results)},
              {"warned", warnings_of(results)},
              {"file", file}};
  if (!study.manoeuvre.empty()) all["manoeuvre"] = {{"file", study.arguments.manoeuvre}, {"numbers", numbers}};
  return json_text(all);
}

}  // namespace mbgen
