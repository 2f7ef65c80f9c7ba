// Outputs of motions, energies and wheels: the recursive formulation against the judges, which share nothing with it.

#include "runtime/judges/cartesian.hpp"
#include "tests/support/motion_outputs_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

TEST(MotionOutputs, OfEveryModelEqualThoseOfTheCartesianSystem) {
  for (const std::string& path : all_models()) {
    SCOPED_TRACE(path);
    const Mechanism m = with_motion_outputs(model_at(path), 3);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
    const std::vector<GenericState> states = random_states(m, 2);
    EXPECT_EQ(states.size(), 2);
    for (const GenericState& state : states) {
      const std::vector<double> tau = random_tau(m, 31), actual = outputs_at(solver, state, tau);
      GenericOutputs expected;
      ASSERT_TRUE(judge.outputs(state, tau, expected).ok());
      EXPECT_LT(motion_difference(m.model, actual, expected.y), 1e-9);
    }
  }
}

}  // namespace
}  // namespace mbgen
