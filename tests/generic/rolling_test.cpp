// Rolling without slip and knife edges against closed forms: precession of a disc, the penny, Chaplygin's sleigh, the
// cycloid of a blade on a slope, a ball on a turntable.

#include <cmath>
#include <numbers>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A mechanism in motion by the generic runtime.
class Rolling : public MechanismInState {
 public:
  using MechanismInState::MechanismInState;

  void project() { ASSERT_TRUE(solver_.project(state_).ok()); }

  /// Solves the equations of motion, which two Cartesian judges solve, too.
  void solve() {
    const std::vector<double> no_tau(state_.z.size(), 0.0);
    ASSERT_TRUE(solver_.accelerations(state_, no_tau, derivative_).ok());
    lambda_ = solver_.multipliers(state_, no_tau, derivative_);
    for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::maggi}) {
      const CartesianSolver judge(m_.model, m_.topology, method, Stabilisation::projection);
      GenericDerivative other;
      ASSERT_TRUE(judge.accelerations(state_, no_tau, other).ok());
      for (std::size_t i = 0; i < state_.z.size(); ++i)
        EXPECT_NEAR(other.zdd[i], derivative_.zdd[i], 1e-10 * (1 + std::abs(derivative_.zdd[i]))) << i;
    }
  }
  void run(double duration, double step) {
    const Dynamics dynamics{solver_};
    for (long k = 0; k < std::lround(duration / step); ++k)
      ASSERT_TRUE(step_rk4(dynamics, state_, step).ok()) << state_.t;
  }

  double lambda(std::size_t row) const { return lambda_[row]; }
  double energy() {
    const std::vector<double> no_tau(state_.z.size(), 0.0);
    EXPECT_TRUE(solver_.accelerations(state_, no_tau, derivative_).ok());
    const GenericOutputs outputs = solver_.outputs(state_, no_tau, derivative_);
    return outputs.kinetic_energy + outputs.potential_energy;
  }
  int coordinate(const std::string& name) const { return static_cast<int>(index(name)); }

 private:
  std::vector<double> lambda_;
};

// A thin disc of tilt p that precesses steadily at the rate W: with s the turn about its axle, as ground sees it, its
// angular momentum W x (m r^2/2 s along the axle and m r^2/4 W cos p across) takes the moment of the force m (r s W
// inwards, g up) at the rim: W cos p (W sin p / 4 - s / 2) = W s cos p + g / r sin p.
class Precession : public ::testing::TestWithParam<double> {};

