#include "workbench/motion/input_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

[[noreturn]] void fail(const CsvLines& line, const std::string& message) {
  throw UserError(fmt::format("{}: {}\n", line.place(), message));
}

void check_unit(const CsvLines& line, const Heading& heading, const std::string& unit) {
  const std::string expected = unit_or_one(unit);
  if (heading.unit.empty() || heading.unit == expected) return;
  fail(line, fmt::format("{} is in \"{}\", found \"{}\"", heading.name, expected, heading.unit));
}

int find_input(const CsvLines& line, const Model& model, const std::string& name) {
  std::vector<std::string> names;
  for (const Input& input : model.inputs) names.push_back(input.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  const std::string hint = did_you_mean(name, {names.begin(), names.end()});
  fail(line, fmt::format("the model has no input \"{}\"; its inputs: {}{}", name,
                         names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                         hint.starts_with("did") ? "; " + hint : ""));
}

/// The actuator of a column actuator.NAME.force, "" for others.
std::string_view actuator_of(std::string_view name) {
  constexpr std::string_view kBefore = "actuator.", kAfter = ".force";
  if (!name.starts_with(kBefore) || !name.ends_with(kAfter) || name.size() <= kBefore.size() + kAfter.size()) return "";
  return name.substr(kBefore.size(), name.size() - kBefore.size() - kAfter.size());
}

/// Whether a table is one of forces along a path: its other columns are no inputs.
bool holds_forces(const std::vector<std::string>& fields) {
  return std::ranges::any_of(fields,
                             [](const std::string& field) { return !actuator_of(heading_of(field).name).empty(); });
}

void read_header(const CsvLines& line, const Model& model, InputTable& table) {
  const std::vector<std::string>& fields = line.fields();
  table.header = line.place();
  const Heading time = heading_of(fields[0]);
  if (time.name != "t") {
    fail(line, fmt::format("the first column must be \"t\", found {}", in_quotes(time.name)));
  }
  check_unit(line, time, "s");
  if (fields.size() == 1) fail(line, "there is no column of an input");
  const bool of_forces = holds_forces(fields);
  for (std::size_t c = 1; c < fields.size(); ++c) {
    Heading heading = heading_of(fields[c]);
    if (of_forces) heading.name = actuator_of(heading.name);
    if (heading.name.empty()) continue;
    const int input = find_input(line, model, heading.name);
    check_unit(line, heading, model.inputs[input].unit);
    const auto is_same = [input](const InputColumn& column) { return column.input == input; };
    if (std::any_of(table.columns.begin(), table.columns.end(), is_same)) {
      fail(line, fmt::format("column \"{}\" stands twice", heading.name));
    }
    table.columns.push_back({input, {}});
    table.fields.push_back(c);
  }
}

void read_row(const CsvLines& line, const Model& model, InputTable& table) {
  const std::vector<std::string>& fields = line.fields();
  const double t = parse_number(fields[0], line.place() + ": t");
  if (!table.t.empty() && !(t > table.t.back())) {
    fail(line, fmt::format("t must increase, found {} after {}", t, table.t.back()));
  }
  table.t.push_back(t);
  table.lines.push_back(line.number());
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    InputColumn& column = table.columns[c];
    column.values.push_back(
        parse_number(fields[table.fields[c]], fmt::format("{}: {}", line.place(), model.inputs[column.input].name)));
  }
}

}  // namespace

std::string unit_or_one(const std::string& unit) { return unit.empty() ? "1" : unit; }

const InputColumn* column_of(const InputTable& table, int input) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [input](const InputColumn& column) { return column.input == input; });
  return found == table.columns.end() ? nullptr : &*found;
}

InputTable read_input_table(const std::string& path, const Model& model) {
  return parse_input_table(read_text(path), path, model);
}

InputTable parse_input_table(const std::string& text, const std::string& path, const Model& model) {
  if (std::optional<Diagnostic> fault = no_text(text, path, "inputs over time are a CSV table: t [s],name [unit]"))
    throw UserError(Diagnostics{*std::move(fault)});
  InputTable table;
  table.path = path;
  for (CsvLines line(text, path); line.next();)
    line.is_header() ? read_header(line, model, table) : read_row(line, model, table);
  if (table.t.empty()) throw UserError(fmt::format("{}: the table has no rows\n", path));
  return table;
}

}  // namespace mbgen
