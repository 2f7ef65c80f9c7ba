// Robots as models: what is in them, loops, names, and files that are refused with their exact texts.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "compiler/algebra/turns.hpp"
#include "compiler/reader/read_model.hpp"
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

TEST(ImportUrdf, AFourBarWithASidecarIsTheFourBarOfModels) {
  expect_four_bar_of_models(mechanism_of(imported("four_bar.urdf", "four_bar_loops.json").json));
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
  // The child's frame is turned by 0.5 rad about x, and its axis is that of the parent there.
  const Mechanism constraint = with(
      "<constraint name='rocker_tip' type='revolute'><parent link='coupler'/><parent_origin xyz='0.32 0 0.2' rpy='0 0 "
      "0.3'/>"
      "<parent_axis xyz='0.29552020666133955 0.955336489125606 0'/><child link='rocker'/>"
      "<child_origin xyz='0.02 0 0.25' rpy='0.5 0 0'/><child_axis xyz='0 0.8775825618903728 "
      "-0.479425538604203'/></constraint>");
  const std::vector<GenericState> states = random_states(sidecar, 3);
  EXPECT_LT(difference(sidecar, constraint, states), 1e-12);
  EXPECT_LT(difference(sidecar, loop_joint, states), 1e-13);
  EXPECT_LT(difference(sidecar, loop, states), 1e-13);
}

