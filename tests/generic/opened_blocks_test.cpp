// Loop blocks with few loops and many freedoms, which the recursive form solves on their opened tree with multipliers:
// against the dense equations of their free directions, and against a Cartesian judge.

#include <cmath>

#include "runtime/generic/by_recursion.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/opened_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

void expect_as_others_have_it(const Mechanism& m) {
  ASSERT_TRUE(m.topology.blocks.front().opened);
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  const GenericSolver by_matrix(m.model, m.topology, m.analysis);
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
  const std::vector<GenericState> states = random_states(m, 3, 0.1);
  ASSERT_EQ(states.size(), 3U);
  for (const GenericState& state : states) {
    const std::vector<double> tau = random_tau(m, 2);
    GenericDerivative dense, judged, found;
    ASSERT_TRUE(by_matrix.accelerations(state, tau, dense).ok());
    ASSERT_TRUE(judge.accelerations(state, tau, judged).ok());
    ASSERT_TRUE(accelerations_by_recursion(equations, state, tau, found).ok());
    EXPECT_LT(relative_error(found.zdd, dense.zdd), 1e-9);
    EXPECT_LT(relative_error(found.zdd, judged.zdd), 1e-7);
  }
}

TEST(OpenedBlocks, APlanarRingOnGround) { expect_as_others_have_it(analysed(grown("ring", 50))); }
TEST(OpenedBlocks, ASpatialRingOnGround) { expect_as_others_have_it(analysed(grown("spatial-ring", 50))); }
TEST(OpenedBlocks, APlanarRingOnABodyThatTurns) { expect_as_others_have_it(mechanism_of(carried_ring(44, false))); }
TEST(OpenedBlocks, ASpatialRingOnABodyThatTurns) { expect_as_others_have_it(mechanism_of(carried_ring(44, true))); }

/// The direction of a link with two points, rad.
double direction_of(const Body& link) {
  const auto &a = link.points[0].position, &b = link.points[1].position;
  return std::atan2(b[1].value - a[1].value, b[0].value - a[0].value);
}

// With all links along one line the ring does not hold its ends along it.
TEST(OpenedBlocks, AStretchedRingIsSingular) {
  const Mechanism m = analysed(grown("ring", 50));
  GenericState state = reference_state(m);
  std::vector<double> turned(state.z.size());
  for (int i = 0; i < m.topology.size(); ++i) {
    const TreeBody& body = m.topology.bodies[i];
    turned[i] = -direction_of(m.model.bodies[body.model_body]);
    state.z[i] = (turned[i] - (body.parent == kGround ? 0.0 : turned[body.parent])) * body.axis[2];
  }
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  GenericDerivative found;
  const Status status = accelerations_by_recursion(equations, state, std::vector<double>(state.z.size(), 0.0), found);
  EXPECT_EQ(status.code, Code::loop_singular);
  EXPECT_EQ(status.index, 0);
}

// Only large blocks are opened, with more freedoms than twice their equations, whose bodies have inertia of their own.
TEST(OpenedBlocks, AreThoseThatGainByIt) {
  const auto is_opened = [](const Result<Model>& model) {
    const Result<Topology> topology = build_topology(*model);
    return topology->blocks.front().opened;
  };
  EXPECT_TRUE(is_opened(grown("ring", 42)));
  EXPECT_FALSE(is_opened(grown("ring", 41)));  // 40 coordinates
  EXPECT_FALSE(is_opened(grown("four-bar", 60)));
  EXPECT_TRUE(is_opened(grown("ring", 60, "sed 's/\"inertia\": .0.002, 0.002, 0.002./\"inertia\": [0, 0, 0]/'")));
  // A link that is a point on its own joint leaves the opened tree without an answer.
  const std::string point = "sed '/\"link9\"/s/\"mass\": 1, .*/\"mass\": 0,/'";
  EXPECT_FALSE(is_opened(grown("ring", 60, point)));
}

}  // namespace
}  // namespace mbgen
