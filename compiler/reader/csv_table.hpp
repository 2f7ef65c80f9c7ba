#pragma once
// Tables of two columns of a CSV file.

#include <array>
#include <string>
#include <vector>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Which columns; empty: the first and the second.
struct CsvColumns {
  std::string x, y;
  std::string_view key_of_y = "y";  ///< what names y in the object
};

/// The file that `file` names, relative to it, as a document without JSON. Fails: nothing, with the problem.
const Document* open_named(Reader& reader, const std::string& file, const std::string& name, std::uint32_t& index,
                           std::string& problem);

/// The file that `value` of the current scope names, relative to the one it is written in, as a document without JSON.
/// what: as messages call it. Fails: nothing, with a complaint at `value`.
const Document* open_beside(Reader& reader, const Value& value, std::string_view what, std::uint32_t& index);

/// Points [x, y] of two columns. The first line holds the names of the columns, perhaps with a unit in brackets behind;
/// fields are separated by commas; empty lines and lines that start with # are skipped.
/// value: the name of the file; table: the object it stands in, with "x" and the key of y.
/// Fails: empty, with a complaint that names line and column of the CSV file.
std::vector<std::array<double, 2>> read_csv_table(Reader& reader, const Value& table, const CsvColumns& columns);

}  // namespace mbgen::reading
