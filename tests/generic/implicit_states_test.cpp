// Implicit steps of models with auxiliary states: the user's own, bristles and what presses them. Their matrix against
// differences of the rates; stiff states and oil at a millisecond.

#include <cmath>
#include <cstdio>

#include "compiler/algebra/dense.hpp"
#include "tests/support/implicit_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Trolleys on one line, on which no force turns: laws of every kind that look at states, and states that look at all
/// that they may.
constexpr const char* kLine = R"json({ "mbgen": 1, "name": "line", "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "o": [0, 0, 0], "c": [2, 0, 0], "wall": [-1, 0, 0] } },
    "a": { "mass": 2, "inertia": [0, 0, 0], "points": { "o": [0, 0, 0], "b": [1, 0, 0] } },
    "b": { "mass": 1, "inertia": [0, 0, 0], "points": { "o": [1, 0, 0] } },
    "c": { "mass": 3, "inertia": [0, 0, 0], "points": { "o": [2, 0, 0] } }
  },
  "joints": {
    "a": { "type": "prismatic", "from": "ground.o", "to": "a.o", "axis": "x" },
    "b": { "type": "prismatic", "from": "a.b", "to": "b.o", "axis": "x" },
    "c": { "type": "prismatic", "from": "ground.c", "to": "c.o", "axis": "x" }
  },
  "states": {
    "p": { "initial": 3, "derivative": "-40*p + 7*q*rate.cylinder - 900*rate.cylinder/length.cylinder + 2*spool^2" },
    "q": { "initial": 1.5, "derivative": "30*p - 60*q + 50*sin(3*z.c)*zd.b + length.leaf*zd.a" },
    "spool": { "initial": 0.4, "derivative": "(0.3*sin(t) - spool)/0.01 + 4*z.a - zd.c" },
    "sum": { "initial": 0.2, "derivative": "z.b - 0.1*t" },
    "alone": { "initial": 2, "derivative": "-100*alone^3" }
  },
  "springs": {
    "cylinder": { "from": "ground.wall", "to": "a.o", "damping": 30, "force": "50*q*length - 200*p + 3*zd.c*rate" },
    "leaf": { "from": "b.o", "to": "c.o", "stiffness": "4e3 + 100*q", "damping": 20, "free_length": 1.2,
      "force": "-10*p" }
  },
  "joint_springs": { "c": { "joint": "c", "stiffness": 500, "force": "20*sum*position" } },
  "joint_forces": { "drive": { "joint": "b", "force": "-300*spool + 5*rate.leaf*length.leaf - 10*zd.b*p" } },
  "forces": { "wind": { "at": "c.o", "axes": "body", "force": ["-4*zd.c^2 + 6*spool*q", 0, 0] } },
  "frictions": {
    "rail": { "joint": "a", "law": "elasto_plastic", "coulomb": "3 + p", "stiffness": 50, "damping": 5,
      "lag": 0.1 },
    "pad": { "joint": "c", "coulomb": 0.2, "velocity": 0.3, "normal": "leaf" },
    "lining": { "joint": "b", "law": "lugre", "coulomb": 0.2, "stiction": 0.3, "stribeck_velocity": 0.2,
      "stiffness": 4, "damping": 0.1, "normal": "cylinder", "lag": 0.1 },
    "leaves": { "spring": "leaf", "law": "lugre", "normal": "leaf", "coulomb": 0.1, "stiffness": 3, "damping": 0.05,
      "lag": 0.1 }
  }
})json";

TEST(ImplicitStates, MatrixIsThatOfAllRatesWhereNoForceTurns) {
  const Free line{mechanism_of(kLine)};
  GenericState state = reference_state(line.m);
  ASSERT_EQ(state.x.size(), 8u);
  state.t = 0.3;
  state.z = {0.1, -0.05, 0.07};
  state.zd = {0.4, -0.3, 0.8};
  state.x[1] = -0.03;
  state.x[2] = 0.01;
  for (const double bent : {0.04, 0.11}) {  // elastic, sliding
    state.x[0] = bent;
    EXPECT_LT(largest_difference(line.matrix(state), line.differences(state)), 1e-7) << bent;
  }
}

