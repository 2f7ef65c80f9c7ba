// The Cartesian judges as engines. All that they give is their own: nothing of it comes from the recursive formulation.

#include <algorithm>
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

/// The judge of inverse dynamics: without the motions that actuators give.
std::shared_ptr<CartesianSolver> without_actuated_motions(const Compilation& compilation, CartesianMethod method,
                                                          const std::shared_ptr<CartesianSolver>& judge) {
  if (std::ranges::none_of(compilation.model.motions, &Motion::is_actuated)) return judge;
  Model model = compilation.model;
  std::erase_if(model.motions, [](const Motion& motion) { return motion.is_actuated; });
  model.outputs.clear();
  return std::make_shared<CartesianSolver>(model, compilation.topology, method, Stabilisation::projection);
}

/// Coordinates of motions get the accelerations that the whole judge finds for them.
void add_inverse_dynamics(const Compilation& compilation, CartesianMethod method,
                          const std::shared_ptr<CartesianSolver>& judge, Engine& engine) {
  const auto freed = without_actuated_motions(compilation, method, judge);
  engine.set_inputs = [judge, freed](const std::vector<double>& inputs) {
    judge->set_inputs(inputs);
    freed->set_inputs(inputs);
  };
  if (!has_inverse_dynamics(compilation.model, compilation.topology, compilation.analysis)) return;
  engine.inverse_dynamics = [judge, freed, driven = compilation.analysis.driven,
                             moved = actuated_coordinates(compilation.topology, compilation.analysis)](
                                const LoadedState& at, GenericDerivative& derivative, std::vector<double>& force) {
    GenericDerivative wanted = derivative, forward;
    Status status = freed == judge ? Status{} : judge->accelerations(at.state, at.tau, forward);
    for (std::size_t i = 0; i < forward.zdd.size() && status.ok(); ++i)
      if (driven[i]) wanted.zdd[i] = forward.zdd[i];
    if (status.ok()) status = freed->inverse_dynamics(at.state, at.tau, moved, wanted, force);
    if (status.ok()) derivative = std::move(wanted);
    return status;
  };
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
  add_inverse_dynamics(compilation, method, judge, engine);
  engine.residuals = [judge](const GenericState& state, Residuals& largest) {
    return judge->residuals(state, largest.position, largest.velocity);
  };
  engine.time_accelerations = [judge](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(*judge, at, repetitions);
  };
  return engine;
}

}  // namespace mbgen
