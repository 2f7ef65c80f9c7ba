// SDF: frames, loops, geared joints, against models of mbgen that are written by hand and against closed forms.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/reader/read_model.hpp"
#include "tests/import/import_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

ImportedModel imported_sdf(const std::string& members, const std::string& version = "1.9") {
  return imported_text(
      request_of("robot.sdf", fmt::format("<sdf version='{}'><model name='robot'>{}</model></sdf>", version, members)));
}

/// A link with its centre of mass at a place in its frame.
std::string sdf_link(const std::string& name, const std::string& pose, double mass, const std::string& com,
                     double inertia) {
  return fmt::format(
      "<link name='{0}'><pose>{1}</pose><inertial><pose>{3} 0 0 0</pose><mass>{2}</mass><inertia><ixx>{4}</ixx>"
      "<iyy>{4}</iyy><izz>{4}</izz></inertia></inertial></link>",
      name, pose, mass, com, inertia);
}

/// Accelerations at a position of the coordinates, at rest, in the order of the tree.
std::vector<double> at_rest(const Mechanism& m, const std::vector<std::pair<std::string, double>>& positions) {
  GenericState state{.z = std::vector<double>(m.topology.bodies.size()), .zd = {}, .x = {}, .t = 0};
  state.zd = state.z;
  for (const auto& [name, value] : positions) state.z[index_of(m, name)] = value;
  GenericDerivative derivative;
  const GenericSolver solver(m.model, m.topology, m.analysis);
  EXPECT_TRUE(solver.accelerations(state, std::vector<double>(state.z.size()), derivative).ok());
  return derivative.zdd;
}

TEST(ImportSdf, AFourBarIsTheFourBarOfModels) {
  const ImportedModel sdf = imported("four_bar.sdf");
  EXPECT_EQ(sdf.loops, 1);
  EXPECT_EQ(sdf.format, "SDF");
  EXPECT_TRUE(sdf.notes.empty());
  expect_four_bar_of_models(mechanism_of(sdf.json));
}

/// m g l = (m l^2 + I) zdd, l the way per radian.
TEST(ImportSdf, AScrewFallsByItsPitch) {
  const std::string nut = sdf_link("nut", "0 0 0 0 0 0", 3, "0 0 0", 0.02);
  for (const auto& [pitch, lead] :
       {std::pair("<screw_thread_pitch>0.5</screw_thread_pitch>", 0.5 / (2 * std::numbers::pi)),
        {"<thread_pitch>-8</thread_pitch>", 1 / 8.0}}) {
    const Mechanism m =
        mechanism_of(imported_sdf(nut + "<joint name='s' type='screw'><parent>world</parent><child>nut</child>" +
                                  pitch + "<axis><xyz>0 0 1</xyz></axis></joint>")
                         .json);
    const std::vector<double> zdd = at_rest(m, {});
    const double expected = -3 * 9.81 * lead / (3 * lead * lead + 0.02);
    EXPECT_NEAR(zdd[index_of(m, "s")], expected, 1e-10 * std::abs(expected)) << pitch;
    EXPECT_NEAR(zdd[index_of(m, "s_slide")], lead * expected, 1e-10 * std::abs(expected)) << pitch;
  }
}

/// theta_2 = -r theta_1: a spring on the first wheel turns both, (I1 + r^2 I2) zdd_1 = -k z_1. The joint of the second
/// wheel is written from the wheel to the base, and its axis the other way round.
TEST(ImportSdf, AGearboxCouplesTwoAngles) {
  const ImportedModel model =
      imported_sdf(sdf_link("base", "0 0 0 0 0 0", 5, "0 0 0", 1) + sdf_link("one", "0 0 0 0 0 0", 1, "0 0 0", 0.3) +
                   sdf_link("two", "1 0 0 0 0 0", 1, "0 0 0", 0.1) +
                   "<joint name='hold' type='fixed'><parent>world</parent><child>base</child></joint>"
                   "<joint name='a' type='continuous'><parent>base</parent><child>one</child><axis><xyz>0 0 1</xyz>"
                   "<dynamics><spring_stiffness>7</spring_stiffness></dynamics></axis></joint>"
                   "<joint name='b' type='continuous'><pose relative_to='two'/><parent>two</parent><child>base</child>"
                   "<axis><xyz>0 0 -1</xyz></axis></joint>"
                   "<joint name='g' type='gearbox'><parent>one</parent><child>two</child><axis><xyz>0 0 1</xyz></axis>"
                   "<axis2><xyz>0 0 1</xyz></axis2><gearbox_ratio>4</gearbox_ratio>"
                   "<gearbox_reference_body>base</gearbox_reference_body></joint>");
  EXPECT_NE(model.json.find("\"relation\": \"z.b + 4*z.a\""), std::string::npos) << model.json;
  const Mechanism m = mechanism_of(model.json);
  const double expected = -7 * 0.2 / (0.3 + 16 * 0.1);
  const std::vector<double> zdd = at_rest(m, {{"a", 0.2}, {"b", -0.8}});
  EXPECT_NEAR(zdd[index_of(m, "a")], expected, 1e-10);
  EXPECT_NEAR(zdd[index_of(m, "b")], -4 * expected, 1e-10);
}

