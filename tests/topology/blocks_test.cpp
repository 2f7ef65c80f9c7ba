// Loop blocks and groups, and what must hold on any graph.

#include <array>
#include <random>
#include <set>

#include "tests/topology/topology_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Names = std::vector<std::string>;
using Indices = std::vector<int>;

TEST(Blocks, LoopsThatShareAJointMakeOneBlock) {
  ModelBuilder builder;
  builder.revolute("A", "ground", "crank").revolute("B", "crank", "coupler").revolute("D", "ground", "rocker");
  builder.revolute("G", "ground", "lever").revolute("F", "lever", "link");
  builder.revolute("C", "coupler", "rocker", CutMark::cut).revolute("E", "coupler", "link", CutMark::cut);
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(topology.blocks.size(), 1u);
  const LoopBlock& block = topology.blocks[0];
  EXPECT_EQ(block.loops, (Indices{0, 1}));
  EXPECT_EQ(names_of(topology, block.joints), (Names{"A", "B", "D", "G", "F"}));
  EXPECT_EQ(block.base, kGround);
  EXPECT_EQ(block.equations, 10);
  EXPECT_EQ(names_of(topology, topology.loops[0].joints), (Names{"A", "B", "D"}));
  EXPECT_EQ(names_of(topology, topology.loops[1].joints), (Names{"A", "B", "G", "F"}));
}

TEST(Blocks, LoopsOnOneBodyWithoutACommonJointAreApart) {
  ModelBuilder builder;
  builder.joint("hull", JointType::free, "ground", "hull");
  for (const std::string side : {"left", "right"}) {
    builder.revolute(side, "hull", side).revolute(side + "_tip", side, side + "_end");
    builder.rod(side + "_rod", side + "_end", "hull");
  }
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(topology.blocks.size(), 2u);
  const int hull = find_coordinate(topology, "hull_rx");
  EXPECT_EQ(names_of(topology, topology.blocks[0].joints), (Names{"left", "left_tip"}));
  EXPECT_EQ(names_of(topology, topology.blocks[1].joints), (Names{"right", "right_tip"}));
  EXPECT_EQ(topology.blocks[0].base, hull);
  EXPECT_EQ(topology.blocks[1].base, hull);
}

// The inner loop meets on a body that moves in the outer one: the block's base is the outer ancestor.
TEST(Blocks, BaseIsTheLowestCommonAncestorOfAllLoops) {
  ModelBuilder builder;
  builder.revolute("base", "ground", "base").revolute("a", "base", "a").revolute("b", "a", "b").revolute("c", "b", "c");
  builder.rod("inner", "c", "a").rod("outer", "b", "base");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(topology.loops[0].ancestor, 1);
  EXPECT_EQ(topology.loops[1].ancestor, 0);
  ASSERT_EQ(topology.blocks.size(), 1u);
  EXPECT_EQ(topology.blocks[0].base, 0);
  EXPECT_EQ(names_of(topology, topology.blocks[0].joints), (Names{"a", "b", "c"}));
}

// Frame, cab by a four-bar on the frame, seat by a four-bar on the cab, a lamp on the seat.
TEST(Blocks, BlocksNestThroughTheirBases) {
  ModelBuilder builder;
  builder.revolute("frame", "ground", "frame");
  builder.revolute("front_arm", "frame", "front_arm").revolute("cab", "front_arm", "cab");
  builder.revolute("seat_arm", "cab", "seat_arm").revolute("seat", "seat_arm", "seat");
  builder.revolute("seat_link", "cab", "seat_link").revolute("lamp", "seat", "lamp");
  builder.revolute("rear_arm", "frame", "rear_arm");
  builder.revolute("seat_tip", "seat_link", "seat", CutMark::cut).revolute("cab_tip", "rear_arm", "cab", CutMark::cut);
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(topology.blocks.size(), 2u);
  EXPECT_EQ(names_of(topology, topology.blocks[0].joints), (Names{"front_arm", "cab", "rear_arm"}));
  EXPECT_EQ(names_of(topology, topology.blocks[1].joints), (Names{"seat_arm", "seat", "seat_link"}));
  EXPECT_EQ(topology.blocks[1].base, find_coordinate(topology, "cab"));

  ASSERT_EQ(topology.groups.size(), 4u);
  const auto group = [&](int g) { return names_of(topology, topology.groups[g].joints); };
  EXPECT_EQ(group(0), Names{"frame"});
  EXPECT_EQ(group(1), (Names{"front_arm", "cab", "rear_arm"}));
  EXPECT_EQ(group(2), (Names{"seat_arm", "seat", "seat_link"}));
  EXPECT_EQ(group(3), Names{"lamp"});
  // frame 0, front_arm 1, cab 2, seat_arm 3, seat 4, seat_link 5, lamp 6, rear_arm 7
  const std::vector<std::array<int, 3>> expected = {// block, base, parent
                                                    {-1, kGround, -1},
                                                    {0, 0, 0},
                                                    {1, 2, 1},
                                                    {-1, 4, 2}};
  for (int g = 0; g < 4; ++g) {
    const JointGroup& found = topology.groups[g];
    EXPECT_EQ((std::array<int, 3>{found.block, found.base, found.parent}), expected[g]) << g;
  }
  EXPECT_EQ(topology.group_of, (Indices{0, 1, 1, 2, 2, 2, 3, 1}));
}

