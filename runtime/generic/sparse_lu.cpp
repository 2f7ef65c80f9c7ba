#include "runtime/generic/sparse_lu.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "mbgen/blocks.hpp"

namespace mbgen {

int SparseLu::larger_of(int a, int b) const {
  if (a < 0 || b < 0) return std::max(a, b);
  return std::abs(largest_[b].value) > std::abs(largest_[a].value) ? b : a;
}

void SparseLu::set_largest(int row) {
  Entry largest;
  for (const Entry& e : left_[row]) {
    const double size = std::abs(e.value), best = std::abs(largest.value);
    if (size > best || (size == best && size > 0 && e.index < largest.index)) largest = e;
  }
  largest_[row] = largest;
}

/// Takes over the entries that are not zero. Result: false where one is not finite.
bool SparseLu::take(const std::vector<SparseRow<double>>& rows, int columns) {
  rows_ = static_cast<int>(rows.size());
  left_.resize(rows.size());
  largest_.resize(rows.size());
  rows_of_.resize(static_cast<std::size_t>(columns));
  for (std::vector<int>& of_column : rows_of_) of_column.clear();
  bool finite = true;
  for (int r = 0; r < rows_; ++r) {
    left_[r].clear();
    for (std::size_t e = 0; e < rows[r].columns.size(); ++e) {
      const double value = rows[r].values[e];
      finite = finite && std::isfinite(value);
      if (value == 0) continue;
      left_[r].push_back({rows[r].columns[e], value});
      rows_of_[rows[r].columns[e]].push_back(r);
    }
    set_largest(r);
  }
  leaves_ = std::bit_ceil(rows.size() + 1);
  contest_.assign(2 * leaves_, -1);
  for (int r = 0; r < rows_; ++r) contest_[leaves_ + r] = r;
  for (std::size_t node = leaves_; --node > 0;) contest_[node] = larger_of(contest_[2 * node], contest_[2 * node + 1]);
  return finite;
}

/// Takes `factor` times the rest of the pivot's row from another row.
void SparseLu::subtract(int from, double factor, const Pivot& pivot) {
  std::vector<Entry>& row = left_[from];
  for (std::size_t e = 0; e < row.size(); ++e) place_in_row_[row[e].index] = static_cast<int>(e);
  for (const Entry& u : pivot.above) {
    if (place_in_row_[u.index] >= 0) {
      row[place_in_row_[u.index]].value -= factor * u.value;
    } else {
      row.push_back({u.index, -(factor * u.value)});
      rows_of_[u.index].push_back(from);
    }
  }
  for (const Entry& e : row) place_in_row_[e.index] = -1;
  multiplications_ += static_cast<long>(pivot.above.size());
}

/// Makes the largest entry of a row the next pivot.
void SparseLu::eliminate(int row) {
  if (spare_.empty()) spare_.emplace_back();
  Pivot pivot = std::move(spare_.back());
  spare_.pop_back();
  pivot.row = row;
  pivot.column = largest_[row].index;
  pivot.value = largest_[row].value;
  pivot.below.clear();
  pivot.above.clear();
  for (const Entry& e : left_[row])
    if (e.index != pivot.column) pivot.above.push_back(e);
  left_[row].clear();
  largest_[row] = {};
  const auto contend = [&](int r) {
    for (std::size_t node = (leaves_ + r) / 2; node > 0; node /= 2)
      contest_[node] = larger_of(contest_[2 * node], contest_[2 * node + 1]);
  };
  contend(row);
  for (const int r : rows_of_[pivot.column]) {
    std::vector<Entry>& entries = left_[r];
    const auto at =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.index == pivot.column; });
    if (at == entries.end()) continue;  // it had its pivot
    const double factor = at->value / pivot.value;
    *at = entries.back();
    entries.pop_back();
    pivot.below.push_back({r, factor});
    if (factor != 0) subtract(r, factor, pivot);
    set_largest(r);
    contend(r);
  }
  pivots_.push_back(std::move(pivot));
}

