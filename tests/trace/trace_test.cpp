// The traced programs, interpreted, against the formulation at double run by the generic runtime.

#include <map>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "runtime/generic/block_factors.hpp"
#include "tests/support/recursion_support.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

using Slots = std::map<SlotGroup, std::vector<double>>;

/// Runs a program on named arrays; parameters and inputs at their defaults.
Slots run(const Program& program, const Mechanism& m, Slots given) {
  for (const Parameter& p : m.model.parameters)
    if (p.tunable) given[Array::par].push_back(p.value);
  for (const Input& input : m.model.inputs) given[Array::in].push_back(input.default_value);
  given[Array::charts].resize(m.topology.balls.size(), 0.0);
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(given.at(slot.group).at(slot.index));
  const std::vector<double> values = interpret(program, inputs);
  Slots results;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<double>& group = results[program.outputs[i].slot.group];
    const auto index = static_cast<std::size_t>(program.outputs[i].slot.index);
    if (group.size() <= index) group.resize(index + 1);
    group[index] = values[i];
  }
  return results;
}

Slots slots_of(const GenericState& state, const std::vector<double>& tau) {
  return {{Array::z, state.z}, {Array::zd, state.zd}, {Array::x, state.x}, {Array::t, {state.t}}, {Array::tau, tau}};
}

/// Asks for what every joint and rod transmits at both ends, and for every multiplier.
Mechanism with_reactions(Mechanism m) {
  const auto ask = [&](const auto& source) { m.model.outputs.push_back({"asked", {}, "", source}); };
  const auto ask_reactions = [&](int joint, int rod) {
    using Source = ReactionOutput;
    for (const Source::What what : {Source::What::force, Source::What::moment})
      for (const Source::End end : {Source::End::to, Source::End::from})
        for (int axis = 0; axis < 3; ++axis) ask(Source{what, joint, rod, axis, end == Source::End::from, end});
  };
  for (std::size_t j = 0; j < m.model.joints.size(); ++j) ask_reactions(static_cast<int>(j), -1);
  for (std::size_t r = 0; r < m.model.rods.size(); ++r) ask_reactions(-1, static_cast<int>(r));
  for (const Loop& loop : m.topology.loops)
    for (int e = 0; e < loop.equations; ++e) ask(MultiplierOutput{loop.joint, loop.rod, e});
  return m;
}

class EveryModel : public ::testing::TestWithParam<std::string> {
 protected:
  EveryModel()
      : m(with_reactions(load(GetParam()))),
        programs(traced_programs(m.model, m.topology, m.analysis).programs),
        solver(m.model, m.topology, m.analysis) {}
  Mechanism m;
  Programs programs;
  GenericSolver solver;
};

class EveryModelWithLoops : public EveryModel {};

// Both solve the same equations with other pivots: differences are rounding times the condition of the mechanism.
TEST_P(EveryModel, FrozenAccelerationsEqualThoseOfFullPivoting) {
  const Program matrix = trace_accelerations(m.model, m.topology, m.analysis, Form::matrix);
  for (const Program& program : {programs.accelerations, optimise(programs.accelerations), matrix, optimise(matrix)})
    for (const GenericState& state : random_states(m, 5)) {
      const std::vector<double> tau = random_tau(m, 11);
      GenericDerivative expected;
      ASSERT_TRUE(solver.accelerations(state, tau, expected).ok());
      const Slots actual = run(program, m, slots_of(state, tau));
      EXPECT_LT(
          relative_error(actual.contains(Array::zdd) ? actual.at(Array::zdd) : std::vector<double>{}, expected.zdd),
          1e-9);
      if (!expected.xd.empty()) {
        EXPECT_LT(relative_error(actual.at(Array::xd), expected.xd), 1e-9);
      }
      if (actual.contains(Array::inertia)) {
        for (double inertia : actual.at(Array::inertia)) EXPECT_GT(inertia, 0);
      }
    }
}

/// Projections of all blocks by full pivoting. terms: outputs of the closure terms.
std::vector<GroupProjection<double>> pivoted_projections(const Mechanism& m, const Slots& terms) {
  std::vector<GroupProjection<double>> projections;
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b) {
    const std::size_t columns = m.topology.blocks[b].joints.size(), rows = terms.at(of_block(Array::Phi, b)).size();
    const std::vector<double>& flat = terms.at(of_block(Array::Jz, b));
    std::vector<std::vector<double>> jacobian;
    for (std::size_t e = 0; e < rows; ++e)
      jacobian.emplace_back(flat.begin() + e * columns, flat.begin() + (e + 1) * columns);
    const BlockFactors factors(sparse_rows(jacobian), static_cast<int>(columns), m.analysis.blocks[b].driven,
                               m.analysis.blocks[b].rank);
    std::vector<double> zdd_star(columns, 0.0);
    for (int c : m.analysis.blocks[b].driven)
      zdd_star[c] = terms.at(Array::driven_acceleration)[m.topology.blocks[b].joints[c]];
    factors.solve(terms.at(of_block(Array::c, b)), zdd_star);
    projections.push_back({factors.rz(), zdd_star});
  }
  return projections;
}

