// Forces and moments that joints and rods transmit: outputs of the recursive formulation against those of the judges.

#include <map>

#include "runtime/judges/cartesian.hpp"
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

// The body without mass inside the cylindrical joint is the base of the coupling's block. The values follow from the
// motion of the bodies.
TEST(Reactions, BelowACoupledTurnOfACylindricalJointPassItsSlide) {
  const Mechanism m = load("tests/data/models/below_coupled.json");
  const GenericState state = reference_state(m);
  const std::vector<double> tau(state.z.size(), 0.0);
  const std::vector<double> expected{13.461, 3.986, 37.597, 0, -9.6467, -1.1394, -17.977};
  const GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<std::vector<double>> answers{outputs_at(solver, state, tau)};
  for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::range_space,
                                       CartesianMethod::null_space, CartesianMethod::maggi}) {
    GenericOutputs outputs;
    ASSERT_TRUE(
        CartesianSolver(m.model, m.topology, method, Stabilisation::projection).outputs(state, tau, outputs).ok());
    answers.push_back(outputs.y);
  }
  for (const std::vector<double>& y : answers)
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(y[i], expected[i], i < 3 || i > 5 ? 5e-4 : 5e-5) << i;
}

/// All outputs that the model has, and the terms of its energy balance.
TEST(Outputs, OfEveryModelAreTheJudgesOwnAndTheSame) {
  int compared = 0;
  for (const std::string& path : all_models()) {
    SCOPED_TRACE(path);
    const Mechanism m = load(path);
    if (has_redundant_equations(m)) continue;
    const GenericSolver solver(m.model, m.topology, m.analysis);
    const CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
    const std::vector<GenericState> states = random_states(m, 2);
    for (const GenericState& state : states) {
      const std::vector<double> tau = random_tau(m, 37);
      GenericDerivative derivative;
      ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
      const GenericOutputs actual = solver.outputs(state, tau, derivative);
      GenericOutputs expected;
      ASSERT_TRUE(judge.outputs(state, tau, expected).ok());
      std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> by_unit;
      for (std::size_t i = 0; i < actual.y.size(); ++i) {
        auto& [ours, theirs] = by_unit[m.model.outputs[i].unit];
        ours.push_back(actual.y[i]), theirs.push_back(expected.y[i]);
      }
      for (const auto& [unit, both] : by_unit) EXPECT_LT(relative_error(both.first, both.second, 1e-2), 1e-8) << unit;
      EXPECT_LT(relative_error({actual.kinetic_energy}, {expected.kinetic_energy}), 1e-9);
      EXPECT_NEAR(actual.potential_energy, expected.potential_energy, 1e-9 * (1 + std::abs(expected.potential_energy)));
      EXPECT_LT(relative_error({actual.applied_power}, {expected.applied_power}, 1), 1e-8);
    }
    ++compared;
  }
  EXPECT_GE(compared, 15);
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
