#pragma once
// Tables as comma separated values.

#include <string>
#include <string_view>
#include <utility>
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

/// The lines with text of a CSV file: its header, then rows of as many fields.
class CsvLines {
 public:
  /// Requires: the text outlives this.
  CsvLines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  /// Goes to the next line. Result: false at the end. Fails: UserError for a row that is not as wide as the header, and
  /// for semicolons between fields.
  bool next();
  const std::vector<std::string>& fields() const { return fields_; }
  bool is_header() const { return lines_ == 1; }
  int number() const { return number_; }
  /// FILE:LINE of the line; at the end of the last one, of an empty file of its begin.
  std::string place() const;

 private:
  std::string_view rest_;
  std::string file_;
  std::vector<std::string> fields_;
  int number_ = 0, lines_ = 0;
};

/// Columns of a CSV file. Fails: see read_results.
Result<Results> read_csv(std::string_view text, const std::string& file);

}  // namespace mbgen
