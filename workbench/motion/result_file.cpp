#include "workbench/motion/result_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_table.hpp"

namespace mbgen {
namespace {

/// Whether a text matches a pattern, * being any letters.
bool matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0, star = std::string_view::npos, after = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      after = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++after;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

[[noreturn]] void fail_unknown(const Results& results, const std::string& name, const std::string& path,
                               const std::string& option) {
  std::vector<std::string_view> names;
  for (std::size_t c = 1; c < results.columns.size(); ++c) names.push_back(results.columns[c].heading.name);
  const std::string hint = did_you_mean(name, names);
  throw UserError(fmt::format("{}: {} has no column \"{}\"{}{}\n", option, path, name, hint.empty() ? "" : "; ", hint));
}

}  // namespace

Results read_result_file(const std::string& path) {
  const std::string bytes = read_text(path);
  Results results = expect(read_results(bytes, path));
  std::error_code ignored;
  if (results.run.empty() && std::filesystem::is_regular_file(run_file(path), ignored)) {
    results.run = read_text(run_file(path));
  }
  return results;
}

Results read_result_or_sweep(const std::string& path) {
  const std::string bytes = read_text(path);
  return is_sweep(bytes) ? expect(read_sweep(bytes, path)) : read_result_file(path);
}

std::vector<int> find_columns(const Results& results, const std::string& names, const std::string& path,
                              const std::string& option) {
  std::vector<int> found;
  for (const std::string& name : csv_fields(names)) {
    const std::size_t before = found.size();
    if (const int column = find_column(results, name); column >= 0) found.push_back(column);
    for (std::size_t c = 1; c < results.columns.size() && name.find('*') != std::string::npos; ++c) {
      if (matches(name, results.columns[c].heading.name)) found.push_back(static_cast<int>(c));
    }
    if (found.size() == before) fail_unknown(results, name, path, option);
  }
  return found;
}

}  // namespace mbgen
