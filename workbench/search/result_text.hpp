#pragma once
// Pieces of results as text, JSON and pages.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mbgen {

using TableRow = std::vector<std::string>;

/// Columns with blanks between them, numbers aligned right, the first and the last column left. Requires: a row.
std::string aligned_rows(const std::vector<TableRow>& rows);

/// A number, null where it is not finite.
nlohmann::ordered_json number_or_null(double value);

/// A page up to its pictures: title, and the result as text. command: "fit", with a page docs/use/COMMAND.md.
std::string page_head(const std::string& title, const std::string& command, const std::string& text);
constexpr const char* kPageEnd = "</body></html>\n";

}  // namespace mbgen
