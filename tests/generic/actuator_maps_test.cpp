// Maps between motors and joints in the generic runtime, against the least forces of the judges, which know neither
// free directions nor factors of loops.

#include <algorithm>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen::testing {
namespace {

/// A four-bar with motors at both of its pins on ground, and a cylinder along its spring.
Mechanism pushed_four_bar() {
  return analysed(read_model(R"({ "mbgen": 1, "name": "pushed", "include": [")" + source_path("models/four_bar.json") +
                                 R"("], "actuators": { "crank": { "joint": "crank_pin", "gear": 4 },
         "rocker": { "joint": "rocker_pin", "weight": 3 }, "ram": { "spring": "return_spring", "gear": 2 } },
         "solver": { "closure_tolerance": 1e-13 } })",
                             "pushed.json"));
}

TEST(ActuatorMapsOfTheGenericRuntime, AreThoseOfTheJudges) {
  const Mechanism m = pushed_four_bar();
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::null_space, Stabilisation::projection);
  const std::vector<double> tau = {3, -1, 0.5}, none(3, 0.0);
  for (const GenericState& state : random_states(m, 5)) {
    std::vector<double> position, speed, mapped, jacobian;
    ASSERT_TRUE(solver.actuator_positions(state, position, speed).ok());
    ASSERT_TRUE(solver.forces_at_actuators(state, tau, mapped).ok());
    ASSERT_TRUE(solver.actuator_jacobian(state, jacobian).ok());
    // Other forces on the coordinates are borne by the actuators.
    std::vector<double> with, without;
    GenericDerivative derivative{none, {}}, other{none, {}};
    const std::vector<int> independent = free_coordinates(m.topology, m.analysis);
    ASSERT_TRUE(judge.inverse_dynamics(state, tau, independent, derivative, with).ok());
    ASSERT_TRUE(judge.inverse_dynamics(state, none, independent, other, without).ok());
    std::vector<double> rates(3, 0.0), transposed(3, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(without[i] - with[i], mapped[i], 1e-9 * (std::abs(mapped[i]) + std::abs(without[i])));
      for (std::size_t c = 0; c < 3; ++c) {
        rates[c] += jacobian[3 * c + i] * speed[i];
        transposed[i] += jacobian[3 * c + i] * tau[c];
      }
    }
    EXPECT_LT(relative_error(rates, state.zd), 1e-12);
    EXPECT_LT(relative_error(transposed, mapped), 1e-12);
    // The same power on the independent coordinate alone, whatever moves the state.
    std::vector<double> reduced;
    ASSERT_TRUE(solver.forces_at_independent(state, mapped, reduced).ok());
    double power = 0;
    for (std::size_t c = 0; c < 3; ++c) power += tau[c] * state.zd[c];
    const auto free = static_cast<std::size_t>(independent[0]);
    EXPECT_NEAR(reduced[free] * state.zd[free], power, 1e-12 * std::abs(power));
    EXPECT_EQ(std::ranges::count(reduced, 0.0), 2);
    // Motors lead to the state again, and their accelerations to its.
    GenericState near = state;
    near.z[static_cast<std::size_t>(independent[0])] += 0.02;
    near.zd = none;
    ASSERT_TRUE(solver.project(near).ok());
    ASSERT_TRUE(solver.complete_joints(position, speed, near).ok());
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(near.z[c], state.z[c], 1e-12);
    EXPECT_LT(relative_error(near.zd, state.zd), 1e-8);
    GenericDerivative motion;
    ASSERT_TRUE(solver.accelerations(state, none, motion).ok());
    constexpr double kStep = 1e-4;
    std::vector<double> acceleration(3), before, after, unused, zdd;
    const auto positions_at = [&](double t, std::vector<double>& found) {
      GenericState moved = state;
      for (std::size_t c = 0; c < 3; ++c) moved.z[c] += t * (state.zd[c] + t / 2 * motion.zdd[c]);
      ASSERT_TRUE(solver.actuator_positions(moved, found, unused).ok());
    };
    positions_at(-kStep, before);
    positions_at(kStep, after);
    for (std::size_t i = 0; i < 3; ++i) acceleration[i] = (after[i] - 2 * position[i] + before[i]) / (kStep * kStep);
    ASSERT_TRUE(solver.complete_accelerations(state, acceleration, zdd).ok());
    EXPECT_LT(relative_error(zdd, motion.zdd), 1e-5);
  }
}

/// The cylinder alone does not move the crank where both are in line.
TEST(ActuatorMapsOfTheGenericRuntime, NameTheActuatorNearItsDeadCentre) {
  const Mechanism m = analysed(read_model(R"({ "mbgen": 1, "name": "crank", "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "F": [-1, 0, 0] } },
      "crank": { "mass": 1, "com": [0.1, 0, 0], "inertia": [0.1, 0.1, 0.1],
                 "points": { "O": [0, 0, 0], "P": [0, 0, 0.2] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "y" } },
    "actuators": { "ram": { "from": "ground.F", "to": "crank.P" } } })",
                                          "crank.json"));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const auto at = [&](double angle) { return GenericState{.z = {angle}, .zd = {0}, .x = {}, .t = 0}; };
  std::vector<double> force;
  ASSERT_TRUE(solver.forces_at_actuators(at(0), {5}, force).ok());
  // Lever of the line from (-1, 0) to (0, 0.2) about the origin.
  EXPECT_NEAR(force[0], 5 * std::hypot(1, 0.2) / 0.2, 1e-12);
  const Status status = solver.forces_at_actuators(at(M_PI / 2 + 1e-3), {5}, force);
  EXPECT_EQ(status.code, Code::actuators_singular);
  EXPECT_EQ(actuated_directions(m.model, m.topology, m.analysis).at(static_cast<std::size_t>(status.index)),
            "ram on pin");
}

}  // namespace
}  // namespace mbgen::testing
