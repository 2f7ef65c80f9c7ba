#pragma once
// Which entries of a Jacobian are not always zero, and which of its columns one direction gives.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Pattern in compressed columns: entries of column j are those from first[j] to before first[j + 1], row by row.
struct Pattern {
  int rows = 0;
  std::vector<int> first = {0}, row = {};

  int columns() const { return static_cast<int>(first.size()) - 1; }
  int entries() const { return first.back(); }
};

Pattern dense_pattern(int rows, int columns = 1);
Pattern empty_pattern(int rows, int columns = 1);

/// The columns from `begin` to before `end`.
Pattern columns_of(const Pattern& pattern, int begin, int end);

/// Dependence of the derivative outputs of a program on Array::seed. outputs: a row for each. Entries that only some
/// values make zero are in it.
Pattern dependence(const Program& slopes, const std::vector<Slot>& outputs, int seeds);

/// A colour for each column, from 0 on: columns of one colour have no row in common. Source: Curtis, Powell and Reid,
/// On the estimation of sparse Jacobian matrices (1974); columns with most entries first.
std::vector<int> coloured_columns(const Pattern& pattern);

}  // namespace mbgen
