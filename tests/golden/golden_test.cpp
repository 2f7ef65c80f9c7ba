// The committed code of generated/, compiled as it stands, against the generic runtime on random states.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/compile.hpp"
#include "compiler/linearisation/groups.hpp"
#include "mbgen/blocks.hpp"
#include "runtime/generic/generic.hpp"
#include "tests/support/compiled_solver.hpp"
#include "tests/support/recursion_support.hpp"

namespace mbgen::test {
namespace {

constexpr int kStates = 100;
/// Largest error over largest acceleration. Both engines agree to 1e-13 where the closures are well conditioned; the
/// frozen partition may lose three more digits before its monitor hands over to pivoting.
constexpr double kTolerance = 1e-10;

/// The recursive form at `double`, its program interpreted and its emitted code do the same operations but for sums in
/// another order: some units in the last place, more by the condition of the closures.
constexpr double kSameEquations = 1e-12;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> golden_models() {
  std::ifstream file(MBGEN_SOURCE_DIR "/tests/golden/models.txt");
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) names.push_back(line.substr(0, line.find(' ')));
  return names;
}

/// Largest difference over the largest value.
double relative_error(const std::vector<double>& actual, const std::vector<double>& expected) {
  double difference = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    difference = std::max(difference, std::abs(actual[i] - expected[i]));
  return difference / std::max(largest_absolute(expected), 1e-300);
}

/// The frozen program of the accelerations, interpreted. Parameters and inputs at their defaults.
Groups interpreted(const Compilation& compilation, const GenericState& state, const std::vector<double>& tau) {
  Groups given = {
      {Array::z, state.z}, {Array::zd, state.zd}, {Array::x, state.x}, {Array::t, {state.t}}, {Array::tau, tau}};
  for (const Parameter& p : compilation.model.parameters)
    if (p.tunable) given[Array::par].push_back(p.value);
  for (const Input& input : compilation.model.inputs) given[Array::in].push_back(input.default_value);
  const Programs programs = counted_programs(compilation);
  if (!programs.derived_constants.outputs.empty())
    given[Array::derived] = evaluate(programs.derived_constants, given).at(Array::derived);
  return evaluate(programs.accelerations, given);
}

/// A state near the reference, as a solver's table has it, and joint forces.
struct Guess {
  std::vector<double> state, tau;
};

Guess any_guess(const SolverTable& table, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const int n = table.coordinates;
  Guess guess{std::vector<double>(table.state_size, 0.0), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    guess.state[i] = 0.2 * number(random);
    guess.state[n + i] = 2 * number(random);
    guess.tau[i] = 100 * number(random);
  }
  for (int i = 0; i < table.auxiliary_states; ++i) guess.state[2 * n + i] = 0.01 * number(random);
  return guess;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, agreesWithTheGenericRuntime) {
  const Result<Compilation> compilation = compile(MBGEN_SOURCE_DIR "/models/" + GetParam() + ".json");
  ASSERT_TRUE(compilation) << to_text(compilation.problems());
  const std::string name = solver_name(compilation->model);
  std::vector<EmittedFile> files = {emit_driver(compilation->model)};
  for (const char* ending : {".hpp", ".cpp"}) {
    files.push_back({name + ending, read_text(MBGEN_SOURCE_DIR "/generated/" + GetParam() + "/" + name + ending)});
  }
  // committed_test compiles these files as users do, for long runs; optimisation leaves the bits of one state alone.
  const Loaded loaded(files, name, {"g++", CompilerFamily::gnu}, " -O0");
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  const RecursionChoices choices =
      cheapest_recursion(compilation->model, compilation->topology, compilation->analysis).choices;
  const GenericSolver generic(compilation->model, compilation->topology, compilation->analysis);

  const int n = table.coordinates;
  ASSERT_EQ(n, compilation->topology.size());
  const int slips = table.auxiliary_states;
  std::mt19937 random(2012);
  int compared = 0, frozen = 0;
  for (int attempt = 0; attempt < 2 * kStates && compared < kStates; ++attempt) {
    auto [state, tau] = any_guess(table, random);
    std::vector<double> derivative(table.derivative_size), position(table.closure_equations + 1), velocity = position;
    // A guess that far from the reference need not lead to a closed position.
    if (!table.project(table.default_parameters, table.default_inputs, state.data()).ok()) continue;
    ++compared;
    ASSERT_TRUE(
        table.residuals(table.default_parameters, table.default_inputs, state.data(), position.data(), velocity.data())
            .ok());
    EXPECT_LE(largest_absolute(position), 1e-12);
    // Rates up to some hundred rad/s times lengths of a metre, rounded.
    EXPECT_LE(largest_absolute(velocity), 1e-11 * std::max(1.0, largest_absolute(state)));

    ASSERT_TRUE(
        table.accelerations(table.default_parameters, table.default_inputs, state.data(), tau.data(), derivative.data())
            .ok());
    GenericState same;
    same.z.assign(state.begin(), state.begin() + n);
    same.zd.assign(state.begin() + n, state.begin() + 2 * n);
    same.x.assign(state.begin() + 2 * n, state.begin() + 2 * n + slips);
    GenericDerivative expected;
    ASSERT_TRUE(generic.accelerations(same, tau, expected).ok());
    const auto end_of_zdd = derivative.begin() + n;
    EXPECT_LE(relative_error({derivative.begin(), end_of_zdd}, expected.zdd), kTolerance) << "state " << attempt;
    EXPECT_LE(relative_error({end_of_zdd, end_of_zdd + slips}, expected.xd), kTolerance) << "state " << attempt;

    Groups program = interpreted(*compilation, same, tau);
    if (std::any_of(program[Array::pivot].begin(), program[Array::pivot].end(),
                    [](double pivot) { return pivot < kPivotThreshold<double>; }))
      continue;  // emitted code has pivoted there
    ++frozen;
    const auto at_double =
        recursion_at_double(compilation->model, compilation->topology, compilation->analysis, choices, same, tau);
    EXPECT_LE(relative_error(program[Array::zdd], at_double.zdd), kSameEquations) << "state " << attempt;
    EXPECT_LE(relative_error({derivative.begin(), end_of_zdd}, at_double.zdd), kSameEquations) << "state " << attempt;
    EXPECT_LE(relative_error({end_of_zdd, end_of_zdd + slips}, at_double.xd), kSameEquations) << "state " << attempt;
  }
  EXPECT_EQ(compared, kStates) << "too few guesses could be closed";
  EXPECT_GE(frozen, kStates / 2) << "too few states on the frozen path";
}

INSTANTIATE_TEST_SUITE_P(Models, Golden, testing::ValuesIn(golden_models()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace mbgen::test
