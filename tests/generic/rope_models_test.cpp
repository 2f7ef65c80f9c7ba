// The models of models/ropes: each does its work.

#include <cmath>

#include "mbgen/solver/rosenbrock.hpp"
#include "tests/support/dynamics.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A model whose outputs are looked at by name while it moves.
class Working : public MechanismInState {
 public:
  explicit Working(const std::string& name) : MechanismInState(load("models/ropes/" + name)), dynamics_{solver_} {}

  double output(const std::string& name) {
    const std::vector<double> tau(state_.z.size());
    EXPECT_TRUE(solver_.accelerations(state_, tau, derivative_).ok());
    const std::vector<double> y = solver_.outputs(state_, tau, derivative_).y;
    for (std::size_t i = 0; i < y.size(); ++i)
      if (m_.model.outputs[i].name == name) return y[i];
    ADD_FAILURE() << name;
    return 0;
  }
  void run(double until, double h) {
    for (const auto steps = std::lround((until - state_.t) / h); state_.t < until - h / 2 && steps > 0;)
      ASSERT_TRUE(step_rosenbrock(dynamics_, state_, h).ok()) << state_.t;
  }

 private:
  Dynamics dynamics_;
};

// The controller brings the car up; the counterweight is the heavier one, and the groove holds both.
TEST(RopeModels, ElevatorDrivesUp) {
  Working m("elevator.json");
  double largest = 0;
  for (int k = 1; k <= 20; ++k) {
    m.run(0.5 * k, 2e-3);
    const double ratio = m.output("counter_pull") / m.output("car_pull");
    EXPECT_GT(ratio, 1) << k;
    largest = std::max(largest, ratio);
  }
  // 1.6 m/s over 6 s, less the lag of the controller; sheave and car go the same way up to the stretch.
  EXPECT_NEAR(m.output("height"), 9.6, 0.1);
  EXPECT_NEAR(m.output("height"), 0.3 * m.z("sheave"), 0.02);
  EXPECT_LT(largest, std::exp(0.22 * 3.1416));
}

TEST(RopeModels, CraneLiftsItsLoadOnTwoFalls) {
  Working m("crane.json");
  const double before = m.output("height");
  m.run(10, 4e-3);
  // The drum takes in 0.15 m times its turn, and each of the falls half of it; the load swings a little.
  EXPECT_NEAR(m.output("height") - before, -0.15 * m.z("drum") / 2, 0.05);
  EXPECT_NEAR(m.output("pull"), 2072 * 9.81 / 2, 0.03 * 2072 * 9.81);
  EXPECT_NEAR(m.output("swing"), m.z("trolley") + 0.075, 0.5);
}

TEST(RopeModels, CableRobotFollowsItsCircle) {
  Working m("cable_robot.json");
  for (int k = 1; k <= 12; ++k) {
    m.run(0.5 * k, 4e-3);
    if (k < 4) continue;
    EXPECT_NEAR(m.output("x"), 0.4 * std::sin(0.6 * k), 0.01) << k;
    EXPECT_NEAR(m.output("y"), 0.4 * std::cos(0.6 * k), 0.01) << k;
    EXPECT_GT(m.output("upper_pull"), 0) << k;
    EXPECT_GT(m.output("lower_pull"), 0) << k;
  }
}

}  // namespace
}  // namespace mbgen