/// Two turns one after the other: a universal joint of mbgen is written by itself.
TEST(ImportSdf, AUniversalJointIsTheOneOfTheModel) {
  const Mechanism sdf =
      mechanism_of(imported_sdf(sdf_link("load", "0 0 0 0 0 0", 2, "0.3 0.1 -0.4", 0.05) +
                                "<joint name='u' type='universal'><parent>world</parent><child>load</child>"
                                "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>")
                       .json);
  const Mechanism written = mechanism_of(R"({ "mbgen": 1, "name": "u", "gravity": [0, 0, -9.81],
    "bodies": { "ground": { "points": { "o": [0, 0, 0] } },
      "load": { "mass": 2, "com": [0.3, 0.1, -0.4], "inertia": [0.05, 0.05, 0.05], "points": { "o": [0, 0, 0] } } },
    "joints": { "u": { "type": "universal", "from": "ground.o", "to": "load.o", "axis": "x", "axis2": "y" } } })");
  const std::vector<double> one = at_rest(sdf, {{"u", 0.4}, {"u_2", -0.7}}),
                            other = at_rest(written, {{"u_rx", 0.4}, {"u_ry", -0.7}});
  ASSERT_EQ(one.size(), 2u);
  EXPECT_LT(relative_error(one, other), 1e-12);
}

/// A pendulum on a slanted axis, which three versions of the format write in frames of their own.
TEST(ImportSdf, AxesAreReadInTheFrameOfTheirVersion) {
  const std::string link = sdf_link("arm", "0.2 0 0 0.3 -0.5 0.7", 2, "0.3 0.1 -0.4", 0.05);
  const auto with = [&](const std::string& axis, const std::string& version) {
    return at_rest(
        mechanism_of(
            imported_sdf(link +
                             "<joint name='pin' type='revolute'><pose>0 0 0.1 0.2 0 0</pose><parent>world</parent>"
                             "<child>arm</child><axis>" +
                             axis + "</axis></joint>",
                         version)
                .json),
        {{"pin", 0.3}});
  };
  const std::vector<double> in_model = with("<xyz expressed_in='__model__'>0 1 0</xyz>", "1.10");
  EXPECT_LT(relative_error(with("<xyz>0 1 0</xyz>", "1.4"), in_model), 1e-13);
  EXPECT_LT(
      relative_error(with("<xyz>0 1 0</xyz><use_parent_model_frame>true</use_parent_model_frame>", "1.6"), in_model),
      1e-13);
  const std::vector<double> in_joint = with("<xyz>0 1 0</xyz>", "1.7");
  EXPECT_LT(relative_error(with("<xyz>0 1 0</xyz>", "1.5"), in_joint), 1e-13);
  EXPECT_GT(relative_error(in_joint, in_model), 1e-3);
}

