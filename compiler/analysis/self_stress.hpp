#pragma once
// Redundant equations of a part that cannot move: do they follow from the equations that they depend on?

#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Rows of a matrix that depend on each other: the connected components of its dependences, each with its kept rows and
/// its dependent rows. Rows on which nothing depends are in none.
struct DependentRows {
  std::vector<int> kept, redundant;
};
/// late: rows that follow from others before other rows do.
std::vector<DependentRows> dependent_rows(const Eigen::MatrixXd& matrix, int rank, const std::vector<int>& late = {});

/// True when every set of rows of a locked part that depend on each other leaves its loops a freedom and agrees along
/// it, as a parallelogram does that a rod locks: what locks the part is then in no contradiction with anything.
/// s: a view index of generic rank; start: the position there.
bool redundancy_holds(NumericSystem& numbers, std::size_t b, const PartView& view, std::size_t s,
                      const std::vector<double>& start);

}  // namespace mbgen
