// The stiffness of a model at rest by slopes against central differences, and laws that have a slope on one side only.

#include <cmath>

#include "runtime/generic/balance.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A position at rest of a model, with what a search asks there.
struct Rest {
  Mechanism mechanism;
  GenericEquations equations;
  GenericSolver solver;
  GenericState state;
  Pinned pinned;

  explicit Rest(Mechanism m)
      : mechanism(std::move(m)),
        equations(mechanism.model, mechanism.topology, mechanism.analysis, {}),
        solver(mechanism.model, mechanism.topology, mechanism.analysis),
        state(reference_state(mechanism)),
        pinned(state.x.size(), false) {}

  Eigen::MatrixXd by_slopes() { return stiffness_by_slopes(equations, state, balance(equations, state), pinned); }
  Eigen::MatrixXd by_differences() {
    Eigen::MatrixXd stiffness;
    const Balance b = balance(equations, state);
    EXPECT_TRUE(stiffness_by_differences(solver, equations, state, b, pinned, stiffness).ok());
    return stiffness;
  }
  Eigen::VectorXd force_after(Eigen::Index unknown, double change) {
    const Balance b = balance(equations, state);
    GenericState there;
    const Eigen::VectorXd way = Eigen::VectorXd::Unit(unknowns_of(equations, b), unknown) * change;
    EXPECT_TRUE(moved(solver, equations, state, b, way, there).ok());
    return balance(equations, there).force;
  }
  /// A column by differences of second order on one side, ahead or behind.
  Eigen::VectorXd on_one_side(Eigen::Index unknown, double step) {
    return (4 * force_after(unknown, step) - 3 * balance(equations, state).force - force_after(unknown, 2 * step)) /
           (2 * step);
  }
  Eigen::MatrixXd taken() {
    Eigen::MatrixXd stiffness;
    const Balance b = balance(equations, state);
    EXPECT_TRUE(stiffness_at(solver, equations, state, b, pinned, stiffness).ok());
    return stiffness;
  }
};

constexpr double kOfDifferences = 2e-7;  // of the largest entry of a row: of second order, over 1e-6 rad or m
constexpr double kRounding = 1e-3;       // N/m or N m/rad: of 1e5 N over the difference
constexpr double kShort = 2e-8;          // rad or m

class Stiffness : public ::testing::TestWithParam<std::string> {};

/// A law that bends within the central difference, or curves more than that follows, has a slope at the state all the
/// same: that of a shorter difference on the side where the bend is not. Random states of models with stiff rubber are
/// within 3e-6 rad of the reference, where wheels stand upright and laws of tyres bend over the size of the camber.
TEST_P(Stiffness, BySlopesIsThatByDifferences) {
  Rest rest(load(GetParam()));
  for (const GenericState& start : random_states(rest.mechanism, 2, 0.03)) {
    rest.state = start;
    ASSERT_TRUE(brought_to_rest(rest.solver, rest.state).ok());
    const Eigen::MatrixXd slopes = rest.by_slopes(), differences = rest.by_differences();
    ASSERT_EQ(slopes.cols(), unknowns_of(rest.equations, balance(rest.equations, rest.state)));
    EXPECT_EQ(rest.taken(), slopes);
    const Eigen::VectorXd size = differences.rowwise().lpNorm<Eigen::Infinity>();
    for (Eigen::Index u = 0; u < slopes.cols(); ++u) {
      const Eigen::ArrayXd bound = kOfDifferences * size.array() + kRounding;
      Eigen::ArrayXd off = (slopes.col(u) - differences.col(u)).cwiseAbs().array() / bound;
      if (off.maxCoeff() > 1) {
        const Eigen::ArrayXd ahead = (slopes.col(u) - rest.on_one_side(u, kShort)).cwiseAbs().array() / bound;
        const Eigen::ArrayXd behind = (slopes.col(u) - rest.on_one_side(u, -kShort)).cwiseAbs().array() / bound;
        off = off.min(ahead).min(behind);
      }
      Eigen::Index row;
      EXPECT_LE(off.maxCoeff(&row), 1) << row << ", " << u;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Stiffness, ::testing::ValuesIn(all_models()), test_name);

/// The bend of the row that central differences of rubber_coach miss by 2e-4: the cornering stiffness of a PAC2002 tyre
/// is K (1 - PKY3 |camber|), and its lateral force a function of K times the slip. So dF/dcamber jumps by
/// 2 PKY3 slip dF/dslip where a wheel stands upright, less than 1e-6 rad from the state.
TEST(StiffnessOfLaws, OfATyreBendsWhereTheWheelStandsUpright) {
  Rest rest(load("models/rubber_coach.json"));
  rest.state = random_states(rest.mechanism, 1, 0.03).at(0);
  ASSERT_TRUE(brought_to_rest(rest.solver, rest.state).ok());
  const std::vector<int> free = free_coordinates(rest.mechanism.topology, rest.mechanism.analysis);
  const auto place = [&](const char* name) {
    return std::find(free.begin(), free.end(), find_coordinate(rest.mechanism.topology, name)) - free.begin();
  };
  const Eigen::Index across = place("chassis_ty"), tilt = place("carrier_right_rx");
  const Eigen::Index slip = static_cast<Eigen::Index>(free.size()) + 3;  // lateral, of the front right tyre
  const Eigen::MatrixXd here = rest.by_slopes();
  const double force_by_slip = here(across, slip) / rest.equations.magnitudes[3];
  const Balance b = balance(rest.equations, rest.state);
  GenericState beyond;
  ASSERT_TRUE(
      moved(rest.solver, rest.equations, rest.state, b, Eigen::VectorXd::Unit(here.cols(), tilt) * -1e-6, beyond).ok());
  const double lateral_slip = rest.state.x[3];
  rest.state = beyond;
  constexpr double kPky3 = -0.25732;  // models/tyres/315_80_R22.json
  const double jump = rest.by_slopes()(across, tilt) - here(across, tilt);
  EXPECT_NEAR(jump / (2 * kPky3 * lateral_slip * force_by_slip), 1, 0.01) << jump;
}

Mechanism sliding_under(const std::string& force) {
  return mechanism_of(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
                "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "x" } },
    "joint_springs": { "push": { "joint": "slide", "force": ")" +
                      force + R"(" } } })");
}

// At the kink of |x| the mean of both slopes counts, as a central difference has it.
TEST(StiffnessOfLaws, AtAKinkIsTheMeanOfBothSides) {
  Rest rest(sliding_under("300*abs(position) + 100*position"));
  EXPECT_EQ(rest.taken()(0, 0), -100);
}

// A root has no slope at zero: there the difference is taken.
TEST(StiffnessOfLaws, WithoutASlopeIsByDifferences) {
  Rest rest(sliding_under("sqrt(max(position, 0))"));
  EXPECT_FALSE(std::isfinite(rest.by_slopes()(0, 0)));
  EXPECT_TRUE(std::isfinite(rest.taken()(0, 0)));
}

}  // namespace
}  // namespace mbgen
