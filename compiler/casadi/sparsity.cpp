#include "compiler/casadi/sparsity.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace mbgen {

Pattern dense_pattern(int rows, int columns) {
  Pattern pattern{rows};
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) pattern.row.push_back(i);
    pattern.first.push_back(static_cast<int>(pattern.row.size()));
  }
  return pattern;
}

Pattern empty_pattern(int rows, int columns) {
  Pattern pattern{rows};
  pattern.first.assign(static_cast<std::size_t>(columns) + 1, 0);
  return pattern;
}

Pattern columns_of(const Pattern& pattern, int begin, int end) {
  Pattern part{pattern.rows};
  const int start = pattern.first[static_cast<std::size_t>(begin)];
  for (int j = begin; j < end; ++j) part.first.push_back(pattern.first[static_cast<std::size_t>(j) + 1] - start);
  part.row.assign(pattern.row.begin() + start, pattern.row.begin() + start + part.entries());
  return part;
}

Pattern dependence(const Program& slopes, const std::vector<Slot>& outputs, int seeds) {
  const std::size_t width = static_cast<std::size_t>(seeds);
  std::vector<std::vector<bool>> reached(slopes.nodes.size());
  for (ValueId v = 0; v < slopes.nodes.size(); ++v) {
    const Node& node = slopes.nodes[v];
    const Slot* slot = node.op == Op::input ? &slopes.inputs[static_cast<std::size_t>(node.input)] : nullptr;
    if (slot != nullptr && slot->group == Array::seed) {
      reached[v].assign(width, false);
      reached[v][static_cast<std::size_t>(slot->index)] = true;
    }
    for (int k = 0; k < arity(node.op); ++k) {
      const std::vector<bool>& operand = reached[node.operands[k]];
      if (operand.empty()) continue;
      reached[v].resize(width, false);
      for (std::size_t s = 0; s < width; ++s) reached[v][s] = reached[v][s] || operand[s];
    }
  }
  std::map<Slot, ValueId> values;
  for (const auto& [slot, value] : slopes.outputs) values[slot] = value;
  Pattern pattern{static_cast<int>(outputs.size())};
  for (std::size_t s = 0; s < width; ++s) {
    for (int i = 0; const Slot& slot : outputs) {
      const std::vector<bool>& of_output = reached[values.at(slot)];
      if (!of_output.empty() && of_output[s]) pattern.row.push_back(i);
      ++i;
    }
    pattern.first.push_back(static_cast<int>(pattern.row.size()));
  }
  return pattern;
}

std::vector<int> coloured_columns(const Pattern& pattern) {
  const auto entries = [&](int j) {
    return std::span(pattern.row)
        .subspan(static_cast<std::size_t>(pattern.first[static_cast<std::size_t>(j)]),
                 static_cast<std::size_t>(pattern.first[static_cast<std::size_t>(j) + 1] -
                                          pattern.first[static_cast<std::size_t>(j)]));
  };
  std::vector<int> order(static_cast<std::size_t>(pattern.columns())), colour(order.size(), -1);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](int j) { return entries(j).size(); });
  std::vector<std::vector<bool>> taken;  // rows of each colour
  for (const int j : order) {
    const auto is_apart = [&](const std::vector<bool>& rows) {
      return std::ranges::none_of(entries(j), [&](int i) { return rows[static_cast<std::size_t>(i)]; });
    };
    const auto place = std::ranges::find_if(taken, is_apart) - taken.begin();
    if (place == static_cast<std::ptrdiff_t>(taken.size()))
      taken.emplace_back(static_cast<std::size_t>(pattern.rows), false);
    for (const int i : entries(j)) taken[static_cast<std::size_t>(place)][static_cast<std::size_t>(i)] = true;
    colour[static_cast<std::size_t>(j)] = static_cast<int>(place);
  }
  return colour;
}

}  // namespace mbgen
