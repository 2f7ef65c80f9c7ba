#pragma once
// Consistency of columns of rates with the columns of their values.

#include "workbench/motion/input_table.hpp"

namespace mbgen {

/// Compares a column with the column of its derivative, if the table has one: the integral of the rates between rows,
/// by the trapezoidal rule, with the change of the values. Rows of a smooth motion agree from four rows per period on;
/// so do measured rates with an offset, and rates that jump at a few of many rows. Fails: UserError with file and line,
/// both names and both numbers.
void check_rates(const Model& model, const InputTable& table, const InputColumn& column);

}  // namespace mbgen
