// All loops in one sparse matrix, and products that follow the path matrix.

#include <algorithm>

#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/sparse_partition.hpp"

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

/// An entry of M in the row of some coordinate.
struct MassEntry {
  int column = 0, source = 0;  ///< source: index into TreeMass
};

/// Rows of M: columns of the coordinate's own group and of those below it.
std::vector<std::vector<MassEntry>> mass_rows(const Topology& topology) {
  const TreeMass pattern = tree_mass_pattern(topology);
  std::vector<std::vector<MassEntry>> rows(topology.bodies.size());
  for (int e = 0; e < static_cast<int>(pattern.row.size()); ++e) {
    const int i = pattern.row[e], j = pattern.column[e];
    rows[i].push_back({j, e});
    if (i != j && topology.group_of[i] == topology.group_of[j]) rows[j].push_back({i, e});
  }
  return rows;
}

/// An entry of Rz in the column of some direction.
struct RzEntry {
  int coordinate = 0;
  double value = 0;
};

class SparseLoops {
 public:
  SparseLoops(const Topology& topology, const Analysis& analysis)
      : topology_(topology),
        shape_(loop_shape(topology, analysis)),
        jacobian_(std::make_unique<PartitionedJacobian>(topology, shape_, frozen_partition(analysis))),
        mass_rows_(mass_rows(topology)),
        rz_(shape_.directions),
        coupled_(shape_.directions),
        row_(shape_.coordinates) {
    for (const FreeJoint& joint : shape_.free_joints) rz_[joint.direction] = {{joint.coordinate, 1.0}};
    couple_directions();
  }

  Status factorise(const std::vector<BlockClosure<double>>& closures) {
    const double ratio = jacobian_->factorise(closures);
    if (ratio > least_ratio_) {
      if (ratio > kGoodRatio) least_ratio_ = kGoodRatio;
      return {};
    }
    std::vector<BlockPartition> chosen;
    for (std::size_t b = 0; b < shape_.blocks.size(); ++b) {
      const BlockFactors factors(closures[b].jacobian, shape_.blocks[b].driven, shape_.blocks[b].rank);
      if (factors.rank() < shape_.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
      std::vector<int> equations = factors.pivoted().rows();
      equations.resize(factors.rank());
      chosen.push_back({std::move(equations), factors.dependent(), factors.free()});
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
        std::vector<RzEntry>& column = rz_[block.first_direction + q];
        column.clear();
        const double* entry = follow.data() + static_cast<std::size_t>(q) * jacobian_->rank() + jacobian_->first_row(b);
        for (int c : part.dependent) column.push_back({block.joints[c], -*entry++});
        column.push_back({block.joints[part.free[q]], 1.0});
      }
    }
  }

  void solve(const PerBlock& right_hand_side, std::vector<double>& x) { jacobian_->solve(right_hand_side, x); }

  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
    const auto times = [](const std::vector<RzEntry>& column, const std::vector<double>& values) {
      double sum = 0;
      for (const RzEntry& entry : column) sum += entry.value * values[entry.coordinate];
      return sum;
    };
    reduced.mass.setZero(shape_.directions, shape_.directions);
    reduced.right_hand_side.resize(shape_.directions);
    for (int d = 0; d < shape_.directions; ++d) {
      std::fill(row_.begin(), row_.end(), 0.0);
      for (const RzEntry& entry : rz_[d])
        for (const MassEntry& m : mass_rows_[entry.coordinate]) row_[m.column] += entry.value * mass.value[m.source];
      for (int below : coupled_[d]) reduced.mass(d, below) = times(rz_[below], row_);
      reduced.right_hand_side[d] = times(rz_[d], q);
    }
  }

  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const {
    for (int d = 0; d < shape_.directions; ++d)
      for (const RzEntry& entry : rz_[d]) x[entry.coordinate] += entry.value * free[d];
  }

 private:
  /// Directions of a group meet those before them of their own group, and all of the groups below it.
  void couple_directions() {
    std::vector<std::vector<int>> of_group(topology_.groups.size());
    for (const FreeJoint& joint : shape_.free_joints)
      of_group[topology_.group_of[joint.coordinate]].push_back(joint.direction);
    for (const BlockShape& block : shape_.blocks)
      for (int q = 0; q < block.directions(); ++q)
        of_group[topology_.group_of[block.joints[0]]].push_back(block.first_direction + q);
    for (std::size_t g = 0; g < of_group.size(); ++g)
      for (int d : of_group[g]) {
        for (int own : of_group[g])
          if (own <= d) coupled_[d].push_back(own);
        for (int h = topology_.groups[g].parent; h >= 0; h = topology_.groups[h].parent)
          coupled_[d].insert(coupled_[d].end(), of_group[h].begin(), of_group[h].end());
      }
  }

  Topology topology_;
  LoopShape shape_;
  std::unique_ptr<PartitionedJacobian> jacobian_;
  double least_ratio_ = kGoodRatio;
  std::vector<std::vector<MassEntry>> mass_rows_;
  std::vector<std::vector<RzEntry>> rz_;   ///< per direction
  std::vector<std::vector<int>> coupled_;  ///< per direction: those up to it that M couples it with
  std::vector<double> row_;
};

}  // namespace

LoopAlgebra sparse_algebra(const Topology& topology, const Analysis& analysis) {
  return algebra_of<SparseLoops>(topology, analysis);
}

}  // namespace mbgen
