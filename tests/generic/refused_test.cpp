// Mechanisms with locked coordinates or special geometry (tests/data/refused): states of an independent solver, starts,
// runs and reactions.

#include <cmath>

#include "tests/support/dynamics.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

const std::string kFolder = "tests/data/refused/";

class Refused : public ::testing::TestWithParam<std::string> {};

/// The states have locked coordinates at rounding of zero; where the solver closes them matters to no acceleration.
TEST_P(Refused, HasTheAccelerationsOfTheIndependentSolver) {
  const Mechanism m = load(kFolder + GetParam() + ".json");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<ReferenceState> states = reference_states(m.topology, kFolder + GetParam() + "_ref.json");
  ASSERT_FALSE(states.empty());
  for (ReferenceState s : states) {
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(s.state, s.tau, derivative).ok());
    EXPECT_LT(relative_error(derivative.zdd, s.zdd), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(WithStates, Refused,
                         ::testing::Values("m4", "m7", "k0_s20261127", "k0_s20261140", "k0_s20261160", "k0_s20261175",
                                           "k0_s20261198", "k1_s31030"),
                         [](const auto& info) { return info.param; });

class Started : public ::testing::TestWithParam<std::string> {};

/// From the velocities that the closures leave of a start, energy is kept over a run.
TEST_P(Started, RunsAndKeepsItsEnergy) {
  const Mechanism m = load(kFolder + GetParam() + ".json");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  const int moved = free_coordinates(m.topology, m.analysis)[0];
  ASSERT_TRUE(solver.project(state).ok());
  ASSERT_TRUE(solver.assemble_velocities(state, {{moved, 1.0, 1.0, true}}).ok());
  EXPECT_NEAR(state.zd[static_cast<std::size_t>(moved)], 1.0, 1e-9);
  const auto energy = [&] {
    GenericDerivative derivative;
    const std::vector<double> tau(state.z.size(), 0.0);
    EXPECT_TRUE(solver.accelerations(state, tau, derivative).ok());
    const GenericOutputs outputs = solver.outputs(state, tau, derivative);
    return outputs.kinetic_energy + outputs.potential_energy;
  };
  const double before = energy();
  const Dynamics dynamics{solver};
  for (int k = 0; k < 100; ++k) ASSERT_TRUE(step_rk4(dynamics, state, 1e-3).ok()) << k;
  EXPECT_NEAR(energy(), before, 1e-6 * (1 + std::abs(before)));
}

INSTANTIATE_TEST_SUITE_P(SpecialGeometry, Started, ::testing::Values("shaker", "deltaR", "bricard"),
                         [](const auto& info) { return info.param; });

/// By hand, moments about y of the forearm about the elbow and of both about the shoulder, with (X, Z) on the hand:
/// 0.4 Z + 0.2 X = 0.2 * 2 g and 0.9 Z - 0.2 X = 0.25 * 3 g + 0.7 * 2 g. The ball, the `to` of the joint, feels the
/// opposite.
TEST(ArmOnBall, StandsAndGivesItsReactions) {
  Mechanism m = load(kFolder + "arm_on_ball.json");
  for (const Output& output : std::vector<Output>(m.model.outputs)) {
    m.model.outputs.push_back(output);
    std::get<ReactionOutput>(m.model.outputs.back().source).end = ReactionOutput::End::from;
  }
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const double g = 9.81, lift = (0.4 + 0.75 + 1.4) * g / 1.3, pull = (0.4 * g - 0.4 * lift) / 0.2;
  GenericState state = reference_state(m);
  const std::vector<double> tau(3, 0.0);
  GenericDerivative derivative;
  ASSERT_TRUE(solver.project(state).ok());
  ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
  for (double zdd : derivative.zdd) EXPECT_NEAR(zdd, 0, 1e-12);
  const GenericOutputs outputs = solver.outputs(state, tau, derivative);
  ASSERT_EQ(outputs.y.size(), 4u);
  const double on_ball_and_hand[] = {-pull, -lift, pull, lift};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(outputs.y[i], on_ball_and_hand[i], 1e-10) << i;
}

}  // namespace
}  // namespace mbgen
