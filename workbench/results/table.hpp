#pragma once
// A table of a motion: columns of numbers with a name and a unit.

#include <cstddef>
#include <string>
#include <vector>

namespace mbgen {

/// A heading of a table: `name [unit]`, or `name`.
struct Heading {
  std::string name, unit;
};

/// `name [unit]`, or `name` without a unit.
std::string heading_text(const Heading& heading);

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

}  // namespace mbgen