/// Joints without forces close the loops; a mimic is a coupling; ranges become stops; what moves freely is told.
TEST(ImportSdf, ForcesStayOnTheTree) {
  const std::string text = sdf_link("a", "0 0 0 0 0 0", 1, "0 0 0", 1) + sdf_link("b", "1 0 0 0 0 0", 1, "0 0 0", 1) +
                           sdf_link("c", "1 0 1 0 0 0", 1, "0 0 0", 1);
  const auto joint = [](const char* name, const char* type, const char* parent, const char* below, const char* rest) {
    return fmt::format("<joint name='{}' type='{}'><parent>{}</parent><child>{}</child>{}</joint>", name, type, parent,
                       below, rest);
  };
  const char* damped = "<axis><xyz>0 1 0</xyz><dynamics><damping>2</damping><friction>0.1</friction></dynamics></axis>";
  const ImportedModel loop =
      imported_sdf(text + joint("ab", "ball", "a", "b", "") + joint("bc", "revolute", "b", "c", damped) +
                   joint("ca", "revolute", "c", "a", damped));
  EXPECT_EQ(loop.loops, 1);
  EXPECT_NE(loop.json.find("\"ab\": { \"type\": \"spherical\", \"from\": \"a.ab\", \"to\": \"b.ab\", \"cut\": true }"),
            std::string::npos);
  EXPECT_TRUE(has_note(loop, "link \"a\" moves freely: no joint holds it to the world"));
  EXPECT_TRUE(has_note(loop, "friction of 2 joints is smoothed"));
  EXPECT_TRUE(read_model(loop.json, "loop.json"));
  const ImportedModel all =
      imported_sdf(text + joint("ab", "revolute", "a", "b", damped) + joint("bc", "revolute", "b", "c", damped) +
                   joint("ca", "revolute", "c", "a", damped));
  EXPECT_TRUE(has_note(all, "forces and stops of joint \"ca\" are not carried over: it closes a loop"));
  ImportRequest request = request_of(
      "r.sdf",
      "<sdf version='1.11'><model name='r'>" + text +
          joint("wa", "revolute", "world", "a",
                "<axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>2</upper><effort>30</effort></limit></axis>") +
          joint(
              "ab", "revolute", "a", "b",
              "<axis><xyz>0 1 0</xyz><mimic joint='wa'><multiplier>-2</multiplier><offset>0</offset></mimic></axis>") +
          joint(
              "bc", "prismatic", "b", "c",
              "<axis><xyz>0 1 0</xyz><mimic joint='wa'><multiplier>1</multiplier><offset>0.3</offset></mimic></axis>") +
          "</model></sdf>");
  request.stop_stiffness = 1e5;
  const ImportedModel mimic = imported_text(request);
  EXPECT_NE(mimic.json.find("\"relation\": \"z.ab + 2*z.wa\""), std::string::npos) << mimic.json;
  EXPECT_NE(mimic.json.find("// limits -1 .. 2 rad, effort 30 N m"), std::string::npos);
  EXPECT_NE(mimic.json.find("\"wa_upper\": { \"joint\": \"wa\", \"side\": \"above\", \"clearance\": 2"),
            std::string::npos);
  EXPECT_TRUE(has_note(mimic, "joint \"bc\" does not follow \"wa\": it would stand at 0.3"));
  EXPECT_TRUE(read_model(mimic.json, "mimic.json"));
}

TEST(ImportSdf, TellsWhatItLeavesOut) {
  const ImportedModel model =
      imported_text(request_of("world.sdf",
                               "<sdf version='1.6'><world name='w'><gravity>0 0 -1.62</gravity><physics "
                               "type='ode'><max_step_size>0.002</max_step_size></physics>"
                               "<model name='floor'><static>true</static><link name='l'/></model>"
                               "<model name='rover'><pose frame=''>0 0 2 0 0 0</pose><link name='box'><visual "
                               "name='v'><geometry><box><size>1 2 3</size></box></geometry>"
                               "<material><diffuse>1 0 0 1</diffuse></material></visual><collision name='c'/><sensor "
                               "name='s' type='imu'/></link>"
                               "<plugin name='p' filename='q'/><lnik/></model></world></sdf>"));
  EXPECT_EQ(model.name, "rover");
  EXPECT_TRUE(has_note(model, "static models of the world are left out"));
  EXPECT_TRUE(has_note(model, "without <inertial>: \"box\"; the format gives such a link 1 kg"));
  EXPECT_TRUE(has_note(model, "<collision> not carried over: there is no contact"));
  EXPECT_TRUE(has_note(model, "<plugin> not carried over: controllers"));
  EXPECT_TRUE(has_note(model, "<lnik> not carried over: it is unknown in <model>"));
  EXPECT_NE(model.json.find("\"gravity\": [0, 0, -1.62]"), std::string::npos);
  EXPECT_NE(model.json.find("\"step\": 0.002"), std::string::npos);
  EXPECT_NE(model.json.find("\"colour\": \"#ff0000\""), std::string::npos);
  EXPECT_TRUE(read_model(model.json, "rover.json"));
}

/// The four-bar in a file of its own, placed back and forth.
TEST(ImportSdf, AnIncludedModelKeepsItsPlaces) {
  const std::string linkage = content_of(source_path("tests/import/four_bar.sdf")).value();
  ImportRequest request = request_of("robots/cell.sdf",
                                     "<sdf version='1.9'><model name='cell'><pose>-1 2 0 0 0 0</pose><include "
                                     "merge='true'><uri>model://linkage</uri><pose>1 -2 0 0 0 0</pose></include>"
                                     "</model></sdf>");
  request.read = [&](const std::string& path) {
    return path == "linkage/model.sdf" ? std::optional(linkage) : std::nullopt;
  };
  const ImportedModel model = imported_text(request);
  EXPECT_EQ(model.files, (std::vector<std::string>{"robots/cell.sdf", "linkage/model.sdf"}));
  expect_four_bar_of_models(mechanism_of(model.json));
}

