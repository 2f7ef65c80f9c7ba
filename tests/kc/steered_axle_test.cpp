// A steered axle that is the same on both sides, by its closed form: upright kingpins, a rack across, tie rods in one
// plane. Left and right are two linkages of one shape, so that each side's angles are those of the other mirrored.

#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

// The left side; the kingpin stands at (0, 0.6), the arm goes to (-0.12, 0.55), the rack's end is at (-0.1, 0.3).
constexpr double kKingpin = 0.6, kArmX = -0.12, kArmY = -0.05, kRackX = -0.1, kRackY = 0.3;

std::string side(const std::string& name, const std::string& y) {
  const auto replaced = [&](std::string text) {
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"SIDE", name}, {"+", y}}) {
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    }
    return text;
  };
  return replaced(R"(
    "guide_SIDE": { "mass": 5, "com": [0, +0.6, 0.3], "inertia": [1, 1, 1], "points": { "pin": [0, +0.6, 0.3] } },
    "knuckle_SIDE": { "mass": 5, "com": [0, +0.6, 0.3], "inertia": [1, 1, 1],
      "points": { "pin": [0, +0.6, 0.3], "arm": [-0.12, +0.55, 0.3], "hub": [0, +0.7, 0.3] } },
    "wheel_SIDE": { "mass": 5, "com": [0, +0.7, 0.3], "inertia": [1, 1, 1], "points": { "hub": [0, +0.7, 0.3] } })");
}

std::string joints(const std::string& name) {
  std::string text = R"(
    "guide_SIDE": { "type": "prismatic", "from": "ground.SIDE", "to": "guide_SIDE.pin", "axis": "z" },
    "knuckle_SIDE": { "type": "revolute", "from": "guide_SIDE.pin", "to": "knuckle_SIDE.pin", "axis": "z" },
    "wheel_SIDE": { "type": "revolute", "from": "knuckle_SIDE.hub", "to": "wheel_SIDE.hub", "axis": "y" })";
  for (std::size_t at = 0; (at = text.find("SIDE", at)) != std::string::npos;) text.replace(at, 4, name);
  return text;
}

std::string steered_axle() {
  return R"({ "mbgen": 1, "gravity": [0, 0, 0], "bodies": {
    "ground": { "points": { "left": [0, 0.6, 0.3], "right": [0, -0.6, 0.3], "rack": [-0.1, 0, 0.3],
      "top_left": [0, 0.6, 0.8], "top_right": [0, -0.6, 0.8] } },
    "rack": { "mass": 2, "com": [-0.1, 0, 0.3], "inertia": [1, 1, 1],
      "points": { "o": [-0.1, 0, 0.3], "left": [-0.1, 0.3, 0.3], "right": [-0.1, -0.3, 0.3] } },)" +
         side("left", "") + "," + side("right", "-") + R"( },
  "joints": { "rack": { "type": "prismatic", "from": "ground.rack", "to": "rack.o", "axis": "y" },)" +
         joints("left") + "," + joints("right") + R"( },
  "rods": { "tie_left": { "from": "rack.left", "to": "knuckle_left.arm" },
    "tie_right": { "from": "rack.right", "to": "knuckle_right.arm" } },
  "springs": { "left": { "from": "ground.top_left", "to": "guide_left.pin", "stiffness": 20000 },
    "right": { "from": "ground.top_right", "to": "guide_right.pin", "stiffness": 20000 } },
  "axles": { "front": { "left": { "centre": "wheel_left.hub", "radius": 0.3 },
    "right": { "centre": "wheel_right.hub", "radius": 0.3 }, "steer": "rack", "wheelbase": 2.6 } } })";
}

/// The angle of the left wheel with its rack at s, positive to the left, and its arm `travel` above the rack:
/// |kingpin + R(angle) arm - rack end| is the length of the rod seen from above, A cos(angle) + B sin(angle) = C.
double left_angle(double s, double travel = 0) {
  const double dx = -kRackX, dy = kKingpin - kRackY - s;  // from the rack's end to the kingpin
  const double squared = std::pow(kArmX - kRackX, 2) + std::pow(kKingpin + kArmY - kRackY, 2) - travel * travel;
  const double a = 2 * (dx * kArmX + dy * kArmY), b = 2 * (dy * kArmX - dx * kArmY);
  const double c = squared - dx * dx - dy * dy - kArmX * kArmX - kArmY * kArmY;
  const double middle = std::atan2(b, a), half = std::acos(c / std::hypot(a, b));
  const double one = std::remainder(middle + half, 2 * std::acos(-1.0)),
               other = std::remainder(middle - half, 2 * std::acos(-1.0));
  return std::abs(one) < std::abs(other) ? one : other;
}

TEST(SteeredAxle, LeftAndRightTurnAlike) {
  constexpr double kSteer = 0.04;  // m, of the rack
  const KcReport report = report_of_text(steered_axle(), {.travel = 0.03, .steer = kSteer, .points = 9});
  EXPECT_NEAR(left_angle(0), 0, 1e-15);
  EXPECT_GT(std::abs(left_angle(kSteer)), 0.2);
  const KcTable& steering = table(report, "steering");
  const std::vector<double>& rack = steering.columns.front().values;
  const std::vector<double>&left = values(steering, "steer_angle_left"), &right = values(steering, "steer_angle_right");
  ASSERT_EQ(rack.size(), 9u);
  for (std::size_t i = 0; i < rack.size(); ++i) {
    EXPECT_NEAR(left[i], left_angle(rack[i]), 1e-11) << rack[i];
    EXPECT_NEAR(right[i], -left_angle(-rack[i]), 1e-11) << rack[i];
    EXPECT_NEAR(right[i], -left[rack.size() - 1 - i], 1e-12) << "the mirrored row, " << rack[i];
  }
  // The inner wheel turns by more than the outer one: arms that point inwards behind the axle.
  EXPECT_GT(std::abs(left.front()), std::abs(right.front()));
  for (const char* name : {"steer_angle", "toe", "camber"}) {
    EXPECT_NEAR(figure(report, name, 0), 0, 1e-14) << name;
    EXPECT_NEAR(figure(report, name, 1), 0, 1e-14) << name;
  }
  // Tie rods that are level at the start toe both wheels alike, up or down.
  for (const char* curve : {"parallel_travel", "opposite_travel"}) {
    const KcTable& travels = table(report, curve);
    const std::vector<double>& travel = travels.columns.front().values;
    for (std::size_t i = 0; i < travel.size(); ++i) {
      EXPECT_NEAR(values(travels, "toe_left")[i], -left_angle(0, travel[i]), 1e-11) << curve << travel[i];
      EXPECT_NEAR(values(travels, "toe_right")[i], values(travels, "toe_left")[i], 1e-12) << curve << travel[i];
    }
  }
}

}  // namespace
}  // namespace mbgen::kc_test
