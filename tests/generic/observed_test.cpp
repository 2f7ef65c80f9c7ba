// Outputs in expressions, sensors and delays against closed forms and difference equations.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/integrators.hpp"
#include "tests/support/course.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A slide of 2 kg along x and a wheel on it, without gravity, with these sections.
std::string slide_and_wheel(const std::string& sections) {
  return R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "wall": [-1, 0, 0], "post": [-1, 0, 0.5] } },
      "slide": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } },
      "wheel": { "mass": 1, "inertia": [1, 0.5, 1], "points": { "O": [0, 0, 0], "rim": [0, 0, 0.3] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" },
      "wheel": { "type": "revolute", "from": "slide.O", "to": "wheel.O", "axis": "y" } },)" +
         sections + "}";
}

std::vector<double> accelerations(const std::string& text, double z, double zd, double turn, double spin) {
  Course course(text);
  course.state.z = {z, turn};
  course.state.zd = {zd, spin};
  GenericDerivative rates;
  EXPECT_TRUE(course.solver.accelerations(course.state, {0, 0}, rates).ok());
  return rates.zdd;
}

// The velocity of a point of the rim in the wheel's axes: x is zd cos(turn) + 0.3 spin.
TEST(Observed, VelocitiesOfPointsDriveForces) {
  const std::vector<double> zdd = accelerations(
      slide_and_wheel(
          R"("outputs": { "rim": { "point": "wheel.rim", "quantity": "velocity", "axis": "x", "frame": "body" },
                            "twice": { "expression": "2*out.rim" } },
      "joint_forces": { "push": { "joint": "slide", "force": "6 - 3*out.rim" },
                        "turn": { "joint": "wheel", "force": "out.twice" } })"),
      0.1, 0.7, 0.4, 2);
  const double rim = 0.7 * std::cos(0.4) + 0.3 * 2;
  EXPECT_NEAR(zdd[0], (6 - 3 * rim) / 3, 1e-14);
  EXPECT_NEAR(zdd[1], 2 * rim / 0.5, 1e-14);
}

// Angular velocities, and velocities relative to a point that an observer sees.
TEST(Observed, RotationsAndObserversDriveForces) {
  const std::vector<double> zdd = accelerations(
      slide_and_wheel(R"("outputs": { "spin": { "body": "wheel", "quantity": "angular_velocity", "axis": "y" },
                            "seen": { "point": "wheel.rim", "relative_to": "ground.O", "quantity": "velocity", "axis": "z",
                                      "axes_of": "wheel" } },
      "joint_forces": { "push": { "joint": "slide", "force": "-out.spin" },
                        "turn": { "joint": "wheel", "force": "out.seen" } })"),
      0.1, 0.7, 0.4, 2);
  EXPECT_NEAR(zdd[0], -2.0 / 3, 1e-14);
  // Rate of the third component of the position in the wheel's axes: that of 0.1 sin(turn) + 0.3.
  EXPECT_NEAR(zdd[1], (0.7 * std::sin(0.4) + 0.1 * std::cos(0.4) * 2) / 0.5, 1e-13);
}

// The length of a spring is known before its force.
TEST(Observed, AForceMayLookAtItsOwnLength) {
  const std::vector<double> zdd = accelerations(
      slide_and_wheel(
          R"("springs": { "line": { "from": "ground.wall", "to": "slide.O", "force": "2*out.long + out.fast" } },
      "outputs": { "long": { "spring": "line", "quantity": "length" }, "fast": { "spring": "line", "quantity": "rate" } })"),
      0.2, 0.5, 0, 0);
  EXPECT_NEAR(zdd[0], -(2 * 1.2 + 0.5) / 3, 1e-14);
}

