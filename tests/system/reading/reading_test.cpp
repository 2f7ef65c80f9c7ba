// The copy of a solver for reading: it computes the fast solver's accelerations, its headings stand in the order of the
// paper's steps, and its values and numbers have names.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/emit/quantity_names.hpp"
#include "tests/support/compiled_solver.hpp"
#include "tests/support/reference_support.hpp"
#include "workbench/describe/equation.hpp"
#include "workbench/describe/equation_lines.hpp"

namespace mbgen {
namespace {

using namespace test;
using testing::reference_states;
using testing::ReferenceState;

/// Both copies are the same equations; sums in other orders cost some units in the last place, more by the condition of
/// the closures.
constexpr double kRounding = 1e-11;

std::string path_of(const std::string& model) { return std::string(MBGEN_SOURCE_DIR) + "/models/" + model + ".json"; }

Compilation compiled(const std::string& model, Spelling spelling, std::optional<Form> form = {}) {
  Result<Compilation> compilation = compile(path_of(model), {.form = form, .spelling = spelling});
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return std::move(*compilation);
}

std::string solver_text(const Compilation& compilation) {
  for (const EmittedFile& file : emit(compilation, {.runtime_headers = false}))
    if (file.path == solver_name(compilation.model) + ".cpp") return file.text;
  return "";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Values of a text, and how many of them have no name but a step and a number.
struct Named {
  int values = 0, unnamed = 0;
};

Named named_values(const std::string& text) {
  static const std::regex kValue(R"(  const double (\w+) = .*)"), kUnnamed(R"(s\d+_\d+)");
  Named named;
  std::smatch match;
  for (const std::string& line : lines_of(text)) {
    if (!std::regex_match(line, match, kValue)) continue;
    ++named.values;
    named.unnamed += std::regex_match(match[1].str(), kUnnamed);
  }
  return named;
}

struct Case {
  const char *model, *states;  ///< "" states: those of any_state
  double most_unnamed;
};

void PrintTo(const Case& of, std::ostream* out) { *out << of.model; }

class ReadingCopy : public ::testing::TestWithParam<Case> {};

/// Accelerations of a solver at states of its coordinates.
std::vector<std::vector<double>> accelerations_of(const SolverTable& table, const std::vector<ReferenceState>& states) {
  std::vector<std::vector<double>> all;
  for (const ReferenceState& at : states) {
    std::vector<double> state(static_cast<std::size_t>(table.state_size)),
        derivative(static_cast<std::size_t>(table.derivative_size));
    std::ranges::copy(at.state.z, state.begin());
    std::ranges::copy(at.state.zd, state.begin() + table.coordinates);
    std::ranges::copy(at.state.x, state.begin() + 2 * static_cast<std::ptrdiff_t>(table.coordinates));
    const Status status = table.accelerations(table.default_parameters, table.default_inputs, state.data(),
                                              at.tau.data(), derivative.data());
    EXPECT_TRUE(status.ok()) << text(status.code);
    all.emplace_back(derivative.begin(), derivative.begin() + table.coordinates);
  }
  return all;
}

/// Closed states of a four-bar: turning couplers in four positions, driven by a torque.
std::vector<ReferenceState> turned_states(const SolverTable& table) {
  std::vector<ReferenceState> states;
  for (const double angle : {0.0, 0.1, 0.2, -0.1}) {
    std::vector<double> state(static_cast<std::size_t>(table.state_size));
    state[1] = angle;
    state[static_cast<std::size_t>(table.coordinates) + 1] = 2 + angle;
    if (!table.project(table.default_parameters, table.default_inputs, state.data()).ok()) continue;
    const auto n = static_cast<std::ptrdiff_t>(table.coordinates);
    states.push_back({{{state.begin(), state.begin() + n}, {state.begin() + n, state.begin() + 2 * n}, {}, 0},
                      std::vector<double>(static_cast<std::size_t>(n), 1.5),
                      {},
                      {}});
  }
  return states;
}

/// Compares the accelerations of both copies. states_of: of a compilation and its solver, some states.
template <class StatesOf>
void expect_equal_accelerations(const std::string& model, const StatesOf& states_of) {
  const auto loaded = [&](Spelling spelling) {
    const Compilation compilation = compiled(model, spelling);
    std::vector<EmittedFile> files = emit(compilation, {.runtime_headers = false});
    files.push_back(emit_driver(compilation.model));
    return std::make_unique<Loaded>(files, solver_name(compilation.model), Compiler{"g++", CompilerFamily::gnu},
                                    " -O0");
  };
  const auto fast = loaded(Spelling::fast), reading = loaded(Spelling::reading);
  ASSERT_NE(fast->table(), nullptr) << fast->compilation().text;
  ASSERT_NE(reading->table(), nullptr) << reading->compilation().text;
  const std::vector<ReferenceState> states = states_of(compiled(model, Spelling::fast), *fast->table());
  ASSERT_GE(states.size(), 3u);
  const auto expected = accelerations_of(*fast->table(), states), found = accelerations_of(*reading->table(), states);
  for (std::size_t s = 0; s < states.size(); ++s) {
    double largest = 0;
    for (const double value : expected[s]) largest = std::max(largest, std::abs(value));
    ASSERT_GT(largest, 0);
    for (std::size_t i = 0; i < expected[s].size(); ++i)
      EXPECT_NEAR(found[s][i], expected[s][i], kRounding * largest) << "state " << s << ", coordinate " << i;
  }
}

TEST_P(ReadingCopy, ComputesTheAccelerationsOfTheFastSolver) {
  expect_equal_accelerations(GetParam().model, [](const Compilation& compilation, const SolverTable& table) {
    return *GetParam().states != '\0' ? reference_states(compilation.topology, GetParam().states)
                                      : turned_states(table);
  });
}

/// The texts of the functions that compute a program, by their names.
std::map<std::string, std::string> functions_of(const std::string& text) {
  std::map<std::string, std::string> functions;
  constexpr std::string_view kHead = "\nvoid compute_";
  for (std::size_t start = text.find(kHead); start != std::string::npos; start = text.find(kHead, start + 1)) {
    const std::size_t name = start + std::string_view("\nvoid ").size();
    functions[text.substr(name, text.find('(', name) - name)] = text.substr(start, text.find("\n}\n", start) - start);
  }
  return functions;
}

void expect_names_in_each_function(const std::string& text, double most_unnamed) {
  const std::map<std::string, std::string> functions = functions_of(text);
  EXPECT_GE(functions.size(), 4u);
  for (const auto& [function, body] : functions) {
    if (function == "compute_tangents" || function == "compute_changes") continue;  // of implicit steps
    const Named named = named_values(body);
    EXPECT_LT(named.unnamed, most_unnamed * named.values + 1)
        << function << ": " << named.unnamed << " of " << named.values;
  }
}

TEST_P(ReadingCopy, NamesItsValues) {
  const std::string text = solver_text(compiled(GetParam().model, Spelling::reading));
  EXPECT_GT(named_values(functions_of(text).at("compute_accelerations")).values, 30) << "the test has read too little";
  expect_names_in_each_function(text, GetParam().most_unnamed);
}

TEST_P(ReadingCopy, WritesOneSignATerm) {
  const std::string text = solver_text(compiled(GetParam().model, Spelling::reading));
  for (const char* twice : {"- -", "+ -"}) {
    const std::size_t at = text.find(twice);
    EXPECT_EQ(at, std::string::npos) << text.substr(at > 80 ? at - 80 : 0, 160);
  }
}

TEST_P(ReadingCopy, NamesNumbersByTheirOrigin) {
  static const std::regex kNumber(R"(constexpr double ([a-zA-Z]\w*_\w+) = )");
  const std::string text = solver_text(compiled(GetParam().model, Spelling::reading));
  int numbers = 0;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), kNumber); at != std::sregex_iterator(); ++at) {
    const std::string name = (*at)[1];
    ++numbers;
    EXPECT_FALSE(name.starts_with("number")) << name;
    EXPECT_FALSE(quantity_of(name).prefix.empty()) << name;
  }
  EXPECT_GT(numbers, 10);
}