/// The projections as inputs of a program.
Slots with_projections(Slots given, const std::vector<GroupProjection<double>>& projections) {
  for (std::size_t b = 0; b < projections.size(); ++b) {
    given[of_block(Array::zdd_star, b)] = projections[b].zdd_star;
    std::vector<double>& flat = given[of_block(Array::Rz, b)];
    for (const std::vector<double>& row : projections[b].rz) flat.insert(flat.end(), row.begin(), row.end());
  }
  return given;
}

/// Results of all elements of every law, from the arguments that the program around them gives.
Slots with_law_results(const std::vector<SharedLaw>& laws, const Slots& around, Slots given) {
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const SharedLaw& law = laws[k];
    const std::vector<double>& arguments = around.at(of_block(Array::law_argument, k));
    const std::size_t elements = law.tyres.size();
    std::vector<double>& results = given[of_block(Array::law_result, k)];
    for (std::size_t element = 0; element < elements; ++element) {
      std::vector<double> inputs;
      for (const Slot& slot : law.program.inputs) {
        const LawArgument& argument = law.arguments.at(slot.index);
        inputs.push_back(argument.numbers.empty() ? arguments.at(argument_place(law, slot.index, element))
                                                  : argument.numbers.at(element));
      }
      const std::vector<double> values = interpret(law.program, inputs);
      for (std::size_t i = 0; i < values.size(); ++i)
        results.at(law.program.outputs[i].slot.index * elements + element) = values[i];
    }
  }
  return given;
}

TEST(SharedLaws, AccelerationsAroundThemAreTheSame) {
  for (const char* model : {"models/coach.json", "models/truck.json", "tests/data/models/three_wheeler.json",
                            "tests/data/models/turning_three_wheeler.json"}) {
    const Mechanism m = load(model);
    const auto [programs, around_laws, in_pairs] = traced_programs(m.model, m.topology, m.analysis);
    ASSERT_TRUE(around_laws) << model;
    const std::vector<SharedLaw>& laws = around_laws->laws;
    ASSERT_EQ(laws.size(), 1u) << model;
    ASSERT_EQ(laws[0].tyres.size(), m.model.tyres.size());
    for (const GenericState& state : random_states(m, 3)) {
      Slots given = slots_of(state, random_tau(m, 13));
      given[of_block(Array::law_result, 0)].resize(laws[0].results.size() * m.model.tyres.size());
      const Slots around = run(around_laws->program, m, given);
      const Slots split = run(around_laws->program, m, with_law_results(laws, around, given));
      const Slots whole = run(programs.accelerations, m, given);
      EXPECT_LT(relative_error(split.at(Array::zdd), whole.at(Array::zdd)), 1e-12) << model;
      EXPECT_LT(relative_error(split.at(Array::xd), whole.at(Array::xd)), 1e-12) << model;
    }
  }
}

TEST(SharedLaws, OneTyreAndTyresOfOtherCoefficientsHaveNone) {
  const Mechanism one = load("models/pulled_wheel.json");
  EXPECT_FALSE(trace_around_laws(one.model, one.topology, one.analysis, {}));
  Mechanism m = load("tests/data/models/three_wheeler.json");
  m.model.tyres[1].coefficients[0].value += 1;
  const std::optional<AroundLaws> around = trace_around_laws(m.model, m.topology, m.analysis, {});
  ASSERT_TRUE(around);
  ASSERT_EQ(around->laws.size(), 1u);
  EXPECT_EQ(around->laws[0].tyres, (std::vector<int>{0, 2}));
}

TEST_P(EveryModelWithLoops, AccelerationsWithAGivenPartitionEqualTheFrozenOnes) {
  for (const GenericState& state : random_states(m, 3)) {
    const std::vector<double> tau = random_tau(m, 13);
    const auto projections = pivoted_projections(m, run(programs.closure_terms, m, slots_of(state, tau)));
    const Slots chosen = run(programs.accelerations_chosen, m, with_projections(slots_of(state, tau), projections));
    const Slots frozen = run(programs.accelerations, m, slots_of(state, tau));
    EXPECT_LT(relative_error(chosen.at(Array::zdd), frozen.at(Array::zdd)), 1e-9);
  }
}

