#include "compiler/results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "compiler/results/parts.hpp"

namespace mbgen {
namespace results_detail {

Diagnostic problem(const std::string& file, int line, std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.where.file = file;
  diagnostic.where.line = line;
  diagnostic.where.column = line > 0 ? 1 : 0;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  return diagnostic;
}

}  // namespace results_detail

std::optional<Diagnostic> no_text(std::string_view bytes, const std::string& file, const char* kind) {
  const auto is_control = [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code == 0x7f || (code < ' ' && letter != '\t' && letter != '\n' && letter != '\r');
  };
  const auto first = std::find_if(bytes.begin(), bytes.end(), is_control);
  if (first == bytes.end()) return std::nullopt;
  Diagnostic diagnostic;
  const auto before = std::find(std::make_reverse_iterator(first), bytes.rend(), '\n');
  diagnostic.where.file = file;
  diagnostic.where.line = static_cast<int>(std::count(bytes.begin(), first, '\n')) + 1;
  diagnostic.where.column = static_cast<int>(std::distance(before.base(), first)) + 1;
  diagnostic.message = fmt::format("must be text, found a byte {:#04x}", static_cast<unsigned char>(*first));
  diagnostic.hint = kind;
  return diagnostic;
}

int find_column(const Results& results, const std::string& name) {
  for (std::size_t c = 0; c < results.columns.size(); ++c) {
    const Heading& heading = results.columns[c].heading;
    if (heading.name == name || heading_text(heading) == name) return static_cast<int>(c);
  }
  return -1;
}

Result<Results> read_results(std::string_view bytes, const std::string& file) {
  using namespace results_detail;
  constexpr const char* kHint = "a result is a table of mbgen simulate";
  if (bytes.empty()) return problem(file, 0, "the file is empty", kHint);
  if (!is_mat(bytes)) {
    if (std::optional<Diagnostic> fault = no_text(bytes, file, kHint)) return *std::move(fault);
  }
  Result<Results> results = is_mat(bytes) ? read_mat(bytes, file) : read_csv(bytes, file);
  if (!results) return results;
  const std::string& first = results->columns.front().heading.name;
  if (first != "t")
    return problem(file, 1, fmt::format("the first column must be \"t\", found {}", in_quotes(first)), kHint);
  if (results->rows() == 0) return problem(file, 0, "the table has no rows", kHint);
  std::set<std::string> names;
  for (const Column& column : results->columns) {
    if (names.insert(column.heading.name).second) continue;
    return problem(file, 1, fmt::format("column \"{}\" stands twice", column.heading.name));
  }
  for (const Column& column : results->columns) {
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      if (std::isfinite(column.values[row])) continue;
      return problem(file, 0, fmt::format("{}: row {} is not finite", column.heading.name, row + 1));
    }
  }
  const std::vector<double>& time = results->columns.front().values;
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (time[row] > time[row - 1]) continue;
    return problem(file, 0, fmt::format("t must increase, found {} after {}", time[row], time[row - 1]));
  }
  return results;
}

}  // namespace mbgen
