// Friction that sticks, by its generic and Cartesian solutions, against closed forms.

#include <cmath>
#include <numbers>

#include "mbgen/solver/rosenbrock.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"

namespace mbgen::testing {
namespace {

constexpr double kMass = 2, kStiffness = 8e4, kDamping = 250;

/// A block on an incline, pushed by `push` along it; law: fields of its friction.
Mechanism block(const std::string& push, const std::string& law) {
  return mechanism_of(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "block": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "block.O", "axis": "x" } },
    "joint_forces": { "push": { "joint": "x", "force": ")" +
                      push + R"(" } },
    "frictions": { "floor": { "joint": "x", "coulomb": 10, "stiffness": 8e4, "damping": 250, )" +
                      law + " } } }");
}

/// The block after so many seconds from rest.
GenericState moved(const Mechanism& m, double seconds, double h) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const Dynamics dynamics{solver};
  GenericState state = reference_state(m);
  for (long k = std::lround(seconds / h); k > 0; --k) EXPECT_TRUE(step_rk4(dynamics, state, h).ok());
  return state;
}

// A load that vibrates below 0.8 of the friction only bends elasto-plastic bristles: the block is a linear oscillator,
// whose motion is known. Those of LuGre creep under it.
TEST(Bristle, HoldsUnderAVibratingLoad) {
  constexpr double kLoad = 4, kSwing = 2, kRate = 60, kTime = 2;
  const std::string push = "4 + 2*sin(60*t)";
  const Mechanism m = block(push, R"("law": "elasto_plastic")");
  const GenericState state = moved(m, kTime, 5e-4);
  const double omega2 = kStiffness / kMass, damping = kDamping / kMass;
  const double a = omega2 - kRate * kRate, b = damping * kRate;
  const double forced = kSwing / kMass * (a * std::sin(kRate * kTime) - b * std::cos(kRate * kTime)) / (a * a + b * b);
  EXPECT_NEAR(state.z[0], kLoad / kStiffness + forced, 1e-10);  // what began with it has died out
  EXPECT_NEAR(state.x[0], state.z[0], 1e-12);
  const GenericState creeping = moved(block(push, R"("law": "lugre")"), kTime, 5e-4);
  EXPECT_GT(creeping.z[0], 1.5 * state.z[0]);
}

// Steady sliding: Stribeck's curve; a bristle that is bent to its end rests there.
TEST(Bristle, SlidesOnStribecksCurve) {
  for (const std::string kind : {"elasto_plastic", "lugre"}) {
    const Mechanism m =
        block("0", "\"law\": \"" + kind + R"(", "stiction": 15, "stribeck_velocity": 0.1, "viscous": 3)");
    const GenericSolver solver(m.model, m.topology, m.analysis);
    for (const double v : {-0.3, -0.05, 1e-4, 0.08, 2.0}) {
      const double level = 10 + 5 * std::exp(-v * v / 0.01);
      GenericState state = reference_state(m);
      state.zd[0] = v;
      state.x[0] = std::copysign(level / kStiffness, v);
      GenericDerivative derivative;
      ASSERT_TRUE(solver.accelerations(state, {0}, derivative).ok());
      EXPECT_NEAR(derivative.xd[0], 0, 1e-13) << kind << v;
      EXPECT_NEAR(derivative.zdd[0] * kMass, -std::copysign(level, v) - 3 * v, 1e-11) << kind << v;
    }
  }
}

// A load that grows by 5 N/s breaks the block loose at the stiction, not before.
TEST(Bristle, BreaksAwayAtTheStiction) {
  const Mechanism m = block("5*t", R"("law": "elasto_plastic", "stiction": 15, "stribeck_velocity": 0.05)");
  EXPECT_LT(moved(m, 2.9, 1e-3).z[0], 3 * 15 / kStiffness);
  EXPECT_GT(moved(m, 3.2, 1e-3).zd[0], 0.1);
}

