// The short lists of partitions, the mirror of a model, blocks of one structure.

#include <algorithm>
#include <set>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/block_structure.hpp"
#include "compiler/analysis/elimination_order.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/sampling.hpp"
#include "compiler/analysis/symmetry.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

std::set<int> equations_of(const LoopPartition& partition) {
  std::set<int> equations;
  for (const Pivot& pivot : partition.pivots) equations.insert(pivot.equation);
  return equations;
}

int column_of(const Mechanism& m, const LoopBlock& block, const std::string& name) {
  const int joint = find_coordinate(m.topology, name);
  return static_cast<int>(std::find(block.joints.begin(), block.joints.end(), joint) - block.joints.begin());
}

TEST(Candidates, AllHoldAsWellAsTheFirstOverTheSameEquations) {
  for (const char* model :
       {"models/four_bar.json", "models/andrews_squeezer.json", "models/starters/double_wishbone.json",
        "tests/data/models/spatial_four_bar.json", "tests/data/models/closure_planar.json"}) {
    const Mechanism m = load(model);
    for (const BlockAnalysis& block : m.analysis.blocks) {
      ASSERT_FALSE(block.candidates.empty()) << model;
      const PartitionCandidate& first = block.candidates[0];
      EXPECT_EQ(block.quasi.dependent, first.dependent) << model;
      EXPECT_LE(block.candidates.size(), search_numbers::kShortList + 1) << model;
      std::set<std::vector<int>> seen;
      for (const PartitionCandidate& candidate : block.candidates) {
        EXPECT_TRUE(seen.insert(candidate.dependent).second) << model << ": one set twice";
        EXPECT_EQ(static_cast<int>(candidate.dependent.size()), block.rank) << model;
        EXPECT_EQ(equations_of(candidate), equations_of(block)) << model;
        EXPECT_GE(candidate.score, search_numbers::kListShare) << model;
        EXPECT_GE(candidate.worst_pivot_ratio, std::min(kPivotRatio, first.worst_pivot_ratio)) << model;
      }
      EXPECT_TRUE(std::is_sorted(block.candidates.begin() + 1, block.candidates.end(),
                                 [](const auto& a, const auto& b) { return a.estimate < b.estimate; }))
          << model;
    }
  }
}

/// Smallest |pivot| over the largest entry of its column that is left, over the matrices.
double worst_pivot(std::vector<Eigen::MatrixXd> matrices, const std::vector<Pivot>& pivots) {
  double worst = 1;
  for (Eigen::MatrixXd& m : matrices) {
    std::vector<int> left;
    for (const Pivot& pivot : pivots) left.push_back(pivot.equation);
    for (const Pivot& pivot : pivots) {
      double largest = 0;
      for (const int r : left) largest = std::max(largest, std::abs(m(r, pivot.coordinate)));
      worst = std::min(worst, std::abs(m(pivot.equation, pivot.coordinate)) / largest);
      left.erase(left.begin());
      for (const int r : left)
        m.row(r) -= m(r, pivot.coordinate) / m(pivot.equation, pivot.coordinate) * m.row(pivot.equation);
    }
  }
  return worst;
}

TEST(Candidates, NoPivotIsBelowTheBoundAtTheSamples) {
  for (const char* model : {"models/four_bar.json", "models/slider_crank.json", "models/andrews_squeezer.json"}) {
    const Mechanism m = load(model);
    NumericSystem numbers(m.model, m.topology);
    const std::vector<Configuration> configurations = closed_configurations(numbers, 12);
    const BlockAnalysis& block = m.analysis.blocks[0];
    std::vector<int> all(m.topology.blocks[0].joints.size()), rows;
    for (std::size_t c = 0; c < all.size(); ++c) all[c] = static_cast<int>(c);
    for (const int e : equations_of(block)) rows.push_back(e);
    for (const PartitionCandidate& candidate : block.candidates) {
      std::vector<Eigen::MatrixXd> good;
      for (const Configuration& at : configurations) {
        if (!at.closed[0]) continue;
        const Eigen::MatrixXd& j = at.blocks[0].jacobian;
        const double best = singular_values(part_of(j, rows, all))[block.rank - 1];
        const double here = singular_values(part_of(j, rows, candidate.dependent))[block.rank - 1];
        if (here >= kPivotRatio * best) good.push_back(j);
      }
      ASSERT_FALSE(good.empty()) << model;
      EXPECT_GE(worst_pivot(good, candidate.pivots), kPivotRatio * (1 - 1e-9)) << model;
    }
  }
}

