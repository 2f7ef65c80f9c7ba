// Parallel robots against the closed forms of their geometry.

#include <cmath>
#include <numbers>

#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// States of a robot, with the coordinates and the platform's pose that they mean.
struct Robot {
  Mechanism m;
  GenericSolver solver{m.model, m.topology, m.analysis};
  std::vector<GenericState> states;

  /// reach: of the guesses from which the states are closed.
  Robot(const std::string& path, double reach) : m(load(path)), states(random_states(m, 6, reach)) {
    EXPECT_EQ(states.size(), 6u) << path;
  }

  std::size_t at(const std::string& name) const { return static_cast<std::size_t>(find_coordinate(m.topology, name)); }
  double z(const GenericState& state, const std::string& name) const { return state.z[at(name)]; }
  /// Rotation by rows, and origin, global.
  Pose platform(const GenericState& state) const {
    const std::vector<Pose> poses = solver.poses(state);
    for (std::size_t b = 0; b < poses.size(); ++b)
      if (m.model.bodies[b].name == "platform") return poses[b];
    throw std::runtime_error("no platform");
  }
  std::size_t redundant() const { return m.analysis.blocks[0].redundant_equations.size(); }
};

void expect_not_turned(const Pose& platform) {
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(platform.rotation[i], i % 4 == 0 ? 1 : 0, 1e-12);
}

// The centre of each pair of wrists is a forearm's length from the centre of the elbows, in the plane of no arm.
TEST(ParallelRobots, DeltaHasItsElbowsOnSpheresAboutItsPlatform) {
  Robot robot("models/delta.json", 0.5);
  EXPECT_EQ(robot.m.analysis.degrees_of_freedom, 3);
  const double base = 0.4573 / (2 * std::sqrt(3.0)), platform_radius = 0.115 / (2 * std::sqrt(3.0));
  for (GenericState& state : robot.states) {
    // A platform that is turned may be closed with crossed forearms.
    for (const char* turn : {"platform_rx", "platform_ry", "platform_rz"}) state.z[robot.at(turn)] = 0;
    ASSERT_TRUE(robot.solver.project(state).ok());
    const Pose platform = robot.platform(state);
    expect_not_turned(platform);
    const double rest = base + 0.112 * std::sqrt(0.75) - platform_radius;
    const double height = platform.origin[2] - 0.056 - std::sqrt(0.232 * 0.232 - rest * rest);
    for (int arm = 0; arm < 3; ++arm) {
      const double angle = std::numbers::pi / 6 + robot.z(state, "motor_" + std::to_string(arm + 1));
      const double turn = 2 * std::numbers::pi / 3 * arm, reach = base + 0.112 * std::cos(angle) - platform_radius;
      const double x = reach * std::cos(turn) - platform.origin[0], y = reach * std::sin(turn) - platform.origin[1];
      EXPECT_NEAR(std::hypot(x, y, -0.112 * std::sin(angle) - height), 0.232, 1e-11);
    }
  }
}

TEST(ParallelRobots, TripteronMovesAlongEachAxisAsTheSlideOfThatAxisDoes) {
  const Robot robot("models/tripteron.json", 0.5);
  EXPECT_EQ(robot.m.analysis.degrees_of_freedom, 3);
  EXPECT_EQ(robot.redundant(), 3u);
  for (const GenericState& state : robot.states) {
    const Pose platform = robot.platform(state);
    expect_not_turned(platform);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(platform.origin[k], robot.z(state, std::string("slide_") + "xyz"[k]), 1e-12);
  }
}

// Middle and tip of each leg are perpendicular: Bonev, Chablat and Wenger, 2006.
TEST(ParallelRobots, AgileEyeKeepsNeighbouringAxesPerpendicular) {
  const Robot robot("models/agile_eye.json", 0.5);
  EXPECT_EQ(robot.m.analysis.degrees_of_freedom, 3);
  EXPECT_EQ(robot.redundant(), 6u);
  for (const GenericState& state : robot.states) {
    const Pose platform = robot.platform(state);
    double turned = 0;
    for (int leg = 0; leg < 3; ++leg) {
      const double angle = robot.z(state, "motor_" + std::to_string(leg + 1));
      const int a = (leg + 1) % 3, b = (leg + 2) % 3;  // the motor's axis is `leg`, the middle at rest b, the tip -a
      EXPECT_NEAR(platform.rotation[3 * a + a] * -std::sin(angle) + platform.rotation[3 * b + a] * std::cos(angle), 0,
                  1e-12);
      turned = std::max(turned, std::abs(angle));
    }
    EXPECT_GT(turned, 0.05);
    for (const double place : platform.origin) EXPECT_NEAR(place, 0, 1e-12);
  }
}

}  // namespace
}  // namespace mbgen
