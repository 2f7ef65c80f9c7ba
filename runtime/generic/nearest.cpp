#include "runtime/generic/nearest.hpp"

#include <Eigen/Sparse>
#include <algorithm>

#include "runtime/generic/sparse_lu.hpp"

namespace mbgen {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kProximity = 1e-4;  ///< weight of the last iterate beside the targets, whose largest is 1
constexpr int kMostIterates = 300;
constexpr double kStands = 1e-15;  ///< change of an iterate over its size that ends them

Sparse matrix_of(const std::vector<SparseRow<double>>& rows, int columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i < rows[r].columns.size(); ++i)
      entries.emplace_back(static_cast<int>(r), rows[r].columns[i], rows[r].values[i]);
  Sparse matrix(static_cast<Index>(rows.size()), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// rows scale rows' + damping, factorised.
class Square {
 public:
  Square(const std::vector<SparseRow<double>>& rows, const VectorXd& scale, double damping) {
    if (rows.empty()) return;
    const Sparse a = matrix_of(rows, static_cast<int>(scale.size()));
    Sparse square = a * scale.asDiagonal() * Sparse(a.transpose());
    for (Index i = 0; i < square.rows(); ++i) square.coeffRef(i, i) += damping;
    factors_.compute(square);
  }
  VectorXd solve(const VectorXd& b) const { return b.size() == 0 ? b : VectorXd(factors_.solve(b)); }

 private:
  Eigen::SimplicialLDLT<Sparse> factors_;
};

}  // namespace

SparseEquations::SparseEquations(const std::vector<SparseRow<double>>& rows, int columns,
                                 const std::vector<int>& movable)
    : given_(static_cast<Index>(rows.size())), columns_(static_cast<int>(movable.size())) {
  std::vector<int> place(static_cast<std::size_t>(columns), -1);
  for (std::size_t i = 0; i < movable.size(); ++i) place[static_cast<std::size_t>(movable[i])] = static_cast<int>(i);
  std::vector<SparseRow<double>> over_movable(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i < rows[r].columns.size(); ++i)
      if (const int c = place[static_cast<std::size_t>(rows[r].columns[i])]; c >= 0)
        over_movable[r].push_back(c, rows[r].values[i]);
  SparseLu factors;
  factors.compute(over_movable, columns_, std::min(columns_, static_cast<int>(rows.size())));
  kept_ = factors.rows();
  std::sort(kept_.begin(), kept_.end());
  for (const int row : kept_) rows_.push_back(over_movable[static_cast<std::size_t>(row)]);
}

VectorXd product(const std::vector<SparseRow<double>>& rows, const VectorXd& x) {
  VectorXd result = VectorXd::Zero(static_cast<Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i < rows[r].columns.size(); ++i)
      result[static_cast<Index>(r)] += rows[r].values[i] * x[rows[r].columns[i]];
  return result;
}

void SparseEquations::add_transposed(const VectorXd& y, VectorXd& x) const {
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t i = 0; i < rows_[r].columns.size(); ++i)
      x[rows_[r].columns[i]] += rows_[r].values[i] * y[static_cast<Index>(r)];
}

VectorXd SparseEquations::of_kept(const VectorXd& b) const { return b(kept_); }

VectorXd SparseEquations::least(const VectorXd& weight, const VectorXd& pull, const VectorXd& b) const {
  const VectorXd scale = weight.cwiseInverse();
  VectorXd force = pull;
  add_transposed(Square(rows_, scale, 0).solve(of_kept(b) - product(rows_, scale.cwiseProduct(pull))), force);
  return scale.cwiseProduct(force);
}

VectorXd SparseEquations::damped(const VectorXd& b, double damping) const {
  VectorXd x = VectorXd::Zero(columns_);
  add_transposed(Square(rows_, VectorXd::Ones(columns_), damping).solve(of_kept(b)), x);
  return x;
}

// Each iterate is held a little to the last one, so that coordinates without a weight stay determined; the distance
// from the result shrinks with the ratio of kProximity to the weight of a direction. The changes are computed, not the
// iterates: their rounding goes with them.
VectorXd SparseEquations::nearest(const VectorXd& weight, const VectorXd& target, const VectorXd& b) const {
  VectorXd x = damped(b, 0);
  const VectorXd square = weight.cwiseAbs2(), scale = (square.array() + kProximity).inverse();
  const Square factors(rows_, scale, 0);
  for (int k = 0; k < kMostIterates; ++k) {
    VectorXd force = square.cwiseProduct(target - x);
    const VectorXd open = of_kept(b) - product(rows_, x);
    add_transposed(factors.solve(open - product(rows_, scale.cwiseProduct(force))), force);
    const VectorXd change = scale.cwiseProduct(force);
    x += change;
    if (!(change.norm() > kStands * x.norm())) break;
  }
  // Feasible to rounding, whatever the weights' range left open.
  VectorXd open = b;
  open(kept_) -= product(rows_, x);
  return x + damped(open, 0);
}

}  // namespace mbgen
