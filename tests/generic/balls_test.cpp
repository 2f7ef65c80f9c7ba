// Spherical and free joints through the poles of their angles: charts change, the motion does not.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "mbgen/integrators.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr std::array<const char*, 6> kSequences = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};

/// A generic solver that changes charts, as engines run it.
struct Moving {
  using State = GenericState;
  using Derivative = GenericDerivative;

  Mechanism m;
  GenericSolver solver{m.model, m.topology, m.analysis};
  GenericState state;
  AbmHistory<Moving> history{};
  mutable int evaluations = 0;
  bool fails = false;  ///< whether the next evaluation does
  int changes = 0;     ///< steps after which other charts are taken
  Status worst;        ///< the first that is not ok itself

  explicit Moving(const std::string& text) : m(mechanism_of(text)) {
    state.z.assign(m.topology.bodies.size(), 0.0);
    state.zd = state.z;
    for (const InitialValue& value : m.model.initial.positions) set(state.z, value);
    for (const InitialValue& value : m.model.initial.velocities) set(state.zd, value);
    EXPECT_TRUE(solver.project(state).ok());
  }
  Moving(const Moving&) = delete;
  void set(std::vector<double>& values, const InitialValue& value) const {
    values[static_cast<std::size_t>(tree_coordinate(m.topology, value.coordinate))] = value.value;
  }

  Status derivative(const State& at, Derivative& rates) const noexcept {
    ++evaluations;
    if (fails) return {Code::not_a_number, 0};
    return solver.solve_motion(at, rates);
  }
  Status project(State& at) const noexcept { return solver.project_motion(at); }
  Status project_nearest(State& at) const noexcept { return solver.project_nearest(at); }
  Status project_crossing(State& at, double& clearance) const noexcept {
    return solver.project_crossing(at, clearance);
  }
  bool leaves_charts(const State& at) const noexcept { return mbgen::leaves_charts(m.topology.balls, at); }
  bool settle_charts(State& at) const noexcept { return mbgen::settle_charts(m.topology.balls, at); }
  void change_charts(const State& from, const State& to, std::vector<double>& z, std::vector<double>& zd,
                     std::vector<double>& zdd) const noexcept {
    mbgen::change_charts(m.topology.balls, from, to, z, zd, zdd);
  }

  void go(int steps, double h, bool multistep = false) {
    for (int k = 0; k < steps; ++k) {
      const std::vector<double> before = state.charts;
      const Status status = multistep ? step_abm4(*this, state, history, h) : step_rk4(*this, state, h);
      if (status.code != Code::ok && worst.code == Code::ok) worst = status;
      changes += before != state.charts ? 1 : 0;
    }
  }
  std::vector<double> outputs() const {
    const std::vector<double> none(state.z.size(), 0.0);
    GenericDerivative rates;
    EXPECT_TRUE(solver.accelerations(state, none, rates).ok());
    return solver.outputs(state, none, rates).y;
  }
  GenericState users() const { return in_users_angles(m.topology.balls, state); }
};

std::string text_of(const std::string& relative) {
  std::ifstream file(source_path(relative));
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string heavy_top(const char* sequence) {
  return with(text_of("models/published/heavy_top.json"), R"("sequence": "xzy")",
              std::string(R"("sequence": ")") + sequence + "\"");
}

// The pole of the published sequence is where the top never goes; those of the others lie on its way.
TEST(HeavyTop, KeepsItsDigitsWhereverThePoleLies) {
  const auto reference = nlohmann::json::parse(text_of("tests/data/reference/rigid_body.json"))["heavy_top"];
  int changes = 0;
  for (const char* sequence : kSequences) {
    Moving top(heavy_top(sequence));
    for (int row = 0; row < 2; ++row) {
      top.go(5000, 2e-5);
      const std::vector<double> y = top.outputs();
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(y[k], reference[static_cast<std::size_t>(row)]["r_com"][k].get<double>(), 1e-9) << sequence;
    }
    EXPECT_EQ(top.worst.code, Code::ok) << sequence;
    changes += top.changes;
  }
  EXPECT_GT(changes, 10);
}

std::string rod_pendulum(const char* sequence) {
  return std::string(R"({
  "mbgen": 1, "name": "rod_pendulum", "gravity": [0, 0, -9.81],
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0], "A": [0.3, 0.2, 0.8] } },
    "arm": { "mass": 2, "com": [0, 0, -0.5], "inertia": [0.28, 0.3, 0.05],
      "points": { "O": [0, 0, 0], "B": [0.1, 0, -0.6], "tip": [0.3, 0.1, -1] } }
  },
  "joints": { "ball": { "type": "spherical", "from": "ground.O", "to": "arm.O", "sequence": ")") +
         sequence + R"(" } },
  "rods": { "rod": { "from": "ground.A", "to": "arm.B", "mass": 0.3 } },
  "outputs": {
    "x": { "point": "arm.tip", "axis": "x" }, "y": { "point": "arm.tip", "axis": "y" },
    "z": { "point": "arm.tip", "axis": "z" }, "turn": { "joint": "ball_ry" }, "rate": { "expression": "zd.ball_ry" }
  },
  "initial": { "velocities": { "ball_rx": 6, "ball_ry": 4, "ball_rz": 7 } }
})";
}

