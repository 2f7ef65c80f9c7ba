// Anti-roll bar: angles, torque and forces against their closed forms, by the generic runtime and by a judge.
#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class AntiRollBar : public CommandLine {};

constexpr double kArm = 0.25, kLink = 0.2, kStiffness = 1500;

/// Travel of a droplink's end that moves along z, over the angle of its arm: the droplink tilts by the arc of the arm.
double travel(double angle) {
  const double aside = kArm * (1 - std::cos(angle));
  return kArm * std::sin(angle) - kLink + std::sqrt(kLink * kLink - aside * aside);
}

/// d travel / d angle, m.
double lever(double angle) {
  const double aside = kArm * (1 - std::cos(angle));
  return kArm * std::cos(angle) - aside * kArm * std::sin(angle) / std::sqrt(kLink * kLink - aside * aside);
}

double angle_of(double wanted) {
  double angle = wanted / kArm;
  for (int k = 0; k < 50; ++k) angle -= (travel(angle) - wanted) / lever(angle);
  return angle;
}

const char* const kSlides = R"({
  "mbgen": 1,
  "name": "anti_roll_bar",
  "gravity": [0, 0, 0],
  "parameters": { "left_travel": 0.06, "right_travel": -0.03 },
  "hardpoints": { "bar_pivot": [0, 0.4, 0.3], "bar_arm": [-0.25, 0.5, 0.3], "bar_link": [-0.25, 0.5, 0.5] },
  "bodies": {
    "ground": { "points": { "left": [0, 0.6, 0.5], "right": [0, -0.6, 0.5] } },
    "left_slide":  { "mass": 1, "com": [0, 0.6, 0.5], "inertia": [0, 0, 0], "points": { "guide": [0, 0.6, 0.5] } },
    "right_slide": { "mass": 1, "com": [0, -0.6, 0.5], "inertia": [0, 0, 0], "points": { "guide": [0, -0.6, 0.5] } }
  },
  "joints": {
    "left_slide":  { "type": "prismatic", "from": "ground.left", "to": "left_slide.guide", "axis": "z" },
    "right_slide": { "type": "prismatic", "from": "ground.right", "to": "right_slide.guide", "axis": "z" }
  },
  "anti_roll_bars": {
    "bar": { "body": "ground", "left": "left_slide", "right": "right_slide",
      "pivot": "bar_pivot", "arm": "bar_arm", "link": "bar_link", "stiffness": 1500 }
  },
  "motions": {
    "left":  { "joint": "left_slide", "position": "left_travel*t" },
    "right": { "joint": "right_slide", "position": "right_travel*t" }
  },
  "outputs": {
    "left_angle":  { "joint": "bar_left" },
    "right_angle": { "joint": "bar_right" },
    "left_force":  { "motion": "left" },
    "right_force": { "motion": "right" },
    "left_link":   { "reaction": "bar_link_left", "quantity": "force", "axis": "z" },
    "stored":      { "joint_spring": "bar", "quantity": "potential_energy" }
  },
  "solver": { "step": 0.01, "duration": 1 }
})";

// The slides move by 60 and -30 mm: the bar's torque is k times the difference of the angles, and a droplink's end
// feels the torque over the lever.
TEST_F(AntiRollBar, HasTheForcesOfItsClosedForm) {
  write("bar.json", kSlides);
  const double left = angle_of(0.06), right = angle_of(-0.03), torque = kStiffness * (left - right);
  for (const std::string engine : {"generic", "maggi"}) {
    const Outcome run = mbgen("simulate bar.json --engine " + engine + " --out bar.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Table result = table("bar.csv");
    EXPECT_NEAR(result.last("left_angle [rad]"), left, 1e-10) << engine;
    EXPECT_NEAR(result.last("right_angle [rad]"), right, 1e-10) << engine;
    EXPECT_NEAR(result.last("left_force [N]"), torque / lever(left), 1e-6) << engine;
    EXPECT_NEAR(result.last("right_force [N]"), -torque / lever(right), 1e-6) << engine;
    EXPECT_NEAR(result.last("left_link [N]"), -torque / lever(left), 1e-6) << engine;
    EXPECT_NEAR(result.last("stored [J]"), kStiffness * std::pow(left - right, 2) / 2, 1e-7) << engine;
  }
}

// A bar in a subsystem: mirrored, rotated, with coordinates about parallel axes, its points over a tunable parameter.
TEST_F(AntiRollBar, HasThemInMirroredInstancesToo) {
  std::string part = kSlides;
  const auto replace = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(part.find(from), std::string::npos) << from;
    part.replace(part.find(from), from.size(), to);
  };
  replace(R"("right_travel": -0.03)", R"("right_travel": -0.03, "arm_x": { "value": -0.25, "tunable": true })");
  replace(R"("bar_arm": [-0.25,)", R"("bar_arm": ["arm_x",)");
  replace("\"gravity\": [0, 0, 0],", "");
  write("part.json", part);
  const double left = angle_of(0.06), right = angle_of(-0.03), torque = kStiffness * (left - right);
  for (const std::string place :
       {R"("mirror": "xz")", R"("mirror": "xz", "coordinates": "parallel")", R"("mirror": "yz", "offset": [1, 2, 3])",
        R"("mirror": "xz", "rotation": { "axis": "z", "angle": { "deg": 30 } })"}) {
    write("whole.json", R"({ "mbgen": 1, "name": "whole", "gravity": [0, 0, 0], "bodies": { "ground": {} },
      "instances": { "a": { "file": "part.json", "suffix": "_a", )" +
                            place + R"( } },
      "solver": { "step": 0.01, "duration": 1 } })");
    const Outcome run = mbgen("simulate whole.json --engine generic --out whole.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Table result = table("whole.csv");
    EXPECT_NEAR(result.last("left_force_a [N]"), torque / lever(left), 1e-6) << place;
    EXPECT_NEAR(result.last("right_force_a [N]"), -torque / lever(right), 1e-6) << place;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
