#include "workbench/search/measured_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

bool is_gap_word(std::string_view field) {
  std::string small(field);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small.empty() || small == "nan" || small == "-nan" || small == "na" || small == "n/a";
}

double number_of(const std::string& field, const CsvLines& line, const Column& column) {
  if (is_gap_word(field)) return kGap;
  double value = 0;
  const char* first = field.data() + (field.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(first, field.data() + field.size(), value);
  const bool is_number = error == std::errc() && end == field.data() + field.size() && std::isfinite(value);
  if (is_number && std::abs(value) <= kLargestNumber) return value;
  throw UserError(fmt::format(
      "{}: {}: {}\n", line.place(), column.heading.name,
      is_number ? too_large(field) : fmt::format("must be a number, or empty for none, found {}", in_quotes(field))));
}

void read_measured_header(const CsvLines& line, MeasuredTable& table) {
  for (const std::string& field : line.fields()) table.columns.push_back({heading_of(field), {}});
  std::set<std::string> names;
  for (const Column& column : table.columns)
    if (!names.insert(column.heading.name).second)
      throw UserError(fmt::format("{}: column {} stands twice\n", table.header(), in_quotes(column.heading.name)));
}

void read_measured_csv(const std::string& text, MeasuredTable& table) {
  if (std::optional<Diagnostic> fault = no_text(text, table.path, "measured values are a table, CSV or MAT"))
    throw UserError(Diagnostics{*std::move(fault)});
  for (CsvLines line(text, table.path); line.next();) {
    if (line.is_header()) {
      read_measured_header(line, table);
      continue;
    }
    table.lines.push_back(line.number());
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      table.columns[c].values.push_back(number_of(line.fields()[c], line, table.columns[c]));
  }
}

void read_measured_mat(const std::string& bytes, MeasuredTable& table) {
  Results results = expect(read_mat(bytes, table.path));
  table.columns = std::move(results.columns);
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) table.lines.push_back(static_cast<int>(row) + 1);
}

/// Exponents with angles as plain numbers.
}  // namespace

std::string MeasuredTable::place(std::size_t row) const { return fmt::format("{}:{}", path, lines[row]); }

std::string MeasuredTable::header() const { return path + ":1"; }

MeasuredTable read_measured_table(const std::string& path) {
  MeasuredTable table{path, {}, {}};
  const std::string bytes = read_text(path);
  if (is_mat(bytes)) {
    read_measured_mat(bytes, table);
  } else {
    read_measured_csv(bytes, table);
  }
  if (table.lines.empty()) throw UserError(fmt::format("{}: the table has no rows\n", path));
  return table;
}

int time_column(const MeasuredTable& table) {
  for (const char* name : {"t", "time", "Time"})
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      if (table.columns[c].heading.name == name) return static_cast<int>(c);
  return -1;
}

std::vector<double> in_unit(const MeasuredTable& table, const Column& column, const std::string& unit) {
  const std::string& found = column.heading.unit;
  if (found.empty() || found == unit) return column.values;
  const std::string wanted = unit.empty() ? "1" : unit;
  const std::optional<UnitExponents> from = unit_exponents(found), to = unit_exponents(wanted);
  const bool is_plain = found == "-" || found == "1";
  if (to && (from || is_plain)) {
    const UnitExponents of_column = from.value_or(UnitExponents{});
    if (are_alike(of_column, *to)) {
      std::vector<double> values = column.values;
      for (double& value : values) value *= of_column.factor / to->factor;
      return values;
    }
  }
  throw UserError(fmt::format("{}: {} is in {}, found {}{}\n", table.header(), column.heading.name, in_quotes(wanted),
                              in_quotes(found), from || is_plain ? "" : ", a unit that mbgen does not know"));
}

std::vector<double> times_of(const MeasuredTable& table) {
  const Column& column = table.columns[static_cast<std::size_t>(time_column(table))];
  const std::vector<double> times = in_unit(table, column, "s");
  for (std::size_t row = 0; row < times.size(); ++row) {
    const std::string name = column.heading.name;
    if (std::isnan(times[row])) throw UserError(fmt::format("{}: {} has no value\n", table.place(row), name));
    if (times[row] < 0)
      throw UserError(
          fmt::format("{}: {} = {} s: a motion starts at 0\n  hint: shift the times, so that 0 is the instant of the "
                      "model's initial state\n",
                      table.place(row), name, times[row]));
    if (row > 0 && !(times[row] > times[row - 1]))
      throw UserError(
          fmt::format("{}: {} must increase, found {} after {}\n", table.place(row), name, times[row], times[row - 1]));
  }
  return times;
}

}  // namespace mbgen
