// Good models: parameters, bodies, poses, joints and the names and axes of their freedoms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/model/inputs.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

constexpr double kRounding = 1e-15;  // a few operations on numbers of order 1

void expect_vector(const Vector3& actual, const Vector3& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], kRounding) << "component " << i;
}

std::string freedom_names(const Joint& joint) {
  std::string names;
  for (const Freedom& freedom : joint.freedoms) names += (names.empty() ? "" : " ") + freedom.name;
  return names;
}

/// The joint of joint_model.
Joint read_joint(const std::string& joint, const std::string& pose = "{}") {
  const Model model = read(joint_model(joint, pose));
  return model.joints.empty() ? Joint{} : model.joints[0];
}

TEST(Parameters, NumbersExpressionsDegreesAndObjects) {
  const Model model = read(arm_model(R"("parameters": { "a": 2, "b": "3*a^2", "c": { "deg": 180 },
    "d": { "value": { "deg": -90 }, "unit": "rad", "tunable": true }, "e": { "value": "b/a" } })"));
  ASSERT_EQ(model.parameters.size(), 5u);
  EXPECT_EQ(model.parameters[1].value, 12);
  EXPECT_EQ(model.parameters[2].value, std::numbers::pi);
  EXPECT_EQ(model.parameters[3].value, -std::numbers::pi / 2);
  EXPECT_TRUE(model.parameters[3].tunable);
  EXPECT_FALSE(model.parameters[4].tunable);
  EXPECT_EQ(model.parameters[4].value, 6);
  EXPECT_EQ(model.parameters[3].unit, "rad");
  EXPECT_TRUE(model.expressions.empty()) << "constants fold";
}

TEST(Inputs, Defaults) {
  const Model model = read(arm_model(R"("inputs": { "push": {}, "steer": { "unit": "rad", "default": 0.25 } })"));
  EXPECT_EQ(model.inputs[0].default_value, 0);
  EXPECT_EQ(model.inputs[1].default_value, 0.25);
  EXPECT_EQ(model.inputs[1].unit, "rad");
  EXPECT_EQ(model.inputs[1].derivative, -1);
}

TEST(Inputs, DerivativesNameInputsInAnyOrder) {
  const Model model = read(arm_model(R"("inputs": {
    "rate": { "derivative": "acceleration" }, "left": { "derivative": "rate" }, "right": { "derivative": "rate" },
    "acceleration": {}, "push": {} })"));
  ASSERT_EQ(model.inputs.size(), 5u);
  EXPECT_EQ(model.inputs[0].derivative, 3);
  EXPECT_EQ(model.inputs[1].derivative, 0);
  EXPECT_EQ(model.inputs[2].derivative, 0);
  EXPECT_EQ(model.inputs[3].derivative, -1);
  EXPECT_TRUE(inputs_have_derivatives(model.inputs));
  // rate 3, acceleration 4 after half a second: 1 + 3/2 + 4/8, and 3 + 4/2.
  EXPECT_EQ(advanced_inputs(model.inputs, {3, 1, 2, 4, 7}, 0.5), (std::vector<double>{5, 3, 4, 4, 7}));
}

TEST(Inputs, AdvanceByEveryDerivativeTheyHave) {
  const Model model = read(arm_model(R"("inputs": {
    "u": { "derivative": "u1" }, "u1": { "derivative": "u2" }, "u2": { "derivative": "u3" }, "u3": {} })"));
  // u = t^3 at t = 2, two seconds later: every derivative is that of the same cubic.
  EXPECT_EQ(advanced_inputs(model.inputs, {8, 12, 12, 6}, 2), (std::vector<double>{64, 48, 24, 6}));
}

TEST(Model, Defaults) {
  const Model model = read(arm_model(""));
  EXPECT_EQ(model.gravity[0].value, 0);
  EXPECT_EQ(model.gravity[2].value, -9.81);
  EXPECT_EQ(model.ground, 0);
  EXPECT_EQ(model.solver.integrator, SolverSettings::Integrator::rk4);
  EXPECT_EQ(model.solver.step, 1e-3);
  EXPECT_EQ(model.solver.duration, 1);
  EXPECT_EQ(model.solver.closure_tolerance, 1e-12);
  EXPECT_FALSE(model.initial.equilibrium);
  EXPECT_EQ(read(joint_model(R"("type": "fixed")")).ground, 0);
}

TEST(Model, WithoutGroundIsFineWhenNothingRefersToIt) {
  const Model model = read(R"({ "mbgen": 1, "bodies": { "rock": { "mass": 1, "inertia": [1, 1, 1] } } })");
  EXPECT_EQ(model.ground, -1);
  EXPECT_EQ(model.bodies.size(), 1u);
}

