#include "runtime/generic/sparse_partition.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Whether an equation of a block can depend on a column: the joints of its loop.
std::vector<std::vector<bool>> block_pattern(const Topology& topology, const LoopBlock& block) {
  std::vector<std::vector<bool>> pattern;
  for (int l : block.loops) {
    const Loop& loop = topology.loops[l];
    std::vector<bool> touched;
    for (int joint : block.joints) touched.push_back(std::binary_search(loop.joints.begin(), loop.joints.end(), joint));
    pattern.insert(pattern.end(), loop.equations, touched);
  }
  return pattern;
}

}  // namespace

PartitionedJacobian::PartitionedJacobian(const Topology& topology, const LoopShape& shape,
                                         std::vector<BlockPartition> partition)
    : partition_(std::move(partition)) {
  std::vector<int> starts{0}, rows;
  for (std::size_t b = 0; b < partition_.size(); ++b) {
    const BlockPartition& part = partition_[b];
    const std::vector<std::vector<bool>> touches = block_pattern(topology, topology.blocks[b]);
    first_row_.push_back(rank());
    directions_ = std::max(directions_, static_cast<int>(part.free.size()));
    for (int c : part.dependent) {
      for (std::size_t k = 0; k < part.equations.size(); ++k) {
        if (!touches[part.equations[k]][c]) continue;
        entries_.push_back({static_cast<int>(b), part.equations[k], c});
        rows.push_back(first_row_[b] + static_cast<int>(k));
      }
      starts.push_back(static_cast<int>(rows.size()));
      dependent_coordinates_.push_back(shape.blocks[b].joints[c]);
    }
    for (std::size_t q = 0; q < part.free.size(); ++q)
      add_column(shape, touches, static_cast<int>(b), part.free[q], static_cast<int>(q));
    for (int c : shape.blocks[b].driven) add_column(shape, touches, static_cast<int>(b), c, -1);
  }
  dependence_.resize(static_cast<std::size_t>(rank()) * directions_);
  b_.resize(rank());
  if (rank() > 0) factors_ = std::make_unique<KluFactors>(std::move(starts), std::move(rows));
}

void PartitionedJacobian::add_column(const LoopShape& shape, const std::vector<std::vector<bool>>& touches, int block,
                                     int column, int direction) {
  const std::vector<int>& equations = partition_[block].equations;
  for (std::size_t k = 0; k < equations.size(); ++k)
    if (touches[equations[k]][column])
      others_.push_back({{block, equations[k], column},
                         first_row_[block] + static_cast<int>(k),
                         shape.blocks[block].joints[column],
                         direction,
                         0});
}

double PartitionedJacobian::factorise(const Closures& closures) {
  const auto value = [&](const Entry& e) { return closures[e.block].jacobian[e.equation].at(e.column); };
  for (OtherEntry& other : others_) other.value = value(other.source);
  if (!factors_) return 1;
  std::transform(entries_.begin(), entries_.end(), factors_->values().begin(), value);
  return factors_->factorise();
}

void PartitionedJacobian::solve(const PerBlock& right_hand_side, std::vector<double>& x) {
  auto row = b_.begin();
  for (std::size_t b = 0; b < partition_.size(); ++b)
    for (int e : partition_[b].equations) *row++ = right_hand_side[b][e];
  for (const OtherEntry& other : others_) b_[other.row] -= other.value * x[other.coordinate];
  if (factors_) factors_->solve(1, b_);
  for (int k = 0; k < rank(); ++k) x[dependent_coordinates_[k]] = b_[k];
}

const std::vector<double>& PartitionedJacobian::dependence() {
  std::fill(dependence_.begin(), dependence_.end(), 0.0);
  for (const OtherEntry& other : others_)
    if (other.direction >= 0) dependence_[static_cast<std::size_t>(other.direction) * rank() + other.row] = other.value;
  if (factors_) factors_->solve(directions_, dependence_);
  return dependence_;
}

}  // namespace mbgen
