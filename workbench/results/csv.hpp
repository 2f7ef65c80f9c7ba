#pragma once
// Tables as comma separated values.

#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// The text of a field of a header, without the brackets.
Heading heading_of(const std::string& field);

/// A field of a CSV file, quoted where it has to be (RFC 4180).
std::string csv_field(const std::string& text);

/// Columns with their headings as a CSV file, all digits; a number that is not finite is an empty field.
std::string csv_text(const std::vector<Column>& columns);

/// Fields of a line of a CSV file, without the blanks around them and the quotes.
std::vector<std::string> csv_fields(std::string_view line);

/// Columns of a CSV file. Fails: see read_results.
Result<Results> read_csv(std::string_view text, const std::string& file);

}  // namespace mbgen