TEST(Bodies, MassInertiaAndPlace) {
  const Model model = read(R"({ "mbgen": 1,
  "parameters": { "m": { "value": 3, "tunable": true } },
  "bodies": {
    "massless": {},
    "point_mass": { "mass": 2, "inertia": [0, 0, 0] },
    "full": { "mass": "2*m", "com": [1, "m", 3], "inertia": [2, 2.5, 3, 0.1, 0.2, 0.3],
      "points": { "P": ["m^2", 0, -1] } } } })");
  ASSERT_EQ(model.bodies.size(), 3u);
  EXPECT_EQ(model.bodies[0].mass.value, 0);
  EXPECT_EQ(model.bodies[1].mass.value, 2);
  const Body& full = model.bodies[2];
  EXPECT_EQ(full.mass.value, 6);
  ASSERT_GE(full.mass.expression, 0);
  EXPECT_EQ(model.expressions[static_cast<std::size_t>(full.mass.expression)].text, "2*m");
  EXPECT_EQ(full.com[1].value, 3);
  EXPECT_EQ(full.com[0].expression, -1);
  const std::array<double, 6> inertia{2, 2.5, 3, 0.1, 0.2, 0.3};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(full.inertia[i].value, inertia[i]);
  EXPECT_EQ(full.points[0].position[0].value, 9);
  EXPECT_EQ(full.where.line, 6);
  EXPECT_EQ(full.where.column, 5);
  EXPECT_EQ(full.where.pointer, "/bodies/full");
  EXPECT_EQ(full.where.line_text.substr(0, 11), "    \"full\":");
}

TEST(Bodies, InertiaOfARodAndOfADiscStandOnTheTriangleInequality) {
  // A thin rod has a zero moment about its axis, a thin disc the sum of the other two: both are allowed exactly.
  EXPECT_EQ(messages(R"({ "mbgen": 1, "bodies": { "rod": { "mass": 1, "inertia": [0, 1, 1] } } })"), "");
  EXPECT_EQ(messages(R"({ "mbgen": 1, "bodies": { "disc": { "mass": 1, "inertia": [0.1, 0.2, 0.3] } } })"), "");
  // The disc turned by 30 deg about x: yy = 0.2 c^2 + 0.3 s^2, zz = 0.2 s^2 + 0.3 c^2, yz = -0.1 s c.
  EXPECT_EQ(messages(R"({ "mbgen": 1, "bodies": { "disc": { "mass": 1,
    "inertia": [0.1, 0.225, 0.275, 0, 0, -0.04330127018922193] } } })"),
            "");
  EXPECT_NE(messages(R"({ "mbgen": 1, "bodies": { "no": { "mass": 1, "inertia": [0.1, 0.2, 0.3000001] } } })"), "");
}

TEST(Poses, RotationsMultiplyFromTheLeft) {
  const Model model = read(R"({ "mbgen": 1, "bodies": {
    "one": { "pose": { "origin": [1, 2, 3], "rotation": { "axis": "z", "angle": { "deg": 90 } } } },
    "two": { "pose": { "rotation": [ { "axis": "z", "angle": "pi/2" },
      { "axis": [2, 0, 0], "angle": { "deg": 90 } } ] } },
    "three": { "pose": { "rotation": { "axis": [1, 1, 1], "angle": { "deg": 120 } } } } } })");
  expect_vector(model.bodies[0].pose.origin, {1, 2, 3});
  const auto expect_matrix = [](const Matrix3& actual, const Matrix3& expected) {
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(actual[i], expected[i], kRounding) << "entry " << i;
  };
  expect_matrix(model.bodies[0].pose.rotation, {0, -1, 0, 1, 0, 0, 0, 0, 1});
  expect_matrix(model.bodies[1].pose.rotation, {0, 0, 1, 1, 0, 0, 0, 1, 0});  // Rz Rx
  expect_matrix(model.bodies[2].pose.rotation, {0, 0, 1, 1, 0, 0, 0, 1, 0});  // x to y to z to x
}

