#pragma once
// Whether columns of rates belong to the columns of values beside them.

#include "workbench/motion/input_table.hpp"

namespace mbgen {

/// Compares a column with that of its derivative, where the table has one: what the rates add up to between rows, by
/// the trapezoidal rule, with what the values change by. Rows of a smooth motion agree from four rows a period on; so
/// do measured rates with an offset, and rates that jump at a few of many rows. Fails: UserError with file and line,
/// both names and both numbers.
void check_rates(const Model& model, const InputTable& table, const InputColumn& column);

}  // namespace mbgen
