// Accelerations of every model against Simbody, which computes them by articulated bodies and Lagrange multipliers.

#include <cstdio>

#include "tests/system/oracle/oracle_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

class EveryModelInSimbody : public InSimbody<std::string> {};

TEST_P(EveryModelInSimbody, HasTheSameAccelerations) {
  const Mechanism m = load_without_tyres(GetParam());
  GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::SimbodyMechanism simbody = in_simbody(m);
  const std::vector<double> tau = random_tau(m, 11);
  const std::vector<GenericState> states = random_states(m, 4);
  ASSERT_FALSE(states.empty());
  double error = 0;
  for (GenericState state : states) {
    solver.set_inputs(foreign::inputs_at(m.model, state.t));
    ASSERT_TRUE(solver.project(state).ok());
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    error = std::max(error, relative_error(simbody.accelerations(foreign_state(state, tau)), derivative.zdd));
  }
  std::printf("%s: accelerations as in Simbody, %.1e relative\n", m.model.name.c_str(), error);
  EXPECT_LT(error, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModelInSimbody, ::testing::ValuesIn(models_in_simbody()), test_name);

TEST(ForeignForces, TyresAreRefusedByNameAndPlace) {
  const Mechanism m = load("models/coach.json");
  const Result<foreign::ForceElements> elements = foreign::force_elements_of(m.model, m.topology);
  ASSERT_FALSE(elements);
  ASSERT_EQ(elements.problems().size(), 4u);
  EXPECT_EQ(elements.problems()[0].message, "tyre \"front_left\" has no form in a foreign solver");
  // The tyre is written once, in the file that the model places left and right.
  EXPECT_EQ(elements.problems()[0].where.pointer, "/tyres/front");
}

}  // namespace
}  // namespace mbgen