TEST_P(Precession, OfADiscIsSteady) {
  const double r = 0.3, m = 2, g = 9.81, turning = 1.7, tilt = GetParam();
  const double sine = std::sin(tilt), cosine = std::cos(tilt);
  const double spin = (turning * turning * sine * cosine / 4 - g / r * sine) / (1.5 * turning * cosine);
  Rolling disc(load("models/rolling_disc.json"));
  EXPECT_EQ(disc.analysis().degrees_of_freedom, 3);
  EXPECT_EQ(disc.analysis().position_freedoms, 5);
  disc.set("disc_rx", tilt, 0);
  disc.set("disc_rz", 0, turning);
  disc.set("disc_ry", 0, spin - turning * sine);
  disc.set("disc_tz", r * (cosine - 1), 0);
  disc.set("disc_tx", 0, r * spin);
  const GenericState wanted = disc.state();
  disc.project();
  for (std::size_t i = 0; i < wanted.z.size(); ++i) {
    EXPECT_NEAR(disc.state().z[i], wanted.z[i], 1e-14) << i;
    EXPECT_NEAR(disc.state().zd[i], wanted.zd[i], 1e-13 * (1 + std::abs(spin))) << i;
  }
  disc.solve();
  for (const char* name : {"disc_rx", "disc_ry", "disc_rz", "disc_tz", "disc_tx"})
    EXPECT_NEAR(disc.zdd(name), 0, 1e-10) << name;
  EXPECT_NEAR(disc.zdd("disc_ty"), r * spin * turning, 1e-10);
  EXPECT_NEAR(disc.lambda(0), m * g, 1e-10);
  EXPECT_NEAR(disc.lambda(1), 0, 1e-10);
  EXPECT_NEAR(disc.lambda(2), m * r * spin * turning, 1e-9);
  disc.run(2, 5e-3);
  const double radius = r * spin / turning;
  EXPECT_NEAR(disc.z("disc_tx"), radius * std::sin(2 * turning), 1e-6 * std::abs(radius));
  EXPECT_NEAR(disc.z("disc_ty"), radius * (1 - std::cos(2 * turning)), 1e-6 * std::abs(radius));
  EXPECT_NEAR(disc.z("disc_rx"), tilt, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Tilts, Precession, ::testing::Values(-0.9, -0.2, 0.35, 1.2));

TEST(RollingDisc, KeepsItsEnergyAndStaysOnThePlane) {
  Rolling disc(load("models/rolling_disc.json"));
  disc.set("disc_rx", 0.3, 0.4);
  disc.set("disc_rz", 0, 1.5);
  disc.set("disc_ry", 0, 8);
  disc.project();
  const double before = disc.energy();
  disc.run(10, 2e-3);
  EXPECT_NEAR(disc.energy(), before, 1e-7 * std::abs(before));
  EXPECT_NEAR(disc.z("disc_tz"), 0.3 * (std::cos(disc.z("disc_rx")) - 1), 1e-12);
}

// Every position that rolling leaves free is met at the start, and the height follows; of velocities there are fewer.
TEST(RollingDisc, StartsWhereverItIsPut) {
  Rolling disc(load("models/rolling_disc.json"));
  std::vector<CoordinateTarget> targets;
  const std::pair<const char*, double> wanted[] = {
      {"disc_tx", 3.2}, {"disc_ty", -1.7}, {"disc_rz", 2.4}, {"disc_rx", -0.6}, {"disc_ry", 5}};
  for (const auto& [name, value] : wanted) targets.push_back({disc.coordinate(name), value});
  ASSERT_TRUE(disc.solver().assemble(disc.state(), targets).ok());
  for (const auto& [name, value] : wanted) EXPECT_NEAR(disc.z(name), value, 1e-12) << name;
  EXPECT_NEAR(disc.z("disc_tz"), 0.3 * (std::cos(0.6) - 1), 1e-12);
  ASSERT_TRUE(disc.solver().assemble_velocities(disc.state(), {{disc.coordinate("disc_ry"), 4.0}}).ok());
  EXPECT_NEAR(disc.zd("disc_ry"), 4, 1e-12);
  const double turn = 4 + disc.zd("disc_rz") * std::sin(-0.6);  // about the axle, as ground sees it
  EXPECT_NEAR(std::hypot(disc.zd("disc_tx"), disc.zd("disc_ty")), 0.3 * turn, 1e-12);
}

// A disc that a fork holds upright keeps its rates: its centre goes round in a circle of radius r spin / turning. The
// plane of the fork holds the height already.
TEST(Penny, RollsInACircle) {
  const double r = 0.2, spin = 5, turning = 0.8, time = 6;
  Rolling penny(mechanism_of(R"({ "mbgen": 1, "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "fork": { "mass": 0.3, "inertia": [0.01, 0.01, 0.02], "points": { "O": [0, 0, 0], "axle": [0, 0, 0.2] } },
      "penny": { "mass": 1, "pose": { "origin": [0, 0, 0.2] }, "inertia": [0.01, 0.02, 0.01], "points": { "C": [0, 0, 0] } } },
    "joints": {
      "fork": { "type": "planar", "from": "ground.O", "to": "fork.O", "axis": "z" },
      "axle": { "type": "revolute", "from": "fork.axle", "to": "penny.C", "axis": "y" },
      "contact": { "type": "rolling_disc", "from": "ground.O", "to": "penny.C", "axis": "z", "axis2": "y" } } })"));
  EXPECT_EQ(penny.analysis().degrees_of_freedom, 2);
  EXPECT_EQ(penny.analysis().position_freedoms, 4);
  ASSERT_EQ(penny.analysis().blocks[0].redundant_names.size(), 1);
  EXPECT_EQ(penny.analysis().blocks[0].redundant_names[0], "contact.normal");
  penny.set("fork_rz", 0, turning);
  penny.set("axle", 0, spin);
  penny.set("fork_tx", 0, r * spin);
  penny.project();
  penny.run(time, 1e-2);
  EXPECT_NEAR(penny.z("axle"), spin * time, 1e-8);
  EXPECT_NEAR(penny.z("fork_rz"), turning * time, 1e-10);
  EXPECT_NEAR(penny.z("fork_tx"), r * spin / turning * std::sin(turning * time), 1e-8);
  EXPECT_NEAR(penny.z("fork_ty"), r * spin / turning * (1 - std::cos(turning * time)), 1e-8);
  penny.solve();
  EXPECT_NEAR(penny.lambda(2), 1.3 * r * spin * turning, 1e-10);
}

