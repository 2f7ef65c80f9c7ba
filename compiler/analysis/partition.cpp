#include "compiler/analysis/partition.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/elimination_order.hpp"
#include "compiler/analysis/part.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/sparse_elimination.hpp"
#include "mbgen/solver/loop.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using namespace search_numbers;

MatrixXd columns_of(const MatrixXd& m, const std::vector<int>& columns) {
  MatrixXd result(m.rows(), columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) result.col(c) = m.col(columns[c]);
  return result;
}

int rank_of(const MatrixXd& m) {
  if (m.size() == 0) return 0;
  return static_cast<int>((singular_values(m).array() > kLeastSingularValue).count());
}

/// Rows and columns that full pivoting takes first, late rows after the others.
Candidate pivoted(MatrixXd m, int rank, const std::vector<int>& columns, const LateRows& late) {
  Candidate chosen;
  std::set<int> rows_left, columns_left(columns.begin(), columns.end()), waiting;
  for (int r = 0; r < m.rows(); ++r) (contains(late.equations, r) ? waiting : rows_left).insert(r);
  for (int k = 0; k < rank; ++k) {
    if (!waiting.empty() && k == late.early_rank) rows_left = std::move(waiting), waiting.clear();
    int row = *rows_left.begin(), column = *columns_left.begin();
    for (int r : rows_left)
      for (int c : columns_left)
        if (std::abs(m(r, c)) > std::abs(m(row, column)) * (1 + kTie)) row = r, column = c;  // ties go to the first
    rows_left.erase(row);
    columns_left.erase(column);
    chosen.rows.push_back(row);
    chosen.columns.push_back(column);
    for (const std::set<int>* some : {&rows_left, &waiting})
      for (int r : *some) {
        const double factor = m(r, column) / m(row, column);
        for (int c : columns_left) m(r, c) -= factor * m(row, c);
      }
  }
  std::sort(chosen.rows.begin(), chosen.rows.end());
  std::sort(chosen.columns.begin(), chosen.columns.end());
  return chosen;
}

/// Smallest singular value of a square matrix from the eigenvalues of M'M: to half the digits, which is enough to
/// compare candidates, and several times faster than by rotations.
double weakest_singular_value(const MatrixXd& m) {
  return std::sqrt(std::max(0.0, symmetric_eigenvalues(m.transpose() * m)[0]));
}

/// How well a candidate holds over the samples, from its conditions: near its worst, and never bad at the reference.
double score_of(std::vector<double> conditions) {
  const double reference = std::min(1.0, kReferenceWeight * conditions[0]);
  std::sort(conditions.begin(), conditions.end());
  return reference * conditions[static_cast<std::size_t>(kWorstQuantile * static_cast<double>(conditions.size()))];
}

/// Sets of columns that full pivoting takes, with the columns as they are and weighted at random.
std::set<Candidate> candidates(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& columns,
                               const LateRows& late) {
  std::set<Candidate> found;
  std::mt19937_64 random(kSeed);
  for (const MatrixXd& jacobian : jacobians) {
    for (int w = 0; w <= kWeightings; ++w) {
      MatrixXd weighted = jacobian;
      for (Eigen::Index c = 0; w > 0 && c < weighted.cols(); ++c)
        weighted.col(c) *= kLeastWeight + (1 - kLeastWeight) * static_cast<double>(random() >> 11) * 0x1p-53;
      found.insert(pivoted(std::move(weighted), rank, columns, late));
    }
    if (found.size() > kMostCandidates) break;
  }
  return found;
}

/// The candidates of one block, each judged once.
class Search {
 public:
  /// jacobians: of full rank. best: smallest singular value of all columns, per sample. columns: candidates for
  /// dependence. like, late: see choose_partition.
  Search(const std::vector<MatrixXd>& jacobians, const std::vector<double>& best, const std::vector<int>& columns,
         int rank, std::span<const PartitionCandidate> like, const LateRows& late)
      : jacobians_(jacobians), best_(best), columns_(columns), rank_(rank), like_(like), late_(late) {}

  /// The cheapest by its estimate of the well conditioned ones.
  Candidate best_estimate() {
    for (const Candidate& candidate : candidates(jacobians_, rank_, columns_, late_))
      top_ = std::max(top_, judged(candidate).score);
    Candidate chosen;
    std::vector<Candidate> good;
    for (const auto& [candidate, judgement] : judged_)
      if (judgement.score >= kScoreShare * top_) good.push_back(candidate);
    for (const Candidate& candidate : good)
      if (chosen.columns.empty() || cost(candidate) < cost(chosen)) chosen = candidate;
    return improved(std::move(chosen));
  }