/// A trolley that is pushed to and fro, and a state of these equations.
Mechanism trolley(const std::string& states, const std::string& force = "20*cos(3*t)") {
  return mechanism_of(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "o": [0, 0, 0] } },
                "a": { "mass": 2, "inertia": [0, 0, 0], "points": { "o": [0, 0, 0] } } },
    "joints": { "a": { "type": "prismatic", "from": "ground.o", "to": "a.o", "axis": "x" } },
    "joint_forces": { "push": { "joint": "a", "force": ")" +
                      force + R"(" } }, "states": { )" + states + " } }");
}

/// The state of a mechanism after so many steps.
GenericState after(const Mechanism& m, double duration, int steps, bool implicit = true) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const Dynamics dynamics{solver};
  GenericState state = reference_state(m);
  for (int i = 0; i < steps; ++i) {
    const double h = duration / steps;
    EXPECT_TRUE((implicit ? step_rosenbrock(dynamics, state, h) : step_rk4(dynamics, state, h)).ok());
  }
  return state;
}

// A lag of 1e-5 s is a hundred times shorter than the step: it forgets its start, and follows at its distance.
TEST(ImplicitStates, StiffLagTakesItsQuasiStaticValueWithinSteps) {
  constexpr double kRate = 1e5;
  const Mechanism m = trolley(R"j("lag": { "initial": 1, "derivative": "1e5*(z.a - lag)" })j");
  const GenericState state = after(m, 0.02, 20);
  EXPECT_NEAR(state.x[0], state.z[0] - state.zd[0] / kRate, 1e-9);
  const Mechanism stiffer = trolley(R"j("lag": { "initial": 1, "derivative": "1e9*(z.a - lag)" })j");
  EXPECT_LT(std::abs(after(stiffer, 0.001, 1).x[0]), 1e-5) << "L-stable";
}

// x' = -L (x - sin t) + cos t, of Prothero and Robinson: of order two and more, however stiff.
TEST(ImplicitStates, ProtheroRobinsonKeepsItsOrder) {
  for (const char* rate : {"1e1", "1e4", "1e7"}) {
    const Mechanism m = trolley(std::string(R"j("x": { "derivative": "-)j") + rate + R"j(*(x - sin(t)) + cos(t)" })j");
    const double coarse = std::abs(after(m, 1, 50).x[0] - std::sin(1.0)),
                 fine = std::abs(after(m, 1, 100).x[0] - std::sin(1.0));
    std::printf("Prothero-Robinson at %s 1/s: errors %.2e, %.2e, ratio %.2f\n", rate, coarse, fine, coarse / fine);
    EXPECT_TRUE(coarse / fine > 3.7 || coarse < 1e-12) << rate;
  }
}

// States that drive a motion and are driven by it, in a chain: of order three.
TEST(ImplicitStates, CoupledStatesHaveOrderThree) {
  const Mechanism m = trolley(R"j("first": { "derivative": "20*(sin(2*t) - z.a - first)" },
                                 "second": { "derivative": "30*(first - second) - 2*zd.a" })j",
                              "80*second - 5*zd.a");
  const GenericState exact = after(m, 1, 2000, false), coarse = after(m, 1, 50), fine = after(m, 1, 100);
  const auto error = [&](const GenericState& s) {
    return std::max({std::abs(s.z[0] - exact.z[0]), std::abs(s.x[0] - exact.x[0]), std::abs(s.x[1] - exact.x[1])});
  };
  EXPECT_GT(error(coarse) / error(fine), 7);
}

