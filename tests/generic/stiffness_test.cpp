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
  Eigen::MatrixXd taken() {
    Eigen::MatrixXd stiffness;
    const Balance b = balance(equations, state);
    EXPECT_TRUE(stiffness_at(solver, equations, state, b, pinned, stiffness).ok());
    return stiffness;
  }
};

constexpr double kOfDifferences = 1e-3;  // of the largest entry: laws that bend within the difference
constexpr double kRounding = 1e-3;       // N/m or N m/rad: of 1e5 N over the difference

class Stiffness : public ::testing::TestWithParam<std::string> {};

TEST_P(Stiffness, BySlopesIsThatByDifferences) {
  Rest rest(load(GetParam()));
  for (const GenericState& start : random_states(rest.mechanism, 2, 0.03)) {
    rest.state = start;
    ASSERT_TRUE(settled(rest.solver, rest.state).ok());
    const Eigen::MatrixXd slopes = rest.by_slopes(), differences = rest.by_differences();
    ASSERT_EQ(slopes.cols(), unknowns_of(rest.equations, balance(rest.equations, rest.state)));
    EXPECT_EQ(rest.taken(), slopes);
    for (Eigen::Index row = 0; row < slopes.rows(); ++row) {
      const double size = differences.row(row).cwiseAbs().maxCoeff();
      EXPECT_LT((slopes.row(row) - differences.row(row)).cwiseAbs().maxCoeff(), kOfDifferences * size + kRounding)
          << row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Stiffness, ::testing::ValuesIn(all_models()), test_name);

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