// Every sequence moves alike, and as the judge, which has no angles.
TEST(RodPendulum, MovesAlikeInEverySequence) {
  constexpr double kStep = 4e-4;
  constexpr int kSteps = 2000;
  for (const bool multistep : {false, true}) {
    std::vector<double> expected;
    int changes = 0;
    for (const char* sequence : kSequences) {
      if (multistep && !expected.empty() && changes > 4) break;  // the way back is that of the others
      Moving pendulum(rod_pendulum(sequence));
      if (expected.empty()) {
        CartesianSolver judge(pendulum.m.model, pendulum.m.topology, CartesianMethod::augmented,
                              Stabilisation::projection);
        GenericState state = pendulum.state;
        for (int k = 0; k < kSteps; ++k) ASSERT_TRUE(judge.step(state, kStep).ok()) << k;
        GenericOutputs outputs;
        ASSERT_TRUE(judge.outputs(state, std::vector<double>(state.z.size(), 0.0), outputs).ok());
        expected = outputs.y;
      }
      pendulum.go(kSteps, kStep, multistep);
      const std::vector<double> y = pendulum.outputs();
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(y[k], expected[k], 2e-7) << sequence << multistep;
      const GenericState users = pendulum.users();
      const auto turn = static_cast<std::size_t>(find_coordinate(pendulum.m.topology, "ball_ry"));
      EXPECT_NEAR(y[3], users.z[turn], 1e-12) << sequence;
      EXPECT_NEAR(y[4], users.zd[turn], 1e-10 * (1 + std::abs(users.zd[turn]))) << sequence;
      EXPECT_EQ(pendulum.worst.code, Code::ok) << sequence << " " << text(pendulum.worst.code);
      changes += pendulum.changes;
    }
    EXPECT_GT(changes, 4);
  }
}

std::string racket(const char* sequence, const std::string& initial) {
  return std::string(R"({
  "mbgen": 1, "name": "racket", "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0] } },
    "racket": { "mass": 1, "inertia": [1, 2, 3], "points": { "O": [0, 0, 0] } }
  },
  "joints": { "float": { "type": "free", "from": "ground.O", "to": "racket.O", "sequence": ")") +
         sequence + R"(" } },
  "outputs": {
    "x": { "body": "racket", "quantity": "angular_momentum", "axis": "x" },
    "y": { "body": "racket", "quantity": "angular_momentum", "axis": "y" },
    "z": { "body": "racket", "quantity": "angular_momentum", "axis": "z" },
    "energy": { "body": "racket", "quantity": "kinetic_energy" },
    "wx": { "body": "racket", "quantity": "angular_velocity", "axis": "x", "axes_of": "racket" }
  },
  "initial": )" +
         initial + "\n}";
}

// Dzhanibekov's racket turns about its middle axis and flips over and over: the angular velocity goes along the line of
// equal energy and momentum, whose constants are kept, wherever the pole lies.
TEST(Racket, KeepsMomentumAndEnergyAsItFlips) {
  for (const char* sequence : kSequences) {
    Moving flying(racket(sequence, R"({ "velocities": { "float_rx": 0.01, "float_ry": 3, "float_tx": 0.5 } })"));
    const std::vector<double> start = flying.outputs();
    double most = 0;
    for (int part = 0; part < 20; ++part) {
      flying.go(200, 5e-3);
      const std::vector<double> y = flying.outputs();
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(y[k], start[k], 1e-6) << sequence << part;
      most = std::max(most, std::abs(y[4]));
    }
    EXPECT_GT(most, 2.5) << sequence;  // it has flipped: most of the energy was about the first axis
    EXPECT_EQ(flying.worst.code, Code::ok) << sequence;
    // About y, z, x the pole is where the first axis lies along y, as the momentum: more energy than there is.
    if (std::string_view(sequence) != "yzx") {
      EXPECT_GT(flying.changes, 0) << sequence;
    }
  }
}

