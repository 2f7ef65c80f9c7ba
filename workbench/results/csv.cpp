#include "workbench/results/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "compiler/text/characters.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/results/faults.hpp"

namespace mbgen {
namespace {

/// The next line of a text, taken off it.
std::string_view take_line(std::string_view& rest) {
  const std::size_t length = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return line;
}

/// Appends the numbers of a row. Result: the fault, empty for none.
std::string read_row(std::string_view rest, Results& results) {
  std::size_t found = 0;
  for (bool more = true; more; ++found) {
    const std::size_t length = std::min(rest.find(','), rest.size());
    const std::string_view field = without_blanks(rest.substr(0, length));
    more = length < rest.size();
    rest.remove_prefix(more ? length + 1 : length);
    if (found >= results.columns.size()) continue;
    Column& column = results.columns[found];
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) {
      return fmt::format("{}: must be a finite number, found {}", column.heading.name, in_quotes(field));
    }
    column.values.push_back(value);
  }
  if (found == results.columns.size()) return {};
  return fmt::format("must have {} fields like the header, found {}", results.columns.size(), found);
}

}  // namespace

Heading heading_of(const std::string& field) {
  const std::size_t bracket = field.rfind('[');
  if (bracket == std::string::npos || field.back() != ']') return {field, ""};
  return {std::string(without_blanks(std::string_view(field).substr(0, bracket))),
          field.substr(bracket + 1, field.size() - bracket - 2)};
}

std::string csv_field(const std::string& text) {
  const std::string line = line_text(text);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string quoted = "\"";
  for (const char letter : line) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string csv_text(const std::vector<Column>& columns) {
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c)
    text += (c > 0 ? "," : "") + csv_field(heading_text(columns[c].heading));
  text += '\n';
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = columns[c].values[row];
      if (c > 0) text += ',';
      if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
    text += '\n';
  }
  return text;
}

std::vector<std::string> csv_fields(std::string_view line) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (doubled) fields.back() += line[i++];
      if (!doubled) quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  for (std::string& field : fields) field = without_blanks(field);
  return fields;
}

bool CsvLines::next() {
  std::string_view line;
  do {
    if (rest_.empty()) return false;
    line = take_line(rest_);
    ++number_;
  } while (without_blanks(line).empty());
  const std::size_t width = fields_.size();
  fields_ = csv_fields(line);
  ++lines_;
  if (is_header() && fields_.size() == 1 && line.find(';') != std::string_view::npos)
    throw UserError(fmt::format(
        "{}: fields are separated by commas, found semicolons\n  hint: write the table with commas between fields, "
        "and points in numbers\n",
        place()));
  if (!is_header() && fields_.size() != width)
    throw UserError(fmt::format("{}: must have {} fields like the header, found {}\n", place(), width, fields_.size()));
  return true;
}

std::string CsvLines::place() const { return fmt::format("{}:{}", file_, std::max(1, number_)); }

Result<Results> read_csv(std::string_view text, const std::string& file) {
  Results results;
  int line = 1;
  for (const std::string& field : csv_fields(take_line(text))) results.columns.push_back({heading_of(field), {}});
  if (results.columns.front().heading.name != "t") return results;  // which the caller refuses
  for (++line; !text.empty(); ++line) {
    const std::string_view row = without_blanks(take_line(text));
    if (row.empty()) continue;
    if (std::string wrong = read_row(row, results); !wrong.empty()) return table_fault(file, line, std::move(wrong));
    const std::vector<double>& time = results.columns.front().values;
    if (time.size() > 1 && !(time.back() > time[time.size() - 2])) {
      return table_fault(file, line,
                         fmt::format("t must increase, found {} after {}", time.back(), time[time.size() - 2]));
    }
  }
  return results;
}

}  // namespace mbgen
