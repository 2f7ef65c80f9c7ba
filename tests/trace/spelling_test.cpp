// A ball is the same mechanism whether one joint of the model or three single ones make it.

#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "tests/support/recursion_support.hpp"
#include "tests/support/spelling_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

long operations_of(const Mechanism& m) {
  return count_operations(optimise(trace_recursive_accelerations(m.model, m.topology, m.analysis))).total();
}

std::vector<std::string> coordinates_of(const Mechanism& m) {
  std::vector<std::string> names;
  for (const TreeBody& body : m.topology.bodies) names.push_back(body.coordinate);
  return names;
}

class Spelling : public ::testing::TestWithParam<std::string> {};

TEST_P(Spelling, SingleJointsOverMasslessBodiesTakeTheOperationsOfTheJointThatTheyMake) {
  const Mechanism whole = load(GetParam()), single = spelled_by_single_joints(whole);
  ASSERT_EQ(coordinates_of(single), coordinates_of(whole));
  ASSERT_GT(single.model.joints.size(), whole.model.joints.size());
  EXPECT_EQ(operations_of(single), operations_of(whole));
  const GenericSolver solver(single.model, single.topology, single.analysis);
  for (const GenericState& state : random_states(whole, 2)) {
    const std::vector<double> tau = random_tau(whole, 23);
    const auto of_whole = test::recursion_at_double(whole.model, whole.topology, whole.analysis, {}, state, tau);
    const auto of_single = test::recursion_at_double(single.model, single.topology, single.analysis, {}, state, tau);
    EXPECT_LT(relative_error(of_single.zdd, of_whole.zdd), 1e-11);
    GenericDerivative generic;
    ASSERT_TRUE(solver.accelerations(state, tau, generic).ok());
    EXPECT_LT(relative_error(of_single.zdd, generic.zdd), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Spelling,
                         ::testing::Values("models/coach.json", "models/truck.json", "models/published/iltis.json",
                                           "models/published/heavy_top.json", "tests/data/models/closure_planar.json",
                                           "tests/data/models/skew_tree.json"),
                         test_name);

/// Three turns about one point, over links that `edit` changes.
Mechanism three_turns(const std::string& link, const std::string& more = "") {
  return mechanism_of(R"({ "mbgen": 1, "name": "turns", "bodies": {
    "ground": { "points": { "at": [0, 0, 0] } },
    "one": { "points": { "at": [0, 0, 0] } },
    "two": { )" + link +
                      R"( "points": { "at": [0, 0, 0], "arm": [0.1, 0, 0] } },
    "end": { "mass": 2, "com": [0.2, 0.1, 0.3], "inertia": [0.1, 0.2, 0.3], "points": { "at": [0, 0, 0] } } },
  "joints": {
    "a": { "type": "revolute", "axis": "x", "from": "ground.at", "to": "one.at" },
    "b": { "type": "revolute", "axis": "y", "from": "one.at", "to": "two.at" },
    "c": { "type": "revolute", "axis": "z", "from": "two.at", "to": "end.at" } })" +
                      more + " }");
}

bool has_quasi_velocities(const Mechanism& m) {
  const Recursion recursion = plan_recursion(m.model, m.topology, m.analysis.driven);
  return std::any_of(recursion.units.begin(), recursion.units.end(), [](const RecursionUnit& unit) {
    return std::any_of(unit.steps.begin(), unit.steps.end(), [](const JointStep& step) { return step.quasi(); });
  });
}

TEST(SpellingOfBalls, OnlyLinksThatDoNothingElseAreInsideABall) {
  EXPECT_TRUE(has_quasi_velocities(three_turns("")));
  const std::string spring = R"(, "springs": { "s": { "from": "ground.at", "to": "two.arm", "stiffness": 10,
    "free_length": 0.1 } })";
  const std::string force = R"(, "forces": { "f": { "at": "two.arm", "force": [0, 0, 1] } })";
  const std::string motion = R"(, "motions": { "m": { "joint": "b", "angle": "0.1 * t" } })";
  EXPECT_FALSE(has_quasi_velocities(three_turns(R"("mass": 1, "inertia": [0, 0, 0],)")));
  for (const std::string& more : {spring, force, motion})
    EXPECT_FALSE(has_quasi_velocities(three_turns("", more))) << more;
}

}  // namespace
}  // namespace mbgen
