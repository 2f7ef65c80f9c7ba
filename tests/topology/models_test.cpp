// The models of the project: the paper's counts, the reference's joint order, closure of the reference configurations.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "tests/topology/topology_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Names = std::vector<std::string>;

std::string source_path(const std::string& relative) { return std::string(MBGEN_SOURCE_DIR) + "/" + relative; }

Model model_of(const std::string& relative) {
  Result<Model> model = read_model_file(source_path(relative));
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

struct Counts {
  int bodies_with_ground, massless, joints, tree, cut, equations, rods;
  bool operator==(const Counts&) const = default;
};

Counts counts(const Topology& topology) {
  Counts result{topology.size() + 1, 0, topology.size(), topology.size(), 0, 0, 0};
  for (const TreeBody& body : topology.bodies) result.massless += body.massless;
  for (const Loop& loop : topology.loops) {
    ++(loop.rod < 0 ? result.cut : result.rods);
    result.equations += loop.equations;
  }
  result.joints += result.cut;
  return result;
}

Names reference_order(const std::string& file) {
  std::ifstream stream(source_path("tests/data/reference/" + file));
  return nlohmann::json::parse(stream).at("joint_order").get<Names>();
}

TEST(Models, CoachHasThePapersCounts) {
  const Topology topology = topology_of(model_of("models/coach_mechanism.json"));
  EXPECT_EQ(counts(topology), (Counts{33, 14, 34, 32, 2, 17, 11}));
  EXPECT_EQ(coordinates(topology), reference_order("coach_states.json"));
  EXPECT_EQ(topology.cut_reasons, (Names{"marked", "marked"}));
  ASSERT_EQ(topology.blocks.size(), 2u);
  EXPECT_EQ(topology.blocks[0].joints.size(), 14u);
  EXPECT_EQ(topology.blocks[0].equations, 11);
  EXPECT_EQ(topology.blocks[1].joints.size(), 8u);
  EXPECT_EQ(topology.blocks[1].equations, 6);
  for (const LoopBlock& block : topology.blocks) EXPECT_EQ(topology.bodies[block.base].name, "chassis");
}

TEST(Models, TruckHasThePapersCounts) {
  const Topology topology = topology_of(model_of("models/truck_mechanism.json"));
  EXPECT_EQ(counts(topology), (Counts{81, 34, 89, 80, 9, 51, 18}));
  EXPECT_EQ(coordinates(topology), reference_order("truck_states.json"));
  Names bases;
  for (const LoopBlock& block : topology.blocks) bases.push_back(topology.bodies[block.base].name);
  EXPECT_EQ(bases, (Names{"frame", "cab", "cab", "frame", "frame_rear", "frame_rear", "trailer_rear", "trailer_rear",
                          "trailer_rear"}));
}

// With the marks gone the same balls and pins are cut: they are the cheapest of their loops.
TEST(Models, CoachNeedsNoMarks) {
  Model model = model_of("models/coach_mechanism.json");
  for (Joint& joint : model.joints) joint.cut = CutMark::automatic;
  EXPECT_EQ(counts(topology_of(model)), (Counts{33, 14, 34, 32, 2, 17, 11}));
}

TEST(Models, EveryModelHasATopology) {
  for (const char* folder : {"models", "models/iftomm", "models/published", "models/rides", "tests/data/models"}) {
    for (const auto& entry : std::filesystem::directory_iterator(source_path(folder))) {
      if (entry.path().extension() != ".json") continue;
      const Result<Model> model = read_model_file(entry.path().string());
      ASSERT_TRUE(model) << to_text(model.problems());
      const Result<Topology> topology = build_topology(*model);
      EXPECT_TRUE(topology) << to_text(topology.problems());
    }
  }
}

// Points of joints coincide at the reference to rounding, far below the reader's tolerance of 1e-6 m.
TEST(Models, ReferenceConfigurationsCloseToRounding) {
  for (const char* path :
       {"models/andrews_squeezer.json", "models/slider_crank.json", "models/coach_mechanism.json",
        "models/truck_mechanism.json", "tests/data/models/skew_tree.json", "models/iftomm/a05_flyball_governor.json"}) {
    const Model model = model_of(path);
    const auto place = [&](const Attachment& at) {
      const Body& body = model.bodies[at.body];
      Vector3 world = body.pose.origin;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) world[i] += body.pose.rotation[3 * i + k] * body.points[at.point].position[k].value;
      return world;
    };
    for (const Joint& joint : model.joints) {
      const Vector3 from = place(joint.from), to = place(joint.to);
      EXPECT_LT(std::hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]), 1e-15) << path << " " << joint.name;
    }
  }
}

}  // namespace
}  // namespace mbgen
