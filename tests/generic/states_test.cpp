// States of the user's own and sampled values against closed forms: a lag, a second-order filter, a tank that empties,
// oil as a spring, a controller as a difference equation; and against the judges.

#include <array>
#include <cmath>
#include <complex>

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/course.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A slide of 2 kg along x without gravity, with these sections.
std::string slide(const std::string& sections) {
  return R"model({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "wall": [-0.5, 0, 0], "stop": [0.5, 0, 0] } },
      "slide": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" } },)model" +
         sections + "}";
}

TEST(UserStates, LagAndSecondOrderFilterAnswerAStep) {
  Course course(slide(R"model("inputs": { "u": { "default": 3 } }, "states": {
    "lag": { "derivative": "(u - lag)/0.2", "initial": 1 },
    "swing": { "derivative": "speed" },
    "speed": { "derivative": "25*(u - swing) - 2*0.3*5*speed" } })model"));
  ASSERT_TRUE(course.step(1000, 1e-3).ok());
  EXPECT_NEAR(course.x("lag"), 3 - 2 * std::exp(-5.0), 1e-11);
  const double damped = 5 * std::sqrt(1 - 0.09);
  const double expected = 3 * (1 - std::exp(-1.5) * (std::cos(damped) + 1.5 / damped * std::sin(damped)));
  EXPECT_NEAR(course.x("swing"), expected, 1e-10);
}

// Torricelli: the root of the height falls with constant speed, a sqrt(g / 2) / A.
TEST(UserStates, TankEmptiesThroughItsOrifice) {
  Course course(slide(R"model("parameters": { "hole": { "value": 2e-4, "tunable": true } }, "states": {
    "height": { "derivative": "-hole/0.05*sqrt(2*9.81*max(height, 0))", "initial": 1.5, "unit": "m" } })model"));
  ASSERT_TRUE(course.step(1000, 0.05).ok());
  const double root = std::sqrt(1.5) - 50 * 2e-4 / 0.05 * std::sqrt(9.81 / 2);
  EXPECT_NEAR(course.x("height"), root * root, 1e-10);
}

/// A slide between two chambers of oil with closed valves: cylinders of the lengths 0.5 m to both sides.
const char* const kEnclosedOil = R"model("parameters": { "bulk": 1.4e9, "area": 1e-3 },
  "states": {
    "front": { "derivative": "-bulk*rate.front/length.front", "initial": 5e6, "unit": "Pa" },
    "back": { "derivative": "-bulk*rate.back/length.back", "initial": 5e6, "unit": "Pa" } },
  "springs": {
    "front": { "from": "ground.wall", "to": "slide.O", "force": "-area*front" },
    "back": { "from": "ground.stop", "to": "slide.O", "force": "-area*back" } },
  "initial": { "velocities": { "slide": 1e-3 } })model";

// Oil that is shut in keeps p + bulk log(length), so the stiffness at the middle is 2 bulk area / 0.5 m.
TEST(UserStates, ShutOilIsASpring) {
  Course course(slide(kEnclosedOil));
  course.state.zd[0] = 1e-3;
  const double omega = std::sqrt(2 * 1.4e9 * 1e-3 / 0.5 / 2);
  const double h = 2 * M_PI / omega / 400;
  ASSERT_TRUE(course.step(100, h).ok());  // a quarter of a period
  EXPECT_NEAR(course.state.z[0], 1e-3 / omega, 1e-9 / omega);
  EXPECT_NEAR(course.state.zd[0], 0, 1e-9);
  EXPECT_NEAR(course.x("front"), 5e6 - 1.4e9 * std::log1p(course.state.z[0] / 0.5), 1e-2);
}

// A load hangs on a cylinder whose orifice lets the pressure of the supply through: at rest both pressures are one, and
// the load is held where the spring beside it takes the rest.
TEST(UserStates, EquilibriumFindsWhatStandsStill) {
  Course course(slide(R"model("states": {
      "oil": { "derivative": "1e9*(1e-9*(2e5 - oil) - 1e-3*rate.cylinder)/(1e-3*length.cylinder)", "initial": 1e5,
        "unit": "Pa" },
      "lag": { "derivative": "(z.slide - lag)/0.1" } },
    "springs": { "cylinder": { "from": "ground.wall", "to": "slide.O", "force": "-1e-3*oil", "damping": 10 },
      "back": { "from": "slide.O", "to": "ground.stop", "stiffness": 4000 } })model"));
  ASSERT_TRUE(course.solver.equilibrium(course.state).ok());
  EXPECT_NEAR(course.x("oil"), 2e5, 1e-2);
  EXPECT_NEAR(course.state.z[0], 200 / 4000.0, 1e-9);
  EXPECT_NEAR(course.x("lag"), 0.05, 1e-9);
}

/// A force that is held moves the slide by v T + F T^2 / 4 in a period T, exactly.
struct Held {
  double z = 0, v = 0;
  void pass(double force, double period) {
    z += v * period + force * period * period / 4;
    v += force * period / 2;
  }
};

constexpr double kPeriod = 0.01;

/// A PID controller of the slide's position with the wanted one 1 m; the force acts `delay` periods later.
std::string pid(const std::string& delay) {
  return slide(R"model("sampled": {
    "error": { "period": 0.01, "value": "1 - z.slide" },
    "sum": { "period": 0.01, "value": "sum + 0.01*error" },
    "force": { "period": 0.01, "value": "60*error + 20*sum + 18*(error - last)/0.01", "unit": "N", "delay": )model" +
               delay + R"model(, "initial": 2 },
    "last": { "period": 0.01, "value": "error" } },
    "joint_forces": { "drive": { "joint": "slide", "force": "force" } })model");
}

