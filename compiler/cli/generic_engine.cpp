// The generic runtime as an engine, stepped by the integrators that generated code uses.

#include <memory>

#include "compiler/cli/engine.hpp"
#include "mbgen/integrators.hpp"

namespace mbgen::cli {
namespace {

/// What the integrators ask of a system.
struct GenericSystem {
  using State = GenericState;
  using Derivative = GenericDerivative;

  Status derivative(const GenericState& state, GenericDerivative& rates) const noexcept {
    return solver.accelerations(state, no_tau, rates);
  }
  Status project(GenericState& state) const noexcept { return solver.project(state); }

  GenericSolver solver;
  std::vector<double> no_tau;
  AbmHistory<GenericSystem> history{};
};

long long time_accelerations(const GenericSolver& solver, const std::vector<LoadedState>& at, int repetitions) {
  long long failures = 0;
  GenericDerivative derivative;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (const LoadedState& one : at) {
      failures += solver.accelerations(one.state, one.tau, derivative).ok() ? 0 : 1;
    }
  }
  return failures;
}

}  // namespace

Engine make_generic_engine(const Compilation& compilation, const EngineChoice& choice) {
  const std::vector<double> no_tau(static_cast<std::size_t>(compilation.topology.size()), 0.0);
  const auto system = std::make_shared<GenericSystem>(
      GenericSystem{GenericSolver(compilation.model, compilation.topology, compilation.analysis), no_tau, {}});
  Engine engine;
  engine.name = choice.name;
  engine.form = "matrix";
  engine.linear_algebra = "eigen";
  engine.accelerations = [system](const LoadedState& at, GenericDerivative& derivative) {
    return system->solver.accelerations(at.state, at.tau, derivative);
  };
  engine.project = [system](GenericState& state) { return system->solver.project(state); };
  engine.step = [system, integrator = choice.integrator](GenericState& state, double h) {
    return integrator == SolverSettings::Integrator::rk4 ? step_rk4(*system, state, h)
                                                         : step_abm4(*system, state, system->history, h);
  };
  engine.multipliers = [system](const LoadedState& at, const GenericDerivative& derivative,
                                std::vector<double>& lambda) {
    lambda = system->solver.multipliers(at.state, at.tau, derivative);
    return Status{};
  };
  engine.outputs = [system](const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
    values = system->solver.outputs(at.state, at.tau, derivative);
    return Status{};
  };
  engine.residuals = [system](const GenericState& state, Residuals& largest) {
    largest = {largest_absolute(system->solver.position_residuals(state)),
               largest_absolute(system->solver.velocity_residuals(state))};
    return Status{};
  };
  engine.set_inputs = [system](const std::vector<double>& inputs) { system->solver.set_inputs(inputs); };
  engine.time_accelerations = [system](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(system->solver, at, repetitions);
  };
  return engine;
}

}  // namespace mbgen::cli
