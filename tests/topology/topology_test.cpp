// The tree, the loops and the blocks of small models built by hand, all expectations exact.

#include <cmath>

#include "tests/topology/topology_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Names = std::vector<std::string>;
using Indices = std::vector<int>;

// crank_pin, coupler_pin, rocker_pin and rocker_tip, on `base`.
ModelBuilder& add_four_bar(ModelBuilder& builder, const std::string& prefix, const std::string& base) {
  return builder.revolute(prefix + "crank_pin", base, prefix + "crank")
      .revolute(prefix + "coupler_pin", prefix + "crank", prefix + "coupler")
      .revolute(prefix + "rocker_pin", base, prefix + "rocker")
      .revolute(prefix + "rocker_tip", prefix + "coupler", prefix + "rocker");
}

TEST(Tree, ChainHasParentsFirst) {
  ModelBuilder builder;
  builder.revolute("shoulder", "ground", "arm").joint("slide", JointType::prismatic, "arm", "hand");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(body_names(topology), (Names{"arm", "hand"}));
  EXPECT_EQ(coordinates(topology), (Names{"shoulder", "slide"}));
  EXPECT_EQ(parents(topology), (Indices{kGround, 0}));
  EXPECT_EQ(topology.children, (std::vector<Indices>{{1}, {}}));
  EXPECT_EQ(topology.roots, Indices{0});
  EXPECT_EQ(topology.tree_body, (Indices{kGround, 0, 1}));
  EXPECT_EQ(topology.bodies[1].kind, FreedomKind::prismatic);
  EXPECT_EQ(topology.bodies[1].axis, (Vector3{0, 1, 0}));
  EXPECT_TRUE(topology.loops.empty());
  EXPECT_TRUE(topology.blocks.empty());
}

TEST(Tree, AJointWaitsUntilItsParentIsPlaced) {
  ModelBuilder builder;
  builder.revolute("finger", "hand", "finger").revolute("second", "ground", "lamp").revolute("arm", "ground", "arm");
  builder.revolute("hand", "arm", "hand").revolute("third", "ground", "fan");
  EXPECT_EQ(coordinates(topology_of(builder.model)), (Names{"second", "arm", "hand", "finger", "third"}));
}

TEST(Tree, AFreeJointIsAChainWithMasslessBodies) {
  ModelBuilder builder;
  builder.joint("hull", JointType::free, "ground", "hull").revolute("mast", "hull", "mast");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(body_names(topology),
            (Names{"hull_aux1", "hull_aux2", "hull_aux3", "hull_aux4", "hull_aux5", "hull", "mast"}));
  EXPECT_EQ(coordinates(topology), (Names{"hull_tx", "hull_ty", "hull_tz", "hull_rz", "hull_ry", "hull_rx", "mast"}));
  EXPECT_EQ(parents(topology), (Indices{kGround, 0, 1, 2, 3, 4, 5}));
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(topology.bodies[i].massless, i < 5) << i;
    EXPECT_EQ(topology.bodies[i].model_body, i < 5 ? -1 : i - 4) << i;
    EXPECT_EQ(topology.bodies[i].component, i < 6 ? i : 0) << i;
  }
}

// The inverse of R1 R2 R3 is R3(-) R2(-) R1(-): reverse order, negated axes, the user's coordinates and signs.
TEST(Tree, AReversedJointRunsBackwardsWithNegatedAxes) {
  ModelBuilder builder;
  builder.joint("wrist", JointType::spherical, "hand", "arm").revolute("shoulder", "arm", "ground");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(coordinates(topology), (Names{"shoulder", "wrist_rx", "wrist_ry", "wrist_rz"}));
  EXPECT_EQ(body_names(topology), (Names{"arm", "wrist_aux1", "wrist_aux2", "hand"}));
  EXPECT_EQ(topology.bodies[0].axis, (Vector3{0, -1, 0}));
  EXPECT_EQ(topology.bodies[1].axis, (Vector3{-1, 0, 0}));
  EXPECT_EQ(topology.bodies[3].axis, (Vector3{0, 0, -1}));
  EXPECT_FALSE(std::signbit(topology.bodies[3].axis[0]));
  for (const TreeBody& body : topology.bodies) EXPECT_TRUE(body.reversed);
  EXPECT_EQ(topology.bodies[1].component, 2);
  EXPECT_EQ(tree_coordinate(topology, {0, 2}), 1);
  EXPECT_EQ(tree_coordinate(topology, {0, 0}), 3);
}

