#include "workbench/results/sweep.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "compiler/text/characters.hpp"
#include "workbench/results/csv.hpp"
#include "workbench/results/faults.hpp"

namespace mbgen {
namespace {

/// A number of a table, NaN for an empty field; no value for other text.
bool read_field(const std::string& field, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (field.empty()) return true;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc() && end == field.data() + field.size() && std::isfinite(value);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] != '\n' || quoted) continue;
    lines.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  if (begin < text.size()) lines.push_back(text.substr(begin));
  return lines;
}

}  // namespace

bool is_sweep(std::string_view bytes) { return bytes.starts_with("case,"); }

Result<Results> read_sweep(std::string_view text, const std::string& file) {
  return read_table(text, file, "a study is a table of mbgen sweep");
}

Result<Results> read_table(std::string_view text, const std::string& file, const char* expected) {
  if (std::optional<Diagnostic> fault = no_text(text, file, expected)) return *std::move(fault);
  const std::vector<std::string_view> lines = lines_of(text);
  if (lines.empty()) return table_fault(file, 0, "has no rows", expected);
  Results results;
  std::vector<std::string> fields = csv_fields(lines.front());
  for (const std::string& field : fields) results.columns.push_back({heading_of(field), {}});
  const bool has_status = results.columns.back().heading.name == "status";
  if (has_status) results.columns.pop_back();
  for (std::size_t row = 1; row < lines.size(); ++row) {
    if (without_blanks(lines[row]).empty()) continue;
    fields = csv_fields(lines[row]);
    const std::size_t wanted = results.columns.size() + (has_status ? 1 : 0);
    const int line = static_cast<int>(row) + 1;
    if (fields.size() != wanted) {
      return table_fault(file, line,
                         fmt::format("must have {} fields like the header, found {}", wanted, fields.size()));
    }
    for (std::size_t c = 0; c < results.columns.size(); ++c) {
      double value = 0;
      if (!read_field(fields[c], value)) {
        return table_fault(file, line,
                           fmt::format("{}: must be a finite number or empty, found {}",
                                       results.columns[c].heading.name, in_quotes(fields[c])));
      }
      results.columns[c].values.push_back(value);
    }
  }
  if (results.rows() == 0) return table_fault(file, 0, "has no rows");
  return results;
}

}  // namespace mbgen
