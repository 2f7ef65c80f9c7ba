#include "compiler/analysis/position_rank.hpp"

#include <algorithm>
#include <numeric>

#include "compiler/algebra/dense.hpp"

namespace mbgen {

int position_rank(const NumericSystem& numbers, std::size_t b, const PartView& whole, int rank,
                  const std::vector<Configuration>& configurations) {
  const Topology& topology = numbers.topology();
  const LoopBlock& block = topology.blocks[b];
  const std::vector<int> of_velocities = velocity_rows(numbers.model(), topology, block);
  if (of_velocities.empty()) return rank;
  std::vector<int> rows, columns(block.joints.size());
  std::iota(columns.begin(), columns.end(), 0);
  for (int row = 0; row < block.equations; ++row)
    if (!contains(of_velocities, row)) rows.push_back(row);
  if (rows.empty()) return 0;
  std::size_t largest = 0;
  for (const int i : whole.configurations) {
    const Eigen::MatrixXd jacobian = configurations[static_cast<std::size_t>(i)].blocks[b].part(rows, columns);
    largest = std::max(largest, leading_columns(jacobian, kLeastSingularValue).size());
  }
  return static_cast<int>(largest);
}

}  // namespace mbgen