/// The headings of steps in each function.
std::map<std::string, std::vector<std::string>> headings_of(const std::string& text) {
  std::map<std::string, std::vector<std::string>> headings;
  std::string function;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("void compute_")) function = line.substr(0, line.find('('));
    if (line.starts_with("  // --- ")) headings[function].push_back(line);
  }
  return headings;
}

TEST_P(ReadingCopy, HasEachStepOnceInOrder) {
  static const std::regex kStep(R"(  // --- step (\d+): .*)");
  const auto headings = headings_of(solver_text(compiled(GetParam().model, Spelling::reading)));
  EXPECT_GE(headings.size(), 5u);
  for (const auto& [function, all] : headings) {
    int last = 0;
    for (const std::string& heading : all) {
      std::smatch match;
      ASSERT_TRUE(std::regex_match(heading, match, kStep)) << heading;
      EXPECT_GT(std::stoi(match[1]), last) << function << ": " << heading;
      last = std::stoi(match[1]);
    }
  }
  EXPECT_GE(headings.at("void compute_accelerations").size(), 7u);
}

// Halves and doubles are of the equations, and 1e-12 is the share that elimination loses; every other number of the
// accelerations is of the model, and has a name.
TEST_P(ReadingCopy, NamesItsNumbers) {
  static const std::regex kNumber(R"([^\w.](\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+))");
  const std::set<std::string> of_equations = {"0.0", "0.5", "1.0", "2.0", "1e-12"};
  bool is_in_function = false;
  int statements = 0;
  for (const std::string& line : lines_of(solver_text(compiled(GetParam().model, Spelling::reading)))) {
    if (line.starts_with("void compute_accelerations(")) is_in_function = true;
    if (line == "}") is_in_function = false;
    if (!is_in_function || line.find("//") != std::string::npos) continue;
    ++statements;
    for (auto at = std::sregex_iterator(line.begin(), line.end(), kNumber); at != std::sregex_iterator(); ++at)
      EXPECT_TRUE(of_equations.contains((*at)[1])) << line;
  }
  EXPECT_GT(statements, 80);
}