// S. A. Chaplygin, 1911: with J about the blade, u = w sqrt(J/m) tanh(k t) and omega = w sech(k t), k = a w sqrt(m/J).
TEST(ChaplyginSleigh, EndsUpRunningStraight) {
  const double m = 3, a = 0.4, j = 0.2 + m * a * a, w = 2, k = a * w * std::sqrt(m / j);
  Rolling sleigh(load("models/chaplygin_sleigh.json"));
  EXPECT_EQ(sleigh.analysis().degrees_of_freedom, 2);
  EXPECT_EQ(sleigh.analysis().position_freedoms, 3);
  sleigh.set("sleigh_rz", 0, w);
  sleigh.project();
  for (const double t : {0.5, 2.0}) {
    sleigh.run(t - sleigh.state().t, 2e-3);
    const double heading = sleigh.z("sleigh_rz");
    const double along = sleigh.zd("sleigh_tx") * std::cos(heading) + sleigh.zd("sleigh_ty") * std::sin(heading);
    const double across = sleigh.zd("sleigh_ty") * std::cos(heading) - sleigh.zd("sleigh_tx") * std::sin(heading);
    EXPECT_NEAR(along, w * std::sqrt(j / m) * std::tanh(k * t), 1e-9);
    EXPECT_NEAR(across, 0, 1e-13);
    EXPECT_NEAR(sleigh.zd("sleigh_rz"), w / std::cosh(k * t), 1e-9);
    EXPECT_NEAR(heading, w / k * std::asin(std::tanh(k * t)), 1e-9);
  }
  sleigh.solve();
  const double u = w * std::sqrt(j / m) * std::tanh(2 * k), omega = w / std::cosh(2 * k);
  EXPECT_NEAR(sleigh.lambda(0), m * 0.2 / j * u * omega, 1e-8);  // to the left, on the blade
}

// A blade on a slope of g' that turns at the rate w slides sideways: its point draws a cycloid.
TEST(KnifeEdge, DrawsACycloidOnASlope) {
  const double g = 4.3, w = 2.5, time = 3;
  Rolling blade(mechanism_of(R"({ "mbgen": 1, "gravity": [4.3, 0, -8], "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "skate": { "mass": 2, "inertia": [0.2, 0.2, 0.3], "points": { "O": [0, 0, 0] } } },
    "joints": {
      "skate": { "type": "planar", "from": "ground.O", "to": "skate.O", "axis": "z" },
      "blade": { "type": "knife_edge", "from": "ground.O", "to": "skate.O", "axis": "z", "axis2": "x" } } })"));
  blade.set("skate_rz", 0, w);
  blade.project();
  blade.run(time, 5e-3);
  EXPECT_NEAR(blade.z("skate_tx"), g / (2 * w * w) * std::pow(std::sin(w * time), 2), 1e-8);
  EXPECT_NEAR(blade.z("skate_ty"), g / (2 * w * w) * (w * time - std::sin(2 * w * time) / 2), 1e-8);
  blade.solve();
  EXPECT_NEAR(blade.lambda(0), 2 * 2 * g * std::sin(w * time), 1e-8);
}

// A ball on a turntable of rate W goes round in a circle at 2/7 W (E. Routh; J. A. Burns, Am. J. Phys. 49, 1981), and
// down a slope it has 5/7 of the acceleration of what slides.
TEST(RollingBall, GoesRoundOnATurntable) {
  const std::string model = R"({ "mbgen": 1, "gravity": [GRAVITY], "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "B": [0.5, 0, 0.1] } },
      "table": { "mass": 10, "inertia": [1, 1, 2], "points": { "O": [0, 0, 0] } },
      "ball": { "mass": 1, "pose": { "origin": [0.5, 0, 0.1] }, "inertia": [0.004, 0.004, 0.004], "points": { "C": [0, 0, 0] } } },
    "joints": {
      "table": { "type": "revolute", "from": "ground.O", "to": "table.O", "axis": "z" },
      "ball": { "type": "free", "from": "ground.B", "to": "ball.C" },
      "contact": { "type": "rolling_ball", "from": "table.O", "to": "ball.C", "axis": "z" } },
    "motions": { "table": { "joint": "table", "angle": "RATE*t" } } })";
  const auto with = [&](const std::string& gravity, const std::string& rate) {
    std::string text = model;
    text.replace(text.find("GRAVITY"), 7, gravity);
    return mechanism_of(text.replace(text.find("RATE"), 4, rate));
  };
  const double turning = 3.5, rate = turning * 2 / 7, u = 0.3, time = 2;
  Rolling ball(with("0, 0, -9.81", "3.5"));
  ball.set("ball_tx", 0, u);
  ASSERT_TRUE(ball.solver()
                  .assemble_velocities(ball.state(), {{ball.coordinate("ball_tx"), u, 1, true},
                                                      {ball.coordinate("ball_ty"), 0, 1, true},
                                                      {ball.coordinate("ball_rz"), 0, 1, true}})
                  .ok());
  ball.run(time, 2.5e-3);
  EXPECT_NEAR(ball.z("ball_tx"), u / rate * std::sin(rate * time), 4e-9);
  EXPECT_NEAR(ball.z("ball_ty"), u / rate * (1 - std::cos(rate * time)), 4e-9);
  Rolling slope(with("2, 0, -9", "0"));
  slope.project();
  slope.solve();
  EXPECT_NEAR(slope.zdd("ball_tx"), 2 * 5.0 / 7, 1e-12);
  EXPECT_NEAR(slope.lambda(0), 9, 1e-12);
}

}  // namespace
}  // namespace mbgen