/// The period of a block that a spring holds on a belt, from when it last stuck, by the events of rigid friction:
/// it sticks until the spring pulls with the stiction, then swings about the spring's length at sliding friction.
double stick_slip_period(double mass, double spring, double coulomb, double stiction, double belt) {
  const double omega = std::sqrt(spring / mass), swing = (stiction - coulomb) / spring;
  return 2 * swing / belt + (std::numbers::pi + 2 * std::atan(belt / (omega * swing))) / omega;
}

TEST(Bristle, StickSlipHasThePeriodOfRigidFriction) {
  constexpr double kSpring = 200, kBelt = 0.1;
  const Mechanism m = mechanism_of(R"j({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "belt": { "mass": 1, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } },
                "block": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "belt": { "type": "prismatic", "from": "ground.O", "to": "belt.O", "axis": "x" },
                "block": { "type": "prismatic", "from": "belt.O", "to": "block.O", "axis": "x" } },
    "motions": { "belt": { "joint": "belt", "position": "0.1*t" } },
    "joint_forces": { "spring": { "joint": "block", "force": "-200*(z.belt + z.block)" } },
    "frictions": { "belt": { "joint": "block", "law": "elasto_plastic", "coulomb": 10, "stiction": 15,
      "stribeck_velocity": 1e-3, "stiffness": 8e5, "damping": 800, "elastic": 0.95, "lag": 2e-4 } } })j");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const Dynamics dynamics{solver};
  const double expected = stick_slip_period(kMass, kSpring, 10, 15, kBelt);
  for (const bool implicit : {false, true}) {
    GenericState state = reference_state(m);
    ASSERT_TRUE(solver.project(state).ok());
    std::vector<double> sliding;  // s, when the block began to slide by more than half the belt's speed
    for (double before = 0; state.t < 3.6; before = state.zd[1]) {
      ASSERT_TRUE((implicit ? step_rosenbrock(dynamics, state, 1e-3) : step_rk4(dynamics, state, 2e-4)).ok());
      if (before > -kBelt / 2 && state.zd[1] <= -kBelt / 2) sliding.push_back(state.t);
    }
    ASSERT_GE(sliding.size(), 4u);
    EXPECT_NEAR((sliding.back() - sliding[1]) / static_cast<double>(sliding.size() - 2) / expected, 1, 1e-2);
  }
}

// Bristles that are bent at rest bear any load: a search for rest leaves them straight, so that the springs hold it.
TEST(Bristle, EquilibriumIsThatOfTheSprings) {
  const Mechanism m = block("50 - 200*z.x", R"("law": "elasto_plastic")");
  GenericState state = reference_state(m);
  state.x[0] = 1e-4;
  ASSERT_TRUE(GenericSolver(m.model, m.topology, m.analysis).equilibrium(state).ok());
  EXPECT_NEAR(state.z[0], 0.25, 1e-9);
  EXPECT_EQ(state.x[0], 0);
}

// Friction along springs and pressed by springs, in a linkage: the Cartesian judge finds the same accelerations.
TEST(Bristle, CartesianJudgesAgree) {
  const Mechanism m = load("tests/data/models/all_elements.json");
  ASSERT_TRUE(std::any_of(m.model.spring_frictions.begin(), m.model.spring_frictions.end(),
                          [](const SpringFriction& friction) { return friction.normal >= 0; }));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
  const std::vector<double> tau(m.topology.bodies.size());
  for (const GenericState& state : random_states(m, 3)) {
    GenericDerivative generic, cartesian;
    ASSERT_TRUE(solver.accelerations(state, tau, generic).ok());
    ASSERT_TRUE(judge.accelerations(state, tau, cartesian).ok());
    EXPECT_LT(relative_error(cartesian.zdd, generic.zdd), 1e-9);
    EXPECT_LT(relative_error(cartesian.xd, generic.xd), 1e-12);
  }
}

}  // namespace
}  // namespace mbgen::testing