  /// The chosen one, then up to kShortList others over the same equations that hold as its pivots do, cheapest
  /// estimate first.
  std::vector<PartitionCandidate> short_list(const Candidate& chosen) {
    std::set<std::vector<int>> others;
    for (const auto& [candidate, judgement] : judged_)
      if (candidate.columns != chosen.columns && judgement.score >= kListShare * top_) others.insert(candidate.columns);
    const double bound = std::min(kPivotRatio, order(chosen).worst_ratio);
    std::vector<PartitionCandidate> list;
    for (const std::vector<int>& columns : others) {
      const Candidate candidate{chosen.rows, columns};
      if (judged(candidate).score >= kListShare * top_ && order(candidate).worst_ratio >= bound)
        list.push_back(described(candidate));
    }
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.estimate < b.estimate; });
    if (list.size() > kShortList) list.resize(kShortList);
    list.insert(list.begin(), described(chosen));
    return list;
  }

 private:
  struct Judgement {
    std::vector<double> conditions;
    double score = 0;
    std::optional<Ordering> ordering;
  };

  /// Its condition: smallest singular value of the dependent Jacobian over that value for all columns, per sample.
  Judgement& judged(const Candidate& candidate) {
    const auto [at, is_new] = judged_.try_emplace(candidate);
    Judgement& judgement = at->second;
    if (!is_new) return judgement;
    for (std::size_t s = 0; s < jacobians_.size(); ++s)
      judgement.conditions.push_back(weakest_singular_value(part_of(jacobians_[s], candidate.rows, candidate.columns)) /
                                     best_[s]);
    judgement.score = score_of(judgement.conditions);
    return judgement;
  }

  const Ordering& order(const Candidate& candidate) {
    Judgement& judgement = judged(candidate);
    if (judgement.ordering) return *judgement.ordering;
    std::vector<bool> good;
    for (const double condition : judgement.conditions) good.push_back(condition >= kPivotRatio);
    if (std::find(good.begin(), good.end(), true) == good.end()) good.assign(good.size(), true);
    judgement.ordering = order_pivots(jacobians_, good, candidate);
    const auto twin = std::ranges::find(like_, candidate.columns, &PartitionCandidate::dependent);
    if (twin != like_.end()) {
      Ordering same = order_like(twin->pivots, jacobians_, good, candidate);
      const double bound = std::min(kPivotRatio, judgement.ordering->worst_ratio);
      if (!same.pivots.empty() && same.worst_ratio >= bound) judgement.ordering = std::move(same);
    }
    judgement.ordering->cost += projection_cost(candidate, good);
    return *judgement.ordering;
  }
  double cost(const Candidate& candidate) { return order(candidate).cost; }

  /// Operations of the projection beyond the elimination: work of the bodies that each free direction moves, and
  /// products of every two directions that move the same one.
  double projection_cost(const Candidate& candidate, const std::vector<bool>& used) const {
    std::vector<int> free;
    for (int c : columns_)
      if (!std::binary_search(candidate.columns.begin(), candidate.columns.end(), c)) free.push_back(c);
    if (free.empty()) return 0;
    MatrixXd pattern = MatrixXd::Zero(candidate.columns.size(), free.size());
    for (std::size_t s = 0, looked_at = 0; s < jacobians_.size() && looked_at < kPatternSamples; ++s) {
      if (!used[s]) continue;
      ++looked_at;
      const MatrixXd dependent = part_of(jacobians_[s], candidate.rows, candidate.columns);
      pattern = pattern.cwiseMax(solved(dependent, part_of(jacobians_[s], candidate.rows, free)).cwiseAbs());
    }
    double cost = 0;
    for (Eigen::Index c = 0; c < pattern.rows(); ++c) {
      const auto directions = static_cast<double>((pattern.row(c).array() > kStillShare).count());
      cost += kDirectionCost * directions + kPairCost * directions * (directions + 1) / 2;
    }
    return cost;
  }

  /// Exchanges a dependent column for a free one as long as that is cheaper and the condition holds.
  Candidate improved(Candidate chosen) {
    const std::vector<bool> all(jacobians_.size(), true);
    for (bool found = true; found;) {
      found = false;
      const std::vector<int> dependent = chosen.columns;
      for (int free : columns_) {
        if (std::binary_search(dependent.begin(), dependent.end(), free)) continue;
        for (int leaving : dependent) {
          std::vector<int> columns = dependent;
          *std::find(columns.begin(), columns.end(), leaving) = free;
          const Candidate candidate = pivoted(jacobians_[0], rank_, columns, late_);
          if (projection_cost(candidate, all) >= cost(chosen)) continue;
          if (judged(candidate).score < kScoreShare * top_ || cost(candidate) >= cost(chosen)) continue;
          chosen = candidate;
          found = true;
        }
      }
    }
    return chosen;
  }

  PartitionCandidate described(const Candidate& candidate) {
    PartitionCandidate result;
    const Ordering& ordering = order(candidate);
    result.dependent = candidate.columns;
    for (int c : columns_)
      if (!std::binary_search(candidate.columns.begin(), candidate.columns.end(), c)) result.independent.push_back(c);
    result.pivots = ordering.pivots;
    result.triangular_sizes = ordering.triangular_sizes;
    result.worst_pivot_ratio = ordering.worst_ratio;
    result.score = judged(candidate).score / top_;
    result.estimate = ordering.cost;
    return result;
  }

  const std::vector<MatrixXd>& jacobians_;
  const std::vector<double>& best_;
  const std::vector<int>& columns_;
  int rank_;
  std::span<const PartitionCandidate> like_;
  const LateRows& late_;
  double top_ = 0;  ///< best score of the random candidates
  std::map<Candidate, Judgement> judged_;
};

