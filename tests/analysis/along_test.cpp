// Loop blocks with one freedom over their whole motion: the coordinate that is free.

#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

// With 8 legs a rocker was free, which turns back twice a turn.
TEST(AlongTheMotion, AWalkingMachineKeepsItsCrankFree) {
  for (const int legs : {4, 8, 12}) {
    const Mechanism m = analysed(grown("walker", legs));
    ASSERT_EQ(m.analysis.blocks.size(), 1u);
    const BlockAnalysis& block = m.analysis.blocks[0];
    EXPECT_EQ(block.rank, 6 * legs);
    ASSERT_EQ(block.independent.size(), 1u);
    EXPECT_EQ(m.topology.bodies[m.topology.blocks[0].joints[block.independent[0]]].coordinate, "crank") << legs;
    EXPECT_EQ(block.quasi.independent, block.independent) << legs;
  }
}

}  // namespace
}  // namespace mbgen