// The recursion with a partition chosen at run time, at `double` and traced: the same operations but for sums in
// another order. The frozen partition and emitted code: golden_test.
TEST(Trace, TheChosenPartitionAtDoubleEqualsItsProgram) {
  for (const char* path : {"models/four_bar.json", "models/pulled_wheel.json", "models/coach_mechanism.json"}) {
    SCOPED_TRACE(path);
    const Mechanism m = load(path);
    const Program terms = traced_programs(m.model, m.topology, m.analysis).programs.closure_terms;
    const Program program = trace_recursive_accelerations(m.model, m.topology, m.analysis, Role::accelerations_chosen);
    for (const GenericState& state : random_states(m, 3)) {
      const std::vector<double> tau = random_tau(m, 19);
      const auto projections = pivoted_projections(m, run(terms, m, slots_of(state, tau)));
      const Slots traced = run(program, m, with_projections(slots_of(state, tau), projections));
      const auto at_double = test::recursion_at_double(m.model, m.topology, m.analysis, {}, state, tau, projections);
      EXPECT_LT(relative_error(traced.at(Array::zdd), at_double.zdd), 1e-12);
    }
  }
}

TEST_P(EveryModelWithLoops, ClosureProgramLeavesAClosedStateAlone) {
  for (const GenericState& state : random_states(m, 3)) {
    const Slots closure = run(programs.closure, m, slots_of(state, {}));
    EXPECT_LT(largest_absolute(closure.at(Array::residual)), 1e-11);
    EXPECT_LT(largest_absolute(closure.at(Array::dz)), 1e-9);
    EXPECT_LT(relative_error(closure.at(Array::zd), state.zd), 1e-8);
  }
}

