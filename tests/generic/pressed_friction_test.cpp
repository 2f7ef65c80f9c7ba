// Friction that a reaction presses, by the generic runtime: closed forms of blocks, pins, wedges and rods' ends, the
// order in the period, and the Cartesian judges.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/rosenbrock.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"

namespace mbgen::testing {
namespace {

constexpr double kFreeFall = 9.81;

/// A mechanism that is stepped, its loads set at their instants.
struct Pressed : Dynamics {
  explicit Pressed(const GenericSolver& of) : Dynamics{of} {}
  void solve(const Tangents& values, double g, const StateRates<Pressed>& rates, Derivative& change) const noexcept {
    change = solver.changes(values, g, rates.zd, rates.derivative);
  }
  Status sample(State& state, double h, bool& any) const noexcept { return solver.sample(state, h, any); }
};

/// A mechanism in motion.
class PressedCourse {
 public:
  explicit PressedCourse(const std::string& text)
      : mechanism(mechanism_of(text)),
        solver(mechanism.model, mechanism.topology, mechanism.analysis),
        state(reference_state(mechanism)) {}

  /// `count` steps of h seconds.
  void step(int count, double h, bool implicit = false) {
    const Pressed dynamics{solver};
    const double start = state.t;
    for (int k = 1; k <= count; ++k) {
      ASSERT_TRUE((implicit ? step_rosenbrock(dynamics, state, h) : step_rk4(dynamics, state, h)).ok());
      state.t = start + k * h;
    }
  }
  double x(const std::string& name) const {
    const std::vector<std::string> names = auxiliary_state_names(mechanism.model);
    return state.x[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
  }

  const Mechanism mechanism;
  GenericSolver solver;
  GenericState state;
};

/// Text of a number in full.
std::string text(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", number);
  return digits;
}

/// A block of 2 kg on an incline, pressed by what its guide bears; step: of the solver, s; law: fields of its friction.
std::string block(double slope, double step, const std::string& law) {
  return R"({ "mbgen": 1, "gravity": [)" + text(kFreeFall * std::sin(slope)) + ", 0, " +
         text(-kFreeFall * std::cos(slope)) + R"(],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "block": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "block.O", "axis": "x" } },
    "frictions": { "floor": { "joint": "x", "reaction": "x", )" +
         law + R"( } }, "solver": { "step": )" + text(step) + " } }";
}

// Below the angle of friction the block bends its bristles by tan a / stiffness, and stays for 1000 s.
TEST(PressedFriction, BlockHoldsOnAnIncline) {
  constexpr double kSlope = 0.28, kStiffness = 5e3;  // tan 0.28 = 0.2875
  PressedCourse course(
      block(kSlope, 0.1, R"("law": "elasto_plastic", "coulomb": 0.8, "stiffness": 5e3, "damping": 20, "lag": 1e-3)"));
  course.step(1000, 1e-3);
  EXPECT_NEAR(course.state.z[0] * kStiffness / std::tan(kSlope), 1, 1e-9);
  EXPECT_NEAR(course.x("floor_load"), 2 * kFreeFall * std::cos(kSlope), 1e-12);
  const double bent = course.state.z[0];
  course.step(9990, 0.1, true);
  EXPECT_NEAR(course.state.t, 1000, 1e-9);
  EXPECT_NEAR(course.state.z[0], bent, 1e-12);
}

// Just below it, where bristles slide a little before they hold.
TEST(PressedFriction, BlockHoldsJustBelowTheAngleOfFriction) {
  constexpr double kSlope = 0.28, kStiffness = 5e3;
  PressedCourse course(
      block(kSlope, 1e-3, R"("law": "elasto_plastic", "coulomb": 0.3, "stiffness": 5e3, "damping": 20)"));
  course.step(2000, 1e-3);
  EXPECT_NEAR(course.x("floor_bristle") * kStiffness / std::tan(kSlope), 1, 1e-9);
  const double rest = course.state.z[0];
  course.step(20000, 1e-3);
  EXPECT_NEAR(course.state.z[0], rest, 1e-12);
}

// Above it the block slides at g (sin a - mu cos a).
TEST(PressedFriction, BlockSlidesOnASteeperIncline) {
  constexpr double kSlope = 0.4, kCoefficient = 0.3;
  const double expected = kFreeFall * (std::sin(kSlope) - kCoefficient * std::cos(kSlope));
  for (const std::string law : {R"("coulomb": 0.3, "velocity": 1e-3)",
                                R"("law": "elasto_plastic", "coulomb": 0.3, "stiffness": 5e3, "damping": 20)"}) {
    PressedCourse course(block(kSlope, 1e-3, law));
    course.step(200, 1e-3);
    const double before = course.state.zd[0];
    course.step(500, 1e-3);
    EXPECT_NEAR((course.state.zd[0] - before) / 0.5 / expected, 1, 1e-11) << law;
  }
}

/// A point of 1 kg on an arm of 0.5 m about a pin along y, from 1 rad; period: of its load, s.
std::string pendulum(double period) {
  return R"({ "mbgen": 1,
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "bob": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "bob.O", "axis": "y" } },
    "frictions": { "pin": { "joint": "pin", "reaction": "pin", "coulomb": 0.01, "velocity": 1e-3, "period": )" +
         text(period) + R"( } }, "initial": { "positions": { "pin": 1 } } })";
}

/// Amplitude after a half swing of a point on an arm whose pin has a friction of `ratio` arms times its load. With N
/// the pull of the arm, the load is N / sqrt(1 - ratio^2), since friction pulls sideways, and the square v of the speed
/// is linear in the angle: (v exp(-2 k a))' = 2 g/l exp(-2 k a) (k cos a - sin a), k = ratio / sqrt(1 - ratio^2).
double half_swing(double amplitude, double ratio) {
  const double k = ratio / std::sqrt(1 - ratio * ratio);
  const auto integral = [k](double a) {
    return std::exp(-2 * k * a) * ((1 - 2 * k * k) * std::cos(a) + 3 * k * std::sin(a));
  };
  double low = 0, high = amplitude;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (integral(-middle) > integral(amplitude) ? low : high) = middle;
  }
  return low;
}

/// The amplitude after `count` half swings, by steps of 5e-4 s.
double swung(PressedCourse& course, int count) {
  double before = 0;
  for (int turns = 0; turns < count;) {
    before = course.state.zd[0];
    const double z = course.state.z[0];
    course.step(1, 5e-4);
    const double now = course.state.zd[0];
    if (before * now >= 0) continue;
    // Where the velocity, linear over the step, is zero.
    const double part = before / (before - now);
    if (++turns == count) return std::abs(z + 0.5 * part * 5e-4 * before);
  }
  return 0;
}

// A pin of radius r and coefficient mu under the pull of a pendulum, mu r = 0.01 m.
TEST(PressedFriction, PinSlowsAPendulumAsTheClosedFormDoes) {
  double expected = 1;
  for (int i = 0; i < 6; ++i) expected = half_swing(expected, 0.02);
  PressedCourse course(pendulum(1e-3));
  course.state.z[0] = 1;
  const double amplitude = swung(course, 6);
  EXPECT_NEAR((1 - amplitude) / (1 - expected), 1, 1e-3);
  EXPECT_LT(expected, 0.8);
}

// A held load is late by half a period on average: the error falls with the period.
TEST(PressedFriction, ErrorFallsWithThePeriod) {
  std::vector<double> at;
  for (const double period : {16e-3, 8e-3, 4e-3, 5e-4}) {
    PressedCourse course(pendulum(period));
    course.state.z[0] = 1;
    course.step(960, 5e-4);
    at.push_back(course.state.z[0]);
  }
  const double coarse = std::abs(at[0] - at[3]), middle = std::abs(at[1] - at[3]), fine = std::abs(at[2] - at[3]);
  EXPECT_GT(coarse / middle, 1.8);
  EXPECT_GT(middle / fine, 1.8);
  // mu r / m l^2 times what the load, which changes by up to 40 N/s, is late by, twice integrated.
  EXPECT_LT(fine, 0.04 * 40 * 2e-3 * 0.48 * 0.48 / 2);
}

/// A wedge of 1 kg under a block of 3 kg that goes up and down and is pressed down by 200 N: x of the wedge follows
/// from the way along its face. law: fields of the friction on the face.
std::string wedge(double slope, const std::string& law) {
  const std::string face = "[" + text(std::cos(slope)) + ", 0, " + text(std::sin(slope)) + "]";
  return R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "guide": [0, 0, 1] } },
      "wedge": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } },
      "block": { "mass": 3, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "guide": [0, 0, 1] } } },
    "joints": {
      "wedge": { "type": "prismatic", "from": "ground.O", "to": "wedge.O", "axis": "x" },
      "face": { "type": "prismatic", "from": "wedge.O", "to": "block.O", "axis": )" +
         face + R"( },
      "guide": { "type": "point_on_line", "from": "ground.guide", "to": "block.guide", "axis": "z" } },
    "forces": { "press": { "at": "block.O", "force": [0, 0, -200] } },
    "frictions": { "face": { "joint": "face", "reaction": "face", )" +
         law + " } } }";
}

