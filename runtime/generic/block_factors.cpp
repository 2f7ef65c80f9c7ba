#include "runtime/generic/block_factors.hpp"

#include <algorithm>

namespace mbgen {

SparseRows sparse_rows(const std::vector<std::vector<double>>& matrix) {
  SparseRows rows(matrix.size());
  for (std::size_t r = 0; r < matrix.size(); ++r)
    for (std::size_t c = 0; c < matrix[r].size(); ++c)
      if (matrix[r][c] != 0) rows[r].push_back(static_cast<int>(c), matrix[r][c]);
  return rows;
}

namespace {

Eigen::MatrixXd dense_matrix(const SparseRows& rows, int columns) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t e = 0; e < rows[r].columns.size(); ++e)
      a(static_cast<Eigen::Index>(r), rows[r].columns[e]) = rows[r].values[e];
  return a;
}

/// R11^-1 R12 of an upper triangle.
template <class Upper>
Eigen::MatrixXd upper_dependence(const Upper& upper, int rank) {
  Eigen::MatrixXd result = upper.topRows(rank).rightCols(upper.cols() - rank);
  if (result.size() > 0) upper.topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solveInPlace(result);
  return result;
}

/// Sets factors of a matrix. Result: their rank.
template <class Factors>
int computed(Factors& factors, const SparseRows& rows, int columns, int rank_limit) {
  if (rows.empty() || columns == 0) return 0;
  factors.setThreshold(kRankTolerance<double>);
  factors.compute(dense_matrix(rows, columns));
  return std::min(rank_limit, static_cast<int>(factors.rank()));
}

}  // namespace

void PivotedLu::compute(const SparseRows& rows, int columns, int rank_limit) {
  rank_ = computed(factors_, rows, columns, rank_limit);
}

Eigen::MatrixXd PivotedLu::dependence() const { return upper_dependence(factors_.matrixLU(), rank_); }

Eigen::VectorXd PivotedLu::solve(const Eigen::VectorXd& b) const {
  const auto lu = factors_.matrixLU().topLeftCorner(rank_, rank_);
  Eigen::VectorXd x = (factors_.permutationP() * b).head(rank_);
  lu.triangularView<Eigen::UnitLower>().solveInPlace(x);
  lu.triangularView<Eigen::Upper>().solveInPlace(x);
  return x;
}

Eigen::VectorXd PivotedLu::solve_transposed(const Eigen::VectorXd& f) const {
  const auto lu = factors_.matrixLU().topLeftCorner(rank_, rank_);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(factors_.rows());
  y.head(rank_) = f;
  auto pivots = y.head(rank_);
  lu.triangularView<Eigen::Upper>().transpose().solveInPlace(pivots);
  lu.triangularView<Eigen::UnitLower>().transpose().solveInPlace(pivots);
  return factors_.permutationP().inverse() * y;
}

void PivotedQr::compute(const SparseRows& rows, int columns, int rank_limit) {
  rank_ = computed(factors_, rows, columns, rank_limit);
}

Eigen::MatrixXd PivotedQr::dependence() const { return upper_dependence(factors_.matrixQR(), rank_); }

Eigen::VectorXd PivotedQr::solve(const Eigen::VectorXd& b) const {
  Eigen::VectorXd x = b;
  x.applyOnTheLeft(factors_.householderQ().setLength(rank_).adjoint());
  x.conservativeResize(rank_);
  factors_.matrixQR().topLeftCorner(rank_, rank_).triangularView<Eigen::Upper>().solveInPlace(x);
  return x;
}

Eigen::VectorXd PivotedQr::solve_transposed(const Eigen::VectorXd& f) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(factors_.rows());
  y.head(rank_) = f;
  auto pivots = y.head(rank_);
  factors_.matrixQR().topLeftCorner(rank_, rank_).triangularView<Eigen::Upper>().transpose().solveInPlace(pivots);
  y.applyOnTheLeft(factors_.householderQ().setLength(rank_));
  return y;
}

template <class Pivoted>
BlockFactorsOf<Pivoted>::BlockFactorsOf(int columns, const std::vector<int>& driven, int rank_limit)
    : columns_(columns), rank_limit_(rank_limit), place_(static_cast<std::size_t>(columns), 0) {
  for (const int c : driven) place_[c] = -1;
  for (int c = 0; c < columns; ++c) {
    if (place_[c] < 0) continue;
    place_[c] = static_cast<int>(column_.size());
    column_.push_back(c);
  }
}

