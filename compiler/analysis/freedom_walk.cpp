#include "compiler/analysis/freedom_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mbgen {
namespace {

constexpr double kWalkStep = 0.15;  // rad or m, of the coordinate that moves most

LoopPartition partition_at(const SparseRows& jacobian, const LoopBlock& block, const std::vector<int>& late) {
  std::vector<int> rows(block.equations);
  std::iota(rows.begin(), rows.end(), 0);
  LoopPartition partition;
  partition.pivots = eliminate({&jacobian}, rows, std::vector<bool>(block.joints.size(), false), late).pivots;
  std::vector<bool> dependent(block.joints.size(), false);
  for (const Pivot& pivot : partition.pivots) dependent[pivot.coordinate] = true;
  for (std::size_t c = 0; c < dependent.size(); ++c)
    (dependent[c] ? partition.dependent : partition.independent).push_back(static_cast<int>(c));
  return partition;
}

/// Turns a walk round, or into another way after both.
void turn(int attempt, std::size_t coordinates, FreedomWalk& walk) {
  if (attempt % (2 * kWalkLength) != 0) {
    for (double& w : walk.weights) w = -w;
    return;
  }
  walk.weights.clear();
  for (std::size_t c = 0; c < coordinates; ++c)
    walk.weights.push_back(static_cast<double>(walk.random() >> 11) * 0x1p-52 - 1.0);
}

}  // namespace

std::vector<double> mixed_freedoms(const SparseRows& jacobian, const LoopPartition& partition,
                                   const std::vector<double>& weights) {
  const std::size_t coordinates = weights.size();
  const std::vector<double> open =
      moved_over(jacobian, std::vector<double>(jacobian.size(), 0.0), partition.independent, weights);
  std::vector<double> x =
      solve_frozen(factorise_frozen(jacobian, partition, coordinates), partition, open, coordinates);
  for (int c : partition.independent) x[c] = weights[c];
  return x;
}

std::vector<FreedomWalk> start_walks(const NumericSystem& numbers, const Configuration& reference,
                                     std::vector<std::vector<int>>& equations) {
  const Topology& topology = numbers.topology();
  std::vector<FreedomWalk> walks;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    if (!is_large(topology.blocks[b]) || !reference.closed[b]) continue;
    walks.push_back({b, partition_at(reference.blocks[b].sparse, topology.blocks[b], numbers.velocity_rows(b)), {}});
    equations[b].clear();
    for (const Pivot& pivot : walks.back().partition.pivots) equations[b].push_back(pivot.equation);
    std::sort(equations[b].begin(), equations[b].end());
  }
  return walks;
}

void put_next_position(const Topology& topology, const std::vector<Configuration>& found, int attempt,
                       FreedomWalk& walk, std::vector<double>& start) {
  const std::vector<int>& joints = topology.blocks[walk.block].joints;
  const bool turns = attempt % kWalkLength == 0;
  if (turns) turn(attempt, joints.size(), walk);
  const Configuration& from = turns || !found.back().closed[walk.block] ? found.front() : found.back();
  const std::vector<double> way = mixed_freedoms(from.blocks[walk.block].sparse, walk.partition, walk.weights);
  double longest = 0;
  for (double part : way) longest = std::max(longest, std::abs(part));
  const double length = longest > 0 && std::isfinite(longest) ? kWalkStep / longest : 0.0;
  for (std::size_t c = 0; c < joints.size(); ++c)
    start[joints[c]] = from.z[joints[c]] + (length > 0 ? length * way[c] : 0.0);
}

}  // namespace mbgen
