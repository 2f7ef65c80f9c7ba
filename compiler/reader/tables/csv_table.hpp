#pragma once
// Tables of two columns of a CSV file.

#include <array>
#include <string>
#include <vector>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Names of the columns; empty: the first and the second.
struct CsvColumns {
  std::string x = {}, y = {};
  std::string_view key_of_y = "y";  ///< what names y in the object
  bool are_si = true;               ///< the numbers are those of an element: their units have no factor
  std::string_view unit = "";       ///< of both columns, where it is known
};

/// The file named `file`, relative to it, as a document without JSON. Fails: nothing, with the problem.
const Document* open_named(Reader& reader, const std::string& file, const std::string& name, std::uint32_t& index,
                           std::string& problem);

/// The file named by `value` of the current scope, relative to the file of `value`, as a document without JSON. what:
/// its name in messages. Fails: nothing, with a problem at `value`.
const Document* open_beside(Reader& reader, const Value& value, std::string_view what, std::uint32_t& index);

/// Points [x, y] from two columns. The first line has the names of the columns, possibly followed by a unit in
/// brackets, which is compared; fields are separated by commas; empty lines and lines that start with # are skipped.
/// value: the name of the file; table: its object, with "x" and the key of y. Fails: empty, with a problem that names
/// line and column of the CSV file.
std::vector<std::array<double, 2>> read_csv_table(Reader& reader, const Value& table, const CsvColumns& columns);

/// Numbers of a grid with the place of each.
struct CsvNumber {
  double number = 0;
  Place place;
};

/// Lines of numbers; of the first one the first field is a heading and is left out. Empty lines and lines that start
/// with # are skipped. value: the name of the file. Fails: empty, with a problem that names line and column of the
/// file.
std::vector<std::vector<CsvNumber>> read_csv_grid(Reader& reader, const Value& value);

}  // namespace mbgen::reading
