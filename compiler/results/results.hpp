#pragma once
// The door of the results room: tables of a motion as files, CSV or MAT (level 4), written and read.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/diagnostic.hpp"

namespace mbgen {

/// A heading of a table: `name [unit]`, or `name`.
struct Heading {
  std::string name, unit;
};

/// The text of a field of a header, without the brackets.
Heading heading_of(const std::string& field);

/// `name [unit]`, or `name` without a unit.
std::string heading_text(const Heading& heading);

/// A field of a CSV file, quoted where it has to be (RFC 4180).
std::string csv_field(const std::string& text);

/// Fields of a line of a CSV file, without the blanks around them and the quotes.
std::vector<std::string> csv_fields(std::string_view line);

/// One column of a table.
struct Column {
  Heading heading;
  std::vector<double> values;  ///< one per row, in the heading's unit
};

/// A table of a motion.
struct Results {
  std::vector<Column> columns;  ///< the first is time, "t" in s; all of one length
  std::string run;              ///< description of the run, JSON text; empty when the file does not hold it
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

/// Index of the column of this name, with or without its unit in brackets; -1 when there is none.
int find_column(const Results& results, const std::string& name);

/// A MAT file of level 4: `data` (rows by columns), `names` and `units` (one row of text a column, blanks behind) and
/// `run` (JSON text). MATLAB, Octave and scipy.io.loadmat read it.
std::string mat_text(const Results& results);

/// Reads a table that `mbgen simulate` wrote; its bytes say whether it is CSV or MAT. file: for messages.
/// Ensures: every number is finite, time increases.
/// Fails: a file without rows, a row of another length than the header, a field that is no finite number, time that
/// does not increase or does not stand first, a heading that stands twice, a MAT file of another level, byte order or
/// make.
Result<Results> read_results(std::string_view bytes, const std::string& file);

/// Refuses bytes that are no text, control characters but for tabs and ends of lines, before any of them is repeated in
/// a message. kind: of the file that is expected. Fails: Diagnostic with line and column of the first.
std::optional<Diagnostic> no_text(std::string_view bytes, const std::string& file, const char* kind);

/// Whether a text is the table of a study, as `mbgen sweep` writes it: its first column is "case".
bool is_sweep(std::string_view bytes);

/// Reads the table of a study, without its column of states. Values of cases that failed are NaN.
/// Fails: no rows, a row of another length than the header, a field that is neither empty nor a finite number.
Result<Results> read_sweep(std::string_view text, const std::string& file);

}  // namespace mbgen
