// Loop blocks too large for singular values: the same decisions by sparse elimination.

#include "compiler/analysis/large_block.hpp"
#include "compiler/analysis/notes.hpp"
#include "compiler/analysis/partition.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

TEST(LargeBlock, FourBarsHaveOneFreedom) {
  const Result<Model> model = grown("four-bar", 60);
  ASSERT_TRUE(model) << to_text(model.problems());
  const Result<Topology> topology = build_topology(*model);
  const Result<Analysis> analysis = analyse(*model, *topology);
  ASSERT_TRUE(analysis) << to_text(analysis.problems());
  ASSERT_EQ(analysis->blocks.size(), 1u);
  const BlockAnalysis& block = analysis->blocks[0];
  EXPECT_EQ(block.rank, 120);
  EXPECT_EQ(block.pivots.size(), 120u);
  EXPECT_EQ(block.redundant_equations.size(), 180u);  // out of the plane
  EXPECT_EQ(block.independent.size(), 1u);
  EXPECT_GE(block.worst_pivot_ratio, 0.05);
  EXPECT_GT(block.typical_pivot, 0.1);
  EXPECT_EQ(analysis->degrees_of_freedom, 1);
  ASSERT_EQ(block.certificate.ranks.size(), 1u);
  EXPECT_EQ(block.certificate.ranks[0].configurations, 9);
  EXPECT_GT(block.certificate.reach, 0.5);
  EXPECT_TRUE(block.certificate.immobile.empty());
  for (const RedundantEquation& redundant : block.certificate.redundant) EXPECT_LT(redundant.residual, 1e-10);
}

TEST(LargeBlock, ATiltedAxisIsNamed) {
  for (const auto& [kind, size, joint] : {std::tuple{"four-bar", 60, "A30"}, std::tuple{"ring", 50, "J25"}}) {
    const std::string tilted = std::string(R"(sed '/")") + joint + R"(": { "type"/s/"z"/[0, 0.1, 1]/')";
    const Result<Model> model = grown(kind, size, tilted);
    ASSERT_TRUE(model) << to_text(model.problems());
    const Result<Topology> topology = build_topology(*model);
    const Result<Analysis> analysis = analyse(*model, *topology);
    ASSERT_FALSE(analysis) << kind;
    const std::string problems = to_text(analysis.problems());
    EXPECT_NE(problems.find(std::string("the axis of joint \"") + joint + "\""), std::string::npos) << problems;
  }
}

// One loop is a large block, too: a chain drive, a track. Planar ones have three redundant equations.
TEST(LargeBlock, ARingOfManyJointsKeepsItsFreedoms) {
  for (const int size : {50, 200})
    for (const bool is_planar : {true, false}) {
      const Mechanism m = analysed(grown(is_planar ? "ring" : "spatial-ring", size));
      ASSERT_EQ(m.analysis.blocks.size(), 1u);
      const BlockAnalysis& block = m.analysis.blocks[0];
      EXPECT_EQ(m.analysis.degrees_of_freedom, size - (is_planar ? 3 : 6));
      EXPECT_EQ(block.rank, is_planar ? 2 : 5);
      EXPECT_EQ(block.redundant_equations.size(), is_planar ? 3u : 0u);
      EXPECT_GE(block.worst_pivot_ratio, 0.05);
      ASSERT_EQ(block.certificate.ranks.size(), 1u);
      EXPECT_EQ(block.certificate.ranks[0].configurations, 9);
      EXPECT_TRUE(block.certificate.immobile.empty());
      for (const RedundantEquation& redundant : block.certificate.redundant) EXPECT_LT(redundant.residual, 1e-10);
    }
}

// The matrix form eliminates a chain's directions with the cube of their number, and those of a block have no shorter
// way unless it is opened: here a link without mass keeps it closed.
TEST(LeastOperations, GrowWithTheCubeOfAChainInTheMatrixFormAlone) {
  const Mechanism small = analysed(grown("chain", 60)), large = analysed(grown("chain", 120));
  const LeastOperations of_small = least_operations(small.topology, small.analysis);
  const LeastOperations of_large = least_operations(large.topology, large.analysis);
  EXPECT_NEAR(of_large.matrix / of_small.matrix, 8, 0.4);
  EXPECT_EQ(of_large.recursive, 2 * of_small.recursive);
  EXPECT_TRUE(is_worth_writing(of_small.matrix, of_small.recursive));
  EXPECT_FALSE(is_worth_writing(of_large.matrix, of_large.recursive));
  const Mechanism ring = analysed(grown("spatial-ring", 200, R"(sed '/"link9"/s/"mass": 1, .*/"mass": 0,/')"));
  EXPECT_GT(least_operations(ring.topology, ring.analysis).recursive,
            least_operations(ring.topology, ring.analysis).matrix);
  const Mechanism opened = analysed(grown("spatial-ring", 200)), twice = analysed(grown("spatial-ring", 399));
  EXPECT_EQ(least_operations(twice.topology, twice.analysis).recursive,
            2 * least_operations(opened.topology, opened.analysis).recursive);
}

// Whether another partition is chosen at run time: not where its matrices or its mass matrix become too large.
TEST(LargeBlock, KeepsItsPartitionWhereAnotherIsTooExpensive) {
  const auto again = [](const char* kind, int size, const std::string& edit = "cat") {
    return chooses_again(*build_topology(*grown(kind, size, edit)));
  };
  const std::string closed = R"(sed '/"link9"/s/"mass": 1, .*/"mass": 0,/')";
  EXPECT_TRUE(again("ring", 60, closed));
  EXPECT_FALSE(again("ring", 64, closed));
  EXPECT_TRUE(again("ring", 300));
  EXPECT_FALSE(again("ring", 400));  // 399 coordinates along 397 directions
  EXPECT_TRUE(again("four-bar", 100));
  EXPECT_FALSE(again("four-bar", 120));
  const Mechanism m = analysed(grown("ring", 64, closed));
  const Diagnostics notes = analysis_notes(m.model, m.topology, m.analysis);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].message,
            "a generated solver keeps the independent coordinates that were chosen near the reference: a loop block of "
            "63 coordinates and 5 equations is too large to choose others at run time");
  EXPECT_EQ(notes[0].hint,
            "where they do not serve, its motion ends with a singular loop; --engine generic chooses them at every "
            "state");
}

TEST(LargeBlock, EliminationAgreesWithSingularValues) {
  // Rows 0 + 1 = 2 and an empty one; column 3 barred.
  const auto row = [](std::vector<int> columns, std::vector<double> values) {
    return SparseRow<double>{std::move(columns), std::move(values)};
  };
  const SparseRows first = {row({0, 1, 3}, {1, 2, 1}), row({1, 2}, {3, -1}), row({0, 1, 2, 3}, {1, 5, -1, 1}),
                            row({0}, {1e-12})};
  const SparseRows second = {row({0, 1, 3}, {2, 1, 1}), row({1, 2}, {1, 4}), row({0, 1, 2, 3}, {2, 2, 4, 1}),
                             row({0}, {0})};
  const SparseElimination e = eliminate({&first, &second}, {0, 1, 2, 3}, {false, false, false, true});
  EXPECT_EQ(e.pivots.size(), 2u);
  EXPECT_LT(e.largest_dropped, 1e-12);
  for (const Pivot& pivot : e.pivots) EXPECT_NE(pivot.coordinate, 3);
}

}  // namespace
}  // namespace mbgen
