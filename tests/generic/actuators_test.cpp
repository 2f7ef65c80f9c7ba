// Rods whose lengths are given over time or by inputs: closed forms of a crane and of a platform on six legs.

#include <cmath>

#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A state at an instant with its accelerations and outputs.
struct Moment {
  Mechanism m;
  GenericState state;
  GenericDerivative derivative;
  std::vector<double> y;

  Moment(Model model, double t, const std::vector<double>& inputs = {}) : m(analysed(std::move(model))) {
    GenericSolver solver(m.model, m.topology, m.analysis);
    if (!inputs.empty()) solver.set_inputs(inputs);
    state = reference_state(m);
    state.t = t;
    EXPECT_TRUE(solver.project(state).ok());
    const std::vector<double> no_tau(state.z.size(), 0.0);
    EXPECT_TRUE(solver.accelerations(state, no_tau, derivative).ok());
    y = solver.outputs(state, no_tau, derivative).y;
  }
  std::size_t at(const std::string& name) const { return static_cast<std::size_t>(find_coordinate(m.topology, name)); }
};

std::string crane(const std::string& length) {
  return R"({ "mbgen": 1, "gravity": [0, 0, -10],
    "inputs": { "way": { "default": 0.9, "derivative": "speed" }, "speed": { "derivative": "gain" }, "gain": { "default": 1.9 } },
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "foot": [0.6, 0, -0.8] } },
      "boom": { "mass": 10, "com": [1.5, 0, 0], "inertia": [2, 2, 2], "points": { "O": [0, 0, 0], "eye": [1, 0, 0] } } },
    "joints": { "boom": { "type": "revolute", "from": "ground.O", "to": "boom.O", "axis": "y" } },
    "rods": { "lift": { "from": "ground.foot", "to": "boom.eye", "length": ")" +
         length + R"(" } },
    "outputs": { "push": { "motion": "lift_length" }, "tension": { "multiplier": "lift" },
      "x": { "reaction": "lift", "axis": "x" }, "z": { "reaction": "lift", "axis": "z" } } })";
}

/// The triangle of two sides of 1 m and the rod: the angle in the pin is 2 asin(length / 2). Forces by virtual work.
void expect_crane(const Moment& at, double length, double rate, double second) {
  const double reference = std::acos(0.6), angle = 2 * std::asin(length / 2), lever = std::cos(angle / 2);
  const double turning = rate / lever, gain = (second + 0.5 * std::sin(angle / 2) * turning * turning) / lever;
  EXPECT_NEAR(at.state.z[at.at("boom")], reference - angle, 1e-12);
  EXPECT_NEAR(at.state.zd[at.at("boom")], -turning, 1e-12);
  EXPECT_NEAR(at.derivative.zdd[at.at("boom")], -gain, 1e-11);
  EXPECT_NEAR(at.state.zd[at.at("lift_length")], rate, 1e-15);
  const double rise = angle - reference;
  const double push = ((2 + 10 * 1.5 * 1.5) * gain + 10 * 10 * 1.5 * std::cos(rise)) / lever;
  EXPECT_NEAR(at.y[0], push, 1e-9);
  EXPECT_NEAR(at.y[1], -push, 1e-9);
  EXPECT_NEAR(at.y[2], push * (std::cos(rise) - 0.6) / length, 1e-9);
  EXPECT_NEAR(at.y[3], push * (std::sin(rise) + 0.8) / length, 1e-9);
}

TEST(Actuator, LiftsACraneOverTime) {
  for (const double t : {0.0, 0.4, 1.1})
    expect_crane(Moment(model_of(crane("0.9 + 0.2*sin(3*t)")), t), 0.9 + 0.2 * std::sin(3 * t), 0.6 * std::cos(3 * t),
                 -1.8 * std::sin(3 * t));
}

TEST(Actuator, LiftsACraneByAnInputWithItsDerivatives) {
  expect_crane(Moment(model_of(crane("way")), 0, {1.05, -0.4, 2.5}), 1.05, -0.4, 2.5);
  // A length that no derivative of an input is known of stands still.
  expect_crane(Moment(model_of(crane("0.5*gain")), 0, {0, 0, 1.9}), 0.95, 0, 0);
}

// Legs as long as a known motion of the platform makes them: it moves so. The legs carry its weight and inertia.
TEST(Actuator, SixOfThemMoveAPlatform) {
  Model model = load("tests/data/models/stewart.json").model;
  model.outputs.clear();
  for (int leg = 0; leg < 6; ++leg) add_reaction(model, -1, leg, ReactionOutput::What::force, ReactionOutput::End::to);
  for (const double t : {0.0, 0.3, 0.9}) {
    const Moment at(model, t);
    EXPECT_EQ(at.m.analysis.degrees_of_freedom, 6);
    EXPECT_EQ(at.m.analysis.blocks[0].driven.size(), 6u);
    const double turn = 0.2 * std::sin(2 * t), rate = 0.4 * std::cos(2 * t), gain = -0.8 * std::sin(2 * t);
    const Force place{0.1 * std::sin(2 * t), 0.05 * std::cos(3 * t) - 0.05, 0.08 * std::sin(t)};
    const Force speed{0.2 * std::cos(2 * t), -0.15 * std::sin(3 * t), 0.08 * std::cos(t)};
    const Force second{-0.4 * std::sin(2 * t), -0.45 * std::cos(3 * t), -0.08 * std::sin(t)};
    const auto triple = [&](const std::vector<double>& v, const char* kind) {
      const std::string name = std::string("platform_") + kind;
      return Force{v[at.at(name + "x")], v[at.at(name + "y")], v[at.at(name + "z")]};
    };
    expect_vector(triple(at.state.z, "t"), place, 1e-11, "place");
    expect_vector(triple(at.state.zd, "t"), speed, 1e-11, "velocity");
    expect_vector(triple(at.derivative.zdd, "t"), second, 1e-10, "acceleration");
    expect_vector(triple(at.state.z, "r"), {0, 0, turn}, 1e-11, "turn");
    expect_vector(triple(at.state.zd, "r"), {0, 0, rate}, 1e-11, "rate");
    expect_vector(triple(at.derivative.zdd, "r"), {0, 0, gain}, 1e-10, "angular acceleration");
    const double cx = 0.05 * std::cos(turn) + 0.02 * std::sin(turn), cy = 0.05 * std::sin(turn) - 0.02 * std::cos(turn);
    Force sum;
    for (int leg = 0; leg < 6; ++leg) sum = sum + vector_at(at.y, 3 * leg);
    expect_vector(sum,
                  {50 * (second.x - gain * cy - rate * rate * cx), 50 * (second.y + gain * cx - rate * rate * cy),
                   50 * (second.z + 9.81)},
                  1e-8, "sum of the legs' forces");
  }
}

}  // namespace
}  // namespace mbgen
