// Every failure of build_topology with its exact message, hint and place.

#include "tests/topology/topology_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

void expect_problem(const Diagnostic& problem, const std::string& pointer, const std::string& message,
                    const std::string& hint) {
  EXPECT_EQ(problem.where.pointer, pointer);
  EXPECT_EQ(problem.where.file, "test.json");
  EXPECT_EQ(problem.message, message);
  EXPECT_EQ(problem.hint, hint);
}

TEST(TopologyErrors, BodiesWithoutAPathToGround) {
  ModelBuilder builder;
  builder.revolute("hinge", "ground", "door").revolute("pin", "left", "right").body("alone");
  builder.revolute("late", "door", "tail", CutMark::cut);
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 3u);
  expect_problem(problems[0], "/bodies/left", "body \"left\" has no path to ground",
                 "add a joint, for example of type free from ground; 1 more body on its island");
  expect_problem(problems[1], "/bodies/alone", "body \"alone\" has no path to ground",
                 "add a joint, for example of type free from ground");
  expect_problem(problems[2], "/bodies/tail", "body \"tail\" has no path to ground",
                 "joint \"late\" is marked \"cut\": true and holds no body");
}

TEST(TopologyErrors, ABodyThatOnlyEquationsHold) {
  ModelBuilder builder;
  builder.revolute("line", "ground", "slider");
  builder.model.joints[0].type = JointType::point_on_line;
  builder.model.joints[0].freedoms.clear();
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 1u);
  expect_problem(problems[0], "/bodies/slider", "body \"slider\" has no path to ground",
                 "joint \"line\" of type point_on_line has no coordinates: add the joint that the body moves by, for "
                 "example of type free from ground");
}

TEST(TopologyErrors, NoElementRefersToGround) {
  ModelBuilder builder;
  builder.revolute("pin", "left", "right");
  builder.model.ground = -1;
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.back().message, "body \"left\" has no path to ground");
}

TEST(TopologyErrors, MarkedJointsThatFormACycle) {
  ModelBuilder builder;
  builder.revolute("a", "ground", "a", CutMark::tree).revolute("b", "a", "b", CutMark::tree);
  builder.revolute("c", "ground", "b", CutMark::tree);
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 1u);
  expect_problem(problems[0], "/joints/b",
                 "joint \"b\" is marked \"cut\": false but closes a loop: body \"b\" would have two parents",
                 "leave one joint of the loop without the mark");
}

TEST(TopologyErrors, AUsedCoordinateOfACutJoint) {
  ModelBuilder builder;
  builder.revolute("a", "ground", "a").revolute("b", "a", "b").revolute("c", "ground", "b", CutMark::cut);
  Motion motion;
  motion.name = "drive";
  motion.joint = {2, 0};
  builder.model.motions = {motion};
  Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 1u);
  const std::string message =
      "joint \"c\" closes a loop, so its coordinate \"c\" does not exist, but it is used by motion drive";
  expect_problem(problems[0], "/joints/c", message,
                 "take the mark \"cut\": true away or mark another joint of the loop");

  builder.model.joints[2].cut = CutMark::automatic;
  EXPECT_TRUE(problems_of(builder.model).empty());

  builder.model.joints[0].cut = builder.model.joints[1].cut = CutMark::tree;
  problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 1u);
  expect_problem(problems[0], "/joints/c", message,
                 "every other joint of the loop is used or marked too; free one of them");
}

TEST(TopologyErrors, AMultiplierOfAJointInTheTree) {
  ModelBuilder builder;
  builder.revolute("a", "ground", "a").revolute("b", "a", "b").revolute("c", "ground", "b", CutMark::cut);
  const auto ask = [&](int joint) {
    builder.model.outputs = {{"push", {"test.json", 7, 1, "/outputs/push"}, "N", MultiplierOutput{joint, -1, 0}}};
    return problems_of(builder.model);
  };
  EXPECT_TRUE(ask(2).empty());
  const Diagnostics problems = ask(1);
  ASSERT_EQ(problems.size(), 1u);
  expect_problem(problems[0], "/outputs/push",
                 "output \"push\" asks for a multiplier of joint \"b\", which is in the tree and has none",
                 "ask for its \"reaction\", or mark the joint \"cut\": true");
}

TEST(TopologyErrors, LoopsInWhichNothingMoves) {
  ModelBuilder builder;
  builder.joint("post", JointType::fixed, "ground", "post").revolute("arm", "post", "arm");
  builder.joint("pad", JointType::fixed, "arm", "pad");
  builder.revolute("extra", "pad", "arm", CutMark::cut).rod("strut", "post", "ground").rod("tie", "pad", "arm");
  builder.rod("ring", "arm", "arm");
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 4u);
  const std::string hint = "remove it, or one of the fixed joints between them";
  expect_problem(
      problems[0], "/joints/extra",
      "joint \"extra\" closes a loop in which nothing moves: bodies \"pad\" and \"arm\" are fixed to each other", hint);
  expect_problem(
      problems[1], "/rods/strut",
      "rod \"strut\" closes a loop in which nothing moves: bodies \"post\" and \"ground\" are fixed to each other",
      hint);
  expect_problem(problems[2], "/rods/tie",
                 "rod \"tie\" closes a loop in which nothing moves: bodies \"pad\" and \"arm\" are fixed to each other",
                 hint);
  expect_problem(problems[3], "/rods/ring", "rod \"ring\" has both ends on body \"arm\"", "connect two bodies");
}

TEST(TopologyErrors, NothingMoves) {
  ModelBuilder builder;
  builder.joint("post", JointType::fixed, "ground", "post");
  builder.model.file = "test.json";
  const Diagnostics problems = problems_of(builder.model);
  ASSERT_EQ(problems.size(), 1u);
  expect_problem(problems[0], "", "the model has no joint that moves a body", "add a body and a joint");
}

}  // namespace
}  // namespace mbgen
