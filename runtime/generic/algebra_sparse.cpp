// All loops in one sparse matrix, and products that follow the path matrix.

#include <algorithm>

#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/sparse_partition.hpp"
#include "runtime/generic/sparse_projection.hpp"

namespace mbgen {
namespace {

constexpr double kGoodRatio = 1e-4;  // pivots of Phi_d: below it the dependent coordinates are chosen again
constexpr double kWorseAgain = 0.1;  // share of a poor ratio, chosen as the best there is, at which to choose again

std::vector<BlockPartition> frozen_partition(const Analysis& analysis) {
  std::vector<BlockPartition> result;
  for (const BlockAnalysis& block : analysis.blocks) {
    BlockPartition part;
    for (const Pivot& pivot : block.pivots) {
      part.equations.push_back(pivot.equation);
      part.dependent.push_back(pivot.coordinate);
    }
    part.free = block.independent;
    result.push_back(std::move(part));
  }
  return result;
}

class SparseLoops {
 public:
  SparseLoops(const Model& model, const Topology& topology, const Analysis& analysis)
      : topology_(topology),
        shape_(loop_shape(topology, analysis)),
        jacobian_(std::make_unique<PartitionedJacobian>(topology, shape_, frozen_partition(analysis))),
        rz_(model, topology, shape_) {}

  Status factorise(const Closures& closures) {
    const double ratio = jacobian_->factorise(closures);
    if (ratio > least_ratio_) {
      if (ratio > kGoodRatio) least_ratio_ = kGoodRatio;
      return {};
    }
    std::vector<BlockPartition> chosen;
    for (std::size_t b = 0; b < shape_.blocks.size(); ++b) {
      const BlockShape& block = shape_.blocks[b];
      const BlockFactors factors(closures[b].jacobian, static_cast<int>(block.joints.size()), block.driven, block.rank);
      if (factors.rank() < shape_.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
      chosen.push_back({factors.pivoted().rows(), factors.dependent(), factors.free()});
    }
    jacobian_ = std::make_unique<PartitionedJacobian>(topology_, shape_, std::move(chosen));
    const double best = jacobian_->factorise(closures);
    least_ratio_ = std::min(kGoodRatio, kWorseAgain * best);
    return best > 0 ? Status{} : Status{Code::loop_singular, -1};
  }

  void form_rz() {
    const std::vector<double>& follow = jacobian_->dependence();
    for (std::size_t b = 0; b < shape_.blocks.size(); ++b) {
      const BlockShape& block = shape_.blocks[b];
      const BlockPartition& part = jacobian_->partition()[b];
      for (int q = 0; q < block.directions(); ++q) {
        std::vector<RzEntry>& column = rz_.column(block.first_direction + q);
        column.clear();
        const double* entry = follow.data() + static_cast<std::size_t>(q) * jacobian_->rank() + jacobian_->first_row(b);
        for (int c : part.dependent) column.push_back({block.joints[c], -*entry++});
        column.push_back({block.joints[part.free[q]], 1.0});
      }
    }
  }

  void solve(const PerBlock& right_hand_side, std::vector<double>& x) { jacobian_->solve(right_hand_side, x); }

  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
    rz_.reduce(mass, q, reduced);
  }
  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const { rz_.add_rz_times(free, x); }

 private:
  Topology topology_;
  LoopShape shape_;
  std::unique_ptr<PartitionedJacobian> jacobian_;
  double least_ratio_ = kGoodRatio;
  SparseProjection rz_;
};

}  // namespace

LoopAlgebra sparse_algebra(const Model& model, const Topology& topology, const Analysis& analysis) {
  return algebra_of<SparseLoops>(model, topology, analysis);
}

}  // namespace mbgen
