#include "compiler/analysis/partition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/part.hpp"
#include "compiler/analysis/sparse_elimination.hpp"
#include "mbgen/loop.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;

constexpr double kZero = 1e-12;        // entries below this share of the largest are structurally zero
constexpr double kDirectionCost = 20;  // operations on a body per free direction that moves it, about a third of a body
constexpr double kPairCost = 5;        // and per pair of directions
constexpr double kScoreShare = 0.4;    // of the best score: below it a partition is not taken for being cheap
constexpr int kWeightings = 8;         // random column weights tried per sample

MatrixXd columns_of(const MatrixXd& m, const std::vector<int>& columns) {
  MatrixXd result(m.rows(), columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) result.col(c) = m.col(columns[c]);
  return result;
}

MatrixXd part_of(const MatrixXd& m, const std::vector<int>& rows, const std::vector<int>& columns) {
  MatrixXd result(rows.size(), columns.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) result(r, c) = m(rows[r], columns[c]);
  return result;
}

int rank_of(const MatrixXd& m) {
  if (m.size() == 0) return 0;
  return static_cast<int>((singular_values(m).array() > kLeastSingularValue).count());
}

struct Candidate {
  std::vector<int> rows, columns;  // ascending
  bool operator<(const Candidate& other) const { return std::tie(columns, rows) < std::tie(other.columns, other.rows); }
};

