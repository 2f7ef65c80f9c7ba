// Tunable points of joints: each body keeps its own points, so a tuned one moves what it holds, whether its joint is in
// the tree, cut, turned round or fixed. A four-bar against its closed form and against a drawing of it as it becomes.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr double kBase = 4, kCrank = 1.5, kCoupler = 4, kRocker = 3;
constexpr double kTolerance = 1e-12;

struct Planar {
  double x, z;
};

/// Tip of the rocker at an upright crank: where the circles about crank tip and rocker pin meet, the upper point.
Planar tip(double base) {
  const double diagonal = std::hypot(base, kCrank);
  const double along = (diagonal * diagonal + kRocker * kRocker - kCoupler * kCoupler) / (2 * diagonal);
  const double across = std::sqrt(kRocker * kRocker - along * along);
  return {base - along * base / diagonal + across * kCrank / diagonal,
          along * kCrank / diagonal + across * base / diagonal};
}

/// The rocker's pin on ground at `on_ground`, in the rocker at `pin`; cut: the joint marked so.
struct Drawing {
  std::string on_ground = "4", pin = "4", cut = "tip", parameters = "";
  double base = kBase;
  bool turned = false, on_post = false;
};

std::string four_bar(const Drawing& drawing) {
  const Planar at = tip(drawing.base);
  const std::string ground = drawing.on_post ? "post.D" : "ground.D", rocker = "rocker.D";
  const auto mark = [&](const char* joint) { return drawing.cut == joint ? R"(, "cut": true)" : ""; };
  return fmt::format(R"({{ "mbgen": 1, "gravity": [0.3, 0, -9.81], "parameters": {{ {0} }},
    "bodies": {{
      "ground": {{ "points": {{ "A": [0, 0, 0], "D": ["{1}", 0, 0] }} }},
      "post": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "D": ["{2}", 0, 0], "A": [0, 0, 0] }} }},
      "crank": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0], "B": [0, 0, {3}] }} }},
      "coupler": {{ "mass": 2, "com": [0, 0, {3}], "inertia": [1, 1, 1],
                    "points": {{ "B": [0, 0, {3}], "C": [{4}, 0, {5}] }} }},
      "rocker": {{ "mass": 3, "com": [{4}, 0, {5}], "inertia": [1, 1, 1],
                   "points": {{ "D": ["{2}", 0, 0], "C": [{4}, 0, {5}] }} }}
    }},
    "joints": {{
      "crank": {{ "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" }},
      "coupler": {{ "type": "revolute", "from": "crank.B", "to": "coupler.B", "axis": "y"{6} }},
      "bolts": {{ "type": "fixed", "from": "ground.{7}", "to": "post.{7}" }},
      "rocker": {{ "type": "revolute", "from": "{8}", "to": "{9}", "axis": "y"{10} }},
      "tip": {{ "type": "revolute", "from": "coupler.C", "to": "rocker.C", "axis": "y"{11} }}
    }} }})",
                     drawing.parameters, drawing.on_ground, drawing.pin, kCrank, at.x, at.z, mark("coupler"),
                     drawing.on_post ? "D" : "A", drawing.turned ? rocker : ground, drawing.turned ? ground : rocker,
                     mark("rocker"), mark("tip"));
}

constexpr const char* kWidth = R"("width": { "value": 4, "unit": "m", "tunable": true })";

/// The crank's acceleration and the tip, at an upright crank that turns at 2 rad/s, by the recursion and by a judge.
struct Seen {
  Planar tip, pin;
  double acceleration, by_judge;
};

Vector3 on(const Pose& pose, const Vector3& point) {
  Vector3 at = pose.origin;
  for (int i = 0; i < 9; ++i) at[i / 3] += pose.rotation[i] * point[i % 3];
  return at;
}

Seen seen(const Mechanism& m, const std::vector<double>& parameters) {
  GenericSolver solver(m.model, m.topology, m.analysis);
  CartesianSolver judge(m.model, m.topology, CartesianMethod::null_space, Stabilisation::projection);
  solver.set_parameters(parameters);
  judge.set_parameters(parameters);
  const auto n = m.topology.bodies.size();
  GenericState state{std::vector<double>(n), std::vector<double>(n), {}, 0};
  const int crank = find_coordinate(m.topology, "crank");
  EXPECT_TRUE(solver.assemble(state, {{crank, 0, 1, true}}).ok());
  EXPECT_TRUE(solver.assemble_velocities(state, {{crank, 2, 1, true}}).ok());
  EXPECT_TRUE(solver.project(state).ok());
  GenericDerivative derivative, judged;
  EXPECT_TRUE(solver.accelerations(state, std::vector<double>(n), derivative).ok());
  EXPECT_TRUE(judge.accelerations(state, std::vector<double>(n), judged).ok());
  const Pose rocker = solver.poses(state)[4];
  const std::vector<Point>& points = m.model.bodies[4].points;
  const auto written = [&](std::size_t p) {
    return Vector3{points[p].position[0].value, points[p].position[1].value, points[p].position[2].value};
  };
  Seen result{};
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vector3 at = on(rocker, written(p));
    (points[p].name == "C" ? result.tip : result.pin) = {at[0], at[2]};
  }
  result.acceleration = derivative.zdd[crank];
  result.by_judge = judged.zdd[crank];
  return result;
}

struct Variant {
  const char* name;
  Drawing drawing;
};

