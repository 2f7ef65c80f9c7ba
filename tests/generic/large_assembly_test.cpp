// Wishes for the coordinates of large loop blocks, whose equations are sparse: rows of four-bars, each of which is a
// parallelogram, so that all cranks turn alike and all couplers turn back by as much.

#include <cmath>

#include "runtime/generic/nearest.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

int coordinate(const Mechanism& m, const std::string& name) {
  for (int i = 0; i < m.topology.size(); ++i)
    if (m.topology.bodies[i].coordinate == name) return i;
  return -1;
}

void expect_all_alike(const Mechanism& m, const std::vector<double>& values, double crank, double error) {
  for (int i = 0; i < m.topology.size(); ++i) {
    const bool is_crank = m.topology.bodies[i].coordinate[0] == 'A';
    EXPECT_NEAR(values[i], is_crank ? crank : -crank, error) << m.topology.bodies[i].coordinate;
  }
}

TEST(LargeAssembly, OneWishMovesARowOfFourBars) {
  const Mechanism m = analysed(grown("four-bar", 150));  // 451 coordinates
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  ASSERT_TRUE(solver.assemble(state, {{coordinate(m, "A0"), 0.3, 1, true}}).ok());
  expect_all_alike(m, state.z, 0.3, 1e-11);
  ASSERT_TRUE(solver.assemble(state, {{coordinate(m, "A75"), 0.2, 1, false}}).ok());
  expect_all_alike(m, state.z, 0.2, 1e-8);
  ASSERT_TRUE(solver.assemble_velocities(state, {{coordinate(m, "A3"), -2, 1, false}}).ok());
  expect_all_alike(m, state.zd, -2, 1e-11);
  // Wishes that contradict each other: the mean of -1 and 2 by their weights 3 and 1.
  ASSERT_TRUE(
      solver.assemble_velocities(state, {{coordinate(m, "A3"), -1, 3, false}, {coordinate(m, "A9"), 2, 1, false}})
          .ok());
  expect_all_alike(m, state.zd, -0.25, 1e-11);
}

// Rows that repeat others or are empty count for nothing.
TEST(SparseEquations, GiveTheNearestVector) {
  const std::vector<SparseRow<double>> rows{{{0, 1, 3}, {1, 1, 5}}, {{0, 1, 3}, {2, 2, 10}}, {}, {{1, 2}, {1, -1}}};
  const SparseEquations equations(rows, 4, {0, 1, 2});
  EXPECT_FALSE(equations.is_rigid());
  const Eigen::Vector4d b(3, 6, 0, 0);
  // x = (3 - s, s, s): |x|^2 is least at s = 1.
  EXPECT_LT((equations.damped(b, 0) - Eigen::Vector3d(2, 1, 1)).norm(), 1e-14);
  // (x0 - 2)^2 + 4 (x2 - 3)^2 at s = 2.6
  EXPECT_LT(
      (equations.nearest(Eigen::Vector3d(0.5, 0, 1), Eigen::Vector3d(2, 0, 3), b) - Eigen::Vector3d(0.4, 2.6, 2.6))
          .norm(),
      1e-12);
}

}  // namespace
}  // namespace mbgen
