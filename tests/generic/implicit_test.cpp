// The linearly implicit integrator on mechanisms: its matrix against differences of the accelerations, orders, stiff
// problems.

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "tests/support/implicit_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A loop of bars with springs of every kind at rest, where no force changes its direction. All laws are stiff.
constexpr const char* kSprungBody = R"json({ "mbgen": 1, "name": "sprung", "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "a": [0, 0, 0], "d": [0.9, 0, 0], "anchor": [0.3, 0, 0.9] } },
    "crank": { "mass": 1, "com": [0, 0, 0.2], "inertia": [0.02, 0.02, 0.001],
      "points": { "a": [0, 0, 0], "b": [0, 0, 0.4], "tip": [0.1, 0.02, 0.5] } },
    "coupler": { "mass": 2, "com": [0.4, 0, 0.5], "inertia": [0.01, 0.1, 0.1],
      "points": { "b": [0, 0, 0.4], "c": [0.8, 0, 0.6], "rider": [0.5, 0, 0.7] } },
    "rocker": { "mass": 1.5, "com": [0.85, 0, 0.3], "inertia": [0.05, 0.05, 0.001],
      "points": { "c": [0.8, 0, 0.6], "d": [0.9, 0, 0] } },
    "rider": { "mass": 0.5, "com": [0.5, 0, 0.7], "inertia": [0.001, 0.001, 0.001],
      "points": { "pin": [0.5, 0, 0.7], "end": [0.6, 0, 0.9] } }
  },
  "joints": {
    "a": { "type": "revolute", "from": "ground.a", "to": "crank.a", "axis": "y" },
    "b": { "type": "revolute", "from": "crank.b", "to": "coupler.b", "axis": "y" },
    "c": { "type": "revolute", "from": "coupler.c", "to": "rocker.c", "axis": "y" },
    "d": { "type": "revolute", "from": "ground.d", "to": "rocker.d", "axis": "y" },
    "rider": { "type": "revolute", "from": "coupler.rider", "to": "rider.pin", "axis": "y" }
  },
  "springs": {
    "across": { "from": "crank.tip", "to": "rider.end", "stiffness": 3e5, "damping": 2e3 },
    "table": { "from": "ground.anchor", "to": "coupler.rider",
      "stiffness": { "table": [[-0.1, -4e4], [-0.01, -2e3], [0.01, 2e3], [0.1, 9e4]] } },
    "law": { "from": "ground.anchor", "to": "crank.tip", 
      "force": "1e3*sin(100*(length - 0.44766058571198786)) + 50*tanh(rate)" }
  },
  "joint_springs": {
    "rider": { "joint": "rider", "relative_to": "a", "stiffness": 5e4, "damping": 30, "force": "1e3*position^3" }
  },
  "frictions": { "d": { "joint": "d", "coulomb": 40, "stiction": 60, "viscous": 3, "velocity": 0.01 } },
  "joint_forces": { "controller": { "joint": "a", "force": "-4e4*z.rider - 100*zd.d" } }
})json";

TEST(Implicit, MatrixIsThatOfTheMechanismWhereNoForceTurns) {
  const Free sprung{mechanism_of(kSprungBody)};
  const GenericState state = reference_state(sprung.m);
  ASSERT_LT(sprung.rates(state).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(largest_difference(sprung.matrix(state), sprung.differences(state)), 1e-7);
}

/// Two chains of so many bars that hang side by side, their ends joined by a spring: it alone couples them, every joint
/// of one with every joint of the other.
std::string two_chains(int bars) {
  std::string bodies, joints;
  for (const char side : {'a', 'b'})
    for (int i = 0; i < bars; ++i) {
      const std::string below = i == 0 ? "ground" : fmt::format("{}{}", side, i - 1);
      const double x = side == 'a' ? 0 : 1, top = -0.2 * i, end = -0.2 * (i + 1);
      bodies += fmt::format(R"(, "{0}{1}": {{ "mass": 1, "com": [{2}, 0, {3}], "inertia": [0.01, 0.01, 0.001],
        "points": {{ "top": [{2}, 0, {3}], "{0}end": [{2}, 0, {4}] }} }})",
                            side, i, x, top, end);
      joints += fmt::format(R"({0} "{1}{2}": {{ "type": "revolute", "from": "{3}.{1}end", "to": "{1}{2}.top",
        "axis": "y" }})",
                            joints.empty() ? "" : ",", side, i, below);
    }
  return fmt::format(R"({{ "mbgen": 1, "name": "chains", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "aend": [0, 0, 0], "bend": [1, 0, 0] }} }}{} }}, "joints": {{ {} }},
    "springs": {{ "ends": {{ "from": "a{}.aend", "to": "b{}.bend", "stiffness": 3e5, "damping": 2e3 }} }} }})",
                     bodies, joints, bars - 1, bars - 1);
}

TEST(Implicit, MatrixHasASpringBetweenChainsThatNothingElseCouples) {
  for (const int bars : {2, 6}) {  // few places between the chains are filled; many are left apart
    const Free chains{mechanism_of(two_chains(bars))};
    const GenericState state = reference_state(chains.m);
    EXPECT_LT(largest_difference(chains.matrix(state), chains.differences(state)), 1e-6) << bars;
  }
}