// The load of the face depends on the friction there: sliding as of the same instant, once the motion is steady.
TEST(PressedFriction, WedgeSlidesWithTheFrictionOfItsOwnNormalForce) {
  constexpr double kSlope = 0.5, kCoefficient = 0.3;
  PressedCourse course(wedge(kSlope, R"("coulomb": 0.3, "velocity": 1e-3)"));
  course.step(100, 1e-3);
  const double before = course.state.zd[0];
  course.step(100, 1e-3);
  const double s = std::sin(kSlope), c = std::cos(kSlope), along = s - kCoefficient * c;
  const double normal = 200 / (c + kCoefficient * s + 3 * s / c * along);
  EXPECT_NEAR(course.x("face_load"), normal, 1e-9 * normal);
  EXPECT_NEAR(std::abs(course.state.zd[0] - before) / 0.1 / (normal * along), 1, 1e-9);
}

// Below the angle of friction no press drives the wedge out.
TEST(PressedFriction, WedgeLocksItself) {
  constexpr double kSlope = 0.25;  // tan 0.25 = 0.2553, of 0.3
  PressedCourse course(wedge(kSlope, R"("law": "elasto_plastic", "coulomb": 0.3, "stiffness": 1e3, "damping": 4)"));
  course.step(3000, 1e-3);
  EXPECT_NEAR(course.x("face_load"), 200 * std::cos(kSlope), 1e-6);
  EXPECT_NEAR(std::abs(course.x("face_bristle")) * 1e3, std::tan(kSlope), 1e-6);
  const double rest = course.state.z[0];
  course.step(3000, 1e-3);
  EXPECT_NEAR(course.state.z[0], rest, 1e-10);
}