// A spring whose stiffness grows with the force of another one that comes after it in the model, and a third one after
// both: the springs are computed in this order, whatever their places.
TEST(Observed, ForcesOfElementsAreComputedInTheOrderOfTheirUse) {
  const std::vector<double> zdd = accelerations(slide_and_wheel(R"("springs": {
        "third": { "from": "ground.wall", "to": "slide.O", "force": "out.second" },
        "second": { "from": "ground.wall", "to": "slide.O", "stiffness": "10 + out.first", "free_length": 0.9 },
        "first": { "from": "ground.wall", "to": "slide.O", "stiffness": 50, "free_length": 1 } },
      "outputs": { "second": { "spring": "second" }, "first": { "spring": "first" } })"),
                                                0.2, 0, 0, 0);
  const double first = 50 * 0.2, second = (10 + first) * 0.3;
  EXPECT_NEAR(zdd[0], -(first + second + second) / 3, 1e-13);
}

// At an instant a sampled value sees accelerations and reactions by the forces before it.
TEST(Observed, AccelerationsAndReactionsAreSampled) {
  Course course(slide_and_wheel(R"("outputs": {
        "ax": { "point": "slide.O", "quantity": "acceleration", "axis": "x" },
        "load": { "reaction": "wheel", "quantity": "force", "axis": "x" },
        "both": { "expression": "out.ax + 100*out.load" } },
      "sampled": { "push": { "period": 0.01, "value": "3 + 0.5*push", "initial": 6 },
                   "felt": { "period": 0.01, "value": "out.both" } },
      "joint_forces": { "push": { "joint": "slide", "force": "push" } })"));
  double push = 6;
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(course.step(10, 1e-3).ok());
    EXPECT_NEAR(course.x("felt"), push / 3 + 100 * push / 3, 1e-9) << k;
    push = 3 + 0.5 * push;
    EXPECT_NEAR(course.x("push"), push, 1e-12);
  }
}

// Filter, gain, bias, quantisation and delay as a difference equation.
TEST(Sensors, AreTheirDifferenceEquation) {
  Course course(slide_and_wheel(R"("initial": { "velocities": { "slide": 0.3 } },
      "sensors": { "way": { "value": "z.slide", "period": 0.01, "filter": 4, "gain": 1.1, "bias": 0.02, "most": 0.2,
                            "quantisation": 0.004, "delay": 0.03 } })"));
  course.state.zd[0] = 0.3;
  double filtered = 0, shown[3] = {0, 0, 0};
  const double kept = std::exp(-2 * std::numbers::pi * 4 * 0.01);
  for (int k = 0; k < 100; ++k) {
    const double z = 0.3 * 0.01 * k;
    filtered = z + kept * (filtered - z);
    const double now = 0.004 * std::floor(std::min(1.1 * filtered + 0.02, 0.2) / 0.004 + 0.5);
    const double effective = shown[2];
    shown[2] = shown[1], shown[1] = shown[0], shown[0] = now;
    ASSERT_TRUE(course.step(10, 1e-3).ok());
    EXPECT_NEAR(course.x("way"), effective, 1e-12) << k;
    EXPECT_NEAR(course.x("way_filtered"), filtered, 1e-12) << k;
  }
}

// Mean, deviation and excess of 20 000 numbers, and their correlation with the next one and with a second sensor.
TEST(Sensors, NoiseIsNormalAndIndependent) {
  Course course(slide_and_wheel(R"("sensors": {
      "a": { "value": 1, "period": 0.001, "noise": 0.5, "seed": 3 },
      "b": { "value": 0, "period": 0.001, "noise": 1, "seed": 3 } })"));
  constexpr int kCount = 20000;
  double sum = 0, square = 0, fourth = 0, next = 0, other = 0, last = 0;
  for (int k = 0; k < kCount; ++k) {
    ASSERT_TRUE(course.step(1, 1e-3).ok());
    const double n = (course.x("a") - 1) / 0.5;
    sum += n, square += n * n, fourth += n * n * n * n, next += n * last, other += n * course.x("b");
    last = n;
  }
  const double allowed = 4 / std::sqrt(kCount);  // four standard errors of a mean of deviation 1
  EXPECT_LT(std::abs(sum / kCount), allowed);
  EXPECT_LT(std::abs(square / kCount - 1), allowed * std::sqrt(2.0));
  EXPECT_LT(std::abs(fourth / kCount - 3), allowed * std::sqrt(96.0));
  EXPECT_LT(std::abs(next / kCount), allowed);
  EXPECT_LT(std::abs(other / kCount), allowed);
}

// The first numbers by the published generator, computed in integers.
TEST(Sensors, NoiseComesFromWichmannAndHill) {
  Course course(slide_and_wheel(R"("sensors": { "a": { "value": 0, "period": 0.001, "noise": 1 } })"));
  long long x = std::lround(course.x("a_seed_a")), y = std::lround(course.x("a_seed_b")),
            z = std::lround(course.x("a_seed_c"));
  const auto draw = [&] {
    x = 171 * x % 30269, y = 172 * y % 30307, z = 170 * z % 30323;
    return std::fmod(x / 30269.0 + y / 30307.0 + z / 30323.0, 1.0);
  };
  draw();
  for (int k = 0; k < 50; ++k) {
    const double first = draw(), second = draw();
    ASSERT_TRUE(course.step(1, 1e-3).ok());
    EXPECT_NEAR(course.x("a"), std::sqrt(-2 * std::log(first)) * std::cos(2 * std::numbers::pi * second), 1e-9) << k;
  }
}

/// Largest error of sin(3 t) delayed by 0.2 s and integrated, after the start.
double error_of_delay(double period) {
  Course course(
      slide_and_wheel(fmt::format(R"model("delays": {{ "late": {{ "value": "sin(3*t)", "delay": 0.2, "period": {} }} }},
      "states": {{ "error": {{ "derivative": "step(t - 0.5)*abs(late - sin(3*t - 0.6))" }} }})model",
                                  period)));
  EXPECT_TRUE(course.step(2000, 1e-3).ok());
  return course.x("error");
}

