#include "compiler/analysis/triangular.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Kuhn's augmenting path: gives `row` a column, moving others when needed.
bool augment(const std::vector<std::vector<bool>>& pattern, int row, std::vector<int>& row_of,
             std::vector<bool>& seen) {
  for (std::size_t c = 0; c < row_of.size(); ++c) {
    if (!pattern[row][c] || seen[c]) continue;
    seen[c] = true;
    if (row_of[c] < 0 || augment(pattern, row_of[c], row_of, seen)) {
      row_of[c] = row;
      return true;
    }
  }
  return false;
}

/// Tarjan's strongly connected components of the graph row k -> row matched to a column of row k; sinks come out first.
struct Components {
  const std::vector<std::vector<int>>& edges;
  std::vector<int> index, low, stack;
  std::vector<bool> on_stack;
  std::vector<std::vector<int>> found;
  int next = 0;

  void visit(int v) {
    index[v] = low[v] = next++;
    stack.push_back(v);
    on_stack[v] = true;
    for (int w : edges[v]) {
      if (index[w] < 0) {
        visit(w);
        low[v] = std::min(low[v], low[w]);
      } else if (on_stack[w]) {
        low[v] = std::min(low[v], index[w]);
      }
    }
    if (low[v] != index[v]) return;
    found.emplace_back();
    for (int w = -1; w != v;) {
      w = stack.back();
      stack.pop_back();
      on_stack[w] = false;
      found.back().push_back(w);
    }
    std::sort(found.back().begin(), found.back().end());
  }
};

}  // namespace

std::vector<std::vector<std::pair<int, int>>> block_triangular_form(const std::vector<std::vector<bool>>& pattern) {
  const int n = static_cast<int>(pattern.size());
  std::vector<int> row_of(n, -1), column_of(n, -1);
  for (int r = 0; r < n; ++r) {
    std::vector<bool> seen(n, false);
    augment(pattern, r, row_of, seen);
  }
  for (int c = 0; c < n; ++c)
    if (row_of[c] >= 0) column_of[row_of[c]] = c;
  std::vector<std::vector<int>> edges(n);
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c)
      if (pattern[r][c] && row_of[c] >= 0 && row_of[c] != r) edges[r].push_back(row_of[c]);
  Components components{edges, std::vector<int>(n, -1), std::vector<int>(n, 0), {}, std::vector<bool>(n, false), {}, 0};
  for (int r = 0; r < n; ++r)
    if (components.index[r] < 0) components.visit(r);
  std::reverse(components.found.begin(), components.found.end());
  std::vector<std::vector<std::pair<int, int>>> blocks;
  for (const std::vector<int>& rows : components.found) {
    blocks.emplace_back();
    for (int r : rows) blocks.back().emplace_back(r, column_of[r]);
  }
  return blocks;
}

}  // namespace mbgen
