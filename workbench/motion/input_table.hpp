#pragma once
// A CSV file of inputs over time.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

struct InputColumn {
  int input = -1;              ///< index into Model::inputs
  std::vector<double> values;  ///< one per row
};

struct InputTable {
  std::string path;        ///< of the file
  std::string header;      ///< file and line of the header, for messages
  std::vector<double> t;   ///< s, strictly increasing, at least one
  std::vector<int> lines;  ///< of the file, per row
  std::vector<InputColumn> columns;
  std::vector<std::size_t> fields;  ///< of a row, per column
};

/// The unit, "1" for none.
std::string unit_or_one(const std::string& unit);

/// The column of an input, null if the table has none.
const InputColumn* column_of(const InputTable& table, int input);

/// Reads a table whose header is `t` and names of inputs, each with an optional unit in brackets: `steer [rad]`. Fields
/// may be in quotes (RFC 4180); blank lines are skipped. Of a table of forces along a path, see forces_along, only the
/// columns actuator.NAME.force are read. Fails: UserError with file and line for an unknown or repeated
/// column, a unit that differs from the model's, a row of another length than the header, a field that is not a finite
/// number, t that does not increase, no rows.
InputTable read_input_table(const std::string& path, const Model& model);

/// The same from the file's text; path: for messages.
InputTable parse_input_table(const std::string& text, const std::string& path, const Model& model);

}  // namespace mbgen