/// A mass of 200 kg on a cylinder with real oil between a valve and a spring: small dead volumes, and orifices whose
/// pressures settle within 1e-4 s and less.
constexpr const char* kOil =
    R"json({ "mbgen": 1, "name": "oil", "gravity": [0, 0, -9.81],
  "parameters": { "bulk": 1.4e9, "area": 2e-3, "dead": 2e-5, "edge": 3.6e-7, "laminar": 2e5, "supply": 12e6 },
  "bodies": { "ground": { "points": { "foot": [0, 0, 0], "eye": [0, 0, 0.5] } },
              "load": { "mass": 200, "inertia": [1, 1, 1], "points": { "eye": [0, 0, 0.5] } } },
  "joints": { "lift": { "type": "prismatic", "from": "ground.eye", "to": "load.eye", "axis": "z" } },
  "springs": { "cylinder": { "from": "ground.foot", "to": "load.eye", "damping": 1000, "force": "area*(p_b - p_a)" } },
  "states": {
    "p_a": { "initial": 1.981e6, "derivative": "bulk/(dead + area*(length.cylinder - 0.49))*)json"
    R"json((1e-11*(line - p_a) - area*rate.cylinder)" },
    "p_b": { "initial": 1e6, "derivative": "bulk/(dead + area*(0.7 - length.cylinder))*)json"
    R"json((area*rate.cylinder - edge*p_b/sqrt(abs(p_b) + laminar)*0.5 + 1e-10*(1e6 - p_b))" },
    "line": { "initial": 1.981e6, "derivative": "bulk/1e-6*()json"
    R"json(edge*spool*(supply - line)/sqrt(abs(supply - line) + laminar) - 1e-11*(line - p_a))" },
    "spool": { "derivative": "(0.1*sin(6*t)^2 - spool)/1e-4" }
  }
})json";

TEST(ImplicitStates, OilAtAMillisecond) {
  const Free oil{mechanism_of(kOil)};
  const GenericState start = reference_state(oil.m);
  const double fastest = spectral_radius(oil.differences(start));
  const GenericState exact = after(oil.m, 0.2, 20000, false);
  for (const int steps : {200, 400}) {
    const GenericState s = after(oil.m, 0.2, steps);
    const double z = std::abs(s.z[0] / exact.z[0] - 1);
    double pressure = 0;
    for (int i = 0; i < 3; ++i) pressure = std::max(pressure, std::abs(s.x[i] / exact.x[i] - 1));
    std::printf("oil, fastest %.3g 1/s, %d steps of 0.2 s: errors %.1e of the lift, %.1e of pressures\n", fastest,
                steps, z, pressure);
    EXPECT_LT(z, 5e-5 * 200 / steps);
    EXPECT_LT(pressure, 2e-5 * 200 / steps);
  }
  GenericState diverged = start;
  const Dynamics dynamics{oil.solver};
  bool is_ok = true;
  for (int i = 0; i < 50 && is_ok; ++i) is_ok = step_rk4(dynamics, diverged, 1e-3).ok();
  EXPECT_TRUE(!is_ok || !(std::abs(diverged.z[0]) < 1)) << "Runge-Kutta at a millisecond";
}

// Bristles of 1e7 N/m hold 0.1 kg: Runge-Kutta would need steps below 0.3 ms.
TEST(ImplicitStates, StiffBristleHoldsAtAMillisecond) {
  const Mechanism m = mechanism_of(R"j({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "o": [0, 0, 0] } },
                "a": { "mass": 0.1, "inertia": [0, 0, 0], "points": { "o": [0, 0, 0] } } },
    "joints": { "a": { "type": "prismatic", "from": "ground.o", "to": "a.o", "axis": "x" } },
    "joint_forces": { "push": { "joint": "a", "force": "(4 + 2*sin(60*t))*(1 - exp(-20*t))" } },
    "frictions": { "floor": { "joint": "a", "law": "elasto_plastic", "coulomb": 10, "stiffness": 1e7, "damping": 200 } }
  })j");
  const GenericState state = after(m, 2, 2000);
  EXPECT_NEAR(state.z[0] * 1e7, 4 + 2 * std::sin(120.0), 1e-2);
  EXPECT_NEAR(state.x[0], state.z[0], 1e-12);
}

TEST(ImplicitStates, NameAStateThatGrowsTooFast) {
  const Mechanism m = trolley(R"j("lag": { "derivative": "-lag" }, "runs": { "derivative": "1e5*runs + lag" })j");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  const Status status = step_rosenbrock(Dynamics{solver}, state, 1e-3);
  EXPECT_EQ(status.code, Code::implicit_state_grows);
  EXPECT_EQ(status.index, 1);
}

}  // namespace
}  // namespace mbgen
