// The Cartesian judges as engines. Accelerations, motions, multipliers, reactions, residuals and the outputs that show
// motions, energies and angles of wheels are the judge's own; the other outputs are read off its states by the generic
// runtime.

#include <memory>

#include "compiler/engines/engine.hpp"

namespace mbgen {
namespace {

struct Judge {
  CartesianSolver solver;
  GenericSolver observer;  ///< other outputs at the judge's z, zd and zdd
};

std::shared_ptr<Judge> make_judge(const Compilation& compilation, CartesianMethod method, Stabilisation stabilisation) {
  return std::make_shared<Judge>(Judge{CartesianSolver(compilation.model, compilation.topology, method, stabilisation),
                                       GenericSolver(compilation.model, compilation.topology, compilation.analysis)});
}

long long time_accelerations(const CartesianSolver& solver, const std::vector<LoadedState>& at, int repetitions) {
  long long failures = 0;
  GenericDerivative derivative;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (const LoadedState& one : at) failures += solver.accelerations(one.state, one.tau, derivative).ok() ? 0 : 1;
  }
  return failures;
}

}  // namespace

Engine make_cartesian_engine(const Compilation& compilation, const EngineChoice& choice, CartesianMethod method) {
  const std::shared_ptr<Judge> judge = make_judge(compilation, method, choice.stabilisation);
  Engine engine;
  engine.name = choice.name;
  engine.form = "cartesian";
  engine.linear_algebra = "eigen";
  engine.accelerations = [judge](const LoadedState& at, GenericDerivative& derivative) {
    return judge->solver.accelerations(at.state, at.tau, derivative);
  };
  engine.project = [judge](GenericState& state) { return judge->solver.project(state); };
  engine.step = [judge](GenericState& state, double h) { return judge->solver.step(state, h); };
  if (!compilation.model.sampled.empty()) {
    engine.sample = [judge](GenericState& state, double h, bool& any) { return judge->observer.sample(state, h, any); };
  }
  engine.accelerations_in_motion = [judge](const GenericState& state, double, GenericDerivative& derivative) {
    return judge->solver.accelerations(state, std::vector<double>(state.z.size(), 0.0), derivative);
  };
  engine.multipliers = [judge](const LoadedState& at, const GenericDerivative&, std::vector<double>& lambda) {
    return judge->solver.multipliers(at.state, at.tau, lambda);
  };
  engine.driving_forces = [judge](const LoadedState& at, const GenericDerivative&, std::vector<double>& drive) {
    return judge->solver.driving_forces(at.state, at.tau, drive);
  };
  engine.outputs = [judge](const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
    values = judge->observer.outputs(at.state, at.tau, derivative);
    return judge->solver.motion_outputs(at.state, at.tau, values.y);
  };
  engine.reactions = [judge](const LoadedState& at, const GenericDerivative&,
                             std::vector<std::array<double, 6>>& wrenches) {
    return judge->solver.reactions(at.state, at.tau, wrenches);
  };
  engine.residuals = [judge](const GenericState& state, Residuals& largest) {
    return judge->solver.residuals(state, largest.position, largest.velocity);
  };
  engine.set_inputs = [judge](const std::vector<double>& inputs) {
    judge->solver.set_inputs(inputs);
    judge->observer.set_inputs(inputs);
  };
  engine.time_accelerations = [judge](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(judge->solver, at, repetitions);
  };
  return engine;
}

}  // namespace mbgen
