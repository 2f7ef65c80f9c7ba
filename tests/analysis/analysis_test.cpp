// Rank, redundancy, dependent coordinates and the block-triangular form.

#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/triangular.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/expected_text.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

const BlockAnalysis& only_block(const Mechanism& m) {
  EXPECT_EQ(m.analysis.blocks.size(), 1u);
  return m.analysis.blocks[0];
}

TEST(Analysis, CoachHasThePapersCounts) {
  const Mechanism m = load("models/coach_mechanism.json");
  ASSERT_EQ(m.topology.blocks.size(), 2u);
  EXPECT_EQ(m.topology.blocks[0].joints.size(), 14u);
  EXPECT_EQ(m.analysis.blocks[0].rank, 11);
  EXPECT_EQ(m.topology.blocks[1].joints.size(), 8u);
  EXPECT_EQ(m.analysis.blocks[1].rank, 6);
  EXPECT_EQ(m.analysis.independent_equations, 17);
  EXPECT_EQ(m.analysis.degrees_of_freedom, 15);
}

TEST(Analysis, TruckHasThePapersCounts) {
  const Mechanism m = load("models/truck_mechanism.json");
  int equations = 0, redundant = 0;
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b) {
    equations += m.topology.blocks[b].equations;
    redundant += static_cast<int>(m.analysis.blocks[b].redundant_equations.size());
  }
  EXPECT_EQ(equations, 51);
  EXPECT_EQ(m.analysis.independent_equations, 40);
  EXPECT_EQ(redundant, 11);
  EXPECT_EQ(m.analysis.degrees_of_freedom, 40);
}

TEST(Analysis, PlanarFourBarHasThreeRedundantEquations) {
  const Mechanism m = load("models/four_bar.json");
  const BlockAnalysis& block = only_block(m);
  EXPECT_EQ(block.rank, 2);
  EXPECT_EQ(block.redundant_equations.size(), 3u);
  for (const std::string& name : block.redundant_names)  // y axes: out of plane are y and both directions
    EXPECT_TRUE(name.ends_with(".y") || name.ends_with(".axis_1") || name.ends_with(".axis_2")) << name;
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
}

TEST(Analysis, DrivenCoordinatesAreNeverDependent) {
  Mechanism m = load("models/four_bar.json");
  const LoopBlock& block = m.topology.blocks[0];
  for (std::size_t c = 0; c < block.joints.size(); ++c) {
    Model driven = m.model;
    Motion motion;
    motion.name = "drive";
    motion.joint = {m.topology.bodies[block.joints[c]].joint, m.topology.bodies[block.joints[c]].component};
    driven.motions = {motion};
    const Result<Topology> topology = build_topology(driven);
    ASSERT_TRUE(topology) << to_text(topology.problems());
    const Result<Analysis> analysis = analyse(driven, *topology);
    ASSERT_TRUE(analysis) << to_text(analysis.problems());
    const int column = static_cast<int>(c);
    EXPECT_EQ(analysis->blocks[0].driven, std::vector<int>{column});
    EXPECT_EQ(std::count(analysis->blocks[0].dependent.begin(), analysis->blocks[0].dependent.end(), column), 0);
    EXPECT_TRUE(analysis->blocks[0].independent.empty());
  }
}

TEST(Analysis, TwoMotionsOnOneFreedomAreRefused) {
  Mechanism m = load("models/four_bar.json");
  for (int joint : {m.topology.blocks[0].joints[0], m.topology.blocks[0].joints[1]}) {
    Motion motion;
    motion.name = "drive" + std::to_string(joint);
    motion.joint = {m.topology.bodies[joint].joint, 0};
    m.model.motions.push_back(motion);
  }
  const Diagnostics problems = analysis_problems(m.model);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message,
            "motions over-constrain a loop: crank_pin and coupler_pin are driven, and each follows from the other");
}

TEST(Analysis, ALoopThatCannotCloseIsNamed) {
  Mechanism m = load("models/coach_mechanism.json");
  for (Rod& rod : m.model.rods)
    if (rod.name == "drag_link") rod.length = Quantity(0.2);
  const Diagnostics problems = analysis_problems(m.model);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("cannot be closed near the reference configuration"), std::string::npos);
}

TEST(Analysis, AFreeDirectionWithoutInertiaIsNamed) {
  Mechanism m = load("models/double_pendulum.json");
  for (Body& body : m.model.bodies) {
    body.mass = 0.0;
    body.inertia.fill(0.0);
  }
  const Diagnostics problems = analysis_problems(m.model);
  ASSERT_EQ(problems.size(), 2u);
  for (const Diagnostic& problem : problems) EXPECT_NE(problem.message.find("moves no inertia"), std::string::npos);
}

/// Every bad model of tests/errors/analysis is refused with exactly the text beside it; MBGEN_UPDATE=1 rewrites the
/// texts.
TEST(Analysis, RefusesBadModelsWithExactMessages) {
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("tests/errors/analysis"))) {
    if (entry.path().extension() != ".json") continue;
    const Result<Model> model = read_model(content(entry.path()), entry.path().filename().string());
    ASSERT_TRUE(model) << to_text(model.problems());
    expect_text(std::filesystem::path(entry.path()).replace_extension(".txt"), to_text(analysis_problems(*model)));
    ++cases;
  }
  EXPECT_GE(cases, 4);
}

TEST(BlockTriangularForm, SplitsAnUpperTriangularPattern) {
  const auto blocks = block_triangular_form({{true, true, false}, {false, true, true}, {false, false, true}});
  ASSERT_EQ(blocks.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(blocks[k], (std::vector<std::pair<int, int>>{{k, k}}));
}

TEST(BlockTriangularForm, KeepsACycleTogetherAndOrdersTheRest) {
  // rows 0 and 2 share columns 1 and 2; row 1 stands alone in column 0 but is used by row 0
  const auto blocks = block_triangular_form({{true, true, true}, {true, false, false}, {false, true, true}});
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].size(), 2u);
  EXPECT_EQ(blocks[1], (std::vector<std::pair<int, int>>{{1, 0}}));
}

TEST(Partition, TakesTheWellConditionedColumnsOverAllSamples) {
  Eigen::MatrixXd a(1, 3), b(1, 3);
  a << 1, 1e-3, 0.8;
  b << 1e-3, 1, 0.8;
  const BlockAnalysis block = choose_partition({a, b, a, b, a}, 1, {});
  EXPECT_EQ(block.dependent, std::vector<int>{2});
  EXPECT_EQ(block.independent, (std::vector<int>{0, 1}));
  EXPECT_NEAR(block.pivots[0].reference, 0.8, 1e-15);
}

TEST(Partition, RankIsTheLargestOverTheSamples) {
  Eigen::MatrixXd regular = Eigen::MatrixXd::Identity(2, 3), singular = Eigen::MatrixXd::Zero(2, 3);
  singular(0, 0) = 1;
  EXPECT_EQ(generic_rank({singular, regular}, {}), 2);
  EXPECT_EQ(generic_rank({singular, singular}, {}), 1);
  EXPECT_EQ(generic_rank({regular}, {0, 2}), 1);
}

}  // namespace
}  // namespace mbgen