void SparseLu::compute(const std::vector<SparseRow<double>>& rows, int columns, int rank_limit) {
  while (!pivots_.empty()) {
    spare_.push_back(std::move(pivots_.back()));
    pivots_.pop_back();
  }
  multiplications_ = 0;
  place_in_row_.assign(static_cast<std::size_t>(columns), -1);
  double first = 0;
  const bool finite = take(rows, columns);
  while (finite && rank() < rank_limit) {
    const int row = contest_[1];
    const double size = row < 0 ? 0 : std::abs(largest_[row].value);
    if (rank() == 0) first = size;
    if (!(size > 0) || size < kRankTolerance<double> * first) break;
    eliminate(row);
  }
  columns_.clear();
  place_of_column_.assign(static_cast<std::size_t>(columns), -1);
  for (const Pivot& pivot : pivots_) {
    place_of_column_[pivot.column] = static_cast<int>(columns_.size());
    columns_.push_back(pivot.column);
  }
  for (int c = 0; c < columns; ++c) {
    if (place_of_column_[c] >= 0) continue;
    place_of_column_[c] = static_cast<int>(columns_.size());
    columns_.push_back(c);
  }
}

std::vector<int> SparseLu::rows() const {
  std::vector<int> result;
  for (const Pivot& pivot : pivots_) result.push_back(pivot.row);
  return result;
}

double SparseLu::smallest_pivot() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Pivot& pivot : pivots_) smallest = std::min(smallest, std::abs(pivot.value));
  return smallest;
}

std::vector<SparseRow<double>> SparseLu::dependence() const {
  const std::size_t rank = pivots_.size(), others = columns_.size() - rank;
  std::vector<SparseRow<double>> result(rank);
  std::vector<double> sum(others, 0.0);
  std::vector<bool> is_there(others, false);
  std::vector<int> there;
  const auto add = [&](std::size_t q, double value) {
    if (!is_there[q]) there.push_back(static_cast<int>(q));
    is_there[q] = true;
    sum[q] += value;
  };
  for (std::size_t k = rank; k-- > 0;) {
    for (const Entry& u : pivots_[k].above) {
      const auto place = static_cast<std::size_t>(place_of_column_[u.index]);
      if (place >= rank) {
        add(place - rank, u.value);
        continue;
      }
      const SparseRow<double>& later = result[place];
      for (std::size_t e = 0; e < later.columns.size(); ++e)
        add(static_cast<std::size_t>(later.columns[e]), -(u.value * later.values[e]));
    }
    std::sort(there.begin(), there.end());
    for (const int q : there) {
      result[k].push_back(q, sum[q] / pivots_[k].value);
      sum[q] = 0;
      is_there[q] = false;
    }
    there.clear();
  }
  return result;
}

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& b) const {
  Eigen::VectorXd open = b, x(rank());
  for (const Pivot& pivot : pivots_)
    for (const Entry& l : pivot.below) open[l.index] -= l.value * open[pivot.row];
  for (int k = rank() - 1; k >= 0; --k) {
    double value = open[pivots_[k].row];
    for (const Entry& u : pivots_[k].above)
      if (place_of_column_[u.index] < rank()) value -= u.value * x[place_of_column_[u.index]];
    x[k] = value == 0 ? 0.0 : value / pivots_[k].value;  // no -0 of what does not move
  }
  return x;
}

Eigen::VectorXd SparseLu::solve_transposed(const Eigen::VectorXd& f) const {
  Eigen::VectorXd open = f, y = Eigen::VectorXd::Zero(rows_);
  for (int k = 0; k < rank(); ++k) {
    open[k] /= pivots_[k].value;
    for (const Entry& u : pivots_[k].above)
      if (place_of_column_[u.index] < rank()) open[place_of_column_[u.index]] -= u.value * open[k];
    y[pivots_[k].row] = open[k];
  }
  for (int k = rank() - 1; k >= 0; --k)
    for (const Entry& l : pivots_[k].below) y[pivots_[k].row] -= l.value * y[l.index];
  return y;
}

}  // namespace mbgen