// The rates that the method of several steps remembers go over to the other angles: every step takes two evaluations,
// and the error falls by the order of the method, as if there were no changes.
TEST(Racket, TakesItsHistoryThroughPoles) {
  constexpr int kSteps = 500;
  constexpr double kStep = 5e-3;
  const std::string start = R"({ "velocities": { "float_rx": 1, "float_ry": 2.5, "float_rz": 1.5 } })";
  int changes = 0;
  for (const char* sequence : kSequences) {
    const auto run = [&](int finer) {
      Moving flying(racket(sequence, start));
      flying.go(3, kStep / finer, true);
      flying.evaluations = 0;
      flying.go(kSteps * finer - 3, kStep / finer, true);
      EXPECT_EQ(flying.evaluations, 2 * (kSteps * finer - 3)) << sequence;
      changes += flying.changes;
      return flying.outputs();
    };
    const std::vector<double> coarse = run(1), fine = run(2), reference = run(6);
    double coarse_error = 0, fine_error = 0;
    for (std::size_t k = 0; k < reference.size(); ++k) {
      coarse_error = std::max(coarse_error, std::abs(coarse[k] - reference[k]));
      fine_error = std::max(fine_error, std::abs(fine[k] - reference[k]));
    }
    EXPECT_LT(coarse_error, 1e-5) << sequence;
    EXPECT_LT(fine_error, coarse_error / 10) << sequence;
  }
  EXPECT_GT(changes, 15);
}

// A start whose second angle is beyond a quarter turn: the way back by the charts would lead to the other angles.
TEST(Racket, KeepsItsHistoryWhereAStepFailsInOtherCharts) {
  Moving flying(
      racket("xyz", R"({ "positions": { "float_ry": 2.9 }, "velocities": { "float_ry": -3, "float_rz": 1 } })"));
  flying.go(4, 5e-3, true);
  while (!flying.leaves_charts(flying.state)) flying.go(1, 5e-3, true);
  ASSERT_EQ(flying.changes, 0);
  ASSERT_GT(std::abs(flying.state.z[static_cast<std::size_t>(find_coordinate(flying.m.topology, "float_ry"))]), 2);
  const AbmHistory<Moving> before = flying.history;
  const GenericState state = flying.state;
  flying.fails = true;
  EXPECT_EQ(step_abm4(flying, flying.state, flying.history, 5e-3).code, Code::not_a_number);
  EXPECT_EQ(flying.state.z, state.z);
  EXPECT_EQ(flying.history.count, before.count);
  for (int k = 0; k < 4; ++k) {
    const StateRates<Moving>&then = past_rates(before, k), &now = past_rates(flying.history, k);
    EXPECT_EQ(now.zd, then.zd) << k;
    EXPECT_EQ(now.derivative.zdd, then.derivative.zdd) << k;
    const int place = (before.newest + k) % before.kRing;
    EXPECT_EQ(flying.history.past_z[place], before.past_z[place]) << k;
  }
}

// A start in the pole itself, by a quaternion: a quarter about y is the pole of zyx.
TEST(Orientation, StartsInThePole) {
  const double half = std::numbers::sqrt2 / 2;
  Moving here(racket("zyx", R"({ "orientations": { "float": { "quaternion": [)" + std::to_string(half) + ", 0, " +
                                std::to_string(half) + R"(, 0] } }, "velocities": { "float_ry": 2 } })"));
  const auto ry = static_cast<std::size_t>(find_coordinate(here.m.topology, "float_ry"));
  EXPECT_NEAR(here.state.z[ry], std::numbers::pi / 2, 1e-9);
  here.go(100, 1e-3);
  EXPECT_EQ(here.worst.code, Code::ok);
  EXPECT_NEAR(here.outputs()[3], 0.5 * 2 * 2 * 2, 1e-10);
}

// A law on one of the angles makes the angle itself meant: no other chart then.
TEST(Orientation, KeepsAnglesThatLawsAreOn) {
  EXPECT_EQ(mechanism_of(racket("zyx", "{}")).topology.balls.size(), 1u);
  const std::string held = with(racket("zyx", "{}"), R"("outputs")",
                                R"("joint_springs": { "s": { "joint": "float_rz", "stiffness": 1 } }, "outputs")");
  EXPECT_TRUE(mechanism_of(held).topology.balls.empty());
}

}  // namespace
}  // namespace mbgen