// The closed loop as its difference equation, the inverse z-transform of controller and held plant.
TEST(SampledValues, PidIsItsDifferenceEquation) {
  for (const int delay : {0, 1, 3}) {
    for (const bool multistep : {false, true}) {
      Course course(pid(std::to_string(delay)));
      AbmHistory<Course> history{};
      Held plant;
      std::vector<double> later(static_cast<std::size_t>(delay), 2);
      double sum = 0, last = 0;
      for (int k = 0; k < 150; ++k) {
        const double error = 1 - plant.z;
        sum += kPeriod * error;
        later.push_back(60 * error + 20 * sum + 18 * (error - last) / kPeriod);
        last = error;
        plant.pass(later.front(), kPeriod);
        ASSERT_TRUE(course.step(10, 1e-3, multistep ? &history : nullptr).ok());
        ASSERT_NEAR(course.x("force"), later.front(), 1e-9 * (1 + std::abs(later.front()))) << k;
        ASSERT_NEAR(course.state.z[0], plant.z, 1e-10) << k;
        ASSERT_NEAR(course.state.zd[0], plant.v, 1e-9) << k;
        later.erase(later.begin());
      }
    }
  }
}

// The poles of the loop decide how it settles: with gains that put one outside the unit circle it grows as that power.
TEST(SampledValues, LoopGrowsAsItsPole) {
  Course course(slide(R"model("sampled": { "force": { "period": 0.1, "value": "-300*z.slide" } },
    "joint_forces": { "drive": { "joint": "slide", "force": "force" } })model"));
  course.state.z[0] = 1e-3;
  // z(k+1) = z + T v - 300 T^2 / 4 z and v(k+1) = v - 150 T z: the determinant is 1 + 300 T^2 / 4.
  const double trace = 2 - 0.75, determinant = 1 + 0.75;
  const std::complex<double> pole = trace / 2 + std::sqrt(std::complex<double>(trace * trace / 4 - determinant));
  std::array<double, 3> z{};
  ASSERT_TRUE(course.step(100 * 40, 1e-3).ok());
  for (double& value : z) {
    value = course.state.z[0];
    ASSERT_TRUE(course.step(100, 1e-3).ok());
  }
  // Any solution obeys z(k+2) = trace z(k+1) - determinant z(k), and |pole|^2 is the determinant.
  EXPECT_NEAR(z[2], trace * z[1] - determinant * z[0], 1e-6 * std::abs(z[2]));
  EXPECT_NEAR(std::abs(pole), std::sqrt(determinant), 1e-15);
  EXPECT_GT(std::abs(z[2]), 1e3 * 1e-3);
}

TEST(SampledValues, PeriodsThatDoNotFitAreRefused) {
  Course course(pid("0"));
  const int first = static_cast<int>(course.place("error"));
  const auto expect_refused = [&](double t, double h) {
    course.state.t = t;
    const GenericState before = course.state;
    const Status status = step_rk4(course, course.state, h);
    EXPECT_EQ(status.code, Code::sample_inside_step) << t << " " << h;
    EXPECT_EQ(status.index, first);
    EXPECT_EQ(course.state.x, before.x);
    EXPECT_EQ(course.state.t, before.t);
  };
  expect_refused(0, 3e-3);
  expect_refused(0, 2e-2);
  expect_refused(0, 0.01 * (1 + 1e-6));
  expect_refused(0.0005, 1e-3);
  course.state.t = 1e4 + 3e-6;  // a time that added up its roundings
  EXPECT_TRUE(step_rk4(course, course.state, 1e-3).ok());
  EXPECT_NE(course.x("force"), 2);
  course.state.t = 0.003;  // no instant: the values hold
  const double held = course.x("force");
  course.state.z[0] += 0.1;
  EXPECT_TRUE(step_rk4(course, course.state, 1e-3).ok());
  EXPECT_EQ(course.x("force"), held);
}

// The equations of the judges share nothing with those of the solver but the laws.
TEST(UserStates, JudgesSeeTheSameRatesAndTheSameMotion) {
  const Mechanism m = load("tests/data/models/states.json");
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<double> tau(static_cast<std::size_t>(m.topology.size()), 0.0);
  for (const GenericState& state : random_states(m, 5)) {
    GenericDerivative mine, other;
    ASSERT_TRUE(solver.accelerations(state, tau, mine).ok());
    ASSERT_TRUE(judge.accelerations(state, tau, other).ok());
    EXPECT_LT(relative_error(mine.zdd, other.zdd), 1e-11);
    ASSERT_EQ(mine.xd.size(), state.x.size());
    for (std::size_t i = 0; i < mine.xd.size(); ++i)
      EXPECT_NEAR(mine.xd[i], other.xd[i], 1e-10 * (1 + std::abs(other.xd[i]))) << i;
  }
  Course course(m);
  ASSERT_TRUE(solver.project(course.state).ok());
  GenericState judged = course.state;
  CartesianSolver stepper(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
  ASSERT_TRUE(course.step(200, 1e-3).ok());
  for (int k = 1; k <= 200; ++k) {
    ASSERT_TRUE(stepper.step(judged, 1e-3).ok());
    judged.t = k * 1e-3;
  }
  EXPECT_LT(relative_error(course.state.z, judged.z), 1e-9);
  for (std::size_t i = 0; i < judged.x.size(); ++i)
    EXPECT_NEAR(course.state.x[i], judged.x[i], 1e-8 * (1 + std::abs(judged.x[i]))) << i;
}

}  // namespace
}  // namespace mbgen