// Multipliers and reactions are the same for redundant closures too: both leave out the same equations.
TEST_P(EveryModel, MultipliersAndOutputsEqualThoseOfTheGenericRuntime) {
  for (const GenericState& state : random_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 17);
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    Slots given = slots_of(state, tau);
    given[Array::zdd] = derivative.zdd;
    const GenericOutputs expected = solver.outputs(state, tau, derivative);
    const Slots forces = run(programs.multipliers, m, given);
    for (const Array group : {Array::lambda, Array::drive})
      if (forces.contains(group)) given[group] = forces.at(group);
    const Slots outputs = run(programs.outputs, m, given);
    EXPECT_LT(relative_error(outputs.at(Array::y), expected.y), 1e-8);
    if (forces.contains(Array::lambda)) {
      EXPECT_LT(relative_error(forces.at(Array::lambda), solver.multipliers(state, tau, derivative)), 1e-8);
    }
    EXPECT_NEAR(outputs.at(Array::energy)[0], expected.kinetic_energy, 1e-9 * std::abs(expected.kinetic_energy) + 1e-9);
    EXPECT_NEAR(outputs.at(Array::energy)[1], expected.potential_energy,
                1e-9 * std::abs(expected.potential_energy) + 1e-9);
    EXPECT_NEAR(outputs.at(Array::power)[0], expected.applied_power, 1e-7 * std::abs(expected.applied_power) + 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(all_models()), test_name);
INSTANTIATE_TEST_SUITE_P(Models, EveryModelWithLoops, ::testing::ValuesIn(models_with_loops()), test_name);

// Locked and overconstrained blocks: both forms against the states of an independent solver.
TEST(Trace, RefusedMechanismsHaveTheAccelerationsOfTheIndependentSolver) {
  const std::string folder = "tests/data/refused/";
  for (const std::string name :
       {"m7", "k0_s20261127", "k0_s20261140", "k0_s20261160", "k0_s20261175", "k0_s20261198"}) {
    const Mechanism mechanism = load(folder + name + ".json");
    const std::vector<ReferenceState> states = reference_states(mechanism.topology, folder + name + "_ref.json");
    ASSERT_FALSE(states.empty()) << name;
    for (const Form form : {Form::matrix, Form::recursive}) {
      const Program program = trace_accelerations(mechanism.model, mechanism.topology, mechanism.analysis, form);
      for (const ReferenceState& s : states) {
        const Slots given = slots_of(s.state, s.tau);
        EXPECT_LT(relative_error(run(program, mechanism, given).at(Array::zdd), s.zdd), 1e-8)
            << name << " " << name_of(form);
      }
    }
  }
}

TEST(Trace, TwoRunsGiveTheSameProgram) {
  const Mechanism m = load("models/four_bar.json");
  const Programs first = traced_programs(m.model, m.topology, m.analysis).programs,
                 second = traced_programs(m.model, m.topology, m.analysis).programs;
  EXPECT_EQ(dump(first.accelerations), dump(second.accelerations));
}

// Scopes leave no operation outside a step, whatever the form and the program.
TEST(Trace, EveryOperationBelongsToAStep) {
  for (const char* path : {"models/four_bar.json", "models/pulled_wheel.json", "models/slider_crank.json"})
    for (const Form form : {Form::matrix, Form::recursive}) {
      const Mechanism m = load(path);
      const Programs programs = traced_programs(m.model, m.topology, m.analysis, form).programs;
      for (const Program* program : all_programs(programs))
        for (ValueId v = 0; v < program->nodes.size(); ++v) {
          const Node& node = program->nodes[v];
          if (arity(node.op) == 0) continue;
          ASSERT_NE(node.section.step, Step::none) << path << " " << program->name << " %" << v;
        }
    }
}

// A form that grows faster than the model is not written where the other one does not: chains in the matrix form.
TEST(Trace, ALongChainIsTracedInTheRecursiveFormAlone) {
  const auto operations = [](int size) {
    const Mechanism m = analysed(grown("chain", size));
    const Programs programs = traced_programs(m.model, m.topology, m.analysis).programs;
    EXPECT_EQ(programs.form, Form::recursive);
    return count_operations(programs.accelerations).total();
  };
  const long of_100 = operations(100), of_130 = operations(130), of_160 = operations(160);
  // offsets between rounded coordinates are equal or not: a few operations fold or do not
  EXPECT_NEAR(static_cast<double>(of_160 - of_130), static_cast<double>(of_130 - of_100), 0.002 * (of_130 - of_100));
}

// Energies and outputs are summed along the tree: what is asked of a chain twice as long takes twice the operations.
TEST(Trace, OutputsOfAChainGrowWithItsLength) {
  const auto operations = [](int size) {
    const Mechanism m = analysed(grown("chain", size));
    return count_operations(traced_programs(m.model, m.topology, m.analysis, Form::recursive).programs.outputs).total();
  };
  const long of_20 = operations(20), of_40 = operations(40), of_60 = operations(60);
  EXPECT_NEAR(static_cast<double>(of_60 - of_40), static_cast<double>(of_40 - of_20), 0.02 * (of_40 - of_20));
}

// Rings as large blocks: frozen accelerations against full pivoting. A ring that is not opened, here by a link without
// mass, is traced in the matrix form alone.
TEST(Trace, ARingOfFiftyJointsIsTracedInOneForm) {
  for (const auto& [kind, edit, form] :
       {std::tuple{"ring", "cat", Form::recursive}, std::tuple{"spatial-ring", "cat", Form::recursive},
        std::tuple{"ring", R"(sed '/"link9"/s/"mass": 1, .*/"mass": 0,/')", Form::matrix}}) {
    const Mechanism m = analysed(grown(kind, 50, edit));
    const Programs programs = traced_programs(m.model, m.topology, m.analysis).programs;
    EXPECT_EQ(programs.form, form);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    for (const GenericState& state : random_states(m, 2)) {
      const std::vector<double> tau = random_tau(m, 19);
      GenericDerivative expected;
      ASSERT_TRUE(solver.accelerations(state, tau, expected).ok());
      const Slots actual = run(programs.accelerations, m, slots_of(state, tau));
      EXPECT_LT(relative_error(actual.at(Array::zdd), expected.zdd), 1e-9) << kind;
    }
  }
}

// Position and velocity of the root must not enter: the equations live in the frame of the chassis.
TEST(Trace, RootPositionDropsOutOfTheCoach) {
  const Mechanism m = load("models/coach_mechanism.json");
  const Program program = optimise(traced_programs(m.model, m.topology, m.analysis).programs.accelerations);
  for (const Slot& slot : program.inputs)
    for (const char* name : {"chassis_tx", "chassis_ty", "chassis_tz", "wheel_front_left", "wheel_rear_right"})
      EXPECT_FALSE(slot == (Slot{Array::z, find_coordinate(m.topology, name)})) << name;
}

// Ceilings a little above today's counts, so that a lost structural zero shows without a clock.
TEST(Trace, OperationCountsStayLow) {
  const auto count = [](const std::string& path) {
    const Mechanism m = load(path);
    return count_operations(optimise(traced_programs(m.model, m.topology, m.analysis).programs.accelerations)).total();
  };
  EXPECT_LE(count("models/coach_mechanism.json"), 6700);
  EXPECT_LE(count("models/truck_mechanism.json"), 17000);
}

// Sines would cost thousands. All operations count, also floor and look-ups.
TEST(Trace, ARoughRoadCostsATenthOfTheCoachAtMost) {
  const auto count = [](const std::string& roads) {
    const Mechanism m =
        mechanism_of(R"({ "mbgen": 1, "include": [")" + source_path("models/coach.json") + "\"]" + roads + " }");
    const OperationCount c =
        count_operations(optimise(traced_programs(m.model, m.topology, m.analysis).programs.accelerations));
    return c.total() + c.sqrt + c.trigonometric + c.other;
  };
  const long plane = count("");
  EXPECT_LE(count(R"(, "roads": { "rough": { "iso_8608": { "class": "C" } } })"), plane + plane / 10) << plane;
}

}  // namespace
}  // namespace mbgen