TEST(Delays, FallWithTheFourthPowerOfThePeriod) {
  const double coarse = error_of_delay(0.04), fine = error_of_delay(0.02);
  EXPECT_LT(coarse, 1.5 * 81 * 0.04 * 0.04 * 0.04 * 0.04 * 9 / 384);  // s times the bound of cubic interpolation
  EXPECT_GT(coarse / fine, 12);
}

// x' = -x(t - 1) with x = 1 before the start, by the method of steps: sum of (-1)^k (t - k + 1)^k / k!.
TEST(Delays, SolveAnEquationWithDelay) {
  Course course(slide_and_wheel(R"("delays": { "late": { "value": "x", "delay": 1, "period": 0.005, "initial": 1 } },
      "states": { "x": { "derivative": "-late", "initial": 1 } })"));
  ASSERT_TRUE(course.step(600, 5e-3).ok());
  const double t = 3;
  double exact = 0, factor = 1;
  for (int k = 0; k <= 4; ++k) {
    exact += (k % 2 == 0 ? 1 : -1) * std::pow(t - k + 1, k) / factor * (t - k + 1 >= 0 ? 1 : 0);
    factor *= k + 1;
  }
  EXPECT_NEAR(course.x("x"), exact, 1e-5);  // kinks of the history are rounded off
}

// A value under a name is its expression.
TEST(NamedValues, AreTheirExpressions) {
  const std::string plain =
      slide_and_wheel(R"("joint_forces": { "push": { "joint": "slide", "force": "-(5*zd.slide + z.wheel)*2 + 1" } })");
  const std::string named = slide_and_wheel(R"("values": { "drag": "5*zd.slide + z.wheel", "both": "-drag*2" },
      "joint_forces": { "push": { "joint": "slide", "force": "both + 1" } })");
  EXPECT_EQ(accelerations(plain, 0.1, 0.2, 0.3, 0.4), accelerations(named, 0.1, 0.2, 0.3, 0.4));
}

}  // namespace
}  // namespace mbgen
