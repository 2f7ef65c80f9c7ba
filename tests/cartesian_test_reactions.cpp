// What joints and rods transmit: the recursive formulation's outputs against the judges, which share nothing with them.

#include "runtime/cartesian/cartesian.hpp"
#include "tests/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

class JudgedReactions : public ::testing::TestWithParam<std::string> {};

// Of redundant closures everyone leaves out other equations; where all count, reactions are unique.
TEST_P(JudgedReactions, EqualThoseOfTheCartesianSystem) {
  Model model = load(GetParam()).model;
  model.outputs.clear();
  const std::size_t joints = model.joints.size(), rods = model.rods.size();
  for (std::size_t i = 0; i < joints + rods; ++i)
    for (const auto what : {ReactionOutput::What::force, ReactionOutput::What::moment})
      add_reaction(model, i < joints ? static_cast<int>(i) : -1, i < joints ? -1 : static_cast<int>(i - joints), what,
                   ReactionOutput::End::to);
  const Mechanism m = analysed(model);
  for (const BlockAnalysis& block : m.analysis.blocks)
    if (!block.redundant_equations.empty()) return;
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
  for (const GenericState& state : random_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 31), actual = outputs_at(solver, state, tau);
    std::vector<std::array<double, 6>> wrenches;
    ASSERT_TRUE(judge.reactions(state, tau, wrenches).ok());
    std::vector<double> expected;
    for (const auto& wrench : wrenches) expected.insert(expected.end(), wrench.begin(), wrench.end());
    ASSERT_EQ(actual.size(), expected.size());
    EXPECT_LT(relative_error(actual, expected), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, JudgedReactions, ::testing::ValuesIn(all_models()), test_name);

}  // namespace
}  // namespace mbgen
