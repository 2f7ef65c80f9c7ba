#include "compiler/analysis/elimination_order.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "compiler/algebra/median.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/sparse_elimination.hpp"
#include "compiler/analysis/triangular.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using namespace search_numbers;

/// Equilibrated copies of the dependent Jacobian, eliminated in step over all samples.
struct Elimination {
  std::vector<MatrixXd> matrices;  // rows scaled to largest entry 1 over the samples
  std::vector<double> row_scale;
  MatrixXd largest;  // over the samples: the pattern, with fill
};

Elimination equilibrated(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& used,
                         const Candidate& candidate) {
  Elimination e;
  for (std::size_t s = 0; s < jacobians.size(); ++s)
    if (used[s]) e.matrices.push_back(part_of(jacobians[s], candidate.rows, candidate.columns));
  const auto n = static_cast<Eigen::Index>(candidate.rows.size());
  e.largest = MatrixXd::Zero(n, n);
  for (const MatrixXd& m : e.matrices) e.largest = e.largest.cwiseMax(m.cwiseAbs());
  for (Eigen::Index r = 0; r < n; ++r) e.row_scale.push_back(e.largest.row(r).maxCoeff());
  for (MatrixXd& m : e.matrices)
    for (Eigen::Index r = 0; r < n; ++r) m.row(r) /= e.row_scale[r];
  for (Eigen::Index r = 0; r < n; ++r) e.largest.row(r) /= e.row_scale[r];
  return e;
}

/// Smallest |pivot| over the largest entry of its remaining column, over all samples.
double pivot_ratio(const Elimination& e, int row, int column, const std::vector<int>& rows) {
  double worst = 1;
  for (const MatrixXd& m : e.matrices) {
    double largest = 0;
    for (int r : rows) largest = std::max(largest, std::abs(m(r, column)));
    worst = std::min(worst, largest == 0 ? 0.0 : std::abs(m(row, column)) / largest);
  }
  return worst;
}

/// Markowitz: the sparsest of the entries that are large enough everywhere.
std::pair<int, int> choose_pivot(const Elimination& e, const std::vector<int>& rows, const std::vector<int>& columns,
                                 double& ratio) {
  const auto filled = [&](int r, int c) { return e.largest(r, c) > kStructuralZero; };
  std::pair<int, int> best{-1, -1}, largest{rows[0], columns[0]};
  double best_cost = 0, largest_ratio = -1, best_ratio = 0;
  for (int r : rows)
    for (int c : columns) {
      if (!filled(r, c)) continue;
      const double here = pivot_ratio(e, r, c, rows);
      if (here > largest_ratio) largest = {r, c}, largest_ratio = here;
      if (here < kPivotRatio) continue;
      const auto in_row = std::count_if(columns.begin(), columns.end(), [&](int other) { return filled(r, other); });
      const auto in_column = std::count_if(rows.begin(), rows.end(), [&](int other) { return filled(other, c); });
      const double cost = static_cast<double>((in_row - 1) * (in_column - 1));
      if (best.first < 0 || cost < best_cost || (cost == best_cost && here > best_ratio * (1 + kTie)))
        best = {r, c}, best_cost = cost, best_ratio = here;
    }
  ratio = best.first >= 0 ? best_ratio : largest_ratio;
  return best.first >= 0 ? best : largest;
}

double median_pivot(const Elimination& e, int row, int column) {
  std::vector<double> values;
  for (const MatrixXd& m : e.matrices) values.push_back(std::abs(m(row, column)) * e.row_scale[row]);
  return median(std::move(values));
}

