#include "compiler/solver/fine_blocks.hpp"

#include <algorithm>

#include "compiler/analysis/triangular.hpp"

namespace mbgen {
namespace {

using Pattern = std::vector<std::vector<bool>>;

/// Operations of the elimination of all of a block over those of its parts, from which these are taken: below, the
/// tables and the exchanges are not worth it.
constexpr double kWorthFine = 2;

/// Equations and coordinates of the parts, first those whose equations have entries in no later one; none where a
/// pivot comes from elimination alone.
std::vector<std::vector<std::pair<int, int>>> parts_in_order(const std::vector<Pivot>& pivots, const Pattern& pattern) {
  Pattern square(pivots.size(), std::vector<bool>(pivots.size()));
  for (std::size_t r = 0; r < pivots.size(); ++r)
    for (std::size_t c = 0; c < pivots.size(); ++c) square[r][c] = pattern[pivots[r].equation][pivots[c].coordinate];
  std::vector<std::vector<std::pair<int, int>>> parts = block_triangular_form(square);
  for (auto& part : parts) {
    for (auto& [row, column] : part) {
      if (column < 0) return {};
      row = pivots[row].equation;
      column = pivots[column].coordinate;
    }
  }
  std::reverse(parts.begin(), parts.end());
  return parts;
}

double operations_at_once(const BlockAnalysis& block, const Pattern& pattern) {
  const auto rows = std::ranges::count_if(
      pattern, [](const std::vector<bool>& row) { return std::find(row.begin(), row.end(), true) != row.end(); });
  return static_cast<double>(block.rank) * static_cast<double>(rows) * static_cast<double>(pattern[0].size());
}

double operations_of(const FineBlocks& fine) {
  const auto sides = static_cast<double>(fine.others.size() + 2);
  double sum = 0;
  for (const FineBlocks::Part& part : fine.parts)
    sum += part.size * (part.size * (part.size + sides) + part.earlier * sides);
  return sum;
}

}  // namespace

int FineBlocks::largest() const {
  int most = 0;
  for (const Part& part : parts) most = std::max(most, part.size);
  return most;
}

FineBlocks fine_blocks(const BlockAnalysis& block, const Pattern& pattern) {
  if (block.pivots.size() < 2 || !block.late.equations.empty()) return {};
  FineBlocks fine;
  fine.others = block.independent;
  fine.others.insert(fine.others.end(), block.driven.begin(), block.driven.end());
  std::vector<bool> known(pattern[0].size(), false);
  for (const int c : fine.others) known[c] = true;
  for (const auto& pairs : parts_in_order(block.pivots, pattern)) {
    FineBlocks::Part part{static_cast<int>(pairs.size()), static_cast<int>(fine.rows.size()),
                          static_cast<int>(fine.earlier.size())};
    for (const auto& [row, column] : pairs) {
      fine.rows.push_back(row);
      fine.columns.push_back(column);
    }
    for (std::size_t c = 0; c < known.size(); ++c) {
      const bool meets = std::ranges::any_of(pairs, [&](const auto& pair) { return pattern[pair.first][c]; });
      if (known[c] && meets) fine.earlier.push_back(static_cast<int>(c));
    }
    for (const auto& [row, column] : pairs) known[column] = true;
    part.earlier = static_cast<int>(fine.earlier.size()) - part.first_earlier;
    fine.parts.push_back(part);
  }
  const bool is_worth_it =
      !fine.parts.empty() && operations_at_once(block, pattern) >= kWorthFine * operations_of(fine);
  return is_worth_it ? fine : FineBlocks{};
}

FineBlocks fine_blocks(const BlockAnalysis& block, std::size_t b, const BlockPlaces& places,
                       const Program& closure_terms) {
  Pattern pattern(places.equations, std::vector<bool>(places.coordinates, false));
  const SlotGroup group = of_block(Array::Jz, static_cast<int>(b));
  for (const OutputValue& output : closure_terms.outputs) {
    if (output.slot.group != group) continue;
    const Node& node = closure_terms.nodes[output.value];
    if (node.op == Op::constant && node.constant == 0) continue;
    pattern[output.slot.index / places.coordinates][output.slot.index % places.coordinates] = true;
  }
  return fine_blocks(block, pattern);
}

}  // namespace mbgen
