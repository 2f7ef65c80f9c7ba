// The Cartesian judges as engines. All that they give is their own: nothing of it comes from the recursive formulation.

#include <memory>

#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

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
  const auto judge =
      std::make_shared<CartesianSolver>(compilation.model, compilation.topology, method, choice.stabilisation);
  Engine engine;
  engine.name = choice.name;
  engine.form = "cartesian";
  engine.linear_algebra = "eigen";
  engine.accelerations = [judge](const LoadedState& at, GenericDerivative& derivative) {
    return judge->accelerations(at.state, at.tau, derivative);
  };
  engine.project = [judge](GenericState& state) { return judge->project(state); };
  engine.step = [judge](GenericState& state, double h) { return judge->step(state, h); };
  engine.set_friction_loads = [judge](GenericState& state) { return judge->set_friction_loads(state); };
  if (!compilation.model.sampled.empty()) {
    engine.sample = [judge](GenericState& state, double h, bool& any) { return judge->sample(state, h, any); };
  }
  engine.accelerations_in_motion = [judge](const GenericState& state, double, GenericDerivative& derivative) {
    return judge->accelerations(state, std::vector<double>(state.z.size(), 0.0), derivative);
  };
  engine.multipliers = [judge](const LoadedState& at, const GenericDerivative&, std::vector<double>& lambda) {
    return judge->multipliers(at.state, at.tau, lambda);
  };
  engine.driving_forces = [judge](const LoadedState& at, const GenericDerivative&, std::vector<double>& drive) {
    return judge->driving_forces(at.state, at.tau, drive);
  };
  engine.outputs = [judge](const LoadedState& at, const GenericDerivative&, GenericOutputs& values) {
    return judge->outputs(at.state, at.tau, values);
  };
  engine.reactions = [judge](const LoadedState& at, const GenericDerivative&,
                             std::vector<std::array<double, 6>>& wrenches) {
    return judge->reactions(at.state, at.tau, wrenches);
  };
  if (has_inverse_dynamics(compilation.model, compilation.topology, compilation.analysis))
    engine.inverse_dynamics = [judge, independent = free_coordinates(compilation.topology, compilation.analysis)](
                                  const LoadedState& at, GenericDerivative& derivative, std::vector<double>& force) {
      return judge->inverse_dynamics(at.state, at.tau, independent, derivative, force);
    };
  engine.residuals = [judge](const GenericState& state, Residuals& largest) {
    return judge->residuals(state, largest.position, largest.velocity);
  };
  engine.set_inputs = [judge](const std::vector<double>& inputs) { judge->set_inputs(inputs); };
  engine.time_accelerations = [judge](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(*judge, at, repetitions);
  };
  return engine;
}

}  // namespace mbgen