TEST(Joints, NamesOfFreedoms) {
  const auto names = [](const std::string& joint) { return freedom_names(read_joint(joint)); };
  EXPECT_EQ(names(R"("type": "revolute", "axis": "x")"), "j");
  EXPECT_EQ(names(R"("type": "prismatic", "axis": [1, 1, 0])"), "j");
  EXPECT_EQ(names(R"("type": "cylindrical", "axis": "-y")"), "j_ty j_ry");
  EXPECT_EQ(names(R"("type": "cylindrical", "axis": [0, 1, 1])"), "j_tz j_rz");
  EXPECT_EQ(names(R"("type": "universal", "axis": "z", "axis2": [0, -3, 0])"), "j_rz j_ry");
  EXPECT_EQ(names(R"("type": "universal", "axis": "z", "axis2": [1, 1, 0])"), "j_r1 j_r2");
  EXPECT_EQ(names(R"("type": "spherical")"), "j_rz j_ry j_rx");
  EXPECT_EQ(names(R"("type": "spherical", "sequence": "zxy")"), "j_rz j_rx j_ry");
  EXPECT_EQ(names(R"("type": "planar", "axis": "z")"), "j_tx j_ty j_rz");
  EXPECT_EQ(names(R"("type": "planar", "axis": "x")"), "j_ty j_tz j_rx");
  EXPECT_EQ(names(R"("type": "planar", "axis": "-y")"), "j_tz j_tx j_ry");
  EXPECT_EQ(names(R"("type": "planar", "axis": [1, 2, 3])"), "j_t1 j_t2 j_rz");
  EXPECT_EQ(names(R"("type": "free")"), "j_tx j_ty j_tz j_rz j_ry j_rx");
  EXPECT_EQ(names(R"("type": "free", "sequence": "xyz")"), "j_tx j_ty j_tz j_rx j_ry j_rz");
  EXPECT_EQ(names(R"("type": "fixed")"), "");
}

TEST(Joints, AxesAreUnitAndGlobal) {
  const std::string pose = R"({ "rotation": { "axis": "z", "angle": { "deg": 90 } } })";  // body x is global y
  const Joint revolute = read_joint(R"("type": "revolute", "axis": [3, 0, 4], "axis_to": [3, 0, 4])", pose);
  expect_vector(revolute.axis, {0, 0.6, 0.8});
  expect_vector(revolute.freedoms[0].axis, {0, 0.6, 0.8});
  const Joint universal = read_joint(R"("type": "universal", "axis": "x", "axis2": "y")", pose);
  expect_vector(universal.axis, {0, 1, 0});
  expect_vector(universal.second_axis, {-1, 0, 0});
  expect_vector(universal.freedoms[1].axis, {-1, 0, 0});
  const Joint free = read_joint(R"("type": "free")", pose);
  expect_vector(free.freedoms[0].axis, {0, 1, 0});
  expect_vector(free.freedoms[1].axis, {-1, 0, 0});
  expect_vector(free.freedoms[5].axis, {0, 1, 0});
  EXPECT_EQ(free.freedoms[2].kind, FreedomKind::prismatic);
  EXPECT_EQ(free.freedoms[3].kind, FreedomKind::revolute);
}

TEST(Joints, SkewPlanarHasARightHandedFrame) {
  const Joint joint = read_joint(R"("type": "planar", "axis": [1, 2, 2])");
  ASSERT_EQ(joint.freedoms.size(), 3u);
  const Vector3 &u = joint.freedoms[0].axis, &v = joint.freedoms[1].axis;
  expect_vector({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]},
                {1 / 3., 2 / 3., 2 / 3.});
  EXPECT_NEAR(u[0] * v[0] + u[1] * v[1] + u[2] * v[2], 0, kRounding);
  EXPECT_NEAR(std::hypot(u[0], u[1], u[2]), 1, kRounding);
}

TEST(Joints, CutMarks) {
  EXPECT_EQ(read_joint(R"("type": "fixed")").cut, CutMark::automatic);
  EXPECT_EQ(read_joint(R"("type": "fixed", "cut": true)").cut, CutMark::cut);
  EXPECT_EQ(read_joint(R"("type": "fixed", "cut": false)").cut, CutMark::tree);
}

TEST(Joints, CloseWithinAMicrometre) {
  const auto model = [](const std::string& x) {
    return R"({ "mbgen": 1, "bodies": { "a": { "points": { "P": [0, 0, 0] } }, "b": { "points": { "P": [)" + x +
           R"(, 0, 0] } } }, "joints": { "j": { "type": "fixed", "from": "a.P", "to": "b.P" } } })";
  };
  EXPECT_EQ(messages(model("0.99e-6")), "");
  EXPECT_NE(messages(model("1.01e-6")).find("are 1.01e-06 m apart"), std::string::npos);
}

TEST(Joints, AnUnreadableJointDoesNotMakeItsCoordinatesUnknown) {
  const std::string text =
      messages(joint_model(R"("type": "hinge")").substr(0, joint_model(R"("type": "hinge")").size() - 2) +
               R"(, "joint_forces": { "f": { "joint": "j_rz", "force": "z.j" } } })");
  EXPECT_EQ(text.find("unknown"), std::string::npos) << text;
  EXPECT_NE(text.find("must be one of revolute"), std::string::npos) << text;
}

}  // namespace
}  // namespace mbgen