INSTANTIATE_TEST_SUITE_P(Models, ReadingCopy,
                         ::testing::Values(Case{"four_bar", "", 0.30},
                                           Case{"coach_mechanism", "tests/data/reference/coach_states.json", 0.25}),
                         [](const auto& info) { return std::string(info.param.model); });

TEST(ReadingConstants, AreWrittenByTheirOperation) {
  const std::string text = solver_text(compiled("four_bar", Spelling::reading));
  EXPECT_NE(text.find("constexpr double Io_rocker_yy = I_rocker_yy + m_rocker*(c_rocker_x*c_rocker_x +\n"
                      "    c_rocker_z*c_rocker_z);  // 0.02195\n"),
            std::string::npos)
      << text.substr(0, 6000);
}

/// A function of the coach's mechanism.
std::string function_of_mechanism(const char* function) {
  static const std::string text = solver_text(compiled("coach_mechanism", Spelling::reading));
  return functions_of(text).at(function);
}

void expect_in(const std::string& text, const std::vector<std::string>& found, const std::vector<std::string>& others) {
  for (const std::string& name : found) EXPECT_NE(text.find(name), std::string::npos) << name;
  for (const std::string& name : others) EXPECT_EQ(text.find(name), std::string::npos) << name;
}

// Components of the common motion of three joints are named by axis: a slot of carrier_left_rz holds x. Rows of rods
// over them are longer by the length of the rod. Remainders are told from the left side.
TEST(ReadingCopyOfTheMechanism, NamesComponentsRowsAndRemainders) {
  expect_in(function_of_mechanism("compute_accelerations"),
            {" Rz_carrier_left_about_x_2 ", " per_pivot_carrier_left_about_x ", " Q_rear_axle_about_x_applied ",
             " Q_chassis_along_z_reduced ", " Jl_tie_rod_left_carrier_left_about_x ", "Jl_tie_rod_left_bell_crank ",
             " Q_lower_arm_left_reduced "},
            {" Rz_carrier_left_rz_", "per_pivot_carrier_left_rz ", " Q_chassis_rx_", "J_tie_rod_left_", "_left_left",
             "_right_left"});
  expect_in(function_of_mechanism("compute_closure"), {"J_tie_rod_left_bell_crank ", "J_tie_rod_left_carrier_left_rz "},
            {"Jl_", "_about_"});
}

// A value of a loop block does not stand under the heading of the body before it.
TEST(ReadingCopyOfTheMechanism, HasAHeadingWhereTheBodyChanges) {
  std::string heading;
  int values = 0;
  for (const std::string& line : lines_of(function_of_mechanism("compute_accelerations"))) {
    if (line.starts_with("  // ")) heading = line.substr(5);
    if (!line.starts_with("  const double H_") && !line.starts_with("  const double per_pivot_lower_arm_")) continue;
    ++values;
    EXPECT_FALSE(heading.starts_with("wheel_")) << heading << ": " << line;
  }
  EXPECT_GT(values, 5);
}

TEST(ReadingCopyOfMatrixForm, HasEachStepOnceInOrder) {
  const auto headings = headings_of(solver_text(compiled("four_bar", Spelling::reading, Form::matrix)));
  EXPECT_EQ(headings.at("void compute_accelerations").size(), 9u);
}

/// The reading copy of a model with the elements in question, compiled once.
const std::string& text_of(const std::string& model) {
  static std::map<std::string, std::string> texts;
  if (!texts.contains(model)) texts[model] = solver_text(compiled(model, Spelling::reading));
  return texts[model];
}

struct ElementCase {
  const char* model;
  double most_unnamed;  ///< of the accelerations
};
void PrintTo(const ElementCase& of, std::ostream* out) { *out << of.model; }

class ReadingCopyOfElements : public ::testing::TestWithParam<ElementCase> {};

TEST_P(ReadingCopyOfElements, NamesItsValues) {
  const std::string& text = text_of(GetParam().model);
  EXPECT_GT(named_values(functions_of(text).at("compute_accelerations")).values, 1000)
      << "the test has read too little";
  expect_names_in_each_function(text, GetParam().most_unnamed);
  const Named all = named_values(text);
  EXPECT_LT(all.unnamed, 0.40 * all.values) << all.unnamed << " of " << all.values;
}