Mirror mirror_of(const Mechanism& m) {
  const NumericSystem numbers(m.model, m.topology);
  return find_mirror(m.topology, numbers.constants());
}

TEST(Mirror, CoachHasLeftAndRight) {
  const Mechanism m = load("models/coach_mechanism.json");
  const Mirror mirror = mirror_of(m);
  ASSERT_TRUE(mirror.found());
  EXPECT_NEAR(std::abs(mirror.normal[1]), 1, 1e-12);
  EXPECT_NEAR(mirror.offset, 0, 1e-12);
  const auto at = [&](const char* name) { return find_coordinate(m.topology, name); };
  EXPECT_EQ(mirror.image[at("lower_arm_left")], at("lower_arm_right"));
  EXPECT_EQ(mirror.image[at("lower_arm_right")], at("lower_arm_left"));
  EXPECT_EQ(mirror.image[at("wheel_front_left")], at("wheel_front_right"));
  EXPECT_TRUE(mirror.equal[at("lower_arm_left")]);
  EXPECT_EQ(mirror.image[at("chassis_tx")], at("chassis_tx"));
  EXPECT_EQ(mirror.sign[at("chassis_tx")], 1);
  EXPECT_EQ(mirror.sign[at("chassis_ty")], -1);
  EXPECT_EQ(mirror.sign[at("chassis_rz")], -1) << "a turn is reflected and turned round";
  EXPECT_EQ(mirror.sign[at("chassis_ry")], 1);
  EXPECT_EQ(mirror.image[at("bell_crank")], at("bell_crank")) << "its joint lies in the plane";
  EXPECT_FALSE(mirror.equal[at("bell_crank")]) << "its centre of mass does not";
  for (std::size_t i = 0; i < mirror.image.size(); ++i) {
    if (mirror.image[i] < 0) continue;
    EXPECT_EQ(mirror.image[mirror.image[i]], static_cast<int>(i));
  }
}

TEST(Mirror, OneOtherNumberIsTold) {
  Mechanism m = load("models/coach_mechanism.json");
  const int left = find_coordinate(m.topology, "lower_arm_left");
  m.model.bodies[m.topology.bodies[left].model_body].mass.value *= 1.25;
  const Mirror mirror = mirror_of(m);
  EXPECT_EQ(mirror.image[left], find_coordinate(m.topology, "lower_arm_right"));
  EXPECT_FALSE(mirror.equal[left]);
  EXPECT_TRUE(mirror.equal[find_coordinate(m.topology, "wheel_front_left")]);
}

TEST(Mirror, SetsWithBothSidesOrNoneAreSymmetric) {
  const Mechanism m = load("models/coach_mechanism.json");
  const Mirror mirror = mirror_of(m);
  const LoopBlock& front = m.topology.blocks[0];
  const auto columns = [&](std::vector<const char*> names) {
    std::vector<int> result;
    for (const char* name : names) result.push_back(column_of(m, front, name));
    std::sort(result.begin(), result.end());
    return result;
  };
  EXPECT_TRUE(is_symmetric(mirror, front, columns({"lower_arm_left", "lower_arm_right", "bell_crank"})));
  EXPECT_FALSE(is_symmetric(mirror, front, columns({"lower_arm_left", "upper_arm_right", "bell_crank"})));
  EXPECT_FALSE(is_symmetric(mirror, front, columns({"lower_arm_left", "bell_crank"})));
  EXPECT_TRUE(is_symmetric(mirror, front, columns({"bell_crank"})));
}

TEST(Mirror, AFourBarHasNone) { EXPECT_FALSE(mirror_of(load("models/four_bar.json")).found()); }

TEST(BlockStructure, TwinsAreAlikeAndOthersAreNot) {
  const Mechanism m = load("models/truck_mechanism.json");
  NumericSystem numbers(m.model, m.topology);
  const System<double>& system = numbers.at(std::vector<double>(m.topology.bodies.size(), 0.0));
  std::map<std::string, std::string> of;  // first loop of each block -> its structure
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b)
    of[m.topology.loops[m.topology.blocks[b].loops[0]].name] = structure_of(system, static_cast<int>(b));
  EXPECT_EQ(of.at("seat_pivot_left"), of.at("seat_pivot_right"));
  EXPECT_EQ(of.at("v_ball2"), of.at("v_ball3"));
  EXPECT_NE(of.at("cab_upper_pivot"), of.at("seat_pivot_left"));
  EXPECT_NE(of.at("lift_ball"), of.at("v_ball2"));
}

}  // namespace
}  // namespace mbgen
