// Each loop block for itself by the entries of its rows, with pivoting at every state; products that follow the path
// matrix. The cost follows the mechanism, not the square of its sizes, and the pivots are those of dense elimination.

#include <optional>

#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/sparse_projection.hpp"

namespace mbgen {
namespace {

class EntryBlocks {
 public:
  EntryBlocks(const Model& model, const Topology& topology, const Analysis& analysis)
      : model_(model), topology_(topology), shape_(loop_shape(topology, analysis)) {
    for (const BlockShape& block : shape_.blocks)
      factors_.emplace_back(static_cast<int>(block.joints.size()), block.driven, block.rank);
  }

  Status factorise(const Closures& closures) {
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      factors_[b].factorise(closures[b].jacobian);
      if (factors_[b].rank() < shape_.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
    }
    return {};
  }

  void form_rz() {
    if (!rz_) rz_.emplace(model_, topology_, shape_);  // models that are solved by recursion never ask for it
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      const BlockShape& block = shape_.blocks[b];
      const BlockFactors& factors = factors_[b];
      for (int q = 0; q < block.directions(); ++q)
        rz_->column(block.first_direction + q) = {{block.joints[factors.free()[q]], 1.0}};
      factors.each_dependence([&](int d, int q, double value) {
        rz_->column(block.first_direction + q).push_back({block.joints[factors.dependent()[d]], value});
      });
    }
  }

  void solve(const PerBlock& right_hand_side, std::vector<double>& x) {
    solve_blocks(shape_.blocks, factors_, right_hand_side, local_, x);
  }

  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
    rz_->reduce(mass, q, reduced);
  }
  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const { rz_->add_rz_times(free, x); }
  std::vector<std::vector<double>> rz_of(std::size_t block) const { return factors_[block].rz(); }
  double smallest_pivot(std::size_t block) const { return factors_[block].pivoted().smallest_pivot(); }

 private:
  const Model& model_;
  const Topology& topology_;
  LoopShape shape_;
  std::vector<BlockFactors> factors_;
  std::optional<SparseProjection> rz_;
  std::vector<double> local_;
};

}  // namespace

LoopAlgebra entries_algebra(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto blocks = std::make_shared<EntryBlocks>(model, topology, analysis);
  LoopAlgebra algebra = algebra_of(blocks);
  algebra.smallest_pivot = [blocks](std::size_t block) { return blocks->smallest_pivot(block); };
  algebra.rz_of = [blocks](std::size_t block) { return blocks->rz_of(block); };
  return algebra;
}

}  // namespace mbgen
