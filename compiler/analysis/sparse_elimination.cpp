#include "compiler/analysis/sparse_elimination.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace mbgen {
namespace {

using Values = Eigen::ArrayXd;  // one per sample

constexpr double kNothing = 1e-8;  // of a row's largest entry, and in m or 1: closures are exact to 1e-11
constexpr double kNoise = 1e-12;   // entries below it are rounding
constexpr int kSearchedRows = 6;   // shortest rows that are looked at for each pivot

/// A pivot that could be taken next.
struct PivotChoice {
  int row = -1, column = -1;
  long cost = 0;
  double ratio = 0;
};

class Eliminator {
 public:
  Eliminator(const std::vector<const SparseRows*>& samples, const std::vector<int>& rows,
             const std::vector<bool>& barred, const std::vector<int>& late)
      : rows_(samples[0]->size()),
        scale_(samples[0]->size(), 0),
        is_late_(samples[0]->size(), false),
        columns_(barred.size()) {
    for (int r : late) is_late_[r] = true;
    for (int r : rows) read(samples, r, barred);
    for (int r : rows) {
      for (const auto& [column, values] : rows_[r]) columns_[column].insert(r);
      if (!rows_[r].empty()) queue_of(r).emplace(rows_[r].size(), r);
    }
  }

  SparseElimination result() {
    while (!queue_.empty()) take(best());
    queue_ = std::move(waiting_);
    waits_ = false;
    while (!queue_.empty()) take(best());
    return std::move(result_);
  }

 private:
  std::set<std::pair<std::size_t, int>>& queue_of(int r) { return waits_ && is_late_[r] ? waiting_ : queue_; }

  void read(const std::vector<const SparseRows*>& samples, int r, const std::vector<bool>& barred) {
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const SparseRow<double>& row = (*samples[s])[r];
      for (std::size_t i = 0; i < row.columns.size(); ++i) {
        if (barred[row.columns[i]]) continue;
        Values& values =
            rows_[r].try_emplace(row.columns[i], Values::Zero(static_cast<Eigen::Index>(samples.size()))).first->second;
        values[static_cast<Eigen::Index>(s)] = row.values[i];
      }
    }
    for (const auto& [column, values] : rows_[r]) scale_[r] = std::max(scale_[r], values.abs().maxCoeff());
    for (auto entry = rows_[r].begin(); entry != rows_[r].end();) {
      if (scale_[r] > kNothing) entry->second /= scale_[r];
      const bool counts = scale_[r] > kNothing && entry->second.abs().maxCoeff() > kNoise;
      entry = counts ? std::next(entry) : rows_[r].erase(entry);
    }
  }

  /// Largest |entry| of what remains of a row, per sample.
  Values largest_of(int r) const {
    Values largest = rows_[r].begin()->second.abs();
    for (const auto& [column, values] : rows_[r]) largest = largest.max(values.abs());
    return largest;
  }

  /// Smallest |entry| over the largest one of its remaining row (given) and column, over all samples.
  double ratio(int c, const Values& entry, Values largest) const {
    const Values size = entry.abs();
    for (int other : columns_[c]) largest = largest.max(rows_[other].at(c).abs());
    return (largest > 0).select(size / largest, 0.0).minCoeff();
  }

  /// Ratios within a factor of two or so count as equal: rounding must not tell equal cells apart.
  static bool better(const PivotChoice& a, const PivotChoice& b) {
    if (b.row < 0) return true;
    const bool good = a.ratio >= kPivotRatio, other_good = b.ratio >= kPivotRatio;
    if (good != other_good) return good;
    if (good && a.cost != b.cost) return a.cost < b.cost;
    return a.ratio > 2.1 * b.ratio;
  }

  /// The best of the shortest rows, or of all when none of those has a good pivot.
  PivotChoice best() const {
    PivotChoice best;
    int looked_at = 0;
    for (const auto& [length, r] : queue_) {
      if (++looked_at > kSearchedRows && best.ratio >= kPivotRatio) break;
      const Values largest = largest_of(r);
      for (const auto& [c, values] : rows_[r]) {
        const PivotChoice here{r, c, static_cast<long>((length - 1) * (columns_[c].size() - 1)),
                               ratio(c, values, largest)};
        if (better(here, best)) best = here;
      }
    }
    return best;
  }

  void take(const PivotChoice& choice) {
    const std::map<int, Values> pivot_row = std::move(rows_[choice.row]);
    const Values& pivot = pivot_row.at(choice.column);
    queue_.erase({pivot_row.size(), choice.row});
    for (const auto& [c, values] : pivot_row) columns_[c].erase(choice.row);
    note(choice, pivot);
    const std::set<int> below = columns_[choice.column];
    for (int r : below) subtract(r, choice.column, pivot_row, rows_[r].at(choice.column) / pivot);
  }

  void subtract(int r, int column, const std::map<int, Values>& pivot_row, const Values& factor) {
    std::map<int, Values>& row = rows_[r];
    queue_of(r).erase({row.size(), r});
    for (const auto& [c, values] : pivot_row) {
      const auto [entry, fills] = row.try_emplace(c, Values::Zero(values.size()));
      entry->second -= factor * values;
      if (c == column || !(entry->second.abs().maxCoeff() > kNoise)) {
        row.erase(entry);
        columns_[c].erase(r);
      } else if (fills) {
        columns_[c].insert(r);
      }
    }
    double left = 0;
    for (const auto& [c, values] : row) left = std::max(left, values.abs().maxCoeff());
    if (left > kNothing) {
      queue_of(r).emplace(row.size(), r);
      return;
    }
    result_.largest_dropped = std::max(result_.largest_dropped, left);
    for (const auto& [c, values] : row) columns_[c].erase(r);
    row.clear();
  }

  void note(const PivotChoice& choice, const Values& pivot) {
    std::vector<double> sizes;
    for (double value : pivot) sizes.push_back(std::abs(value) * scale_[choice.row]);
    std::sort(sizes.begin(), sizes.end());
    const double smallest = pivot.abs().minCoeff();
    result_.smallest_kept = result_.pivots.empty() ? smallest : std::min(result_.smallest_kept, smallest);
    result_.worst_ratio = std::min(result_.worst_ratio, choice.ratio);
    result_.pivots.push_back({choice.row, choice.column, sizes[sizes.size() / 2]});
  }

  std::vector<std::map<int, Values>> rows_;
  bool waits_ = true;          // late rows do
  std::vector<double> scale_;  // largest entry of each row over the samples
  std::vector<bool> is_late_;
  std::vector<std::set<int>> columns_;                     // rows with an entry, per column
  std::set<std::pair<std::size_t, int>> queue_, waiting_;  // rows without pivot by their lengths; late ones
  SparseElimination result_;
};

}  // namespace

SparseElimination eliminate(const std::vector<const SparseRows*>& samples, const std::vector<int>& rows,
                            const std::vector<bool>& barred, const std::vector<int>& late) {
  return Eliminator(samples, rows, barred, late).result();
}

}  // namespace mbgen
