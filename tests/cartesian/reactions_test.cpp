// What joints and rods transmit: the recursive formulation's outputs against the judges, which share nothing with them.

#include "runtime/cartesian/cartesian.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A model whose outputs are all its reactions, in the order of CartesianSolver::reactions.
Mechanism with_reactions(Model model) {
  model.outputs.clear();
  const std::size_t joints = model.joints.size(), rods = model.rods.size();
  for (std::size_t i = 0; i < joints + rods; ++i)
    for (const auto what : {ReactionOutput::What::force, ReactionOutput::What::moment})
      add_reaction(model, i < joints ? static_cast<int>(i) : -1, i < joints ? -1 : static_cast<int>(i - joints), what,
                   ReactionOutput::End::to);
  return analysed(std::move(model));
}

/// Of redundant equations everyone leaves out others; without them reactions are unique.
bool has_redundant_equations(const Mechanism& m) {
  return std::any_of(m.analysis.blocks.begin(), m.analysis.blocks.end(),
                     [](const BlockAnalysis& block) { return !block.redundant_equations.empty(); });
}

TEST(Reactions, OfEveryModelWithoutRedundanceEqualThoseOfTheCartesianSystem) {
  int compared = 0;
  for (const std::string& path : all_models()) {
    SCOPED_TRACE(path);
    const Mechanism m = with_reactions(load(path).model);
    if (has_redundant_equations(m)) continue;
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
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

}  // namespace
}  // namespace mbgen
