#include "workbench/search/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>"
    "body{{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}}"
    "pre{{overflow-x:auto;background:#f6f6f6;padding:1em}}table{{border-collapse:collapse}}"
    "th,td{{padding:.15em .6em;border-bottom:1px solid #e2e2e2;text-align:right;font-variant-numeric:tabular-nums}}"
    "svg{{max-width:100%;height:auto}}</style></head>\n<body>\n<h1>{0}</h1>\n"
    "<p>By mbgen {1}. Meaning of all numbers: docs/use/{1}.md of mbgen.</p>\n";

/// A text of several lines, escaped.
std::string xml_lines(const std::string& text) {
  std::string escaped;
  for (const std::string& line : split_at(text, '\n')) escaped += xml_text(line) + "\n";
  return escaped;
}

}  // namespace

std::string aligned_rows(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TableRow& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (const TableRow& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c == 0                ? fmt::format("{:<{}}", row[c], widths[c])
              : c + 1 == row.size() ? "  " + row[c]
                                    : fmt::format("  {:>{}}", row[c], widths[c]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

std::string page_head(const std::string& title, const std::string& command, const std::string& text) {
  return fmt::format(fmt::runtime(kHead), xml_text(title), command) + fmt::format("<pre>{}</pre>\n", xml_lines(text));
}

}  // namespace mbgen
