// Tunable parameters: emitted solvers with all their numbers tunable, against those into which the same numbers are
// folded, and against the generic runtime at other values.

#include <cmath>
#include <cstdio>

#include "compiler/compile.hpp"
#include "tests/support/compiled_solver.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/table_state.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Gives numbers of a model to tunable parameters.
class Tuning {
 public:
  explicit Tuning(Model& model) : model_(model) {}

  void take(Quantity& quantity) {
    if (quantity.expression >= 0 || quantity.value == 0) return;
    const int parameter = static_cast<int>(model_.parameters.size());
    model_.parameters.push_back({"number_" + std::to_string(parameter), {}, quantity.value, "", true});
    ExpressionNode node;
    node.kind = ExpressionNode::Kind::parameter;
    node.index = parameter;
    quantity.expression = static_cast<int>(model_.expressions.size());
    model_.expressions.push_back({model_.parameters.back().name, {node}});
  }
  void take(std::optional<Quantity>& quantity) {
    if (quantity) take(*quantity);
  }
  void take(Law& law) {
    if (auto* factor = std::get_if<Quantity>(&law)) take(*factor);
  }
  void take(std::optional<Law>& law) {
    if (law) take(*law);
  }
  template <class Quantities>
  void take_each(Quantities& quantities) {
    for (Quantity& quantity : quantities) take(quantity);
  }

 private:
  Model& model_;
};

void tune_bodies(Model& model, Tuning& tuning) {
  for (Body& body : model.bodies) {
    tuning.take(body.mass);
    tuning.take_each(body.com);
    tuning.take_each(body.inertia);
    for (Point& point : body.points) tuning.take_each(point.position);
  }
}

void tune_forces(Model& model, Tuning& tuning) {
  for (PointSpring& spring : model.springs) {
    tuning.take(spring.stiffness);
    tuning.take(spring.damping);
    tuning.take(spring.free_length);
    tuning.take(spring.preload);
  }
  for (JointSpring& spring : model.joint_springs) {
    tuning.take(spring.stiffness);
    tuning.take(spring.damping);
  }
  for (AirSpring& spring : model.air_springs) {
    for (Quantity* quantity : {&spring.pressure, &spring.ambient, &spring.exponent, &spring.volume0})
      tuning.take(*quantity);
    tuning.take(spring.area);
  }
  for (Tyre& tyre : model.tyres) {
    tuning.take_each(tyre.coefficients);
    for (Quantity* quantity : {&tyre.radius, &tyre.stiffness, &tyre.damping, &tyre.friction, &tyre.rolling_resistance,
                               &tyre.relaxation_x, &tyre.relaxation_y})
      tuning.take(*quantity);
  }
}

/// The model with masses, inertias, geometry, stiffnesses and tyres tunable.
Model tunable(Model model) {
  Tuning tuning(model);
  tune_bodies(model, tuning);
  tune_forces(model, tuning);
  return model;
}

Compilation compiled(const Model& model) {
  Result<Compilation> compilation = compile(model);
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return std::move(*compilation);
}

/// An emitted solver, called at values of its parameters.
struct Solver {
  explicit Solver(const Compilation& compilation)
      : files(emit(compilation)),
        loaded(with_driver(compilation), solver_name(compilation.model), {"g++", CompilerFamily::gnu}, " -O0") {
    if (loaded.table() == nullptr) throw std::runtime_error(loaded.compilation().text);
    table = loaded.table();
    parameters.assign(table->default_parameters, table->default_parameters + table->parameters);
  }
  std::vector<EmittedFile> with_driver(const Compilation& compilation) {
    std::vector<EmittedFile> all = files;
    all.push_back(emit_driver(compilation.model));
    return all;
  }

  std::vector<double> accelerations(const std::vector<double>& state, const std::vector<double>& tau) const {
    std::vector<double> rates(table->coordinates + table->auxiliary_states);
    EXPECT_TRUE(
        table->accelerations(parameters.data(), table->default_inputs, state.data(), tau.data(), rates.data()).ok());
    return rates;
  }
  std::vector<double> after_steps(std::vector<double> state, int steps) const {
    for (int i = 0; i < steps; ++i)
      EXPECT_TRUE(table->step_rk4(parameters.data(), table->default_inputs, state.data(), 1e-3).ok());
    return state;
  }

  std::vector<EmittedFile> files;
  test::Loaded loaded;
  const SolverTable* table = nullptr;
  std::vector<double> parameters;
};

/// At the solver's parameters, the generic runtime gives the same accelerations.
void expect_as_judged(const Solver& solver, const Compilation& tuned) {
  const Mechanism m{tuned.model, tuned.topology, tuned.analysis};
  GenericSolver judge(m.model, m.topology, m.analysis);
  judge.set_parameters(solver.parameters);
  int compared = 0;
  for (GenericState state : random_states(m, 5)) {
    if (!judge.project(state).ok()) continue;
    ++compared;
    const std::vector<double> tau = random_tau(m, 3);
    GenericDerivative expected;
    ASSERT_TRUE(judge.accelerations(state, tau, expected).ok());
    std::vector<double> rates = expected.zdd;
    rates.insert(rates.end(), expected.xd.begin(), expected.xd.end());
    EXPECT_LT(relative_error(solver.accelerations(flat(*solver.table, state), tau), rates), 1e-10);
  }
  EXPECT_GE(compared, 3);
}

class Tunables : public ::testing::TestWithParam<std::string> {};

TEST_P(Tunables, EqualFoldedNumbersAndReachEveryTerm) {
  const Mechanism m = load(GetParam());
  const Compilation tuned = compiled(tunable(m.model)), plain = compiled(m.model);
  const Solver folded(plain);
  Solver solver(tuned);
  const std::vector<double> tau = random_tau(m, 3);
  double accelerations = 0, motion = 0;
  for (const GenericState& state : random_states(m, 5)) {
    const std::vector<double> at = flat(*solver.table, state);
    accelerations =
        std::max(accelerations, relative_error(solver.accelerations(at, tau), folded.accelerations(at, tau)));
    motion = std::max(motion, relative_error(solver.after_steps(at, 50), folded.after_steps(at, 50)));
  }
  std::printf(
      "%s: %d parameters, %d constants follow; %ld operations, %ld when folded; accelerations differ by %.1e, 50 steps "
      "by %.1e\n",
      m.model.name.c_str(), solver.table->parameters,
      static_cast<int>(tuned.emitted.programs.derived_constants.outputs.size()),
      count_operations(counted_programs(tuned).accelerations).total(),
      count_operations(counted_programs(plain).accelerations).total(), accelerations, motion);
  EXPECT_LT(accelerations, 1e-13);
  EXPECT_LT(motion, 1e-12);

  for (std::size_t i = 0; i < solver.parameters.size(); ++i)
    solver.parameters[i] *= 1 + 0.01 * std::sin(static_cast<double>(i));
  expect_as_judged(solver, tuned);
}

INSTANTIATE_TEST_SUITE_P(Models, Tunables,
                         ::testing::Values("models/coach.json", "tests/data/models/all_elements.json"), test_name);

}  // namespace
}  // namespace mbgen
