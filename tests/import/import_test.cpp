// Robots as models: what is in them, loops, names, and files that are refused with their exact texts.

#include <filesystem>

#include "compiler/algebra/turns.hpp"
#include "tests/import/import_support.hpp"
#include "tests/support/expected_text.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;
using namespace mbgen::testing;

std::string messages_of(const ImportRequest& request) {
  const Result<ImportedModel> model = import_robot(request);
  return model ? "" : to_text(model.problems());
}

bool has_note(const ImportedModel& model, const std::string& part) {
  return std::any_of(model.notes.begin(), model.notes.end(),
                     [&](const Diagnostic& note) { return note.message.find(part) != std::string::npos; });
}

std::size_t index_of(const Mechanism& m, const std::string& coordinate) {
  for (std::size_t i = 0; i < m.topology.bodies.size(); ++i)
    if (m.topology.bodies[i].coordinate == coordinate) return i;
  throw std::runtime_error("no coordinate " + coordinate);
}

/// Largest difference of the accelerations that two models have at the same states of the first.
double difference(const Mechanism& a, const Mechanism& b, const std::vector<GenericState>& states) {
  const GenericSolver one(a.model, a.topology, a.analysis), other(b.model, b.topology, b.analysis);
  double error = 0;
  for (const GenericState& state : states) {
    GenericState moved{.z = state.z, .zd = state.zd, .x = {}, .t = state.t};
    for (std::size_t i = 0; i < state.z.size(); ++i) {
      const std::size_t to = index_of(b, a.topology.bodies[i].coordinate);
      moved.z[to] = state.z[i];
      moved.zd[to] = state.zd[i];
    }
    GenericDerivative first, second;
    EXPECT_TRUE(one.accelerations(state, std::vector<double>(state.z.size()), first).ok());
    EXPECT_TRUE(other.accelerations(moved, std::vector<double>(state.z.size()), second).ok());
    std::vector<double> mapped;
    for (std::size_t i = 0; i < state.z.size(); ++i)
      mapped.push_back(second.zdd[index_of(b, a.topology.bodies[i].coordinate)]);
    error = std::max(error, relative_error(mapped, first.zdd));
  }
  return error;
}

TEST(ImportUrdf, AFourBarWithASidecarIsTheFourBarOfModels) {
  const Mechanism robot = mechanism_of(imported("four_bar.urdf", "four_bar_loops.json").json);
  Model model = *read_model_file(source_path("models/four_bar.json"));
  model.springs.clear();
  model.outputs.clear();
  for (Joint& joint : model.joints)
    if (joint.name == "rocker_tip") joint.cut = CutMark::cut;
  const Mechanism written = analysed(Result<Model>(model));
  const std::vector<GenericState> states = random_states(robot, 5);
  ASSERT_EQ(states.size(), 5u);
  EXPECT_LT(difference(robot, written, states), 1e-11);
}

TEST(ImportUrdf, ALinkOfTwoParentsClosesALoop) {
  const ImportedModel model = imported("two_parents.urdf", "two_parents_loops.json");
  EXPECT_EQ(model.loops, 1);
  EXPECT_TRUE(has_note(model, "link \"far_pin\" is the child of joints \"eye\" and \"tip\": the latter closes a loop"));
  const Mechanism m = mechanism_of(model.json);
  EXPECT_EQ(m.topology.size(), 3);
  EXPECT_EQ(random_states(m, 3).size(), 3u);
}

/// The ends of a <loop_joint> or <loop> are two frames, as the sidecar's are.
TEST(ImportUrdf, ExtensionsCloseTheSameLoopAsTheSidecar) {
  const std::string urdf = content_of(source_path("tests/import/four_bar.urdf")).value();
  const auto with = [&](const std::string& loop) {
    std::string text = urdf;
    return mechanism_of(imported_text(request_of("robot.urdf", text.insert(text.rfind("</robot>"), loop))).json);
  };
  const Mechanism sidecar = mechanism_of(imported("four_bar.urdf", "four_bar_loops.json").json);
  const Mechanism loop_joint = with(
      "<loop_joint name='rocker_tip' type='revolute'><link1 link='coupler' xyz='0.32 0 0.2' rpy='0 0 0'/>"
      "<link2 link='rocker' xyz='0.02 0 0.25'/><axis xyz='0 1 0'/></loop_joint>");
  const Mechanism loop = with(
      "<loop name='rocker_tip' type='continuous'><predecessor link='coupler'><origin xyz='0.32 0 0.2'/></predecessor>"
      "<successor link='rocker'><origin xyz='0.02 0 0.25'/></successor><axis xyz='0 1 0'/></loop>");
  const std::vector<GenericState> states = random_states(sidecar, 3);
  EXPECT_LT(difference(sidecar, loop_joint, states), 1e-13);
  EXPECT_LT(difference(sidecar, loop, states), 1e-13);
}

