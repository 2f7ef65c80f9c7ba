// Anti-roll bars: each stands for two half bars, the torsion between them and two droplinks.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/model/element_access.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

/// Two slides, and a bar between them with these fields.
std::string bar_between_slides(const std::string& fields, const std::string& points = R"("pivot": "pivot", "arm": "arm",
    "link": "link")") {
  return R"({ "mbgen": 1, "name": "slides",
    "parameters": { "k": { "value": 900, "tunable": true } },
    "hardpoints": { "pivot": [0, 0.4, 0.3], "arm": [-0.25, 0.5, 0.3], "link": [-0.25, 0.55, 0.5] },
    "bodies": { "ground": { "points": { "left": [0, 0.6, 0.5], "right": [0, -0.6, 0.5] } },
      "left": { "mass": 1, "inertia": [0, 0, 0], "points": { "guide": [0, 0.6, 0.5] } },
      "right": { "mass": 1, "inertia": [0, 0, 0], "points": { "guide": [0, -0.6, 0.5] } } },
    "joints": { "left": { "type": "prismatic", "from": "ground.left", "to": "left.guide", "axis": "z" },
      "right": { "type": "prismatic", "from": "ground.right", "to": "right.guide", "axis": "z" } },
    "anti_roll_bars": { "bar": { "body": "ground", "left": "left", "right": "right", )" +
         points + ", " + fields + " } } }";
}

double stiffness_of(const std::string& fields) {
  const Model model = read(bar_between_slides(fields));
  return std::get<Quantity>(*model.joint_springs.front().stiffness).value;
}

TEST(AntiRollBars, StandForHalfBarsTorsionAndDroplinks) {
  const Model model = read(bar_between_slides(R"("stiffness": "k", "damping": 3, "link_mass": 0.4)"));
  ASSERT_EQ(model.joints.size(), 4u);
  for (const std::size_t side : {0, 1}) {
    const Joint& joint = model.joints[2 + side];
    EXPECT_EQ(joint.name, side == 0 ? "bar_left" : "bar_right");
    EXPECT_EQ(joint.type, JointType::revolute);
    EXPECT_EQ(joint.axis, (Vector3{0, 1, 0}));
    EXPECT_EQ(reference_position(model, joint.from), (Vector3{0, side == 0 ? 0.4 : -0.4, 0.3}));
    EXPECT_EQ(reference_position(model, joint.to), (Vector3{0, side == 0 ? 0.4 : -0.4, 0.3}));
    const Rod& rod = model.rods[side];
    EXPECT_EQ(rod.name, side == 0 ? "bar_link_left" : "bar_link_right");
    EXPECT_EQ(rod.mass.value, 0.4);
    EXPECT_EQ(reference_position(model, rod.from), (Vector3{-0.25, side == 0 ? 0.5 : -0.5, 0.3}));
    EXPECT_EQ(reference_position(model, rod.to), (Vector3{-0.25, side == 0 ? 0.55 : -0.55, 0.5}));
    EXPECT_EQ(model.bodies[static_cast<std::size_t>(rod.to.body)].name, side == 0 ? "left" : "right");
  }
  const JointSpring& spring = model.joint_springs.front();
  EXPECT_EQ(spring.name, "bar");
  EXPECT_EQ(spring.joint.joint, 2);
  EXPECT_EQ(spring.relative_to->joint, 3);
  EXPECT_GE(std::get<Quantity>(*spring.stiffness).expression, 0);
  EXPECT_EQ(std::get<Quantity>(*spring.damping).value, 3);
}

// Of a droplink the lever is 0.25 m times the cosine of its slope; of a round tube G J / L.
TEST(AntiRollBars, TakeTheirStiffnessFromDroplinkOrCrossSection) {
  const double lever = 0.25 * 0.2 / std::hypot(0.2, 0.05);
  EXPECT_NEAR(stiffness_of(R"("link_stiffness": 30e3)"), 30e3 * lever * lever, 1e-9);
  const double polar = std::numbers::pi / 32 * (std::pow(0.024, 4) - std::pow(0.016, 4));
  EXPECT_NEAR(stiffness_of(R"("section": { "diameter": 0.024, "inner_diameter": 0.016 })"), 79.3e9 * polar / 0.8, 1e-9);
  EXPECT_NEAR(
      stiffness_of(R"("section": { "diameter": 0.024, "inner_diameter": 0.016, "length": 1, "shear_modulus": 80e9 })"),
      80e9 * polar, 1e-9);
}

// A thin rod of 0.4 m along y and an arm of hypot(0.25, 0.1) m.
TEST(AntiRollBars, HaveTheInertiaOfAThinRod) {
  const Model model = read(bar_between_slides(R"("stiffness": 900, "mass": 3)"));
  const double axis = 0.4, arm = std::hypot(0.25, 0.1), whole = axis + arm, m1 = 1.5 * axis / whole,
               m2 = 1.5 * arm / whole;
  const double x = m2 * -0.125 / 1.5, y = (m1 * 0.2 + m2 * 0.45) / 1.5;
  const double xx = m1 * (0.16 / 12 + std::pow(0.2 - y, 2)) + m2 * (0.01 / 12 + std::pow(0.45 - y, 2));
  const double yy = m1 * x * x + m2 * (0.0625 / 12 + std::pow(-0.125 - x, 2));
  const double xy = -(m1 * x * (y - 0.2) + m2 * (-0.025 / 12 + (x + 0.125) * (y - 0.45)));
  for (const std::size_t side : {0, 1}) {
    const Body& body = model.bodies[3 + side];
    const double s = side == 0 ? 1 : -1;
    EXPECT_EQ(body.name, side == 0 ? "bar_left" : "bar_right");
    EXPECT_EQ(body.mass.value, 1.5);
    EXPECT_NEAR(body.com[0].value, x, 1e-15);
    EXPECT_NEAR(body.com[1].value, s * y, 1e-15);
    EXPECT_NEAR(body.com[2].value, 0.3, 1e-15);
    EXPECT_NEAR(body.inertia[0].value, xx, 1e-15);
    EXPECT_NEAR(body.inertia[1].value, yy, 1e-15);
    EXPECT_NEAR(body.inertia[2].value, xx + yy, 1e-15);
    EXPECT_NEAR(body.inertia[3].value, s * xy, 1e-15);
  }
}

TEST(AntiRollBars, OfTwoSidesThatDifferHaveTheirAxisThroughBothPivots) {
  const Model model = read(
      bar_between_slides(R"("right_pivot": [0, -0.4, 0.36], "right_link": [-0.25, -0.55, 0.6], "stiffness": 900)"));
  const double length = std::hypot(0.8, 0.06);
  for (const std::size_t joint : {2, 3}) {
    EXPECT_NEAR(model.joints[joint].axis[1], 0.8 / length, 1e-15);
    EXPECT_NEAR(model.joints[joint].axis[2], -0.06 / length, 1e-15);
  }
  EXPECT_EQ(reference_position(model, model.rods[1].from), (Vector3{-0.25, -0.5, 0.3}));
  EXPECT_EQ(reference_position(model, model.rods[1].to), (Vector3{-0.25, -0.55, 0.6}));
}

}  // namespace
}  // namespace mbgen
