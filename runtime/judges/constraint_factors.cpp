#include "runtime/judges/constraint_factors.hpp"

#include <algorithm>

namespace mbgen {
namespace {

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Entry {
  Index column = 0;
  double size = 0;
};

Entry largest_entry(const RowMajor& matrix, Index row) {
  Entry entry;
  if (matrix.cols() > 0) entry.size = matrix.row(row).cwiseAbs().maxCoeff(&entry.column);
  return entry;
}

}  // namespace

ConstraintFactors::ConstraintFactors(const Eigen::MatrixXd& jacobian, const PivotRule& rule) {
  eliminate(jacobian, rule);
  const Index n = jacobian.cols(), r = rank();
  std::vector<bool> is_dependent(static_cast<std::size_t>(n), false);
  dependent_.resize(r, r);
  for (Index k = 0; k < r; ++k) {
    is_dependent[static_cast<std::size_t>(pivot_columns_[k])] = true;
    dependent_.col(k) = reduced_.col(pivot_columns_[k]);
  }
  for (Index c = 0; c < n; ++c)
    if (!is_dependent[static_cast<std::size_t>(c)]) independent_columns_.push_back(static_cast<int>(c));
  null_basis_ = Eigen::MatrixXd::Zero(n, n - r);
  Eigen::MatrixXd dependent_part(r, n - r);
  for (Index i = 0; i < n - r; ++i) {
    null_basis_(independent_columns_[i], i) = 1;
    dependent_part.col(i) = -reduced_.col(independent_columns_[i]);
  }
  if (dependent_part.size() > 0) dependent_.triangularView<Eigen::Upper>().solveInPlace(dependent_part);
  for (Index k = 0; k < r; ++k) null_basis_.row(pivot_columns_[k]) = dependent_part.row(k);
}

/// Rows stay in place, with zeros at the pivot columns after them; unchanged rows cost nothing.
void ConstraintFactors::eliminate(const Eigen::MatrixXd& jacobian, const PivotRule& rule) {
  const Index m = jacobian.rows(), n = jacobian.cols();
  RowMajor rows = jacobian;
  std::vector<Entry> largest;
  for (Index i = 0; i < m; ++i) largest.push_back(largest_entry(rows, i));
  std::vector<bool> is_open(static_cast<std::size_t>(m), rule.equations.empty()), is_pivot(is_open.size(), false);
  for (int equation : rule.equations) is_open[equation] = true;
  std::vector<bool> waits(is_open.size(), false);
  for (int equation : rule.late) waits[equation] = true;
  lower_ = Eigen::MatrixXd::Zero(m, std::min(m, n));
  double first = 0;
  while (rank() < std::min(m, n)) {
    const Index k = rank();
    Index pivot = -1;
    for (Index i = 0; i < m; ++i)
      if (is_open[i] && !waits[i] && (pivot < 0 || largest[i].size > largest[pivot].size)) pivot = i;
    if (pivot >= 0 && k == 0) first = largest[pivot].size;
    if (pivot < 0 || !(largest[pivot].size > rule.smallest * first)) {
      if (std::find(waits.begin(), waits.end(), true) == waits.end()) break;
      for (Index i = 0; i < m; ++i) is_open[i] = is_open[i] && waits[i];
      waits.assign(waits.size(), false);
      continue;
    }
    const Index column = largest[pivot].column;
    is_open[pivot] = false;
    is_pivot[pivot] = true;
    pivot_rows_.push_back(static_cast<int>(pivot));
    pivot_columns_.push_back(static_cast<int>(column));
    for (Index i = 0; i < m; ++i) {
      if (is_pivot[i] || rows(i, column) == 0) continue;
      lower_(i, k) = rows(i, column) / rows(pivot, column);
      rows.row(i) -= lower_(i, k) * rows.row(pivot);
      rows(i, column) = 0;
      largest[i] = largest_entry(rows, i);
    }
  }
  lower_.conservativeResize(Eigen::NoChange, rank());
  reduced_.resize(rank(), n);
  for (Index k = 0; k < rank(); ++k) reduced_.row(k) = rows.row(pivot_rows_[k]);
}

ReducedBias ConstraintFactors::reduce(const Eigen::VectorXd& bias) const {
  ReducedBias result{Eigen::VectorXd(rank()), bias};
  for (Index k = 0; k < rank(); ++k) {
    result.kept[k] = result.dropped[pivot_rows_[k]];
    result.dropped -= result.kept[k] * lower_.col(k);
  }
  for (int row : pivot_rows_) result.dropped[row] = 0;
  return result;
}

Eigen::VectorXd ConstraintFactors::particular(const Eigen::VectorXd& bias) const {
  const Eigen::VectorXd dependent = dependent_.triangularView<Eigen::Upper>().solve(bias);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(reduced_.cols());
  for (Index k = 0; k < rank(); ++k) result[pivot_columns_[k]] = dependent[k];
  return result;
}

Eigen::VectorXd ConstraintFactors::reduced_multipliers(const Eigen::VectorXd& force) const {
  Eigen::VectorXd dependent(rank());
  for (Index k = 0; k < rank(); ++k) dependent[k] = force[pivot_columns_[k]];
  return dependent_.transpose().triangularView<Eigen::Lower>().solve(dependent);
}

Eigen::VectorXd ConstraintFactors::multipliers(const Eigen::VectorXd& reduced) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(lower_.rows());
  for (Index k = rank() - 1; k >= 0; --k) result[pivot_rows_[k]] = reduced[k] - lower_.col(k).dot(result);
  return result;
}

Eigen::VectorXd ConstraintFactors::dependency(int equation) const {
  Eigen::VectorXd result = -multipliers(lower_.row(equation).transpose());
  result[equation] = 1;
  return result;
}

}  // namespace mbgen