/// Rows and columns that full pivoting takes first.
Candidate pivoted(MatrixXd m, int rank, const std::vector<int>& columns) {
  Candidate chosen;
  std::set<int> rows_left, columns_left(columns.begin(), columns.end());
  for (int r = 0; r < m.rows(); ++r) rows_left.insert(r);
  for (int k = 0; k < rank; ++k) {
    int row = *rows_left.begin(), column = *columns_left.begin();
    for (int r : rows_left)
      for (int c : columns_left)
        if (std::abs(m(r, c)) > std::abs(m(row, column)) * (1 + 1e-9)) row = r, column = c;  // ties go to the first
    rows_left.erase(row);
    columns_left.erase(column);
    chosen.rows.push_back(row);
    chosen.columns.push_back(column);
    for (int r : rows_left) {
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

/// Weakest singular value of the dependent Jacobian over that of all columns, per sample.
std::vector<double> conditions(const std::vector<MatrixXd>& jacobians, const std::vector<double>& best,
                               const Candidate& candidate) {
  std::vector<double> ratios;
  for (std::size_t s = 0; s < jacobians.size(); ++s)
    ratios.push_back(weakest_singular_value(part_of(jacobians[s], candidate.rows, candidate.columns)) / best[s]);
  return ratios;
}

/// How well a candidate holds over the samples: near its worst, and never bad at the reference.
double score(std::vector<double> ratios) {
  const double reference = std::min(1.0, 5 * ratios[0]);
  std::sort(ratios.begin(), ratios.end());
  return reference * ratios[ratios.size() / 5];
}

struct Ordering {
  std::vector<Pivot> pivots;
  std::vector<int> triangular_sizes;
  double worst_ratio = 1;
  double cost = 0;
};

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

/// Markowitz: the sparsest entry among those that are large enough everywhere.
std::pair<int, int> choose_pivot(const Elimination& e, const std::vector<int>& rows, const std::vector<int>& columns,
                                 double& ratio) {
  const auto filled = [&](int r, int c) { return e.largest(r, c) > kZero; };
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
      if (best.first < 0 || cost < best_cost || (cost == best_cost && here > best_ratio * (1 + 1e-9)))
        best = {r, c}, best_cost = cost, best_ratio = here;
    }
  ratio = best.first >= 0 ? best_ratio : largest_ratio;
  return best.first >= 0 ? best : largest;
}

double median_pivot(const Elimination& e, int row, int column) {
  std::vector<double> values;
  for (const MatrixXd& m : e.matrices) values.push_back(std::abs(m(row, column)) * e.row_scale[row]);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Eliminates one diagonal block of the triangular form and appends its pivots.
void order_block(Elimination& e, const Candidate& candidate, const std::vector<std::pair<int, int>>& block,
                 Ordering& ordering) {
  std::vector<int> rows, columns;
  for (const auto& [r, c] : block) rows.push_back(r), columns.push_back(c);
  while (!rows.empty()) {
    double ratio = 0;
    const auto [row, column] = choose_pivot(e, rows, columns, ratio);
    ordering.worst_ratio = std::min(ordering.worst_ratio, ratio);
    ordering.pivots.push_back({candidate.rows[row], candidate.columns[column], median_pivot(e, row, column)});
    rows.erase(std::find(rows.begin(), rows.end(), row));
    columns.erase(std::find(columns.begin(), columns.end(), column));
    for (int r : rows) {
      if (e.largest(r, column) <= kZero) continue;
      for (MatrixXd& m : e.matrices) {
        const double factor = m(r, column) / m(row, column);
        for (int c : columns) m(r, c) -= factor * m(row, c);
      }
      for (int c : columns)
        if (e.largest(row, c) > kZero) {
          e.largest(r, c) = std::max(e.largest(r, c), e.largest(row, c));
          ordering.cost += 2;
        }
      ordering.cost += 2;
    }
  }
}

Ordering order_pivots(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& used,
                      const Candidate& candidate) {
  Ordering ordering;
  Elimination e = equilibrated(jacobians, used, candidate);
  const std::size_t n = candidate.rows.size();
  std::vector<std::vector<bool>> pattern(n, std::vector<bool>(n));
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c) pattern[r][c] = e.largest(r, c) > kZero;
  for (const auto& block : block_triangular_form(pattern)) {
    ordering.triangular_sizes.push_back(static_cast<int>(block.size()));
    order_block(e, candidate, block, ordering);
  }
  ordering.cost += 2 * static_cast<double>((e.largest.array() > kZero).count());
  return ordering;
}

/// What the projection of a candidate costs beyond its elimination: work of the bodies that each free direction moves,
/// and products of every two directions that move the same one.
double projection_cost(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& used,
                       const Candidate& candidate, const std::vector<int>& columns) {
  std::vector<int> free;
  for (int c : columns)
    if (!std::binary_search(candidate.columns.begin(), candidate.columns.end(), c)) free.push_back(c);
  if (free.empty()) return 0;
  MatrixXd pattern = MatrixXd::Zero(candidate.columns.size(), free.size());
  for (std::size_t s = 0, looked_at = 0; s < jacobians.size() && looked_at < 3; ++s) {
    if (!used[s]) continue;
    ++looked_at;
    const MatrixXd dependent = part_of(jacobians[s], candidate.rows, candidate.columns);
    pattern = pattern.cwiseMax(solved(dependent, part_of(jacobians[s], candidate.rows, free)).cwiseAbs());
  }
  double cost = 0;
  for (Eigen::Index c = 0; c < pattern.rows(); ++c) {
    const auto directions = static_cast<double>((pattern.row(c).array() > 1e-10).count());
    cost += kDirectionCost * directions + kPairCost * directions * (directions + 1) / 2;
  }
  return cost;
}

std::set<Candidate> candidates(const std::vector<MatrixXd>& jacobians, const std::vector<bool>& full, int rank,
                               const std::vector<int>& columns) {
  std::set<Candidate> found;
  std::mt19937_64 random(20120402);
  for (std::size_t s = 0; s < jacobians.size(); ++s) {
    if (!full[s]) continue;
    for (int w = 0; w <= kWeightings; ++w) {
      MatrixXd weighted = jacobians[s];
      for (Eigen::Index c = 0; w > 0 && c < weighted.cols(); ++c)
        weighted.col(c) *= 0.2 + 0.8 * static_cast<double>(random() >> 11) * 0x1p-53;
      found.insert(pivoted(std::move(weighted), rank, columns));
    }
    if (found.size() > 200) break;
  }
  return found;
}

/// What a partition is chosen from.
struct Search {
  const std::vector<MatrixXd>& jacobians;
  const std::vector<double>& best;  ///< weakest singular value of all columns, per sample
  const std::vector<bool>& full;
  const std::vector<int>& columns;  ///< those that may depend
  int rank = 0;
};

struct Choice {
  Candidate candidate;
  Ordering ordering;
  double least_score = 0;  ///< what a candidate must reach to be taken
};

/// Order and cost of a candidate. ratios: its conditions.
Ordering ordering_of(const Search& search, const Candidate& candidate, const std::vector<double>& ratios) {
  std::vector<bool> good;
  for (double ratio : ratios) good.push_back(ratio >= kPivotRatio);
  if (std::find(good.begin(), good.end(), true) == good.end()) good.assign(good.size(), true);
  Ordering ordering = order_pivots(search.jacobians, good, candidate);
  ordering.cost += projection_cost(search.jacobians, good, candidate, search.columns);
  return ordering;
}

/// The cheapest of the well conditioned ones that random column weights bring up.
Choice best_candidate(const Search& search) {
  struct Scored {
    Candidate candidate;
    std::vector<double> ratios;
    double score = 0;
  };
  std::vector<Scored> scored;
  double top = 0;
  for (const Candidate& candidate : candidates(search.jacobians, search.full, search.rank, search.columns)) {
    std::vector<double> ratios = conditions(search.jacobians, search.best, candidate);
    const double value = score(ratios);
    scored.push_back({candidate, std::move(ratios), value});
    top = std::max(top, value);
  }
  Choice chosen;
  for (const auto& [candidate, ratios, value] : scored) {
    if (value < kScoreShare * top) continue;
    Ordering ordering = ordering_of(search, candidate, ratios);
    if (chosen.candidate.columns.empty() || ordering.cost < chosen.ordering.cost)
      chosen = {candidate, std::move(ordering), kScoreShare * top};
  }
  return chosen;
}

/// Exchanges a dependent column for a free one as long as that is cheaper and the condition holds.
Choice improved(const Search& search, Choice chosen) {
  const std::vector<bool> all(search.jacobians.size(), true);
  for (bool found = true; found;) {
    found = false;
    const std::vector<int> dependent = chosen.candidate.columns;
    for (int free : search.columns) {
      if (std::binary_search(dependent.begin(), dependent.end(), free)) continue;
      for (int leaving : dependent) {
        std::vector<int> columns = dependent;
        *std::find(columns.begin(), columns.end(), leaving) = free;
        const Candidate candidate = pivoted(search.jacobians[0], search.rank, columns);
        if (projection_cost(search.jacobians, all, candidate, search.columns) >= chosen.ordering.cost) continue;
        const std::vector<double> ratios = conditions(search.jacobians, search.best, candidate);
        if (score(ratios) < chosen.least_score) continue;
        Ordering ordering = ordering_of(search, candidate, ratios);
        if (ordering.cost >= chosen.ordering.cost) continue;
        chosen = {candidate, std::move(ordering), chosen.least_score};
        found = true;
      }
    }
  }
  return chosen;
}

}  // namespace

double typical_pivot(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& driven) {
  std::vector<double> smallest;
  for (const MatrixXd& jacobian : jacobians) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> factors = jacobian;
    std::vector<int> rows(jacobian.rows()), columns(jacobian.cols());
    std::vector<unsigned char> is_driven(jacobian.cols(), 0);
    for (const int c : driven) is_driven[c] = 1;
    LoopFactors loop;
    loop.equations = static_cast<int>(jacobian.rows());
    loop.coordinates = static_cast<int>(jacobian.cols());
    loop.matrix = factors.data();
    loop.rows = rows.data();
    loop.columns = columns.data();
    factorise(loop, rank, is_driven.data(), kLeastSingularValue);
    smallest.push_back(loop.rank == rank ? smallest_pivot(loop) : 0);
  }
  std::sort(smallest.begin(), smallest.end());
  return std::stod(fmt::format("{:.2g}", smallest[smallest.size() / 2]));
}