/// For names of tests.
void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

class TunedPin : public ::testing::TestWithParam<Variant> {};

/// The ground's pin is moved, the rocker's point is not: the rocker goes along, as in a drawing with another base.
TEST_P(TunedPin, MovesTheBodyThatItHolds) {
  for (const double width : {4.0, 4.2, 3.7}) {
    SCOPED_TRACE(width);
    Drawing drawing = GetParam().drawing;
    drawing.on_ground = "width";
    drawing.parameters = kWidth;
    const Seen found = seen(mechanism_of(four_bar(drawing)), {width});
    EXPECT_NEAR(found.pin.x, width, kTolerance);
    EXPECT_NEAR(found.pin.z, 0, kTolerance);
    EXPECT_NEAR(found.tip.x, tip(width).x, 1e-9);
    EXPECT_NEAR(found.tip.z, tip(width).z, 1e-9);
    Drawing redrawn;
    redrawn.base = width;
    redrawn.on_ground = redrawn.pin = fmt::format("{}", width);
    const Seen expected = seen(mechanism_of(four_bar(redrawn)), {});
    EXPECT_NEAR(found.acceleration, expected.acceleration, 1e-9);
    EXPECT_NEAR(found.by_judge, expected.acceleration, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, TunedPin,
                         ::testing::Values(Variant{"in_the_tree", {}}, Variant{"cut", {.cut = "rocker"}},
                                           Variant{"in_the_tree_cut_elsewhere", {.cut = "coupler"}},
                                           Variant{"turned_round", {.turned = true}},
                                           Variant{"turned_round_and_cut", {.cut = "rocker", .turned = true}},
                                           Variant{"bolted", {.on_post = true}},
                                           Variant{"bolted_and_cut", {.cut = "rocker", .on_post = true}}),
                         [](const auto& info) { return std::string(info.param.name); });

/// Both points moved alike: the body stays where it is, and its other points with it.
TEST(TunedPins, OfBothBodiesLeaveThemInPlace) {
  for (const char* cut : {"tip", "rocker"}) {
    const Drawing drawing{.on_ground = "width", .pin = "width", .cut = cut, .parameters = kWidth};
    const Seen there = seen(mechanism_of(four_bar({})), {});
    const Seen found = seen(mechanism_of(four_bar(drawing)), {4.2});
    EXPECT_NEAR(found.tip.x, there.tip.x, 1e-9) << cut;
    EXPECT_NEAR(found.tip.z, there.tip.z, 1e-9) << cut;
    EXPECT_GT(std::abs(found.acceleration - there.acceleration), 1e-3) << cut;
    EXPECT_NEAR(found.by_judge, found.acceleration, 1e-9) << cut;
  }
}

/// The same in hardpoints: each name is one place, though the rocker's frame is moved and turned.
std::string four_bar_of_hardpoints(bool cut_rocker) {
  const Planar at = tip(kBase);
  return fmt::format(R"({{ "mbgen": 1, "gravity": [0.3, 0, -9.81], "parameters": {{ {0} }},
    "hardpoints": {{ "A": [0, 0, 0], "B": [0, 0, {1}], "C": [{2}, 0, {3}], "D": ["width", 0, 0] }},
    "bodies": {{
      "ground": {{}},
      "post": {{ "mass": 1, "inertia": [1, 1, 1] }},
      "crank": {{ "mass": 1, "inertia": [1, 1, 1] }},
      "coupler": {{ "mass": 2, "com": "B", "inertia": [1, 1, 1] }},
      "rocker": {{ "pose": {{ "origin": [3.1, 0.2, 0.4], "rotation": {{ "axis": [0.1, 0.7, -0.3], "angle": 0.8 }} }},
                   "mass": 3, "com": "C", "inertia": [1, 1, 1] }}
    }},
    "joints": {{
      "crank": {{ "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" }},
      "coupler": {{ "type": "revolute", "from": "crank.B", "to": "coupler.B", "axis": "y" }},
      "bolts": {{ "type": "fixed", "from": "ground.A", "to": "post.A" }},
      "rocker": {{ "type": "revolute", "from": "rocker.D", "to": "ground.D",
                   "axis": {{ "from": [0, 1, 0], "to": "A" }}{4} }},
      "tip": {{ "type": "revolute", "from": "coupler.C", "to": "rocker.C", "axis": "y"{5} }}
    }} }})",
                     kWidth, kCrank, at.x, at.z, cut_rocker ? R"(, "cut": true)" : "",
                     cut_rocker ? "" : R"(, "cut": true)");
}

TEST(TunedHardpoints, AreTheSamePlaceForEveryBody) {
  for (const bool cut_rocker : {false, true}) {
    for (const double width : {4.0, 4.2, 3.7}) {
      SCOPED_TRACE(width);
      const Seen expected =
          seen(mechanism_of(four_bar({.on_ground = "width", .pin = "width", .parameters = kWidth})), {width});
      const Seen found = seen(mechanism_of(four_bar_of_hardpoints(cut_rocker)), {width});
      EXPECT_NEAR(found.tip.x, expected.tip.x, 1e-9);
      EXPECT_NEAR(found.tip.z, expected.tip.z, 1e-9);
      EXPECT_NEAR(found.acceleration, expected.acceleration, 1e-9);
      EXPECT_NEAR(found.by_judge, expected.acceleration, 1e-9);
    }
  }
}

}  // namespace
}  // namespace mbgen
