#pragma once

#include <utility>
#include <vector>

namespace mbgen {

/// Diagonal blocks of the upper block-triangular form of a square pattern with a perfect matching on its diagonal
/// candidates. Result: for each diagonal block its (row, column) pairs, first block first. Source: Dulmage and
/// Mendelsohn; Tarjan.
std::vector<std::vector<std::pair<int, int>>> block_triangular_form(const std::vector<std::vector<bool>>& pattern);

}  // namespace mbgen