TEST(Tree, FixedJointsMergeBodies) {
  ModelBuilder builder;
  builder.joint("weld", JointType::fixed, "plate", "wall").joint("bolt", JointType::fixed, "ground", "plate");
  builder.revolute("door", "wall", "door").joint("knob", JointType::fixed, "door", "knob");
  builder.revolute("key", "knob", "key");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(body_names(topology), (Names{"door", "key"}));
  EXPECT_EQ(parents(topology), (Indices{kGround, 0}));
  const auto moves_with = [&](const std::string& name) { return topology.tree_body[builder.body(name)]; };
  EXPECT_EQ(moves_with("plate"), kGround);
  EXPECT_EQ(moves_with("wall"), kGround);
  EXPECT_EQ(moves_with("knob"), moves_with("door"));
  EXPECT_EQ(moves_with("key"), 1);
}

TEST(Tree, MasslessMeansExactlyZeroAndNotTunable) {
  ModelBuilder builder;
  for (const char* name : {"bare", "rotor", "tunable", "carrier", "rod_from", "rod_to"})
    builder.revolute(name, "ground", name).massless(name);
  builder.joint("load", JointType::fixed, "carrier", "load").rod("rod", "rod_from", "rod_to", 0.5);
  builder.rod("light", "bare", "rotor", 0);
  builder.model.bodies[builder.body("rotor")].inertia[1] = 0.1;
  builder.model.bodies[builder.body("tunable")].mass.expression = 0;
  builder.model.expressions.emplace_back();
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(body_names(topology), (Names{"bare", "rotor", "tunable", "carrier", "rod_from", "rod_to"}));
  for (int i = 0; i < 6; ++i) EXPECT_EQ(topology.bodies[i].massless, i == 0) << topology.bodies[i].name;
}

TEST(Loops, FourBarIsCutFarthestFromGround) {
  ModelBuilder builder;
  const Topology topology = topology_of(add_four_bar(builder, "", "ground").model);
  EXPECT_EQ(coordinates(topology), (Names{"crank_pin", "coupler_pin", "rocker_pin"}));
  ASSERT_EQ(topology.loops.size(), 1u);
  const Loop& loop = topology.loops[0];
  EXPECT_EQ(loop.name, "rocker_tip");
  EXPECT_EQ(loop.kind, ClosureKind::revolute);
  EXPECT_EQ(loop.joint, 3);
  EXPECT_EQ(loop.rod, -1);
  EXPECT_EQ(loop.body_from, 1);
  EXPECT_EQ(loop.body_to, 2);
  EXPECT_EQ(loop.ancestor, kGround);
  EXPECT_EQ(loop.joints, (Indices{0, 1, 2}));
  EXPECT_EQ(loop.equations, 5);
  EXPECT_EQ(topology.cut_reasons, Names{"fewest equations (5), then farthest from ground, then last in the file"});
  EXPECT_EQ(tree_coordinate(topology, {3, 0}), -1);
}

TEST(Loops, TheJointWithFewestEquationsIsCut) {
  const std::vector<std::pair<JointType, int>> costs = {{JointType::spherical, 3}, {JointType::planar, 3},
                                                        {JointType::universal, 4}, {JointType::cylindrical, 4},
                                                        {JointType::revolute, 5},  {JointType::prismatic, 5}};
  for (const auto& [type, equations] : costs) {
    ModelBuilder builder;  // declared first and on ground, where ties would keep it
    builder.joint("cheap", type, "ground", "a").joint("weld", JointType::fixed, "a", "b");
    builder.joint("dear", JointType::fixed, "b", "c").joint("last", JointType::fixed, "c", "d");
    builder.revolute("hinge", "ground", "d");
    const Topology topology = topology_of(builder.model);
    ASSERT_EQ(topology.loops.size(), 1u);
    EXPECT_EQ(topology.loops[0].equations, equations);
    EXPECT_EQ(topology.loops[0].name, equations < 5 ? "cheap" : "hinge");
  }
}

