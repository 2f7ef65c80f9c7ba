// Opened loop blocks as programs: their operations grow with the joints, and the program of accelerations is the
// recursion at double.

#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/opened_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

long operations(const Mechanism& m, Role role) {
  return count_operations(optimise(trace_recursive_accelerations(m.model, m.topology, m.analysis, role, {}))).total();
}

TEST(OpenedBlocks, OperationsGrowWithTheJoints) {
  for (const auto& [kind, most] : {std::pair{"ring", 250L}, std::pair{"spatial-ring", 1200L}}) {
    const Mechanism small = analysed(grown(kind, 50)), large = analysed(grown(kind, 100));
    for (const Role role : {Role::accelerations, Role::accelerations_chosen}) {
      const long of_small = operations(small, role), of_large = operations(large, role);
      EXPECT_NEAR(static_cast<double>(of_large) / static_cast<double>(of_small), 2.0, 0.1) << kind;
      EXPECT_LT(of_large, 100 * most) << kind;
    }
  }
}

TEST(OpenedBlocks, ProgramsOfBothPartitionsAreTheEquationsOfTheGenericEngine) {
  const Mechanism m = mechanism_of(carried_ring(44, true));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, 2, 0.1);
  ASSERT_EQ(states.size(), 2U);
  const std::vector<double> tau = random_tau(m, 3);
  for (const Role role : {Role::accelerations, Role::accelerations_chosen}) {
    const Program program = optimise(trace_recursive_accelerations(m.model, m.topology, m.analysis, role, {}));
    for (const GenericState& state : states) {
      GenericDerivative expected;
      ASSERT_TRUE(solver.accelerations(state, tau, expected).ok());
      std::vector<double> inputs, zdd(tau.size());
      for (const auto& [group, index] : program.inputs) {
        ASSERT_TRUE(group == Array::z || group == Array::zd || group == Array::tau || group == Array::t);
        inputs.push_back(group == Array::z    ? state.z[index]
                         : group == Array::zd ? state.zd[index]
                         : group == Array::t  ? state.t
                                              : tau[index]);
      }
      const std::vector<double> values = interpret(program, inputs);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& [group, index] = program.outputs[i].slot;
        if (group == Array::zdd) zdd[index] = values[i];
        if (group == Array::inertia || group == Array::pivot) {
          EXPECT_GT(values[i], group == Array::pivot ? 0.05 : 0.0);
        }
      }
      EXPECT_LT(relative_error(zdd, expected.zdd), 1e-9);
    }
  }
}

}  // namespace
}  // namespace mbgen