// Forces by load are left out, and the drag of the tyre on its hub.
TEST(Implicit, MatrixHasWhatIsStiffInATyre) {
  const Free wheel{load("models/pulled_wheel.json")};
  GenericState state = reference_state(wheel.m);
  state.zd[find_coordinate(wheel.m.topology, "pull")] = 15;
  state.zd[find_coordinate(wheel.m.topology, "wheel")] = 47;
  state.x = {0.004, 0.002};
  state = wheel.moved(state, Eigen::VectorXd::Zero(2 * wheel.half() + 2));
  const Eigen::MatrixXd own = wheel.matrix(state), whole = wheel.differences(state);
  EXPECT_LT(largest_difference(own.rightCols(2), whole.rightCols(2)), 1e-6) << "by the deflection states";
  EXPECT_LT(largest_difference(own.bottomRows(2).middleCols(2, 2), whole.bottomRows(2).middleCols(2, 2)), 0.01);
  EXPECT_NEAR(own(2, 0) / whole(2, 0), 1, 0.01) << "vertical";
}

std::string text_of(const std::string& relative) {
  std::ifstream file(source_path(relative));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// An axle on wheels that are steered at standstill; their kingpins stand upright on upright wheels' patches, or not.
Free steered_axle(bool on_patches) {
  std::string text = text_of("tests/data/models/parked_wheels.json");
  for (const auto& [lever, none] : {std::pair{"[0.02, 1.1, 0.5]", "[0, 1, 0.5]"},
                                    {"[0.02, -1.1, 0.5]", "[0, -1, 0.5]"},
                                    {"[0.05, 0.1, 1]", "[0, 0, 1]"},
                                    {"[0.05, -0.1, 1]", "[0, 0, 1]"},
                                    {"[0, 1, 0.03]", "[0, 1, 0]"}})
    for (std::size_t at = 0; on_patches && (at = text.find(lever, at)) != std::string::npos;)
      text.replace(at, std::string_view(lever).size(), none);
  return Free{mechanism_of(text)};
}
GenericState steered(const Free& axle) {
  GenericState state = reference_state(axle.m);
  state.z[find_coordinate(axle.m.topology, "up")] = -0.02;
  state.zd[find_coordinate(axle.m.topology, "left_steer")] = 0.3;
  state.zd[find_coordinate(axle.m.topology, "right_steer")] = -0.2;
  state.x = {0, 0, 0, 0, -0.03, 0.02};
  return axle.moved(state, Eigen::VectorXd::Zero(2 * axle.half() + 6));
}
/// By all velocities but the vertical one, with which the load changes.
Eigen::MatrixXd rates_of_turns(const Free& axle, const Eigen::MatrixXd& matrix) {
  return matrix.bottomRows(2).middleCols(axle.half() + 1, axle.half() - 1);
}

// The matrix leaves out the part of rolling in the turn, and counts the spin of a leaning wheel as turning: neither is
// there where upright wheels turn on the spot.
TEST(Implicit, MatrixHasThePatchesThatTurn) {
  for (const bool on_patches : {true, false}) {
    const Free axle = steered_axle(on_patches);
    const GenericState state = steered(axle);
    const Eigen::MatrixXd own = axle.matrix(state), whole = axle.differences(state);
    EXPECT_GT(whole.rightCols(2).cwiseAbs().maxCoeff(), 100) << "N m/rad over kg m^2";
    EXPECT_LT(largest_difference(own.rightCols(2), whole.rightCols(2)), 1e-6) << "by the turns";
    if (!on_patches) continue;
    EXPECT_LT(largest_difference(rates_of_turns(axle, own), rates_of_turns(axle, whole)), 1e-6) << "by the velocities";
  }
}

// The fastest eigenvalue of the governor is -8117 1/s: beyond Runge-Kutta's region at steps above 3.4e-4 s.
TEST(Implicit, FlyballGovernorAtAMillisecond) {
  const Free governor{load("models/iftomm/a05_flyball_governor.json")};
  GenericState start = reference_state(governor.m);
  start.zd[find_coordinate(governor.m.topology, "shaft")] = 2 * std::acos(-1.0);
  constexpr double kDuration = 0.2;
  const std::vector<double> exact = positions_after(governor, start, kDuration, 2000, false);
  ASSERT_FALSE(exact.empty());
  const double coarse = distance_of(positions_after(governor, start, kDuration, 200, true), exact),
               fine = distance_of(positions_after(governor, start, kDuration, 400, true), exact);
  std::printf("flyball governor: errors %.2e, %.2e rad at 1 ms and 0.5 ms\n", coarse, fine);
  EXPECT_LT(coarse, 1e-6);
  EXPECT_GT(coarse / fine, 3.5);
  const std::vector<double> diverged = positions_after(governor, start, kDuration, 200, false);
  EXPECT_TRUE(diverged.empty() || !(distance_of(diverged, exact) < 1));
}

// Loops, closed by projection: of order three against the published solution's reference.
TEST(Implicit, AndrewsMechanismWithOrderThree) {
  const Free andrews{load("models/andrews_squeezer.json")};
  const GenericState start = reference_state(andrews.m);
  const std::vector<double> exact = positions_after(andrews, start, 0.005, 800, false);
  const double coarse = distance_of(positions_after(andrews, start, 0.005, 100, true), exact),
               fine = distance_of(positions_after(andrews, start, 0.005, 200, true), exact);
  std::printf("Andrews at 0.005 s: errors %.2e, %.2e rad at 100, 200 steps, ratio %.2f\n", coarse, fine, coarse / fine);
  EXPECT_GT(coarse / fine, 6);
  EXPECT_LT(fine, 1e-5);
}

}  // namespace
}  // namespace mbgen