// A connected random mechanism: every body hangs on an earlier one, then chords and rods.
ModelBuilder random_mechanism(std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const JointType types[] = {JointType::revolute,  JointType::prismatic, JointType::cylindrical, JointType::universal,
                             JointType::spherical, JointType::planar,    JointType::free,        JointType::revolute};
  ModelBuilder builder;
  const int bodies = 2 + below(12);
  const auto numbered = [](const char* word, int number) { return std::string(word).append(std::to_string(number)); };
  const auto name = [&](int body) { return body == 0 ? std::string("ground") : numbered("b", body); };
  struct Edge {
    int type, a, b;
  };
  std::vector<Edge> edges;
  for (int b = 1; b < bodies; ++b) edges.push_back({below(8), below(b), b});
  for (int k = below(6); k > 0; --k) {
    const int a = below(bodies), b = below(bodies);
    if (a != b) edges.push_back({below(8), a, b});
  }
  std::shuffle(edges.begin(), edges.end(), random);
  int count = 0;
  for (Edge& edge : edges) {
    if (random() % 2) std::swap(edge.a, edge.b);
    builder.joint(numbered("j", count++), types[edge.type], name(edge.a), name(edge.b));
  }
  for (int k = below(4); k > 0; --k) {
    const int a = below(bodies), b = below(bodies);
    if (a != b) builder.rod(numbered("r", k), name(a), name(b));
  }
  return builder;
}

// Loops, blocks and groups against their definitions, written with the path matrix instead of walks over the tree.
void check_definitions(const Topology& topology) {
  const int n = topology.size();
  const auto row = [&](int i) {
    std::set<int> joints;
    for (int j = 0; j < n; ++j)
      if (on_path(topology, i, j)) joints.insert(j);
    return joints;
  };
  for (const Loop& loop : topology.loops) {
    const std::set<int> a = row(loop.body_from), b = row(loop.body_to);
    Indices difference, common;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(difference));
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    EXPECT_EQ(loop.joints, difference);
    EXPECT_EQ(loop.ancestor, common.empty() ? kGround : common.back());
  }
  std::vector<int> seen(n, 0);
  for (const JointGroup& group : topology.groups) {
    for (int joint : group.joints) {
      ++seen[joint];
      EXPECT_EQ(&topology.groups[topology.group_of[joint]], &group);
      const int parent = topology.bodies[joint].parent;
      if (parent != group.base) {
        EXPECT_EQ(&topology.groups[topology.group_of[parent]], &group);
      }
    }
    EXPECT_LT(group.parent, &group - topology.groups.data());
    EXPECT_EQ(group.parent, group.base == kGround ? -1 : topology.group_of[group.base]);
  }
  EXPECT_EQ(seen, std::vector<int>(n, 1));
  for (const LoopBlock& block : topology.blocks) {
    std::set<int> joints;
    int equations = 0, base = topology.loops[block.loops[0]].ancestor;
    for (int l : block.loops) {
      joints.insert(topology.loops[l].joints.begin(), topology.loops[l].joints.end());
      equations += topology.loops[l].equations;
      base = lowest_common_ancestor(topology, base, topology.loops[l].ancestor);
    }
    EXPECT_EQ(block.joints, Indices(joints.begin(), joints.end()));
    EXPECT_EQ(block.equations, equations);
    EXPECT_EQ(block.base, base);
  }
}

TEST(Blocks, DefinitionsHoldOnRandomGraphs) {
  std::mt19937 random(11);
  int loops = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const ModelBuilder builder = random_mechanism(random);
    const Topology topology = topology_of(builder.model);
    for (int i = 0; i < topology.size(); ++i) EXPECT_LT(topology.bodies[i].parent, i);
    check_definitions(topology);
    loops += static_cast<int>(topology.loops.size());
    const Topology again = topology_of(builder.model);
    EXPECT_EQ(coordinates(again), coordinates(topology));
    EXPECT_EQ(again.cut_reasons, topology.cut_reasons);
  }
  EXPECT_GT(loops, 400);
}

// No other choice of cuts costs fewer equations: every subset of joints that makes a tree is tried.
TEST(Blocks, CutsCostFewestEquationsOfAllTrees) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Model model = random_mechanism(random).model;
    const int joints = static_cast<int>(model.joints.size()), needed = static_cast<int>(model.bodies.size()) - 1;
    if (joints > 14) continue;
    const auto cost = [&](int j) {
      return model.joints[j].type == JointType::free ? 0 : 6 - static_cast<int>(model.joints[j].freedoms.size());
    };
    int fewest = 1000;
    for (int tree = 0; tree < 1 << joints; ++tree) {
      if (__builtin_popcount(static_cast<unsigned>(tree)) != needed) continue;
      Indices root(model.bodies.size());
      for (std::size_t b = 0; b < root.size(); ++b) root[b] = static_cast<int>(b);
      int merged = 0, cut = 0;
      for (int j = 0; j < joints; ++j) {
        if (!(tree >> j & 1)) {
          cut += cost(j);
          continue;
        }
        const int a = root[model.joints[j].from.body], b = root[model.joints[j].to.body];
        merged += a != b;
        std::replace(root.begin(), root.end(), b, a);
      }
      if (merged == needed) fewest = std::min(fewest, cut);
    }
    int found = 0;
    for (const Loop& loop : topology_of(model).loops) found += loop.rod < 0 ? loop.equations : 0;
    EXPECT_EQ(found, fewest) << trial;
  }
}

}  // namespace
}  // namespace mbgen