TEST(ImportUrdf, TellsWhatItLeavesOut) {
  const ImportedModel model = imported("arm.urdf");
  EXPECT_TRUE(has_note(model, "mesh \"package://arm/pedestal.stl\" is not drawn, no STL file"));
  EXPECT_TRUE(has_note(model, "<collision> not carried over"));
  EXPECT_TRUE(has_note(model, "<limit> (6 of them) not carried over"));
  EXPECT_TRUE(has_note(model, "transmission \"t1\" not carried over: it has not one joint and one actuator"));
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
  EXPECT_TRUE(has_note(model, "motor with a range: a limit that is told and not enforced"));
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

Body body_of_geom(const std::string& attributes) {
  const std::string json = imported_text(request_of("m.xml", "<mujoco><worldbody><body name='b'><joint/><geom " +
                                                                 attributes + "/></body></worldbody></mujoco>"))
                               .json;
  return read_model(json, "m.json")->bodies[1];
}

/// A shell is the solid without the solid that is thinner by a layer all around.
TEST(ImportMjcf, ShellsHaveTheInertiaOfThinWalls) {
  constexpr double layer = 1e-6;
  const auto sized = [](const std::string& type, std::vector<double> size, double less) {
    std::string text = "type='" + type + "' size='";
    for (const double s : size) text += fmt::format("{:.17g} ", s - less);
    return text + "'";
  };
  const std::vector<std::pair<std::string, std::vector<double>>> shapes = {
      {"sphere", {0.2}}, {"box", {0.1, 0.2, 0.4}}, {"cylinder", {0.1, 0.3}}, {"ellipsoid", {0.1, 0.2, 0.3}}};
  for (const auto& [type, size] : shapes) {
    const Body shell = body_of_geom(sized(type, size, 0) + " shellinertia='true' mass='3'");
    const Body area = body_of_geom(sized(type, size, 0) + " shellinertia='true' density='1'");
    const Body outer = body_of_geom(sized(type, size, 0) + " density='1'");
    const Body inner = body_of_geom(sized(type, size, layer) + " density='1'");
    const double wall = outer.mass.value - inner.mass.value;
    // The layer of an ellipsoid, even along its axes, is not even across its surface.
    const double allowed = type == "ellipsoid" ? 0.1 : 2e-5;
    EXPECT_NEAR(area.mass.value * layer / wall, 1, allowed) << type;
    for (int i = 0; i < 3; ++i) {
      const double expected = 3 * (outer.inertia[i].value - inner.inertia[i].value) / wall;
      EXPECT_NEAR(shell.inertia[i].value / expected, 1, 2e-5) << type << i;
    }
  }
  // Area of a prolate spheroid; Thomsen's approximation is off by 1.1 % at most.
  const double eccentricity = std::sqrt(0.75);
  const double spheroid = 2 * std::acos(-1.0) * 0.01 * (1 + 2 / eccentricity * std::asin(eccentricity));
  EXPECT_NEAR(body_of_geom("type='ellipsoid' size='0.1 0.1 0.2' density='1' shellinertia='true'").mass.value / spheroid,
              1, 0.011);
  // A capsule without length is a ball, a long one a tube.
  EXPECT_NEAR(body_of_geom("type='capsule' size='0.2 1e-9' mass='3' shellinertia='true'").inertia[0].value, 0.08, 1e-7);
  EXPECT_NEAR(body_of_geom("type='capsule' size='1e-5 3' mass='2' shellinertia='true'").inertia[0].value, 6, 1e-3);
}

/// Flags of MuJoCo disable parts of a model.
TEST(ImportMjcf, WhatFlagsDisableIsLeftOut) {
  const auto with = [](const std::string& flag) {
    return imported_text(request_of(
        "m.xml",
        "<mujoco><option><flag " + flag +
            "='disable'/></option><worldbody><body><joint name='j' stiffness='3' damping='2' frictionloss='1'/>"
            "<geom size='1'/></body></worldbody><equality><joint joint1='j'/></equality>"
            "<actuator><motor name='m' joint='j'/></actuator></mujoco>"));
  };
  const std::vector<std::pair<std::string, std::string>> cases = {{"passive", "joint_springs"},
                                                                  {"frictionloss", "frictions"},
                                                                  {"equality", "couplings"},
                                                                  {"actuation", "actuators"}};
  for (const auto& [flag, section] : cases) {
    EXPECT_EQ(with(flag).json.find('"' + section + '"'), std::string::npos) << flag;
    EXPECT_NE(with("energy").json.find('"' + section + '"'), std::string::npos) << flag;
    EXPECT_TRUE(has_note(with(flag), "flag " + flag + "=\"disable\": ")) << flag;
  }
}

/// kv = 2 ratio sqrt(kp m), m the inertia at the reference: 0.5 about the axis through the end.
TEST(ImportMjcf, ServosByDampingRatioAndTimeConstant) {
  const ImportedModel model = imported_text(request_of(
      "m.xml",
      "<mujoco><worldbody><body name='b'><joint name='j'/><inertial pos='0.5 0 0' mass='1.2' diaginertia='0.1 0.1 "
      "0.2'/>"
      "</body></worldbody><actuator><position name='p' joint='j' kp='50' dampratio='0.7' timeconst='0.02'/></actuator>"
      "</mujoco>"));
  EXPECT_NE(model.json.find("\"force\": \"50*p_filtered - 50*z.j - 7*zd.j\""), std::string::npos) << model.json;
  EXPECT_NE(model.json.find("\"derivative\": \"(p - p_filtered)/0.02\""), std::string::npos) << model.json;
}

/// Every name that a format does not have is told, with the nearest one, once for all its places.
TEST(Import, TellsNamesThatTheFormatDoesNotHave) {
  const ImportedModel mjcf = imported_text(request_of(
      "m.xml",
      "<mujoco><default><joint dampin='3'/></default><worldbody><body name='b' psi='1'><joint name='j' dampin='3'/>"
      "<goem size='1'/><geom size='1' rgba='1 0 0 1'/></body></worldbody></mujoco>"));
  EXPECT_TRUE(has_note(mjcf, "<joint> has no attribute \"dampin\" in MJCF (2 of them): it is not carried over"));
  EXPECT_TRUE(has_note(mjcf, "<body> has no attribute \"psi\" in MJCF: it is not carried over"));
  EXPECT_TRUE(has_note(mjcf, "<goem> not carried over: it is unknown in <body>"));
  EXPECT_TRUE(has_note(mjcf, "not carried over, without a part in the motion of the model: <geom> rgba"));
  const ImportedModel urdf =
      imported_text(request_of("r.urdf",
                               "<robot name='r' version='1.1'><link name='world'/><link name='a'><interial/></link>"
                               "<joint name='j' type='fixed'><parent link='world'/><child link='a'/>"
                               "<origin xyz='1 0 0' quat_xyzw='0 0 0.6 0.8' ryp='1 2 3'/></joint></robot>"));
  EXPECT_TRUE(has_note(urdf, "<origin> has no attribute \"ryp\" in URDF: it is not carried over"));
  EXPECT_TRUE(has_note(urdf, "<interial> not carried over: it is unknown in <link>"));
  // Twice the arc tangent of 3/4 about z.
  EXPECT_NE(urdf.json.find(fmt::format("\"axis\": \"z\", \"angle\": {:.10}", 2 * std::atan(0.75)).substr(0, 30)),
            std::string::npos)
      << urdf.json;
}

/// Accelerations of two arms of which one turns twice as fast backwards, at rest: (1.5 0.3 + 2 0.8 0.2 -2 ...) by hand
/// in shared/reference/outside3: 3.245038167938928 rad/s^2.
TEST(ImportUrdf, AMimicIsACoupling) {
  const std::string inertial =
      "<inertial><origin xyz='{} 0 0'/><mass value='{}'/><inertia ixx='0.01' iyy='{}' izz='{}' ixy='0' ixz='0' "
      "iyz='0'/></inertial>";
  const std::string robot = "<robot name='mimic'><link name='world'/><link name='a'>" +
                            fmt::format(fmt::runtime(inertial), 0.3, 1.5, 0.05, 0.05) + "</link><link name='b'>" +
                            fmt::format(fmt::runtime(inertial), 0.2, 0.8, 0.02, 0.02) +
                            "</link><joint name='ja' type='continuous'><parent link='world'/><child link='a'/>"
                            "<axis xyz='0 1 0'/></joint><joint name='jb' type='continuous'><parent link='world'/>"
                            "<child link='b'/><origin xyz='1 0 0'/><axis xyz='0 1 0'/>"
                            "<mimic joint='ja' multiplier='-2'/></joint></robot>";
  const Mechanism m = mechanism_of(imported_text(request_of("r.urdf", robot)).json);
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations({.z = {0, 0}, .zd = {0, 0}, .x = {}, .t = 0}, {0, 0}, derivative).ok());
  EXPECT_NEAR(derivative.zdd[index_of(m, "ja")], 3.245038167938928, 1e-12);
  EXPECT_NEAR(derivative.zdd[index_of(m, "jb")], -2 * 3.245038167938928, 1e-12);
}

