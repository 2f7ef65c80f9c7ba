// Robots as their files really are: inertias that no rigid body has, loops that do not quite close, looks.

#include <fmt/format.h>

#include <Eigen/Core>

#include "compiler/reader/read_model.hpp"
#include "tests/import/import_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

std::string notes_of(const ImportedModel& model) {
  std::string text;
  for (const Diagnostic& note : model.notes)
    text += fmt::format("{}:{}: {}\n", note.where.line, note.where.column, note.message);
  return text;
}

const Body& body_of(const Model& model, const std::string& name) {
  return *std::find_if(model.bodies.begin(), model.bodies.end(), [&](const Body& body) { return body.name == name; });
}

TEST(ImportRealRobots, WhatMovesAsOneDecidesOnAnInertia) {
  const ImportedModel robot = imported("legged.urdf");
  EXPECT_EQ(
      notes_of(robot),
      "9:33: link \"stand\": inertia breaks the triangle inequality, principal moments 0.01, 0.01, 0.9; it is fixed "
      "to the ground, where that has no effect\n"
      "16:6: <visual> is a box turned in its link: the smallest box around it along the link's axes is drawn\n"
      "19:36: link \"imu_link\": inertia breaks the triangle inequality, principal moments 1e-06, 1e-06, 0.001; "
      "together "
      "with the bodies that are fixed to it, it is the inertia of a rigid body\n"
      "23:8: link \"shank\": inertia breaks the triangle inequality, principal moments 0.01, 0.01, 0.05; it is taken "
      "as it is\n"
      "27:6: link \"shank\": mesh \"package://legged/shank.stl\" is not drawn, no STL file of this name lies beside\n"
      "33:6: <limit> not carried over: limits are not enforced, they stand beside the joints as comments\n");
  const Result<Model> model = read_model(robot.json, "legged.json");
  ASSERT_TRUE(model) << to_text(model.problems());
  EXPECT_EQ(model->notes.size(), 3u) << to_text(model->notes);
}

TEST(ImportRealRobots, AnInertiaThatNoBodyHasIsTakenAsItIs) {
  const Mechanism m = mechanism_of(imported("legged.urdf").json);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  // The trunk stands still in its prismatic joint's direction at knee 0: the leg hangs straight. Turned by 0.4 rad and
  // pushed along z so that the trunk does not move, the knee falls as a pendulum does.
  GenericState state{.z = {0, 0.4}, .zd = {0, 0}, .x = {}, .t = 0};
  ASSERT_EQ(m.topology.bodies[1].coordinate, "knee");
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations(state, std::vector<double>(2), derivative).ok());
  // (trunk + shank) a + shank (l sin) q'' = -g (trunk + shank), (I + m l^2) q'' + m l sin a = -m g l sin: both fall at
  // g.
  EXPECT_NEAR(derivative.zdd[0], -9.81, 1e-9);
  EXPECT_NEAR(derivative.zdd[1], 0, 1e-9);
  std::vector<double> moment = {0, 1};
  ASSERT_TRUE(solver.accelerations(state, moment, derivative).ok());
  const double mass = 2, length = 0.15, inertia = 0.05, total = 17 + 0.01 + 2, lever = mass * length * std::sin(0.4);
  EXPECT_NEAR(derivative.zdd[1], 1 / (inertia + mass * length * length - lever * lever / total), 1e-9);
}

TEST(ImportRealRobots, OnlyAnIndefiniteMassMatrixIsRefused) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = content_of(source_path("tests/import/legged.urdf")).value();
    text.replace(text.find(from), from.size(), to);
    return import_robot(request_of("legged.urdf", text));
  };
  EXPECT_TRUE(with("izz=\"0.9\"", "izz=\"-0.9\"")) << "the stand cannot move";
  EXPECT_TRUE(with("izz=\"1e-3\"", "izz=\"-1e-3\"")) << "the trunk's inertia is larger";
  const Result<ImportedModel> shank = with("iyy=\"0.05\"", "iyy=\"-0.05\"");
  ASSERT_FALSE(shank);
  EXPECT_EQ(shank.problems().front().message,
            "link \"shank\": inertia is not positive semidefinite, principal moments -0.05, 0.01, 0.01");
}

TEST(ImportRealRobots, MjcfInertiasAreTakenAlike) {
  const ImportedModel model = imported_text(request_of(
      "r.xml",
      "<mujoco><worldbody><body name=\"a\"><joint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 3\"/></body>"
      "</worldbody></mujoco>"));
  EXPECT_NE(notes_of(model).find("body \"a\": inertia breaks the triangle inequality, principal moments 1, 1, 3; it is "
                                 "taken as it is"),
            std::string::npos)
      << notes_of(model);
  EXPECT_TRUE(read_model(model.json, "r.json"));
}