int generic_rank(const std::vector<MatrixXd>& jacobians, const std::vector<int>& columns) {
  int rank = 0;
  for (const MatrixXd& j : jacobians) rank = std::max(rank, rank_of(columns.empty() ? j : columns_of(j, columns)));
  return rank;
}

BlockAnalysis choose_partition(const std::vector<MatrixXd>& jacobians, int rank, const std::vector<int>& driven) {
  BlockAnalysis result;
  result.rank = rank;
  result.driven = driven;
  const int coordinates = static_cast<int>(jacobians[0].cols()), equations = static_cast<int>(jacobians[0].rows());
  std::vector<int> columns;
  for (int c = 0; c < coordinates; ++c)
    if (std::find(driven.begin(), driven.end(), c) == driven.end()) columns.push_back(c);
  std::vector<bool> full;
  std::vector<double> best;
  std::vector<MatrixXd> usable;
  for (const MatrixXd& j : jacobians) {
    const MatrixXd movable = columns_of(j, columns);
    const Eigen::VectorXd s = movable.cols() == 0 ? Eigen::VectorXd() : singular_values(movable);
    const bool is_full = rank > 0 && s.size() >= rank && s[rank - 1] > 1e-4 * s[0];
    if (is_full) usable.push_back(j), best.push_back(s[rank - 1]), full.push_back(true);
  }
  if (usable.empty() && rank > 0) usable = {jacobians[0]}, best = {1.0}, full = {true};
  if (rank > 0) {
    result.typical_pivot = typical_pivot(usable, rank, driven);
    const Search search{usable, best, full, columns, rank};
    const Choice chosen = improved(search, best_candidate(search));
    result.dependent = chosen.candidate.columns;
    result.pivots = chosen.ordering.pivots;
    result.triangular_sizes = chosen.ordering.triangular_sizes;
    result.worst_pivot_ratio = chosen.ordering.worst_ratio;
  }
  for (int c : columns)
    if (std::find(result.dependent.begin(), result.dependent.end(), c) == result.dependent.end())
      result.independent.push_back(c);
  for (int e = 0; e < equations; ++e)
    if (std::none_of(result.pivots.begin(), result.pivots.end(), [e](const Pivot& p) { return p.equation == e; }))
      result.redundant_equations.push_back(e);
  return result;
}

}  // namespace mbgen