/// Numbers beyond any length or angle mean no limit; ranges become stops where they are asked for.
TEST(ImportUrdf, LimitsAndStops) {
  const auto robot = [](const std::string& range, double stiffness) {
    ImportRequest request =
        request_of("r.urdf",
                   "<robot name='r'><link name='world'/><link name='a'><inertial><mass value='1'/><inertia ixx='1' "
                   "iyy='1' izz='1' "
                   "ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j' type='revolute'><parent link='world'/>"
                   "<child link='a'/><axis xyz='0 1 0'/><limit " +
                       range + " effort='inf' velocity='2'/></joint></robot>");
    request.stop_stiffness = stiffness;
    return imported_text(request).json;
  };
  for (const char* range : {"lower='-2e19' upper='2e19'", "lower='-inf' upper='inf'", "lower='-1e308' upper='1e309'"}) {
    EXPECT_EQ(robot(range, 100).find("bump_stops"), std::string::npos) << range;
    EXPECT_NE(robot(range, 0).find("// velocity 2 rad/s\n"), std::string::npos) << range;
  }
  const std::string stopped = robot("lower='-0.5' upper='0.6'", 100);
  EXPECT_NE(
      stopped.find("\"j_upper\": { \"joint\": \"j\", \"side\": \"above\", \"clearance\": 0.6, \"stiffness\": 100 }"),
      std::string::npos)
      << stopped;
  EXPECT_NE(
      stopped.find("\"j_lower\": { \"joint\": \"j\", \"side\": \"below\", \"clearance\": 0.5, \"stiffness\": 100 }"),
      std::string::npos)
      << stopped;
  const Mechanism m = mechanism_of(stopped);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations({.z = {0.7}, .zd = {0}, .x = {}, .t = 0}, {0}, derivative).ok());
  EXPECT_NEAR(derivative.zdd[0], -10, 1e-9);
  ASSERT_TRUE(solver.accelerations({.z = {-0.7}, .zd = {0}, .x = {}, .t = 0}, {0}, derivative).ok());
  EXPECT_NEAR(derivative.zdd[0], 20, 1e-9);
}

/// Every bad robot of tests/import/errors is refused with exactly the text beside it; MBGEN_UPDATE=1 rewrites the
/// texts.
TEST(Import, RefusesBadRobotsWithExactMessages) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(source_path("tests/import/errors"))) {
    const fs::path extension = entry.path().extension();
    if (extension != ".urdf" && extension != ".sdf" && extension != ".xml") continue;
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

/// A loop is open because an element is misspelt: the notes name it.
TEST(Import, NotesStandBesideAFailure) {
  const std::string link =
      "<link name='{0}'/><joint name='{0}' type='continuous'><origin xyz='{1}'/><parent link='world'/>"
      "<child link='{0}'/><axis xyz='0 1 0'/></joint>";
  const std::string robot = "<robot name='r'><link name='world'/>" + fmt::format(fmt::runtime(link), "one", "0 0 0") +
                            fmt::format(fmt::runtime(link), "two", "3 0 0") +
                            "<constraint name='c' type='revolute'><parent link='one'/><parent_orign xyz='3 0 1'/>"
                            "<parent_axis xyz='0 1 0'/><child link='two'/><child_origin xyz='0 0 1'/></constraint>"
                            "</robot>";
  Diagnostics notes;
  const Result<ImportedModel> model = import_robot(request_of("r.urdf", robot), &notes);
  ASSERT_FALSE(model);
  EXPECT_NE(to_text(notes).find("<parent_orign> not carried over: it is unknown in <constraint>"), std::string::npos);
  EXPECT_NE(to_text(notes).find("parent_origin"), std::string::npos) << to_text(notes);
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
  for (const char* name : {"arm.urdf", "walker.xml", "linkage.xml", "four_bar.sdf"}) {
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