TEST(ImportRealRobots, LooksBecomeShapes) {
  const Model model = *read_model(imported("legged.urdf").json, "legged.json");
  ASSERT_EQ(model.shapes.size(), 5u);
  const auto at = [&](const Attachment& end) {
    const auto& p = model.bodies[end.body].points[end.point].position;
    return Eigen::Vector3d(p[0].value, p[1].value, p[2].value);
  };
  const auto& [stand, trunk, turned, shin, foot] =
      std::tie(model.shapes[0], model.shapes[1], model.shapes[2], model.shapes[3], model.shapes[4]);
  EXPECT_EQ(stand.kind, DisplayShape::Kind::box);
  EXPECT_EQ(stand.rgb, (std::array<int, 3>{51, 51, 64}));
  EXPECT_TRUE(at(stand.from).isApprox(Eigen::Vector3d(-0.1, -0.05, 0), 1e-12));
  EXPECT_TRUE(at(trunk.from).isApprox(Eigen::Vector3d(-0.2, -0.1, -0.075), 1e-12));
  EXPECT_TRUE(at(trunk.to).isApprox(Eigen::Vector3d(0.4, 0.1, 0.075), 1e-12));
  const double half = 0.05 * (std::cos(0.3) + std::sin(0.3));
  EXPECT_TRUE(at(turned.to).isApprox(Eigen::Vector3d(0.05, half, half), 1e-12));
  EXPECT_EQ(shin.kind, DisplayShape::Kind::cylinder);
  EXPECT_EQ(shin.rgb, (std::array<int, 3>{255, 128, 0}));
  EXPECT_EQ(shin.radius, 0.03);
  EXPECT_TRUE(at(shin.from).isApprox(Eigen::Vector3d(0, 0, -0.3), 1e-12));
  EXPECT_EQ(foot.kind, DisplayShape::Kind::sphere);
  EXPECT_FALSE(foot.has_colour);
  EXPECT_EQ(body_of(model, "shank").name, model.bodies[foot.from.body].name);
}

TEST(ImportRealRobots, ALoopThatIsOpenByMillimetresIsAssembled) {
  const ImportedModel robot = imported("nearly_closed.urdf");
  const std::string notes = notes_of(robot);
  EXPECT_NE(notes.find("loops are open by up to 0.00"), std::string::npos) << notes;
  EXPECT_NE(notes.find("joints are moved to close them, \"crank_pin\" by "), std::string::npos) << notes;
  EXPECT_NE(notes.find("; 0.0005 m that no joint closes are taken up by the points of the loops"), std::string::npos)
      << notes;
  const Mechanism m = mechanism_of(robot.json);  // the reader refuses loops that are open at the reference
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
}

TEST(ImportRealRobots, ALoopThatIsWideOpenIsClosedWhereItsJointsReach) {
  std::string text = content_of(source_path("tests/import/nearly_closed.urdf")).value();
  text.replace(text.find("0 0 0.147"), 9, "0 0 0.120");
  const ImportedModel robot = imported_text(request_of("open.urdf", text));
  EXPECT_NE(notes_of(robot).find("loops are open by up to 0.0"), std::string::npos) << notes_of(robot);
  EXPECT_EQ(mechanism_of(robot.json).analysis.degrees_of_freedom, 1);
  text.replace(text.find("0 0 0.120"), 9, "0 0 2.120");
  const Result<ImportedModel> far = import_robot(request_of("far.urdf", text));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.problems().front().message.find("loop \"tip\" does not close, its ends are "), 0u)
      << to_text(far.problems());
  EXPECT_NE(far.problems().front().message.find("within their limits, "), std::string::npos);
}

/// One link that shows a mesh twice, and a file beside it.
ImportedModel with_mesh(const std::string& content) {
  ImportRequest request =
      request_of("robot.urdf",
                 "<robot name='r'><link name='base'>"
                 "<visual><origin xyz='0 0 1' rpy='0 0 1.5707963267948966'/><geometry>"
                 "<mesh filename='package://r/meshes/part.stl' scale='1e-3 1e-3 -1e-3'/></geometry></visual>"
                 "<visual><geometry><mesh filename='package://r/meshes/part.stl'/></geometry></visual>"
                 "</link></robot>");
  request.read = [content](const std::string& path) -> std::optional<std::string> {
    if (path != "part.stl") return std::nullopt;  // by its name alone
    return content;
  };
  return imported_text(request);
}

TEST(ImportRealRobots, MeshesBecomeTheBoxAroundThem) {
  const std::string ascii =
      "solid part\nfacet normal 0 0 1\nouter loop\nvertex 100 -20 0\nvertex 0 40 3e1\nvertex 5 5 "
      "-1.5\nendloop\nendfacet\n"
      "endsolid part\n";
  std::string binary(80, ' ');  // of the same triangle
  const std::uint32_t count = 1;
  const float numbers[12] = {0, 0, 1, 100, -20, 0, 0, 40, 30, 5, 5, -1.5F};
  binary.append(reinterpret_cast<const char*>(&count), sizeof(count));
  binary.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  binary.append(2, '\0');
  for (const std::string& content : {ascii, binary}) {
    const ImportedModel robot = with_mesh(content);
    EXPECT_EQ(notes_of(robot),
              "1:18: root link \"base\" is fixed to the ground\n1:36: link \"base\": mesh "
              "\"package://r/meshes/part.stl\" is drawn as the box around it\n");
    const Result<Model> model = read_model(robot.json, "r.json");
    ASSERT_TRUE(model) << to_text(model.problems());
    ASSERT_EQ(model->shapes.size(), 2u);
    // Millimetres, mirrored in z, turned by a right angle about z, 1 m up: x runs along -y of the mesh.
    const Vector3 from = reference_position(*model, model->shapes[0].from);
    const Vector3 to = reference_position(*model, model->shapes[0].to);
    const double least[] = {-0.04, 0, 0.97}, most[] = {0.02, 0.1, 1.0015};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(from[i], least[i], 1e-9) << i;
      EXPECT_NEAR(to[i], most[i], 1e-9) << i;
    }
  }
  for (const std::string& content : {binary.substr(0, 130), std::string("solid part\nvertex 1 2 nan\n"),
                                     std::string("solid part\nvertex 1 2"), std::string("v 1 2 3\n"), std::string()}) {
    EXPECT_NE(notes_of(with_mesh(content)).find("is not drawn, no STL file of this name lies beside"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace mbgen