TEST(Loops, UsedCoordinatesAndMarksAreKept) {
  ModelBuilder builder;
  builder.joint("ball", JointType::spherical, "ground", "a").revolute("pin", "a", "b").revolute("hinge", "b", "ground");
  EXPECT_EQ(loop_names(topology_of(builder.model)), Names{"ball"});
  EXPECT_EQ(topology_of(builder.model).cut_reasons, Names{"fewest equations (3) in its loop"});

  Model kept = builder.model;
  kept.joints[0].cut = CutMark::tree;
  EXPECT_EQ(loop_names(topology_of(kept)), Names{"pin"});

  Model used = builder.model;
  used.joint_springs.emplace_back();
  used.joint_springs[0].joint = {0, 1};
  used.joint_springs[0].relative_to = CoordinateReference{1, 0};
  EXPECT_EQ(loop_names(topology_of(used)), Names{"hinge"});
  EXPECT_EQ(topology_of(used).cut_reasons, Names{"fewest equations (5) of the joints that need not stay in the tree"});

  Model marked = builder.model;
  marked.joints[1].cut = CutMark::cut;
  EXPECT_EQ(loop_names(topology_of(marked)), Names{"pin"});
  EXPECT_EQ(topology_of(marked).cut_reasons, Names{"marked"});
}

TEST(Loops, EveryReferenceToACoordinateKeepsItsJoint) {
  ModelBuilder builder;
  add_four_bar(builder, "", "ground");
  const CoordinateReference tip{3, 0};
  const std::vector<void (*)(Model&, CoordinateReference)> uses = {
      [](Model& m, CoordinateReference c) { m.motions.emplace_back().joint = c; },
      [](Model& m, CoordinateReference c) { m.frictions.emplace_back().joint = c; },
      [](Model& m, CoordinateReference c) { m.joint_forces.emplace_back().joint = c; },
      [](Model& m, CoordinateReference c) {
        m.initial.positions.push_back({c, 0.1, {}});
      },
      [](Model& m, CoordinateReference c) {
        m.initial.velocities.push_back({c, 0.1, {}});
      },
      [](Model& m, CoordinateReference c) {
        m.outputs.emplace_back().source = CoordinateOutput{{}, c};
      },
      [](Model& m, CoordinateReference c) {
        ExpressionNode node;
        node.kind = ExpressionNode::Kind::velocity;
        node.coordinate = c;
        m.expressions.emplace_back().nodes.push_back(node);
      }};
  for (const auto& use : uses) {
    Model model = builder.model;
    use(model, tip);
    const Topology topology = topology_of(model);
    EXPECT_GE(tree_coordinate(topology, tip), 0);
    EXPECT_EQ(loop_names(topology), Names{"coupler_pin"});
  }
}

// Rails a and b with rungs, rails declared first: the first tree is both rails and one rung, with loops of 3, 5 and 7.
TEST(Loops, TiesAreExchangedUntilLoopsAreShort) {
  ModelBuilder builder;
  builder.revolute("a1", "ground", "a1").revolute("a2", "a1", "a2").revolute("a3", "a2", "a3");
  builder.revolute("b0", "ground", "b0").revolute("b1", "b0", "b1");
  builder.revolute("b2", "b1", "b2").revolute("b3", "b2", "b3");
  builder.revolute("rung1", "a1", "b1").revolute("rung2", "a2", "b2").revolute("rung3", "a3", "b3");
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(topology.loops.size(), 3u);
  for (const Loop& loop : topology.loops) EXPECT_EQ(loop.joints.size(), 3u) << loop.name;
  EXPECT_EQ(loop_names(topology), (Names{"a1", "a2", "rung3"}));
  const std::string exchanged = "fewest equations (5), then shortest loops";
  EXPECT_EQ(topology.cut_reasons,
            (Names{exchanged, exchanged, "fewest equations (5), then farthest from ground, then last in the file"}));
}

