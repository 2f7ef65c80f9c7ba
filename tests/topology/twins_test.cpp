// Equal parts of a mechanism, told by its build.

#include "compiler/topology/twins.hpp"

#include "compiler/reader/read_model.hpp"
#include "tests/topology/topology_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

std::string twin_of(const Topology& topology, const std::string& name) {
  const std::vector<int> twin = find_twins(topology);
  for (int i = 0; i < topology.size(); ++i) {
    if (topology.bodies[i].name != name) continue;
    if (twin[i] < 0) return "";
    EXPECT_EQ(twin[twin[i]], i);
    return topology.bodies[twin[i]].name;
  }
  ADD_FAILURE() << name;
  return "";
}

TEST(Twins, AreAxlesAndSeatsWithAllThatMovesOnThem) {
  Result<Model> model = read_model_file(std::string(MBGEN_SOURCE_DIR) + "/models/truck_mechanism.json");
  ASSERT_TRUE(model);
  const Topology topology = topology_of(*model);
  EXPECT_EQ(twin_of(topology, "axle2"), "axle3");
  EXPECT_EQ(twin_of(topology, "axle2_aux4"), "axle3_aux4");
  EXPECT_EQ(twin_of(topology, "v_arm2"), "v_arm3");
  EXPECT_EQ(twin_of(topology, "wheel3_right"), "wheel2_right");
  EXPECT_EQ(twin_of(topology, "wheel4_left"), "wheel5_left");
  EXPECT_EQ(twin_of(topology, "seat_left"), "seat_right");
  EXPECT_EQ(twin_of(topology, "axle1"), "") << "nothing else has leaf springs";
  EXPECT_EQ(twin_of(topology, "wheel1_left"), "") << "the knuckles are in one loop block";
  EXPECT_EQ(twin_of(topology, "frame_rear"), "");
}

TEST(Twins, AreTheFirstTwoOfThreeAndNothingBuiltOtherwise) {
  ModelBuilder builder;
  builder.revolute("hull", "ground", "hull");
  for (const std::string leg : {"a", "b", "c", "d"}) {
    builder.revolute("hip_" + leg, "hull", "thigh_" + leg);
    builder.joint("knee_" + leg, leg == "b" ? JointType::prismatic : JointType::revolute, "thigh_" + leg,
                  "shank_" + leg);
  }
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(twin_of(topology, "shank_a"), "shank_c");
  EXPECT_EQ(twin_of(topology, "thigh_c"), "thigh_a");
  EXPECT_EQ(twin_of(topology, "shank_b"), "") << "it slides";
  EXPECT_EQ(twin_of(topology, "thigh_d"), "") << "the third of three";
}

TEST(Twins, AreCellsClosedAlike) {
  ModelBuilder builder;
  for (const std::string cell : {"1", "2", "3", "4"}) {
    builder.revolute("A" + cell, "ground", "crank" + cell).revolute("B" + cell, "crank" + cell, "coupler" + cell);
    builder.revolute("D" + cell, "ground", "rocker" + cell);
    if (cell == "3")
      builder.rod("rod", "coupler3", "rocker3");
    else
      builder.revolute("C" + cell, "coupler" + cell, "rocker" + cell, CutMark::cut);
  }
  const Topology topology = topology_of(builder.model);
  EXPECT_EQ(twin_of(topology, "coupler1"), "coupler2");
  EXPECT_EQ(twin_of(topology, "rocker2"), "rocker1");
  EXPECT_EQ(twin_of(topology, "rocker3"), "") << "a rod closes it";
  EXPECT_EQ(twin_of(topology, "crank4"), "");
}

}  // namespace
}  // namespace mbgen
