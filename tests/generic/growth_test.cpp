// The generic engine over the size of a machine, in operations and entries: four-bars on one crank, one loop block.

#include <cmath>
#include <numbers>
#include <set>

#include "runtime/generic/equations.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A position near the reference with all loops closed, the crank turning at 6 rad/s.
GenericState turning(const Mechanism& m) {
  GenericState state;
  state.z.assign(static_cast<std::size_t>(m.topology.size()), 0.0);
  state.zd = state.z;
  state.z[0] = 0.1;
  state.zd[0] = 6;
  const GenericSolver solver(m.model, m.topology, m.analysis);
  EXPECT_TRUE(solver.project(state).ok());
  return state;
}

struct Work {
  long multiplications = 0;  ///< of the elimination of the block
  std::size_t mass_entries = 0, jacobian_entries = 0;
};

Work work_of(int four_bars) {
  const Mechanism m = analysed(grown("crank", four_bars));
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  System<double>& system = equations.system(turning(m));
  const Closures closures = equations.closures(system, kinematics(system));
  Work work;
  for (const SparseRow<double>& row : closures.at(0).jacobian) work.jacobian_entries += row.columns.size();
  const BlockFactors factors = equations.factors(0, closures[0]);
  EXPECT_EQ(factors.rank(), 2 * four_bars);
  work.multiplications = factors.pivoted().multiplications();
  work.mass_entries = tree_mass_pattern(m.model, m.topology).value.size();
  return work;
}

// Dense elimination of the 200 equations takes 0.6 million multiplications, the dense mass matrix has 6561 entries.
TEST(GenericGrowth, FourBarsOnOneCrankTakeWorkByTheirEntries) {
  const Work many = work_of(40);
  EXPECT_LE(many.multiplications, 2000);
  EXPECT_EQ(many.jacobian_entries, 40U * 5 * 3);
  EXPECT_EQ(many.mass_entries, 1U + 40 * 3);  // itself, and for a coupler the crank below
}

TEST(GenericGrowth, FortyFourBarsMoveAsWithDenseMatrices) {
  const Mechanism m = analysed(grown("crank", 40));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const GenericSolver dense(m.model, m.topology, m.analysis, {LinearAlgebra::eigen, Factorisation::lu});
  const GenericState state = turning(m);
  const std::vector<double> tau(state.z.size(), 0.1);
  GenericDerivative actual, expected;
  ASSERT_TRUE(solver.accelerations(state, tau, actual).ok());
  ASSERT_TRUE(dense.accelerations(state, tau, expected).ok());
  EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-10);
}

// The smallest pivot comes from the factors of the accelerations, and says what a factorisation for it alone says.
TEST(GenericGrowth, NoticesNearASingularPositionAreThoseOfAFactorisationOfTheirOwn) {
  const Mechanism m = analysed(grown("four-bar", 2));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const GenericSolver dense(m.model, m.topology, m.analysis, {LinearAlgebra::eigen, Factorisation::lu});
  std::set<Code> seen;
  for (const double before : {0.6, 0.1, 1e-2, 1e-3, 1e-5, 1e-7}) {
    GenericState state;
    for (int i = 0; i < m.topology.size(); ++i) {
      const double turn = std::numbers::pi / 2 - before;  // all bars lie on one line at a right angle
      state.z.push_back(m.topology.bodies[i].parent == kGround ? turn : -turn);
      state.zd.push_back(m.topology.bodies[i].parent == kGround ? 1 : -1);
    }
    GenericDerivative one, other;
    const Status status = solver.solve_motion(state, one);
    EXPECT_EQ(status.code, dense.solve_motion(state, other).code) << before;
    seen.insert(status.code);
  }
  EXPECT_GE(seen.size(), 3U);  // far, near and in the middle
}

}  // namespace
}  // namespace mbgen
