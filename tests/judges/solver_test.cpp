// The Cartesian judges against the recursive formulation, with which they share no kinematics.

#include <cmath>

#include "compiler/reader/read_model.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/judges/cartesian_support.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

CartesianSolver judge_of(const Mechanism& m, CartesianMethod method,
                         Stabilisation stabilisation = Stabilisation::projection) {
  return {m.model, m.topology, method, stabilisation};
}

class Judges : public ::testing::TestWithParam<std::string> {};

TEST_P(Judges, AccelerationsEqualTheRecursiveOnes) {
  const Mechanism m = load(GetParam());
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, m.topology.size() > 40 ? 1 : 4);
  ASSERT_FALSE(states.empty());
  for (const CartesianMethod method : kMethods) {
    const CartesianSolver judge = judge_of(m, method);
    for (std::size_t s = 0; s < states.size(); ++s) {
      const std::vector<double> tau = random_tau(m, 10 + s);
      GenericDerivative expected, actual;
      ASSERT_TRUE(generic.accelerations(states[s], tau, expected).ok());
      ASSERT_TRUE(judge.accelerations(states[s], tau, actual).ok());
      EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-10);
      EXPECT_LT(relative_error(actual.xd, expected.xd), 1e-10);
    }
  }
}

// Multipliers of redundant equations are not unique, those of the others are.
TEST_P(Judges, MultipliersOfIndependentClosuresEqualTheRecursiveOnes) {
  const Mechanism m = load(GetParam());
  const auto has_redundancy = [](const BlockAnalysis& block) { return !block.redundant_equations.empty(); };
  if (std::any_of(m.analysis.blocks.begin(), m.analysis.blocks.end(), has_redundancy)) return;
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const std::vector<double> tau = random_tau(m, 8);
  for (const GenericState& state : random_states(m, 1)) {
    GenericDerivative derivative;
    ASSERT_TRUE(generic.accelerations(state, tau, derivative).ok());
    const std::vector<double> expected = generic.multipliers(state, tau, derivative);
    for (const CartesianMethod method : kMethods) {
      std::vector<double> actual;
      ASSERT_TRUE(judge_of(m, method).multipliers(state, tau, actual).ok());
      EXPECT_LT(relative_error(actual, expected), 1e-9);
    }
  }
}

