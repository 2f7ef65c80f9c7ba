#include "compiler/reader/tables/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>

#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/read_text.hpp"

namespace mbgen::reading {
namespace {

/// File name extensions of data for models; messages show no text of other files, which may be system files.
constexpr std::string_view kDataEndings[] = {".csv", ".tsv", ".txt", ".dat", ".tir", ".crg"};

/// A field of a line, without surrounding blanks and quotes.
struct CsvField {
  std::string_view text;
  Place place;
};

/// Fields of the line that starts at `start`. Commas within quotes do not separate.
std::vector<CsvField> fields_of(const Document& document, std::uint32_t file, std::size_t start, std::size_t end) {
  const std::string_view text = document.text;
  std::vector<CsvField> fields;
  bool quoted = false;
  for (std::size_t at = start, from = start; at <= end; ++at) {
    if (at < end && text[at] == '"') quoted = !quoted;
    if (at < end && (quoted || text[at] != ',')) continue;
    std::string_view field = without_blanks(text.substr(from, at - from));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    const std::size_t offset = field.empty() ? from : static_cast<std::size_t>(field.data() - text.data());
    fields.push_back({field, {file, static_cast<std::uint32_t>(offset)}});
    from = at + 1;
  }
  return fields;
}

/// A heading without its unit.
std::string_view name_of(std::string_view heading) {
  const std::size_t bracket = heading.rfind('[');
  return bracket == std::string_view::npos || !heading.ends_with(']') ? heading
                                                                      : without_blanks(heading.substr(0, bracket));
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

bool is_shown(const Reader& reader, Place place) { return reader.documents[place.file].is_shown; }

/// Reports a unit of a heading in which the numbers would be others than those of the model. Result: whether it fits.
bool has_unit(Reader& reader, const CsvField& heading, const CsvColumns& columns) {
  const std::string_view name = name_of(heading.text);
  if (!columns.are_si || name == heading.text) return true;
  const std::string_view written = heading.text.substr(heading.text.rfind('[') + 1);
  const std::string_view unit = without_blanks(written.substr(0, written.size() - 1));
  const std::optional<UnitExponents> found = unit_exponents(unit), wanted = unit_exponents(columns.unit);
  const bool is_si = !found || found->factor == 1;
  const bool is_alike = columns.unit.empty() || (found && wanted && are_alike(*found, *wanted));
  if (is_si && is_alike) return true;
  report(reader, heading.place,
         is_shown(reader, heading.place)
             ? fmt::format("column {} is in {}; numbers of a model are in {}", in_quotes(name), in_quotes(unit),
                           columns.unit.empty() ? "m, rad, s, kg, N and their products" : columns.unit)
             : "unit of the column is not the one of the model",
         "convert the numbers");
  return false;
}

/// Index of a named column; nothing with a problem.
std::optional<std::size_t> find_column(Reader& reader, const Value& table, std::string_view key,
                                       const std::string& wanted, const std::vector<CsvField>& header) {
  const std::size_t by_position = key == "x" ? 0 : 1;
  if (wanted.empty()) {
    if (by_position < header.size()) return by_position;
    report(reader, header[0].place, "a table needs two columns, found one");
    return std::nullopt;
  }
  std::vector<std::string_view> names;
  std::vector<std::size_t> found;
  for (const CsvField& field : header) {
    names.push_back(name_of(field.text));
    if (field.text == wanted || names.back() == wanted) found.push_back(names.size() - 1);
  }
  if (found.size() == 1) return found.front();
  if (!found.empty()) {
    report(reader, header[found[1]].place, fmt::format("column {} stands twice", in_quotes(wanted)));
    return std::nullopt;
  }
  report(reader, *find(table, key), fmt::format("file has no column {}", in_quotes(wanted)),
         is_shown(reader, header[0].place) ? did_you_mean(wanted, names) : "");
  return std::nullopt;
}

/// The number in a column of a line; nothing with a problem.
std::optional<double> number_in(Reader& reader, const std::vector<CsvField>& fields, std::size_t column) {
  const CsvField& field = column < fields.size() ? fields[column] : fields.back();
  if (column >= fields.size()) {
    report(reader, field.place, fmt::format("line has {} fields, column {} is missing", fields.size(), column + 1));
    return std::nullopt;
  }
  const std::optional<double> number = number_of(field.text);
  if (number && std::abs(*number) > kLargestNumber) {
    report(reader, field.place, too_large(field.text));
    return std::nullopt;
  }
  if (!number) {
    report(reader, field.place,
           is_shown(reader, field.place) ? fmt::format("must be a number, got {}", in_quotes(field.text))
                                         : "must be a number",
           "fields are separated by commas, numbers have a decimal point");
    return std::nullopt;
  }
  return number;
}

/// Whether a file named by a model is data of its author, judged by its extension.
bool has_ending_of_data(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(std::begin(kDataEndings), std::end(kDataEndings), ending) != std::end(kDataEndings);
}

}  // namespace

const Document* open_named(Reader& reader, const std::string& file, const std::string& name, std::uint32_t& index,
                           std::string& problem) {
  const NamedFile named = beside(file, name);
  for (std::size_t i = 0; i < reader.documents.size(); ++i) {
    if (reader.documents[i].identity != named.identity || reader.documents[i].parsed) continue;
    index = static_cast<std::uint32_t>(i);
    return &reader.documents[i];
  }
  FileText content = read_regular_file(named.path);
  problem = content.problem;
  if (!problem.empty()) return nullptr;
  index = static_cast<std::uint32_t>(add_document(reader, named.path, std::move(content.text)));
  Document& document = reader.documents[index];
  document.identity = named.identity;
  document.is_shown = has_ending_of_data(named.path);
  find_lines(document);
  return &document;
}

const Document* open_beside(Reader& reader, const Value& value, std::string_view what, std::uint32_t& index) {
  std::string problem;
  const std::string file = reader.documents[value.place.file].file;
  const Document* document = open_named(reader, file, value.text, index, problem);
  if (!document)
    report(reader, value, fmt::format("{} {}: {}", what, in_quotes(value.text), problem),
           hint_of_missing(beside(file, value.text).path));
  return document;
}

std::vector<std::array<double, 2>> read_csv_table(Reader& reader, const Value& table, const CsvColumns& columns) {
  std::uint32_t file = 0;
  const Document* document = open_beside(reader, *find(table, "csv"), "table", file);
  if (!document) return {};
  std::vector<std::array<double, 2>> points;
  std::optional<std::size_t> x, y;
  std::vector<std::uint32_t> starts = document->line_starts;
  starts.push_back(static_cast<std::uint32_t>(document->text.size() + 1));
  for (std::size_t line = 0; line + 1 < starts.size(); ++line) {
    const std::string_view text =
        without_blanks(std::string_view(document->text).substr(starts[line], starts[line + 1] - starts[line] - 1));
    if (text.empty() || text.starts_with('#')) continue;
    const std::vector<CsvField> fields = fields_of(*document, file, starts[line], starts[line + 1] - 1);
    if (!x) {
      x = find_column(reader, table, "x", columns.x, fields);
      y = find_column(reader, table, columns.key_of_y, columns.y, fields);
      if (!x || !y || !has_unit(reader, fields[*x], columns) || !has_unit(reader, fields[*y], columns)) return {};
      if (number_of(fields[*x].text) && number_of(fields[*y].text)) {
        report(reader, fields[0].place, "first line must hold the names of the columns, got numbers");
        return {};
      }
      continue;
    }
    const std::optional<double> at = number_in(reader, fields, *x);
    const std::optional<double> value = at ? number_in(reader, fields, *y) : std::nullopt;
    if (!at || !value) return {};
    if (!points.empty() && *at <= points.back()[0]) {
      report(reader, fields[*x].place,
             fmt::format("x of a table must increase, {} comes after {}", *at, points.back()[0]));
      return {};
    }
    points.push_back({*at, *value});
  }
  if (points.size() < 2)
    report(reader, *find(table, "csv"), fmt::format("table needs at least 2 rows of numbers, found {}", points.size()));
  return points;
}

std::vector<std::vector<CsvNumber>> read_csv_grid(Reader& reader, const Value& value) {
  std::uint32_t file = 0;
  const Document* document = open_beside(reader, value, "map", file);
  if (!document) return {};
  std::vector<std::uint32_t> starts = document->line_starts;
  starts.push_back(static_cast<std::uint32_t>(document->text.size() + 1));
  std::vector<std::vector<CsvNumber>> lines;
  for (std::size_t line = 0; line + 1 < starts.size(); ++line) {
    const std::string_view text =
        without_blanks(std::string_view(document->text).substr(starts[line], starts[line + 1] - starts[line] - 1));
    if (text.empty() || text.starts_with('#')) continue;
    const std::vector<CsvField> fields = fields_of(*document, file, starts[line], starts[line + 1] - 1);
    std::vector<CsvNumber> numbers;
    for (std::size_t i = lines.empty() ? 1 : 0; i < fields.size(); ++i) {
      const std::optional<double> number = number_in(reader, fields, i);
      if (!number) return {};
      numbers.push_back({*number, fields[i].place});
    }
    lines.push_back(std::move(numbers));
  }
  return lines;
}

}  // namespace mbgen::reading
