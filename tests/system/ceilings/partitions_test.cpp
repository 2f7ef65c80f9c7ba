// Partitions that counting takes, see compiler/choose/counted_partitions.hpp.

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/choose/counted_partitions.hpp"
#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen::test {
namespace {

Compilation decided(const std::string& model) {
  Result<Compilation> result = decide(MBGEN_SOURCE_DIR "/" + model);
  if (!result) throw std::runtime_error(to_text(result.problems()));
  choose_by_counting(result->model, result->topology, result->analysis);
  return std::move(*result);
}

std::set<std::string> independent(const Compilation& c, std::size_t block) {
  std::set<std::string> names;
  for (const int column : c.analysis.blocks[block].quasi.independent)
    names.insert(c.topology.bodies[c.topology.blocks[block].joints[column]].coordinate);
  return names;
}

long operations_of(const Compilation& c) {
  return count_operations(optimise(trace_accelerations(c.model, c.topology, c.analysis, Form::recursive))).total();
}

TEST(CountedPartitions, CoachTakesTheSymmetricSet) {
  const Compilation coach = decided("models/coach_mechanism.json");
  EXPECT_EQ(independent(coach, 0), (std::set<std::string>{"lower_arm_left", "lower_arm_right", "bell_crank"}));
  const BlockAnalysis& front = coach.analysis.blocks[0];
  EXPECT_TRUE(front.candidates[front.chosen].symmetric);
  for (const PartitionCandidate& other : front.candidates) {
    ASSERT_GT(other.traced, 0);
    EXPECT_LE(front.candidates[front.chosen].traced, other.traced);
  }
}

TEST(CountedPartitions, TwinsTakeTheSameCoordinates) {
  const Compilation truck = decided("models/truck_mechanism.json");
  int twins = 0;
  for (const BlockAnalysis& block : truck.analysis.blocks) {
    if (block.chosen_like < 0) continue;
    ++twins;
    EXPECT_EQ(block.quasi.dependent, truck.analysis.blocks[block.chosen_like].quasi.dependent);
  }
  EXPECT_EQ(twins, 3) << "a seat, an axle of the truck and one of the trailer";
}

TEST(CountedPartitions, NoModelTakesMoreOperationsThanWithTheEstimates) {
  for (const char* model : {"models/four_bar.json", "models/slider_crank.json", "models/andrews_squeezer.json",
                            "models/pulled_wheel.json", "models/iftomm/a04_bricard.json",
                            "models/starters/double_wishbone.json", "tests/data/models/closure_planar.json",
                            "tests/data/models/spatial_four_bar.json", "tests/data/models/governor_rods.json"}) {
    Compilation c = decided(model);
    const long counted = operations_of(c);
    for (BlockAnalysis& block : c.analysis.blocks) block.quasi = block.candidates[0];
    EXPECT_LE(counted, operations_of(c)) << model;
  }
}

TEST(CountedPartitions, TwoRunsCountTheSame) {
  const Compilation one = decided("models/andrews_squeezer.json"), two = decided("models/andrews_squeezer.json");
  for (std::size_t b = 0; b < one.analysis.blocks.size(); ++b)
    for (std::size_t c = 0; c < one.analysis.blocks[b].candidates.size(); ++c) {
      EXPECT_GT(one.analysis.blocks[b].candidates[c].traced, 0);
      EXPECT_EQ(one.analysis.blocks[b].candidates[c].traced, two.analysis.blocks[b].candidates[c].traced);
    }
}

}  // namespace
}  // namespace mbgen::test