// Projections move a state that is nearly closed about as far as it is open, and one that is closed not at all.
TEST_P(Judges, ProjectionClosesWhatIsOpenAndLeavesTheRest) {
  const Mechanism m = load(GetParam());
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const CartesianSolver judge = judge_of(m, CartesianMethod::maggi);
  for (const GenericState& closed : random_states(m, 1)) {
    GenericState same = closed;
    ASSERT_TRUE(judge.project(same).ok());
    EXPECT_LT(relative_error(same.z, closed.z), 1e-11);
    EXPECT_LT(relative_error(same.zd, closed.zd), 1e-10);
    GenericState open = closed;
    for (std::size_t i = 0; i < open.z.size(); ++i) {
      open.z[i] += i % 2 == 0 ? 1e-3 : -1e-3;
      open.zd[i] += i % 3 == 0 ? 1e-2 : -1e-2;
    }
    ASSERT_TRUE(judge.project(open).ok());
    EXPECT_LT(largest_absolute(generic.position_residuals(open)), 1e-11);
    EXPECT_LT(largest_absolute(generic.velocity_residuals(open)), 1e-10);
    EXPECT_LT(relative_error(open.z, closed.z, 1), 1);
    for (const Motion& motion : m.model.motions) {
      const int driven = tree_coordinate(m.topology, motion.joint);
      EXPECT_NEAR(open.z[driven], closed.z[driven], 1e-12);
      EXPECT_NEAR(open.zd[driven], closed.zd[driven], 1e-11);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Judges, ::testing::ValuesIn(all_models()), test_name);

struct Run {
  std::string model;
  double duration, step;  ///< s
};

void PrintTo(const Run& run, std::ostream* stream) { *stream << run.model; }

class JudgesInMotion : public ::testing::TestWithParam<Run> {
 protected:
  Mechanism m = without_friction(load(GetParam().model));
  GenericState start = random_states(m, 1).at(0);

  /// Friction turns round within a tenth of a step: there is no fourth derivative to see.
  static Mechanism without_friction(Mechanism mechanism) {
    mechanism.model.frictions.clear();
    return mechanism;
  }
  /// The state at the end by the recursive formulation, in steps too small to matter.
  GenericState truth() const {
    const GenericSolver solver(m.model, m.topology, m.analysis);
    const Dynamics system{solver};
    GenericState state = start;
    const int steps = 16 * static_cast<int>(std::round(GetParam().duration / GetParam().step));
    for (int k = 0; k < steps; ++k) EXPECT_TRUE(step_rk4(system, state, GetParam().duration / steps).ok());
    return state;
  }
  /// Largest difference from the truth at the end, in steps of `step`.
  double error(CartesianMethod method, Stabilisation stabilisation, const GenericState& expected, double step) const {
    CartesianSolver judge = judge_of(m, method, stabilisation);
    GenericState state = start;
    const int steps = static_cast<int>(std::round(GetParam().duration / step));
    for (int k = 0; k < steps; ++k) EXPECT_TRUE(judge.step(state, GetParam().duration / steps).ok()) << k;
    return std::max({relative_error(state.z, expected.z), relative_error(state.zd, expected.zd),
                     state.x.empty() ? 0 : relative_error(state.x, expected.x)});
  }
};

TEST_P(JudgesInMotion, TrajectoryConvergesToTheRecursiveOneWithOrderFour) {
  const GenericState expected = truth();
  for (const Stabilisation stabilisation : {Stabilisation::projection, Stabilisation::baumgarte}) {
    for (const CartesianMethod method : kMethods) {
      const double coarse = error(method, stabilisation, expected, GetParam().step);
      const double fine = error(method, stabilisation, expected, GetParam().step / 2);
      EXPECT_LT(coarse, 1e-3);
      EXPECT_GT(std::log2(coarse / fine), 3.5);
      EXPECT_LT(std::log2(coarse / fine), 5.5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, JudgesInMotion,
                         ::testing::Values(Run{"models/four_bar.json", 0.2, 4e-3},
                                           Run{"models/slider_crank.json", 0.1, 5e-4},
                                           Run{"models/double_pendulum.json", 0.2, 4e-3},
                                           Run{"models/andrews_squeezer.json", 2e-3, 5e-5},
                                           Run{"models/iftomm/a05_flyball_governor.json", 5e-3, 2e-4},
                                           Run{"tests/data/models/governor_rods.json", 0.1, 4e-3},
                                           Run{"models/iftomm/a04_bricard.json", 0.4, 2e-2}));

/// Largest residuals over a part of a motion.
struct Drift {
  double position = 0, velocity = 0;
};

class FourBarInMotion : public ::testing::Test {
 protected:
  Mechanism m = load("models/four_bar.json");
  GenericState state = random_states(m, 1).at(0);

  Drift drift(CartesianSolver& judge, double duration, double h) {
    Drift drift;
    const int steps = static_cast<int>(std::round(duration / h));
    for (int k = 0; k < steps; ++k) {
      EXPECT_TRUE(judge.step(state, h).ok());
      double position = 0, velocity = 0;
      EXPECT_TRUE(judge.residuals(state, position, velocity).ok());
      drift = {std::max(drift.position, position), std::max(drift.velocity, velocity)};
    }
    return drift;
  }
};

TEST_F(FourBarInMotion, ProjectionLeavesRoundingOnly) {
  CartesianSolver judge = judge_of(m, CartesianMethod::augmented);
  const Drift found = drift(judge, 1, 2e-3);
  EXPECT_LE(found.position, m.model.solver.closure_tolerance);
  EXPECT_LT(found.velocity, 1e-12);
}

// Unstabilised drift grows with the square of time: over these ten seconds, to a hundred times that of the first one.
TEST_F(FourBarInMotion, BaumgarteBoundsTheDrift) {
  CartesianSolver judge = judge_of(m, CartesianMethod::null_space, Stabilisation::baumgarte);
  const Drift first = drift(judge, 2, 2e-3), later = drift(judge, 8, 2e-3);
  EXPECT_GT(first.position, 1e-12) << "else there is nothing to bound";
  EXPECT_LT(first.position, 1e-7);
  EXPECT_LT(later.position, 2 * first.position);
  EXPECT_LT(later.velocity, 2 * first.velocity);
}

TEST_F(FourBarInMotion, StateThatIsNotTheLastStepsIsPlacedAnew) {
  CartesianSolver used = judge_of(m, CartesianMethod::maggi, Stabilisation::baumgarte),
                  fresh = judge_of(m, CartesianMethod::maggi, Stabilisation::baumgarte);
  GenericState other = state;
  for (int k = 0; k < 50; ++k) ASSERT_TRUE(used.step(state, 2e-3).ok());
  GenericState again = other;
  ASSERT_TRUE(used.step(other, 2e-3).ok());
  ASSERT_TRUE(fresh.step(again, 2e-3).ok());
  EXPECT_EQ(other.z, again.z);
  EXPECT_EQ(other.zd, again.zd);
}

TEST_F(FourBarInMotion, FailuresLeaveTheStateAsItWas) {
  CartesianSolver judge = judge_of(m, CartesianMethod::maggi);
  const GenericState before = state;
  EXPECT_EQ(judge.step(state, 0).code, Code::step_invalid);
  EXPECT_EQ(judge.step(state, std::nan("")).code, Code::step_invalid);
  EXPECT_EQ(judge.step(state, 1e6).ok(), false);
  EXPECT_EQ(state.z, before.z);
  EXPECT_EQ(state.zd, before.zd);
  GenericState broken = before;
  broken.zd[1] = std::nan("");
  const Status status = judge.step(broken, 1e-3);
  EXPECT_EQ(status.code, Code::not_a_number);
  EXPECT_EQ(status.index, 1);
  EXPECT_EQ(broken.z, before.z);
  for (Body& body : m.model.bodies)
    if (body.name == "coupler") body.points[1].position[0] = 5.0;  // out of the rocker's reach
  broken = before;
  const GenericState open = broken;
  const Status not_closed = judge_of(m, CartesianMethod::maggi).project(broken);
  EXPECT_EQ(not_closed.code, Code::loop_not_closed);
  EXPECT_EQ(not_closed.index, 0);
  EXPECT_EQ(broken.z, open.z);
}

/// A cart driven along x with a pendulum on it.
Mechanism driven_cart(const std::string& inputs, const std::string& position) {
  const std::string text = R"({ "mbgen": 1, "name": "driven_cart", "inputs": {)" + inputs + R"(},
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "cart": { "mass": 2, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } },
      "bob": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0.1, 0.1, 0.1], "points": { "O": [0, 0, 0] } } },
    "joints": { "track": { "type": "prismatic", "from": "ground.O", "to": "cart.O", "axis": "x" },
      "pin": { "type": "revolute", "from": "cart.O", "to": "bob.O", "axis": "y" } },
    "motions": { "pull": { "joint": "track", "position": ")" +
                           position + R"(" } } })";
  const Result<Model> model = read_model(text, "driven_cart.json");
  if (!model) throw std::runtime_error(to_text(model.problems()));
  const Topology topology = *build_topology(*model);
  return {*model, topology, *analyse(*model, topology)};
}