/// A pendulum two models deep, turned and placed by a frame, falls as one about its place: m g c sin = (I + m c^2) zdd.
TEST(ImportSdf, NestedModelsAreTakenIntoOne) {
  const Mechanism m = mechanism_of(
      imported_sdf("<model name='arm' placement_frame='mount'><pose>1 0 0 0 0 1.5707963267948966</pose>"
                   "<frame name='mount'><pose>0 0 3 0 0 0</pose></frame><model name='inner'><pose "
                   "relative_to='mount'>0.2 0 0 0 0 0</pose>" +
                   sdf_link("rod", "0 0.1 0 0 0 0", 2, "0.4 0 0", 0.05) +
                   "</model><joint name='pin' type='revolute'><parent>world</parent><child>inner::rod</child><axis>"
                   "<xyz expressed_in='__model__'>0 1 0</xyz></axis></joint></model>")
          .json);
  ASSERT_EQ(m.topology.size(), 1);
  EXPECT_NEAR(at_rest(m, {})[0], 2 * 9.81 * 0.4 / (0.05 + 2 * 0.16), 1e-12);
  ASSERT_EQ(m.model.bodies.size(), 2u);
  EXPECT_EQ(m.model.bodies[1].name, "arm__inner__rod");
  const Vector3 expected = {0.9, 0.2, 0};  // the mount of the arm at (1, 0, 0), turned by a quarter
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(m.model.bodies[1].pose.origin[axis], expected[axis], 1e-12);
}

TEST(ImportSdf, TruthsAreWrittenInFourWays) {
  const auto turned = [](const std::string& attributes) {
    return imported_sdf(fmt::format("<link name='l'><pose {}>0 0 0 90 0 0</pose></link>", attributes)).json;
  };
  const std::string degrees = turned("degrees='true'");
  EXPECT_NE(degrees, turned(""));
  for (const char* yes : {"1", "True", "TRUE"}) EXPECT_EQ(turned(fmt::format("degrees='{}'", yes)), degrees) << yes;
  for (const char* no : {"0", "False", ""}) EXPECT_EQ(turned(fmt::format("degrees='{}'", no)), turned("")) << no;
  EXPECT_FALSE(import_robot(request_of(
      "r.sdf", "<sdf version='1.11'><model name='r'><link name='l'><inertial auto='1'/></link></model></sdf>")));
}

/// A frame of the model moves with its canonical link, by default the first one.
TEST(ImportSdf, FramesOfTheModelMoveWithItsCanonicalLink) {
  const auto end_of = [](const std::string& frame, const std::string& attributes = "") {
    const std::string json =
        imported_text(request_of("m.sdf", fmt::format("<sdf version='1.9'><model name='m'{}>{}", attributes, frame) +
                                              sdf_link("a", "1 0 0 0 0 0", 1, "0 0 0", 1) +
                                              sdf_link("b", "0 0 0 0 0 0", 1, "0 0 0", 1) +
                                              sdf_link("c", "0 0 0 0 0 0", 1, "0 0 0", 1) +
                                              "<joint name='j' type='revolute'><parent>F</parent><child>c</child><axis>"
                                              "<xyz>0 1 0</xyz></axis></joint></model></sdf>"))
            .json;
    const std::size_t start = json.find("\"from\": \"", json.find("\"type\": \"revolute\"")) + 9;
    return json.substr(start, json.find('"', start) - start);
  };
  EXPECT_EQ(end_of("<frame name='F'/>"), "a.j");
  EXPECT_EQ(end_of("<frame name='F' attached_to='__model__'/>"), "a.j");
  EXPECT_EQ(end_of("<frame name='F'><pose relative_to='__model__'/></frame>"), "a.j");
  EXPECT_EQ(end_of("<frame name='F'/>", " canonical_link='b'"), "b.j");
  EXPECT_EQ(end_of("<frame name='F' attached_to='G'/><frame name='G'/>", " canonical_link='b'"), "b.j");
}

