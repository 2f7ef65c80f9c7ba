// Programs of outputs of motions, energies and wheels, interpreted, against the formulation at double.

#include "compiler/formulation/orientation.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "tests/support/motion_outputs_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Outputs by a program, at the parameters and inputs of the model.
std::vector<double> run(const Program& program, const Mechanism& m, const GenericState& state,
                        const std::vector<double>& tau, const std::vector<double>& zdd) {
  std::map<Array, std::vector<double>> given{{Array::z, state.z},   {Array::zd, state.zd}, {Array::x, state.x},
                                             {Array::t, {state.t}}, {Array::tau, tau},     {Array::zdd, zdd}};
  for (const Parameter& parameter : m.model.parameters)
    if (parameter.tunable) given[Array::par].push_back(parameter.value);
  for (const Input& input : m.model.inputs) given[Array::in].push_back(input.default_value);
  given[Array::lambda].resize(static_cast<std::size_t>(equation_count(m.topology)));  // no motion shows them
  given[Array::drive].resize(m.model.motions.size());
  given[Array::charts].resize(m.topology.balls.size(), 0.0);
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(given.at(slot.group.array).at(slot.index));
  const std::vector<double> values = interpret(program, inputs);
  std::vector<double> y(m.model.outputs.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (program.outputs[i].slot.group == Array::y) y[program.outputs[i].slot.index] = values[i];
  return y;
}

TEST(MotionOutputs, OfEveryModelAreThoseOfTheGenericRuntimeInBothForms) {
  for (const std::string& path : all_models()) {
    SCOPED_TRACE(path);
    const Mechanism m = with_motion_outputs(model_at(path), 9, 2);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    for (const Form form : {Form::matrix, Form::recursive}) {
      const Program program = optimise(trace_outputs(m.model, m.topology, m.analysis, form));
      for (const GenericState& state : random_states(m, 2)) {
        const std::vector<double> tau = random_tau(m, 17);
        GenericDerivative derivative;
        ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
        const std::vector<double> expected = solver.outputs(state, tau, derivative).y;
        EXPECT_LT(motion_difference(m.model, run(program, m, state, tau, derivative.zdd), expected), 1e-10);
      }
    }
  }
}

// Linearisation and directional derivatives pass through these programs, often at the reference configuration.
TEST(MotionOutputs, DerivativesOfAnglesAreFiniteAtNoRotation) {
  constexpr Vector3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::array<int, 3>& sequence : {std::array{2, 1, 0}, std::array{2, 0, 2}, std::array{0, 1, 0}}) {
    ProgramBuilder builder("outputs");
    Matrix<Expr> r = identity<Expr>();
    for (int turn = 0; turn < 3; ++turn)
      r = r * rotation<Expr>(kAxes[turn], Expr(builder, builder.input(Array::z, turn)));
    const Vector<Expr> vector = rotation_vector(r);
    const Expr values[] = {angle_of_turn(r, sequence, 0),
                           angle_of_turn(r, sequence, 1),
                           angle_of_turn(r, sequence, 2),
                           vector.x,
                           vector.y,
                           vector.z};
    for (int i = 0; i < 6; ++i) builder.output(Array::y, i, values[i].value(builder));
    const int seeds[] = {0, 1, 2};
    const Program program = differentiate(builder.finish(), seeds);
    std::vector<double> inputs(program.inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = program.inputs[i].group == Array::z ? 0.0 : 0.7;
    for (const double value : interpret(program, inputs)) EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace mbgen