TEST(ImportUrdf, TellsWhatItLeavesOut) {
  const ImportedModel model = imported("arm.urdf");
  EXPECT_TRUE(has_note(model, "mesh \"package://arm/pedestal.stl\" is not drawn, no STL file"));
  EXPECT_TRUE(has_note(model, "<collision> not carried over"));
  EXPECT_TRUE(has_note(model, "<limit> (6 of them) not carried over"));
  EXPECT_TRUE(has_note(model, "<transmission> not carried over"));
  EXPECT_NE(model.json.find("\"right\": { \"relation\": \"z.right - z.left\" }"), std::string::npos);
  EXPECT_TRUE(has_note(model, "friction of 1 joint is smoothed below 0.001 rad/s or m/s"));
  EXPECT_EQ(model.bodies, 9);
  EXPECT_EQ(model.joints, 9);
}

TEST(ImportUrdf, TheBaseIsFixedUnlessItFloats) {
  ImportRequest request = request_of("r.urdf",
                                     "<robot name='r'><link name='base'><inertial><mass value='2'/><inertia ixx='1' "
                                     "iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>");
  const Result<Model> fixed = read_model(imported_text(request).json, "r.json");
  ASSERT_TRUE(fixed) << to_text(fixed.problems());
  EXPECT_EQ(fixed->joints[0].type, JointType::fixed);
  EXPECT_TRUE(has_note(imported_text(request), "root link \"base\" is fixed to the ground"));
  request.base = RobotBase::floating;
  EXPECT_EQ(mechanism_of(imported_text(request).json).topology.size(), 6);
}

TEST(ImportUrdf, NamesBecomeValidAndStayApart) {
  const ImportedModel model = imported_text(request_of(
      "names.urdf",
      "<robot name='7 axes'><link name='world'/><link name='a b'/><link name='a_b'/><link name='ground'/><link "
      "name='\xC3\xA4'/>"
      "<joint name='j-1' type='fixed'><parent link='world'/><child link='a b'/></joint>"
      "<joint name='j 1' type='floating'><parent link='a b'/><child link='a_b'/></joint>"
      "<joint name='j_1_2_tx' type='fixed'><parent link='a b'/><child link='ground'/></joint>"
      "<joint name='" +
          std::string(90, 'x') + "' type='fixed'><parent link='a b'/><child link='\xC3\xA4'/></joint></robot>"));
  const Result<Model> read = read_model(model.json, "names.json");
  ASSERT_TRUE(read) << to_text(read.problems());
  EXPECT_EQ(read->name, "_7_axes");
  std::vector<std::string> names;
  for (const Body& body : read->bodies) names.push_back(body.name);
  EXPECT_EQ(names, (std::vector<std::string>{"ground", "a_b", "a_b_2", "ground_2", "__"}));
}

TEST(ImportMjcf, TellsWhatItLeavesOut) {
  const ImportedModel model = imported("walker.xml");
  EXPECT_TRUE(has_note(model, "<light> not carried over"));
  EXPECT_TRUE(has_note(model, "actuator with a range: it is not enforced"));
  EXPECT_TRUE(has_note(model, "joint with a range (2 of them): limits are not enforced"));
  EXPECT_TRUE(has_note(model, "<sensor> not carried over"));
  EXPECT_EQ(model.files, (std::vector<std::string>{"walker.xml", "walker_parts.xml"}));
  const ImportedModel loops = imported("linkage.xml");
  EXPECT_TRUE(has_note(loops, "<connect> is not active: it is left out"));
  EXPECT_EQ(loops.loops, 3);
}

/// An input that is named like a function of expressions could not be used in one.
TEST(ImportMjcf, InputsAreNotNamedLikeFunctions) {
  for (const char* name : {"step", "select", "pow", "t", "z", "pi", "atan2"}) {
    const ImportedModel model = imported_text(request_of(
        "m.xml",
        "<mujoco><worldbody><body><joint name='j'/><geom size='1'/></body></worldbody><actuator><motor name='" +
            std::string(name) + "' joint='j' gear='3'/></actuator></mujoco>"));
    EXPECT_TRUE(read_model(model.json, "m.json")) << name;
  }
}