TEST(Loops, RodsComeAfterCutJoints) {
  ModelBuilder builder;
  builder.rod("rod", "coupler", "ground", 1);
  const Topology topology = topology_of(add_four_bar(builder, "", "ground").model);
  EXPECT_EQ(loop_names(topology), (Names{"rocker_tip", "rod"}));
  const Loop& rod = topology.loops[1];
  EXPECT_EQ(rod.kind, ClosureKind::rod);
  EXPECT_EQ(rod.rod, 0);
  EXPECT_EQ(rod.joint, -1);
  EXPECT_EQ(rod.equations, 1);
  EXPECT_EQ(names_of(topology, rod.joints), (Names{"crank_pin", "coupler_pin"}));
  EXPECT_EQ(topology.cut_reasons.size(), 1u);
}

TEST(Loops, AFreeJointBetweenConnectedBodiesClosesNothing) {
  ModelBuilder builder;
  builder.joint("free", JointType::free, "ground", "b").revolute("a", "ground", "a").revolute("b", "a", "b");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(coordinates(topology), (Names{"a", "b"}));
  EXPECT_TRUE(topology.loops.empty());
  EXPECT_TRUE(topology.cut_reasons.empty());
}

TEST(Loops, AFixedJointCanCloseALoop) {
  ModelBuilder builder;
  add_four_bar(builder, "", "ground").joint("weld", JointType::fixed, "rocker", "ground", CutMark::cut);
  const Topology topology = topology_of(builder.model);
  ASSERT_EQ(loop_names(topology), (Names{"rocker_tip", "weld"}));
  EXPECT_EQ(topology.loops[1].kind, ClosureKind::fixed);
  EXPECT_EQ(topology.loops[1].equations, 6);
}

// The example of (39): two branches of two bodies on a trunk, numbered from the leaves to the root, the trunk is 5.
TEST(Queries, PathMatrixOfThePapersExample) {
  ModelBuilder builder;
  builder.revolute("trunk", "ground", "trunk");
  builder.revolute("left", "trunk", "left").revolute("left_leaf", "left", "left_leaf");
  builder.revolute("right", "trunk", "right").revolute("right_leaf", "right", "right_leaf");
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(
      path_matrix(topology),
      (std::vector<Indices>{{1, 1, 0, 0, 1}, {0, 1, 0, 0, 1}, {0, 0, 1, 1, 1}, {0, 0, 0, 1, 1}, {0, 0, 0, 0, 1}}));
}

TEST(Queries, PathsAndAncestors) {
  ModelBuilder builder;
  builder.revolute("trunk", "ground", "trunk").revolute("left", "trunk", "left").revolute("leaf", "left", "leaf");
  builder.revolute("right", "trunk", "right").revolute("other", "ground", "other");
  const Topology topology = topology_of(builder.model);
  EXPECT_TRUE(on_path(topology, 2, 0));
  EXPECT_TRUE(on_path(topology, 2, 2));
  EXPECT_FALSE(on_path(topology, 3, 1));
  EXPECT_FALSE(on_path(topology, 0, 2));
  EXPECT_FALSE(on_path(topology, kGround, 0));
  EXPECT_FALSE(on_path(topology, 0, kGround));
  EXPECT_EQ(lowest_common_ancestor(topology, 2, 3), 0);
  EXPECT_EQ(lowest_common_ancestor(topology, 2, 1), 1);
  EXPECT_EQ(lowest_common_ancestor(topology, 2, 4), kGround);
  EXPECT_EQ(lowest_common_ancestor(topology, kGround, 3), kGround);
  EXPECT_EQ(path_to(topology, 2, kGround), (Indices{2, 1, 0}));
  EXPECT_EQ(path_to(topology, 2, 0), (Indices{2, 1}));
  EXPECT_TRUE(path_to(topology, 2, 2).empty());
  EXPECT_EQ(find_coordinate(topology, "right"), 3);
  EXPECT_EQ(find_coordinate(topology, "nowhere"), -1);
}

}  // namespace
}  // namespace mbgen
