// All loops in one dense matrix, as in the paper: what its table calls BLAS does not look at blocks.

#include <cblas.h>

#include <algorithm>

#include "runtime/generic/maggi.hpp"
#include "runtime/generic/paper_lu.hpp"

namespace mbgen {
namespace {

/// A column of the whole Jacobian: one coordinate of one block.
struct Column {
  int block = 0, local = 0;
};

/// Dependent columns of the analysis in its order of pivots first, so that good pivots come early; driven columns last.
std::vector<Column> ordered_columns(const LoopShape& shape, const Analysis& analysis) {
  std::vector<Column> dependent, independent, driven;
  for (int b = 0; b < static_cast<int>(shape.blocks.size()); ++b) {
    for (const Pivot& pivot : analysis.blocks[b].pivots) dependent.push_back({b, pivot.coordinate});
    for (int c : analysis.blocks[b].independent) independent.push_back({b, c});
    for (int c : shape.blocks[b].driven) driven.push_back({b, c});
  }
  dependent.insert(dependent.end(), independent.begin(), independent.end());
  dependent.insert(dependent.end(), driven.begin(), driven.end());
  return dependent;
}

PaperLu lu_for(const LoopShape& shape, const std::vector<Column>& columns) {
  std::vector<int> group, most;
  for (const Column& column : columns) {
    const std::vector<int>& driven = shape.blocks[column.block].driven;
    if (std::find(driven.begin(), driven.end(), column.local) == driven.end()) group.push_back(column.block);
  }
  for (const BlockShape& block : shape.blocks) most.push_back(block.rank);
  return {shape.equations, static_cast<int>(columns.size()), group, most};
}

class WholeDense {
 public:
  WholeDense(const Topology& topology, const Analysis& analysis)
      : shape_(loop_shape(topology, analysis)),
        columns_(ordered_columns(shape_, analysis)),
        lu_(lu_for(shape_, columns_)),
        rz_(Eigen::MatrixXd::Zero(shape_.coordinates, shape_.directions)),
        mass_(Eigen::MatrixXd::Zero(shape_.coordinates, shape_.coordinates)),
        mass_times_rz_(shape_.coordinates, shape_.directions) {
    for (const BlockShape& block : shape_.blocks) free_ += block.directions();
    for (const FreeJoint& joint : shape_.free_joints) rz_(joint.coordinate, joint.direction) = 1;
  }

  Status factorise(const Closures& closures) {
    std::vector<double>& a = lu_.matrix();
    std::fill(a.begin(), a.end(), 0.0);
    double* column = a.data();
    for (const Column& c : columns_) {
      double* entry = column + shape_.blocks[c.block].first_equation;
      for (const SparseRow<double>& row : closures[c.block].jacobian) *entry++ = row.at(c.local);
      column += shape_.equations;
    }
    lu_.factorise();
    for (std::size_t b = 0; b < shape_.blocks.size(); ++b)
      if (lu_.pivots_of(static_cast<int>(b)) < shape_.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
    return {};
  }

  void form_rz() {
    lu_.dependence(lu_.pivots(), free_, dependence_);
    for (const Column& c : columns_) rz_.row(joint(c)).setZero();
    std::vector<int> next;
    for (const BlockShape& block : shape_.blocks) next.push_back(block.first_direction);
    for (int q = 0; q < free_; ++q) {
      const Column& free = columns_[lu_.column(lu_.pivots() + q)];
      auto column = rz_.col(next[free.block]++);
      column[joint(free)] = 1;
      const double* follow = dependence_.data() + static_cast<std::size_t>(q) * lu_.pivots();
      for (int d = 0; d < lu_.pivots(); ++d) column[joint(columns_[lu_.column(d)])] = -follow[d];
    }
  }

  void solve(const PerBlock& right_hand_side, std::vector<double>& x) {
    b_.clear();
    for (const std::vector<double>& of_block : right_hand_side) b_.insert(b_.end(), of_block.begin(), of_block.end());
    given_.clear();
    for (std::size_t place = lu_.pivots(); place < columns_.size(); ++place)
      given_.push_back(x[joint(columns_[lu_.column(static_cast<int>(place))])]);
    lu_.solve(b_, given_, dependent_);
    for (int d = 0; d < lu_.pivots(); ++d) x[joint(columns_[lu_.column(d)])] = dependent_[d];
  }

  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
    const int n = shape_.coordinates, f = shape_.directions;
    spread(mass, mass_);
    reduced.mass.resize(f, f);
    reduced.right_hand_side.resize(f);
    if (f == 0) return;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, f, n, 1.0, mass_.data(), n, rz_.data(), n, 0.0,
                mass_times_rz_.data(), n);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, f, f, n, 1.0, rz_.data(), n, mass_times_rz_.data(), n, 0.0,
                reduced.mass.data(), f);
    cblas_dgemv(CblasColMajor, CblasTrans, n, f, 1.0, rz_.data(), n, q.data(), 1, 0.0, reduced.right_hand_side.data(),
                1);
  }

  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const {
    if (free.size() == 0) return;
    cblas_dgemv(CblasColMajor, CblasNoTrans, shape_.coordinates, shape_.directions, 1.0, rz_.data(), shape_.coordinates,
                free.data(), 1, 1.0, x.data(), 1);
  }

 private:
  int joint(const Column& c) const { return shape_.blocks[c.block].joints[c.local]; }

  LoopShape shape_;
  std::vector<Column> columns_;
  PaperLu lu_;
  int free_ = 0;  ///< directions inside loops
  std::vector<double> dependence_, b_, given_, dependent_;
  Eigen::MatrixXd rz_, mass_, mass_times_rz_;
};

}  // namespace

LoopAlgebra blas_algebra(const Topology& topology, const Analysis& analysis) {
  return algebra_of<WholeDense>(topology, analysis);
}

}  // namespace mbgen