// An input with derivatives is, during a step, the polynomial in time that they make of it.
TEST(DrivenCart, StepFollowsInputsByTheirDerivatives) {
  const Mechanism by_input = driven_cart(R"("x": { "default": 0.3, "derivative": "v" },
    "v": { "default": -1.2, "derivative": "a" }, "a": { "default": 5 })",
                                         "x");
  const Mechanism by_time = driven_cart("", "0.3 - 1.2*t + 2.5*t^2");
  for (const Stabilisation stabilisation : {Stabilisation::projection, Stabilisation::baumgarte}) {
    GenericState expected{{0.3, 0.4}, {-1.2, 0.7}, {}, 0}, actual = expected;
    CartesianSolver timed = judge_of(by_time, CartesianMethod::augmented, stabilisation);
    CartesianSolver steered = judge_of(by_input, CartesianMethod::augmented, stabilisation);
    ASSERT_TRUE(timed.step(expected, 0.1).ok());
    ASSERT_TRUE(steered.step(actual, 0.1).ok());
    if (stabilisation == Stabilisation::projection) {  // Baumgarte's corrections act between the stages
      EXPECT_NEAR(actual.z[0], 0.3 - 0.12 + 0.025, 1e-15);
      EXPECT_NEAR(actual.zd[0], -0.7, 1e-14);
    }
    EXPECT_LT(relative_error(actual.z, expected.z), 1e-14);
    EXPECT_LT(relative_error(actual.zd, expected.zd), 1e-14);
  }
}

}  // namespace
}  // namespace mbgen