/// Eliminates one diagonal block of the triangular form and appends its pivots. given: the pivots, chosen where there
/// are none; the first of them are taken away.
void order_block(Elimination& e, const Candidate& candidate, const std::vector<std::pair<int, int>>& block,
                 std::span<const std::pair<int, int>>& given, Ordering& ordering) {
  std::vector<int> rows, columns;
  for (const auto& [r, c] : block) rows.push_back(r), columns.push_back(c);
  while (!rows.empty()) {
    double ratio = 0;
    const auto [row, column] = given.empty() ? choose_pivot(e, rows, columns, ratio) : given[0];
    if (!given.empty()) {
      ratio = pivot_ratio(e, row, column, rows);
      given = given.subspan(1);
    }
    ordering.worst_ratio = std::min(ordering.worst_ratio, ratio);
    ordering.pivots.push_back({candidate.rows[row], candidate.columns[column], median_pivot(e, row, column)});
    rows.erase(std::find(rows.begin(), rows.end(), row));
    columns.erase(std::find(columns.begin(), columns.end(), column));
    for (int r : rows) {
      if (e.largest(r, column) <= kStructuralZero) continue;
      for (MatrixXd& m : e.matrices) {
        const double factor = m(r, column) / m(row, column);
        for (int c : columns) m(r, c) -= factor * m(row, c);
      }
      for (int c : columns)
        if (e.largest(row, c) > kStructuralZero) {
          e.largest(r, c) = std::max(e.largest(r, c), e.largest(row, c));
          ordering.cost += 2;
        }
      ordering.cost += 2;
    }
  }
}

}  // namespace

MatrixXd part_of(const MatrixXd& m, const std::vector<int>& rows, const std::vector<int>& columns) {
  MatrixXd result(rows.size(), columns.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) result(r, c) = m(rows[r], columns[c]);
  return result;
}

namespace {

/// Whether pivots take a triangular form block by block.
bool fit(std::span<const std::pair<int, int>> pivots, const std::vector<std::vector<std::pair<int, int>>>& form) {
  for (const auto& block : form) {
    std::vector<int> rows, columns, pivot_rows, pivot_columns;
    for (std::size_t k = 0; k < block.size(); ++k) {
      rows.push_back(block[k].first);
      columns.push_back(block[k].second);
      pivot_rows.push_back(pivots[k].first);
      pivot_columns.push_back(pivots[k].second);
    }
    if (!std::ranges::is_permutation(rows, pivot_rows) || !std::ranges::is_permutation(columns, pivot_columns))
      return false;
    pivots = pivots.subspan(block.size());
  }
  return true;
}

Ordering ordered(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& used, const Candidate& candidate,
                 std::span<const std::pair<int, int>> given) {
  Ordering ordering;
  Elimination e = equilibrated(jacobians, used, candidate);
  const std::size_t n = candidate.rows.size();
  std::vector<std::vector<bool>> pattern(n, std::vector<bool>(n));
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c) pattern[r][c] = e.largest(r, c) > kStructuralZero;
  const auto form = block_triangular_form(pattern);
  if (!given.empty() && !fit(given, form)) return {};
  for (const auto& block : form) {
    ordering.triangular_sizes.push_back(static_cast<int>(block.size()));
    order_block(e, candidate, block, given, ordering);
  }
  ordering.cost += 2 * static_cast<double>((e.largest.array() > kStructuralZero).count());
  return ordering;
}

}  // namespace

Ordering order_pivots(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& used,
                      const Candidate& candidate) {
  return ordered(jacobians, used, candidate, {});
}

Ordering order_like(const std::vector<Pivot>& pivots, const std::vector<MatrixXd>& jacobians,
                    const std::vector<bool>& used, const Candidate& candidate) {
  std::vector<std::pair<int, int>> places;
  for (const Pivot& pivot : pivots) {
    const auto row = std::ranges::find(candidate.rows, pivot.equation);
    const auto column = std::ranges::find(candidate.columns, pivot.coordinate);
    if (row == candidate.rows.end() || column == candidate.columns.end()) return {};
    places.emplace_back(row - candidate.rows.begin(), column - candidate.columns.begin());
  }
  return places.size() == candidate.rows.size() ? ordered(jacobians, used, candidate, places) : Ordering{};
}

}  // namespace mbgen