/// Frames are of MuJoCo 3; their content moves with them.
TEST(ImportMjcf, AFramePlacesWhatIsInIt) {
  const auto read = [](const std::string& world) {
    return mechanism_of(
        imported_text(request_of("m.xml", "<mujoco><worldbody>" + world + "</worldbody></mujoco>")).json);
  };
  const Mechanism framed = read(
      "<frame pos='1 0 0' euler='0 0 90'><body pos='0 2 0'><joint name='j' axis='1 0 0'/>"
      "<geom type='box' size='0.1 0.2 0.3' pos='0.1 0 0.4'/></body></frame>");
  const Mechanism plain = read(
      "<body pos='-1 0 0' euler='0 0 90'><joint name='j' axis='1 0 0'/>"
      "<geom type='box' size='0.1 0.2 0.3' pos='0.1 0 0.4'/></body>");
  EXPECT_LT(difference(framed, plain, random_states(framed, 3)), 1e-12);
}

/// Every bad robot of tests/import/errors is refused with exactly the text beside it; MBGEN_UPDATE=1 rewrites the
/// texts.
TEST(Import, RefusesBadRobotsWithExactMessages) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(source_path("tests/import/errors"))) {
    const fs::path extension = entry.path().extension();
    if (extension != ".urdf" && extension != ".xml") continue;
    fs::path text = entry.path(), sidecar = entry.path();
    ImportRequest request = request_of(entry.path().filename().string(), content_of(entry.path()).value());
    request.loops = content_of(sidecar.replace_extension(".json"));
    request.loops_file = sidecar.filename().string();
    request.read = [&](const std::string& path) { return content_of((entry.path().parent_path() / path).string()); };
    const std::string actual = messages_of(request);
    EXPECT_NE(actual, "") << entry.path();
    expect_text(text.replace_extension(".txt"), actual);
    ++cases;
  }
  EXPECT_GE(cases, 25);
}

TEST(Import, HostileXmlIsRefused) {
  std::string deep;
  for (int i = 0; i < 1'000'000; ++i) deep += "<a>";
  EXPECT_NE(messages_of(request_of("deep.xml", deep)), "");
  std::string closed = deep;
  for (int i = 0; i < 1'000'000; ++i) closed += "</a>";
  EXPECT_EQ(messages_of(request_of("deep.xml", closed)),
            "deep.xml:1:770: elements are nested deeper than 256 levels\n");
  // Entities are not expanded, so that none can grow.
  const std::string laughs =
      "<!DOCTYPE r [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;'>]><robot name='&b;'><link name='&b;'/></robot>";
  EXPECT_EQ(messages_of(request_of("laughs.urdf", laughs)), "");
  EXPECT_NE(messages_of(request_of("large.xml", std::string((std::size_t{64} << 20) + 1, ' '))), "");
  std::string bytes(4096, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 37);
  EXPECT_NE(messages_of(request_of("bytes.xml", bytes)), "");
}

/// Every beginning of a good file, and the file with single bytes changed, is imported or refused; what is imported can
/// be read.
TEST(Import, BrokenFilesAreImportedOrRefused) {
  for (const char* name : {"arm.urdf", "walker.xml", "linkage.xml"}) {
    const std::string good = content_of(source_path(std::string("tests/import/") + name)).value();
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
      std::string bad = good.substr(0, i % 3 == 0 ? random() % good.size() : good.size());
      for (int change = 0; change < i % 3 && !bad.empty(); ++change)
        bad[random() % bad.size()] = " 0-9<>\"=/azAZ.e"[random() % 15];
      const Result<ImportedModel> model = import_robot(request_of(name, bad));
      if (!model) continue;
      const Result<Model> read = read_model(model->json, "broken.json");
      EXPECT_TRUE(read) << to_text(read.problems()) << bad;
    }
  }
}

TEST(Turns, TakeOneDirectionToTheOther) {
  using Eigen::Vector3d;
  const std::vector<Vector3d> directions = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0},   {-2, 0, 0},    {0, -3, 0},
                                            {0, 1, 0}, {1, 2, -2}, {-1, -2, 2}, {1e-9, 0, -1}, {0, 1e-5, -1}};
  for (const Vector3d& from : directions) {
    for (const Vector3d& to : directions) {
      const Eigen::Quaterniond turn = shortest_turn(from, to);
      EXPECT_NEAR(turn.norm(), 1, 1e-15);
      EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-15)
          << from.transpose() << " to " << to.transpose();
    }
  }
  // MuJoCo turns about x, which decides the frames of bodies with zaxis="0 0 -1".
  EXPECT_EQ(std::abs(shortest_turn(Vector3d::UnitZ(), -Vector3d::UnitZ()).x()), 1);
}

}  // namespace
}  // namespace mbgen
