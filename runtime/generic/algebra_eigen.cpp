// Each loop block for itself, dense, with pivoting at every state; products of whole dense matrices by Eigen.

#include <algorithm>

#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/maggi.hpp"

namespace mbgen {
namespace {

template <class Factors>
class DenseBlocks {
 public:
  DenseBlocks(const Topology& topology, const Analysis& analysis)
      : shape_(loop_shape(topology, analysis)), direction_of_(static_cast<std::size_t>(shape_.coordinates), -1) {
    for (const FreeJoint& joint : shape_.free_joints) direction_of_[joint.coordinate] = joint.direction;
    if (shape_.blocks.empty()) return;
    rz_ = Eigen::MatrixXd::Zero(shape_.coordinates, shape_.directions);
    mass_ = Eigen::MatrixXd::Zero(shape_.coordinates, shape_.coordinates);
    for (const BlockShape& block : shape_.blocks)
      factors_.emplace_back(static_cast<int>(block.joints.size()), block.driven, block.rank);
    for (const FreeJoint& joint : shape_.free_joints) rz_(joint.coordinate, joint.direction) = 1;
  }

  Status factorise(const Closures& closures) {
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      factors_[b].factorise(closures[b].jacobian);
      if (factors_[b].rank() < shape_.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
    }
    return {};
  }

  void form_rz() {
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      const BlockShape& block = shape_.blocks[b];
      const Factors& factors = factors_[b];
      for (int q = 0; q < block.directions(); ++q) {
        auto column = rz_.col(block.first_direction + q);
        for (int c : factors.free()) column[block.joints[c]] = 0;
        column[block.joints[factors.free()[q]]] = 1;
      }
      if (block.rank == 0) continue;
      factors.each_dependence([&](int d, int q, double value) {
        rz_(block.joints[factors.dependent()[d]], block.first_direction + q) = value;
      });
    }
  }

  void solve(const PerBlock& right_hand_side, std::vector<double>& x) {
    solve_blocks(shape_.blocks, factors_, right_hand_side, local_, x);
  }

  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
    if (shape_.blocks.empty()) return take_free(mass, q, reduced);
    spread(mass, mass_);
    mass_times_rz_.noalias() = mass_ * rz_;
    reduced.mass.resize(shape_.directions, shape_.directions);
    if (shape_.directions > 0) reduced.mass.triangularView<Eigen::Lower>() = rz_.transpose() * mass_times_rz_;
    reduced.right_hand_side.noalias() = rz_.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), rz_.rows());
  }

  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const {
    if (shape_.blocks.empty()) {
      for (const FreeJoint& joint : shape_.free_joints) x[joint.coordinate] += free[joint.direction];
      return;
    }
    Eigen::Map<Eigen::VectorXd>(x.data(), rz_.rows()).noalias() += rz_ * free;
  }

 private:
  /// The products of a tree: Rz is 1 per free joint, and whole matrices would be multiplied to copy entries.
  void take_free(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) const {
    reduced.mass.setZero(shape_.directions, shape_.directions);
    reduced.right_hand_side.resize(shape_.directions);
    for (std::size_t e = 0; e < mass.value.size(); ++e) {
      const int row = direction_of_[mass.row[e]], column = direction_of_[mass.column[e]];
      if (row >= 0 && column >= 0) reduced.mass(std::max(row, column), std::min(row, column)) = mass.value[e];
    }
    for (const FreeJoint& joint : shape_.free_joints) reduced.right_hand_side[joint.direction] = q[joint.coordinate];
  }

  LoopShape shape_;
  std::vector<Factors> factors_;
  std::vector<int> direction_of_;              ///< per coordinate outside all loops, -1 for driven ones
  Eigen::MatrixXd rz_, mass_, mass_times_rz_;  ///< empty without loops
  std::vector<double> local_;
};

}  // namespace

LoopAlgebra eigen_lu_algebra(const Topology& topology, const Analysis& analysis) {
  return algebra_of<DenseBlocks<BlockFactorsOf<PivotedLu>>>(topology, analysis);
}

LoopAlgebra eigen_qr_algebra(const Topology& topology, const Analysis& analysis) {
  return algebra_of<DenseBlocks<BlockFactorsOf<PivotedQr>>>(topology, analysis);
}

}  // namespace mbgen