/// A rotor about z, in whose axis a rod ends that is pulled by 500 N; slope: of the rod to the axis, rad.
std::string rotor(double slope) {
  const std::string end = "[" + text(std::sin(slope)) + ", 0, " + text(std::cos(slope)) + "]";
  return R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "E": )" +
         end + R"( } },
      "rotor": { "mass": 1, "inertia": [0.03, 0.03, 0.05], "points": { "O": [0, 0, 0] } },
      "pull": { "mass": 1, "inertia": [0, 0, 0], "points": { "E": )" +
         end + R"( } } },
    "joints": { "rotor": { "type": "revolute", "from": "ground.O", "to": "rotor.O", "axis": "z" },
                "pull": { "type": "prismatic", "from": "ground.E", "to": "pull.E", "axis": )" +
         end + R"( } },
    "rods": { "rod": { "from": "rotor.O", "to": "pull.E" } },
    "joint_forces": { "pull": { "joint": "pull", "force": 500 } },
    "frictions": { "ball": { "rod": "rod", "end": "from", "reaction": "rod", "coulomb": 1e-3, "velocity": 1e-3 } } })";
}

// The ball of a rod brakes by mu r N about what turns across the rod; about the rod itself it turns freely.
TEST(PressedFriction, BallOfARodBrakesARotor) {
  for (const double slope : {M_PI / 2, 1.0, 0.3}) {
    PressedCourse course(rotor(slope));
    course.state.zd[0] = 30;
    course.step(1, 1e-3);
    EXPECT_NEAR(course.x("ball_load"), 500, 1e-9);
    const double before = course.state.zd[0];
    course.step(1000, 1e-3);
    EXPECT_NEAR((before - course.state.zd[0]) / (1e-3 * 500 / 0.05 * std::sin(slope)), 1, 1e-9) << slope;
  }
}

