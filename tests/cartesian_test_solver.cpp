// The Cartesian judges against the recursive formulation, with which they share no kinematics.

#include <fstream>
#include <nlohmann/json.hpp>

#include "mbgen/integrators.hpp"
#include "runtime/cartesian/cartesian.hpp"
#include "tests/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr CartesianMethod kMethods[] = {CartesianMethod::augmented, CartesianMethod::range_space,
                                        CartesianMethod::null_space, CartesianMethod::maggi};

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

INSTANTIATE_TEST_SUITE_P(Models, Judges, ::testing::ValuesIn(all_models()), test_name);

}  // namespace
}  // namespace mbgen