/// Names of the applied forces in the accelerations, of negatives that of the value.
std::set<std::string> names_of_forces(const std::string& text) {
  std::set<std::string> names;
  for (const EquationLine& line : equations_in(text))
    if (line.program == "compute_accelerations" && line.step.starts_with("step 5"))
      names.insert(line.name.starts_with("minus_") ? line.name.substr(6) : line.name);
  return names;
}

TEST_P(ReadingCopyOfElements, NamesTheirForces) {
  const Model model = compiled(GetParam().model, Spelling::reading).model;
  const std::set<std::string> names = names_of_forces(text_of(GetParam().model));
  const auto expect_names = [&](const auto& elements, const std::vector<std::string>& kinds, const char* axis = "") {
    for (const auto& element : elements)
      for (const std::string& kind : kinds)
        EXPECT_TRUE(names.contains(kind + "_" + element.name + axis)) << kind << " of " << element.name;
  };
  expect_names(model.springs, {"force"});
  expect_names(model.air_springs, {"force"});
  expect_names(model.joint_springs, {"force"});
  expect_names(model.bump_stops, {"force"});
  expect_names(model.tyres, {"Fz", "Fx", "Fy", "kappa", "alpha"});
  expect_names(model.bushings, {"deflection", "force"}, "_z");
  EXPECT_GE(model.springs.size() + model.air_springs.size() + model.tyres.size(), 10u);
}

TEST_P(ReadingCopyOfElements, ExplainsEachKindOfName) {
  static const std::regex kUnnamed(R"(s\d+_\d+)");
  for (const std::string& name : names_of_forces(text_of(GetParam().model)))
    EXPECT_TRUE(std::regex_match(name, kUnnamed) || !quantity_of(name).prefix.empty()) << name;
}

INSTANTIATE_TEST_SUITE_P(Models, ReadingCopyOfElements,
                         ::testing::Values(ElementCase{"coach", 0.30}, ElementCase{"truck", 0.30},
                                           ElementCase{"rubber_coach", 0.40}),
                         [](const auto& info) { return std::string(info.param.model); });

TEST(ReadingCopyOfTheCoach, ExplainsForces) {
  const std::string text = equation_text("coach.cpp", text_of("coach"), "Fz_front_left");
  EXPECT_TRUE(text.starts_with("Fz_front_left: vertical force of a tyre, its load, N\n  coach.cpp:")) << text;
  EXPECT_NE(equation_text("coach.cpp", text_of("coach"), "force_damper_front_1_left").find(", N or N m\n"),
            std::string::npos);
  EXPECT_NE(text.find(", compute_accelerations, step 5: "), std::string::npos) << text;
}

/// States of a coach that rolls on its tyres: the chassis heaves and rolls, an arm and the springs with it move.
std::vector<ReferenceState> rolling_states(const Topology& topology, const SolverTable& table) {
  const auto n = static_cast<std::size_t>(table.coordinates);
  const auto coordinate = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(topology.bodies, name, &TreeBody::coordinate) -
                                    topology.bodies.begin());
  };
  std::vector<ReferenceState> states;
  for (const double share : {0.5, 1.0, -1.0}) {
    std::vector<double> state(static_cast<std::size_t>(table.state_size));
    for (std::size_t i = 2 * n; i < state.size(); ++i) state[i] = 0.002 * share;
    state[coordinate("chassis_tz")] = -0.02 * share;
    state[coordinate("chassis_rx")] = 0.02 * share;
    state[n + coordinate("chassis_tx")] = 15;
    state[n + coordinate("chassis_tz")] = 0.2 * share;
    state[n + coordinate("lower_arm_left")] = 0.3 * share;
    for (const char* wheel : {"wheel_front_left", "wheel_front_right", "wheel_rear_left", "wheel_rear_right"})
      state[n + coordinate(wheel)] = 15 / 0.52;
    if (!table.project(table.default_parameters, table.default_inputs, state.data()).ok()) continue;
    const auto size = static_cast<std::ptrdiff_t>(n);
    states.push_back({{{state.begin(), state.begin() + size},
                       {state.begin() + size, state.begin() + 2 * size},
                       {state.begin() + 2 * size, state.end()},
                       0},
                      std::vector<double>(n),
                      {},
                      {}});
  }
  return states;
}

TEST(ReadingCopyOfTheCoach, ComputesTheAccelerationsOfTheFastSolver) {
  expect_equal_accelerations("coach", [](const Compilation& compilation, const SolverTable& table) {
    return rolling_states(compilation.topology, table);
  });
}

}  // namespace
}  // namespace mbgen