/// Friction of a pin by the moment of the joint below a coupled compound joint, and of the slide above by its own
/// force.
Mechanism pressed_below_coupled() {
  nlohmann::json model =
      nlohmann::json::parse(std::ifstream(source_path("tests/data/models/below_coupled.json")), nullptr, true, true);
  model["frictions"] = {
      {"tilt", {{"joint", "j0"}, {"reaction", "j0"}, {"quantity", "moment"}, {"coulomb", 0.2}, {"velocity", 0.05}}},
      {"pin", {{"joint", "j0"}, {"reaction", "j0"}, {"coulomb", 0.01}, {"velocity", 0.05}}},
      {"slide", {{"joint", "p_ty"}, {"reaction", "p"}, {"coulomb", 0.1}, {"velocity", 0.05}}}};
  return mechanism_of(model.dump());
}

// The loads that both take by reactions of their own, and the accelerations under these.
void expect_judges_to_agree(const Mechanism& m) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const Pressed dynamics(solver);
  const std::vector<double> tau(m.topology.bodies.size());
  for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::null_space}) {
    CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
    for (const GenericState& start : random_states(m, 3)) {
      GenericState generic = start, cartesian = start;
      for (GenericState* state : {&generic, &cartesian}) state->t = 0;
      for (int k = 0; k < 2; ++k) {  // the second time under loads
        ASSERT_TRUE(step_rk4(dynamics, generic, 1e-7).ok());
        ASSERT_TRUE(judge.step(cartesian, 1e-7).ok());
        EXPECT_LT(relative_error(cartesian.x, generic.x), 1e-9);
        EXPECT_GT(*std::max_element(generic.x.begin(), generic.x.end()), 1);
        for (GenericState* state : {&generic, &cartesian}) state->t = 2e-3;
      }
      GenericDerivative expected, actual;
      ASSERT_TRUE(solver.accelerations(generic, tau, expected).ok());
      ASSERT_TRUE(judge.accelerations(generic, tau, actual).ok());
      EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-9);
    }
  }
}

/// At a start the judges find what presses by equations of their own.
TEST(PressedFriction, CartesianJudgesPressByThemselves) {
  for (const Mechanism& m : {load("tests/data/models/pressed.json"), pressed_below_coupled()}) {
    const GenericSolver solver(m.model, m.topology, m.analysis);
    for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::maggi}) {
      const CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
      for (const GenericState& start : random_states(m, 3)) {
        GenericState generic = start, cartesian = start;
        ASSERT_TRUE(solver.set_friction_loads(generic).ok());
        ASSERT_TRUE(judge.set_friction_loads(cartesian).ok());
        EXPECT_LT(relative_error(cartesian.x, generic.x), 1e-9);
        EXPECT_NE(cartesian.x, start.x);
        EXPECT_NE(cartesian.x, generic.x);  // to the last bit they are of other equations
      }
    }
  }
}

TEST(PressedFriction, CartesianJudgesAgree) {
  expect_judges_to_agree(load("tests/data/models/pressed.json"));
  expect_judges_to_agree(pressed_below_coupled());
}

}  // namespace
}  // namespace mbgen::testing
