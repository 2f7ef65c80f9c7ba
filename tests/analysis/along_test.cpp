// Loop blocks with one freedom over their whole motion: the coordinate that is free, and the frozen order of pivots.

#include "compiler/analysis/configuration.hpp"
#include "mbgen/blocks.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Smallest monitor of the frozen partition of the first block while the crank, the first coordinate, makes a turn.
double least_monitor(const Mechanism& m, const LoopPartition& partition) {
  const LoopBlock& block = m.topology.blocks[0];
  NumericSystem numbers(m.model, m.topology);
  std::vector<std::vector<int>> equations(1);
  for (const Pivot& pivot : partition.pivots) equations[0].push_back(pivot.equation);
  std::sort(equations[0].begin(), equations[0].end());
  Configuration at = close_equations(numbers, std::vector<double>(m.topology.size(), 0.0), equations);
  double least = 1, turned = 0;
  std::vector<double> before = at.z, step(at.z.size(), 0.0);
  step[0] = 0.05;
  while (turned < 6.4 && at.closed[0]) {
    std::vector<double> start = at.z;
    for (std::size_t c = 0; c < start.size(); ++c) start[c] += step[c];
    at = close_equations(numbers, start, equations);
    SparseRows rows = at.blocks[0].sparse;
    for (Eigen::Index e = 0; rows.size() < static_cast<std::size_t>(at.blocks[0].jacobian.rows()); ++e) {
      rows.emplace_back();
      for (Eigen::Index c = 0; c < at.blocks[0].jacobian.cols(); ++c)
        rows.back().push_back(static_cast<int>(c), at.blocks[0].jacobian(e, c));
    }
    least = std::min(least, factorise_frozen(rows, partition, block.joints.size()).quality);
    for (std::size_t c = 0; c < start.size(); ++c) step[c] = at.z[c] - before[c];
    turned += step[0];
    const double speed = 0.05 / step[0];  // of the crank
    for (double& way : step) way *= speed;
    before = at.z;
  }
  EXPECT_GE(turned, 6.4);
  return least;
}

// No partition is chosen at run time. With 4 legs the order of pivots inside a leg came near zero, with 8 a rocker was
// free, which turns back twice a turn.
TEST(AlongTheMotion, AWalkingMachineKeepsItsCrankFreeAndItsPivotsClear) {
  for (const int legs : {4, 8}) {
    const Mechanism m = analysed(grown("walker", legs));
    ASSERT_EQ(m.analysis.blocks.size(), 1u);
    const BlockAnalysis& block = m.analysis.blocks[0];
    EXPECT_EQ(block.rank, 6 * legs);
    ASSERT_EQ(block.independent.size(), 1u);
    EXPECT_EQ(m.topology.bodies[m.topology.blocks[0].joints[block.independent[0]]].coordinate, "crank") << legs;
    EXPECT_GT(least_monitor(m, block), kPivotThreshold<double>) << legs;
    EXPECT_GT(least_monitor(m, block.quasi), kPivotThreshold<double>) << legs;
  }
}

}  // namespace
}  // namespace mbgen