std::vector<int> undriven_columns(const MatrixXd& jacobian, const std::vector<int>& driven) {
  std::vector<int> columns;
  for (int c = 0; c < jacobian.cols(); ++c)
    if (!contains(driven, c)) columns.push_back(c);
  return columns;
}

/// Whether the early rows have their rank with some margin, too: else their pivots are rounding.
bool has_early_rank(const MatrixXd& movable, const LateRows& late) {
  if (late.equations.empty() || late.early_rank == 0) return true;
  MatrixXd early = movable;
  for (const int e : late.equations) early.row(e).setZero();
  const Eigen::VectorXd s = singular_values(early);
  return s[late.early_rank - 1] > kFullRankShare * s[0];
}

/// A scale to kTypicalDigits decimals: exact quotients of integers, the same double that its text is read as.
double rounded_scale(double value) {
  if (!(value > 0)) return value;
  const int exponent = static_cast<int>(std::floor(std::log10(value))) - (kTypicalDigits - 1);
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? std::nearbyint(value * power) / power : std::nearbyint(value / power) * power;
}

}  // namespace

double typical_pivot(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                     const LateRows& late) {
  std::vector<double> smallest;
  for (const MatrixXd& jacobian : jacobians) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> factors = jacobian;
    std::vector<int> rows(jacobian.rows()), columns(jacobian.cols());
    std::vector<unsigned char> is_driven(jacobian.cols(), 0), is_late(jacobian.rows(), 0);
    for (const int c : driven) is_driven[c] = 1;
    for (const int e : late.equations) is_late[e] = 1;
    LoopFactors loop;
    loop.equations = static_cast<int>(jacobian.rows());
    loop.coordinates = static_cast<int>(jacobian.cols());
    loop.matrix = factors.data();
    loop.rows = rows.data();
    loop.columns = columns.data();
    const LatePivots order{late.equations.empty() ? nullptr : is_late.data(), late.early_rank};
    factorise(loop, rank, is_driven.data(), kLeastSingularValue, order);
    smallest.push_back(loop.rank == rank ? smallest_pivot(loop) : 0);
  }
  std::sort(smallest.begin(), smallest.end());
  return rounded_scale(smallest[smallest.size() / 2]);
}

int generic_rank(const std::vector<MatrixXd>& jacobians, const std::vector<int>& columns) {
  int rank = 0;
  for (const MatrixXd& j : jacobians) rank = std::max(rank, rank_of(columns.empty() ? j : columns_of(j, columns)));
  return rank;
}

void take(BlockAnalysis& block, const PartitionCandidate& candidate) {
  static_cast<LoopPartition&>(block) = candidate;
  block.triangular_sizes = candidate.triangular_sizes;
  block.worst_pivot_ratio = candidate.worst_pivot_ratio;
}

LateRows late_rows(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                   const std::vector<int>& velocity_rows) {
  if (velocity_rows.empty()) return {};
  const std::vector<int> columns = undriven_columns(jacobians[0], driven);
  std::vector<int> rows;
  for (int r = 0; r < jacobians[0].rows(); ++r)
    if (!contains(velocity_rows, r)) rows.push_back(r);
  LateRows late{velocity_rows, 0};
  for (const MatrixXd& j : jacobians) late.early_rank = std::max(late.early_rank, rank_of(part_of(j, rows, columns)));
  const bool are_independent = late.early_rank + static_cast<int>(velocity_rows.size()) == rank;
  return are_independent ? LateRows{} : late;
}

BlockAnalysis choose_partition(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& driven,
                               std::span<const PartitionCandidate> like, const LateRows& late) {
  BlockAnalysis result;
  result.rank = rank;
  result.late = late;
  result.driven = driven;
  const int equations = static_cast<int>(jacobians[0].rows());
  const std::vector<int> columns = undriven_columns(jacobians[0], driven);
  result.independent = columns;
  if (rank > 0) {
    std::vector<double> best;
    std::vector<MatrixXd> usable;
    for (const MatrixXd& j : jacobians) {
      const MatrixXd movable = columns_of(j, columns);
      const Eigen::VectorXd s = movable.cols() == 0 ? Eigen::VectorXd() : singular_values(movable);
      const bool is_full = s.size() >= rank && s[rank - 1] > kFullRankShare * s[0];
      if (is_full && has_early_rank(movable, late)) usable.push_back(j), best.push_back(s[rank - 1]);
    }
    if (usable.empty()) usable = {jacobians[0]}, best = {1.0};
    result.typical_pivot = typical_pivot(usable, rank, driven, late);
    Search search(usable, best, columns, rank, like, late);
    result.candidates = search.short_list(search.best_estimate());
    for (PartitionCandidate& candidate : result.candidates) candidate.driven = driven;
    take(result, result.candidates[0]);
  }
  for (int e = 0; e < equations; ++e)
    if (std::none_of(result.pivots.begin(), result.pivots.end(), [e](const Pivot& p) { return p.equation == e; }))
      result.redundant_equations.push_back(e);
  return result;
}

}  // namespace mbgen
