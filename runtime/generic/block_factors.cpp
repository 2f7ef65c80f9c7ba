#include "runtime/generic/block_factors.hpp"

#include <algorithm>

namespace mbgen {

void PivotedLu::compute(const Eigen::MatrixXd& a) {
  factors_.setThreshold(kRankTolerance<double>);
  factors_.compute(a);
}

std::vector<int> PivotedLu::rows() const {
  std::vector<int> result(factors_.rows());
  for (Eigen::Index r = 0; r < factors_.rows(); ++r) result[factors_.permutationP().indices()[r]] = static_cast<int>(r);
  return result;
}

Eigen::MatrixXd PivotedLu::dependence(int rank) const {
  Eigen::MatrixXd result = factors_.matrixLU().topRows(rank).rightCols(factors_.cols() - rank);
  if (result.size() > 0)
    factors_.matrixLU().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(result);
  return result;
}

Eigen::VectorXd PivotedLu::solve(int rank, const Eigen::VectorXd& b) const {
  const auto lu = factors_.matrixLU().topLeftCorner(rank, rank);
  Eigen::VectorXd x = (factors_.permutationP() * b).head(rank);
  lu.triangularView<Eigen::UnitLower>().solveInPlace(x);
  lu.triangularView<Eigen::Upper>().solveInPlace(x);
  return x;
}

Eigen::VectorXd PivotedLu::solve_transposed(int rank, const Eigen::VectorXd& f) const {
  const auto lu = factors_.matrixLU().topLeftCorner(rank, rank);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(factors_.rows());
  y.head(rank) = f;
  auto pivots = y.head(rank);
  lu.triangularView<Eigen::Upper>().transpose().solveInPlace(pivots);
  lu.triangularView<Eigen::UnitLower>().transpose().solveInPlace(pivots);
  return factors_.permutationP().inverse() * y;
}

void PivotedQr::compute(const Eigen::MatrixXd& a) {
  factors_.setThreshold(kRankTolerance<double>);
  factors_.compute(a);
}

Eigen::MatrixXd PivotedQr::dependence(int rank) const {
  Eigen::MatrixXd result = factors_.matrixQR().topRows(rank).rightCols(factors_.cols() - rank);
  if (result.size() > 0)
    factors_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(result);
  return result;
}

Eigen::VectorXd PivotedQr::solve(int rank, const Eigen::VectorXd& b) const {
  Eigen::VectorXd x = b;
  x.applyOnTheLeft(factors_.householderQ().setLength(rank).adjoint());
  x.conservativeResize(rank);
  factors_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(x);
  return x;
}

Eigen::VectorXd PivotedQr::solve_transposed(int rank, const Eigen::VectorXd& f) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(factors_.rows());
  y.head(rank) = f;
  auto pivots = y.head(rank);
  factors_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().transpose().solveInPlace(pivots);
  y.applyOnTheLeft(factors_.householderQ().setLength(rank));
  return y;
}

template <class Pivoted>
BlockFactorsOf<Pivoted>::BlockFactorsOf(int columns, const std::vector<int>& driven, int rank_limit)
    : rank_limit_(rank_limit) {
  for (int c = 0; c < columns; ++c)
    if (std::find(driven.begin(), driven.end(), c) == driven.end()) movable_.push_back(c);
}

template <class Pivoted>
BlockFactorsOf<Pivoted>::BlockFactorsOf(const std::vector<std::vector<double>>& jacobian,
                                        const std::vector<int>& driven, int rank_limit)
    : BlockFactorsOf(jacobian.empty() ? 0 : static_cast<int>(jacobian[0].size()), driven, rank_limit) {
  factorise(jacobian);
}

template <class Pivoted>
void BlockFactorsOf<Pivoted>::factorise(const std::vector<std::vector<double>>& jacobian) {
  const auto equations = static_cast<Eigen::Index>(jacobian.size());
  const auto columns = static_cast<Eigen::Index>(jacobian.empty() ? 0 : jacobian[0].size());
  const auto movable = static_cast<Eigen::Index>(movable_.size());
  jacobian_.resize(equations, columns);
  for (Eigen::Index e = 0; e < equations; ++e)
    for (Eigen::Index c = 0; c < columns; ++c) jacobian_(e, c) = jacobian[e][c];
  candidates_.resize(equations, movable);
  for (Eigen::Index c = 0; c < movable; ++c) candidates_.col(c) = jacobian_.col(movable_[c]);
  rank_ = 0;
  if (candidates_.size() > 0) {
    pivoted_.compute(candidates_);
    rank_ = std::min(rank_limit_, pivoted_.rank());
  }
  dependent_.clear();
  free_.clear();
  for (int k = 0; k < movable; ++k)
    (k < rank_ ? dependent_ : free_).push_back(movable_[candidates_.size() > 0 ? pivoted_.column(k) : k]);
}

template <class Pivoted>
std::vector<std::vector<double>> BlockFactorsOf<Pivoted>::rz() const {
  std::vector<std::vector<double>> result(jacobian_.cols(), std::vector<double>(free_.size(), 0.0));
  for (std::size_t q = 0; q < free_.size(); ++q) result[free_[q]][q] = 1;
  const Eigen::MatrixXd follow = dependence();
  for (int d = 0; d < rank_; ++d)
    for (std::size_t q = 0; q < free_.size(); ++q) result[dependent_[d]][q] = -follow(d, static_cast<Eigen::Index>(q));
  return result;
}

template <class Pivoted>
void BlockFactorsOf<Pivoted>::solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const {
  if (rank_ == 0) return;
  for (int c : dependent_) x[c] = 0;
  Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(right_hand_side.data(), jacobian_.rows());
  b.noalias() -= jacobian_ * Eigen::Map<const Eigen::VectorXd>(x.data(), jacobian_.cols());
  const Eigen::VectorXd dependent = pivoted_.solve(rank_, b);
  for (int d = 0; d < rank_; ++d) x[dependent_[d]] = dependent[d];
}

template <class Pivoted>
std::vector<double> BlockFactorsOf<Pivoted>::multipliers(const std::vector<double>& right_hand_side) const {
  std::vector<double> lambda(jacobian_.rows(), 0.0);
  if (rank_ == 0) return lambda;
  Eigen::VectorXd f(rank_);
  for (int d = 0; d < rank_; ++d) f[d] = right_hand_side[dependent_[d]];
  const Eigen::VectorXd y = pivoted_.solve_transposed(rank_, f);
  return {y.data(), y.data() + y.size()};
}

PivotedBlock::PivotedBlock(const BlockAnalysis& analysis, const std::vector<std::vector<double>>& jacobian,
                           int rank_limit)
    : rows_(jacobian.size()), columns_(jacobian.empty() ? 0 : jacobian[0].size()) {
  for (const std::vector<double>& row : jacobian) matrix_.insert(matrix_.end(), row.begin(), row.end());
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

void drop_repeating_rows(const BlockAnalysis& analysis, std::vector<std::vector<double>>& jacobian) {
  if (analysis.late.equations.empty()) return;
  const PivotedBlock block(analysis, jacobian, analysis.rank);
  std::vector<bool> is_kept(jacobian.size(), false);
  for (int k = 0; k < block.factors().rank; ++k) is_kept[block.factors().rows[k]] = true;
  for (const int e : analysis.late.equations)
    if (!is_kept[e]) std::fill(jacobian[e].begin(), jacobian[e].end(), 0.0);
}

template class BlockFactorsOf<PivotedLu>;
template class BlockFactorsOf<PivotedQr>;

}  // namespace mbgen