template <class Pivoted>
void BlockFactorsOf<Pivoted>::factorise(const SparseRows& jacobian) {
  jacobian_ = jacobian;
  const int movable = static_cast<int>(column_.size());
  if (movable < columns_) {
    candidates_.assign(jacobian.size(), {});
    for (std::size_t r = 0; r < jacobian.size(); ++r)
      for (std::size_t e = 0; e < jacobian[r].columns.size(); ++e)
        if (const int place = place_[jacobian[r].columns[e]]; place >= 0)
          candidates_[r].push_back(place, jacobian[r].values[e]);
  }
  pivoted_.compute(movable < columns_ ? candidates_ : jacobian_, movable, rank_limit_);
  dependent_.clear();
  free_.clear();
  for (int k = 0; k < movable; ++k)
    (k < rank() ? dependent_ : free_).push_back(column_[rank() > 0 ? pivoted_.column(k) : k]);
}

template <class Pivoted>
std::vector<std::vector<double>> BlockFactorsOf<Pivoted>::rz() const {
  std::vector<std::vector<double>> result(columns_, std::vector<double>(free_.size(), 0.0));
  for (std::size_t q = 0; q < free_.size(); ++q) result[free_[q]][q] = 1;
  if (rank() > 0) each_dependence([&](int d, int q, double value) { result[dependent_[d]][q] = value; });
  return result;
}

template <class Pivoted>
void BlockFactorsOf<Pivoted>::solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const {
  if (rank() == 0) return;
  for (int c : dependent_) x[c] = 0;
  Eigen::VectorXd b(static_cast<Eigen::Index>(jacobian_.size()));
  for (std::size_t r = 0; r < jacobian_.size(); ++r) {
    double known = 0;
    for (std::size_t e = 0; e < jacobian_[r].columns.size(); ++e)
      known += jacobian_[r].values[e] * x[jacobian_[r].columns[e]];
    b[static_cast<Eigen::Index>(r)] = right_hand_side[r] - known;
  }
  const Eigen::VectorXd dependent = pivoted_.solve(b);
  for (int d = 0; d < rank(); ++d) x[dependent_[d]] = dependent[d];
}

template <class Pivoted>
std::vector<double> BlockFactorsOf<Pivoted>::multipliers(const std::vector<double>& right_hand_side) const {
  if (rank() == 0) return std::vector<double>(jacobian_.size(), 0.0);
  Eigen::VectorXd f(rank());
  for (int d = 0; d < rank(); ++d) f[d] = right_hand_side[dependent_[d]];
  const Eigen::VectorXd y = pivoted_.solve_transposed(f);
  return {y.data(), y.data() + y.size()};
}

PivotedBlock::PivotedBlock(const BlockAnalysis& analysis, const SparseRows& jacobian, int columns, int rank_limit)
    : matrix_(written_out(jacobian, columns)), rows_(jacobian.size()), columns_(static_cast<std::size_t>(columns)) {
  std::vector<unsigned char> driven(columns_.size(), 0), late(rows_.size(), 0);
  for (const int c : analysis.driven) driven[c] = 1;
  for (const int e : analysis.late.equations) late[e] = 1;
  factors_.equations = static_cast<int>(rows_.size());
  factors_.coordinates = static_cast<int>(columns_.size());
  factors_.matrix = matrix_.data();
  factors_.rows = rows_.data();
  factors_.columns = columns_.data();
  const LatePivots order{analysis.late.equations.empty() ? nullptr : late.data(), analysis.late.early_rank};
  mbgen::factorise(factors_, rank_limit, driven.data(), kRankTolerance<double>, order);
}

void drop_repeating_rows(const BlockAnalysis& analysis, SparseRows& jacobian, int columns) {
  if (analysis.late.equations.empty()) return;
  const PivotedBlock block(analysis, jacobian, columns, analysis.rank);
  std::vector<bool> is_kept(jacobian.size(), false);
  for (int k = 0; k < block.factors().rank; ++k) is_kept[block.factors().rows[k]] = true;
  for (const int e : analysis.late.equations)
    if (!is_kept[e]) jacobian[e] = {};
}

std::vector<double> written_out(const SparseRows& rows, int columns) {
  std::vector<double> matrix(rows.size() * static_cast<std::size_t>(columns), 0.0);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t e = 0; e < rows[r].columns.size(); ++e)
      matrix[r * static_cast<std::size_t>(columns) + static_cast<std::size_t>(rows[r].columns[e])] = rows[r].values[e];
  return matrix;
}

template class BlockFactorsOf<SparseLu>;
template class BlockFactorsOf<PivotedLu>;
template class BlockFactorsOf<PivotedQr>;

}  // namespace mbgen