/// The axis of a file is read in the frame of its own version, whatever the version of the file around it.
TEST(ImportSdf, AnIncludedFileHasItsOwnVersion) {
  const std::string arm = "<model name='arm'>" + sdf_link("rod", "0 0 0 0 0 0.9", 2, "0.4 0.1 0.2", 0.05) +
                          "<joint name='pin' type='revolute'><pose>0 0 0 0.3 0 0</pose><parent>world</parent>"
                          "<child>rod</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>";
  const auto fall = [&](const std::string& outer, const std::string& version) {
    ImportRequest request = request_of("cell.sdf", "<sdf version='" + outer +
                                                       "'><model name='cell'><include><uri>arm.sdf</uri></include>"
                                                       "</model></sdf>");
    request.read = [&](const std::string&) { return std::optional("<sdf version='" + version + "'>" + arm); };
    return at_rest(mechanism_of(imported_text(request).json), {})[0];
  };
  const auto alone = [&](const std::string& version) {
    return at_rest(mechanism_of(imported_text(request_of("a.sdf", "<sdf version='" + version + "'>" + arm)).json),
                   {})[0];
  };
  EXPECT_GT(std::abs(alone("1.4") - alone("1.9")), 1e-2);
  EXPECT_NEAR(fall("1.4", "1.9"), alone("1.9"), 1e-12);
  EXPECT_NEAR(fall("1.9", "1.4"), alone("1.4"), 1e-12);
  EXPECT_NEAR(fall("1.9", "1.9"), alone("1.9"), 1e-12);
}

/// A chain as long as the file can have it.
TEST(ImportSdf, LongChainsOfFramesAreFollowed) {
  std::string members = "<link name='l'><pose relative_to='f29999'/></link><frame name='f0'/>";
  for (int i = 1; i < 30'000; ++i)
    members += fmt::format(
        "<frame name='f{0}' attached_to='f{1}'><pose relative_to='f{1}'>0 0 0.001 0 0 0</pose></frame>", i, i - 1);
  members += "<joint name='j' type='fixed'><parent>world</parent><child>f29999</child></joint>";
  const ImportedModel model = imported_sdf(members);
  EXPECT_NE(model.json.find("\"j\": { \"type\": \"fixed\", \"from\": \"ground.j\", \"to\": \"l.j\" }"),
            std::string::npos);
  EXPECT_NE(model.json.find("[0, 0, 29.999"), std::string::npos) << model.json;
}

TEST(ImportSdf, AWorldHasGravityAndFramesOfItsOwn) {
  const ImportedModel model = imported_text(request_of(
      "w.sdf",
      "<sdf version='1.9'><world name='w'><frame name='F'><pose>1 0 0 0 0 0</pose></frame><model name='m'><pose "
      "relative_to='F'>0 0 1 0 0 0</pose><link name='l'/></model></world></sdf>"));
  EXPECT_NE(model.json.find("\"gravity\": [0, 0, -9.8]"), std::string::npos);
  EXPECT_TRUE(has_note(model, "the pose of model \"m\" is relative to \"F\", which is not read"));
}

TEST(Import, TheBaseIsOfUrdfAlone) {
  for (const auto& [name, text] :
       {std::pair("m.sdf", "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>"),
        {"m.xml",
         "<mujoco><worldbody><body><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body></worldbody>"
         "</mujoco>"}}) {
    ImportRequest request = request_of(name, text);
    EXPECT_TRUE(import_robot(request));
    for (const RobotBase base : {RobotBase::fixed, RobotBase::floating}) {
      request.base = base;
      const Result<ImportedModel> refused = import_robot(request);
      ASSERT_FALSE(refused);
      EXPECT_NE(to_text(refused.problems()).find("--base is for a URDF robot alone"), std::string::npos);
    }
  }
}

TEST(ImportSdf, MeshesBesideTheFileAreBoxes) {
  ImportRequest request = request_of(
      "robots/cell.sdf",
      "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><pose>0 0 1 0 0 0</pose><geometry><mesh>"
      "<uri>model://parts/meshes/a.stl</uri><scale>2 1 1</scale></mesh></geometry></visual></link></model></sdf>");
  request.read = [&](const std::string& path) -> std::optional<std::string> {
    if (path != "robots/../parts/meshes/a.stl") return std::nullopt;
    return "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 3\nendloop\nendfacet\n"
           "endsolid a\n";
  };
  const ImportedModel model = imported_text(request);
  EXPECT_TRUE(has_note(model, "meshes are drawn as the boxes around them"));
  EXPECT_NE(model.json.find("[2, 2, 4]"), std::string::npos) << model.json;
}

}  // namespace
}  // namespace mbgen
