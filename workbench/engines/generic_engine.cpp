// The generic runtime as an engine, stepped by the integrators that generated code uses.

#include <algorithm>
#include <memory>
#include <numeric>

#include "compiler/model/inputs.hpp"
#include "mbgen/solver/rosenbrock.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/assignments.hpp"

namespace mbgen {
namespace {

/// The functions that integrators need of a system.
struct GenericSystem {
  using State = GenericState;
  using Derivative = GenericDerivative;
  using Tangents = GenericTangents;

  Status tangents(const GenericState& state, double g, GenericTangents& values) const noexcept {
    advance_inputs(state.t);
    return solver.tangents(state, g, values);
  }
  void solve(const GenericTangents& values, double g, const StateRates<GenericSystem>& rates,
             GenericDerivative& change) const noexcept {
    change = solver.changes(values, g, rates.zd, rates.derivative);
  }
  Status derivative(const GenericState& state, GenericDerivative& rates) const noexcept {
    advance_inputs(state.t);
    return solver.solve_motion(state, rates);
  }
  Status project(GenericState& state) const noexcept {
    advance_inputs(state.t);
    return solver.project_motion(state);
  }
  Status project_nearest(GenericState& state) const noexcept {
    advance_inputs(state.t);
    return solver.project_nearest(state);
  }
  Status project_crossing(GenericState& state, double& clearance) const noexcept {
    advance_inputs(state.t);
    return solver.project_crossing(state, clearance);
  }
  int changed_side(const GenericState& from, const GenericState& to) const noexcept {
    advance_inputs(start);
    return solver.changed_side(from, to);
  }
  Status watch_way(const GenericState& from, const GenericState& to, double h, const WayLimits& limits) const noexcept {
    advance_inputs(start);
    return solver.watch_way(from, to, h, limits);
  }
  Status sample(GenericState& state, double h, bool& any) const noexcept { return solver.sample(state, h, any); }
  bool leaves_charts(const GenericState& state) const noexcept { return mbgen::leaves_charts(balls, state); }
  bool settle_charts(GenericState& state) const noexcept { return mbgen::settle_charts(balls, state); }
  void change_charts(const GenericState& from, const GenericState& to, std::vector<double>& z, std::vector<double>& zd,
                     std::vector<double>& zdd) const noexcept {
    mbgen::change_charts(balls, from, to, z, zd, zdd);
  }
  void advance_inputs(double t) const {
    if (inputs_have_derivatives(model_inputs)) solver.set_inputs(advanced_inputs(model_inputs, inputs, t - start));
  }

  mutable GenericSolver solver;  // for its inputs, which advance during a step
  std::vector<Input> model_inputs;
  std::vector<Ball> balls;
  std::vector<double> inputs;  // at the start of the step
  double start = 0;            // s, of the step
  AbmHistory<GenericSystem> history{};
};

Status step(GenericSystem& system, SolverSettings::Integrator integrator, GenericState& state, double h) {
  system.start = state.t;
  using Integrator = SolverSettings::Integrator;
  const Status status = integrator == Integrator::rk4    ? step_rk4(system, state, h)
                        : integrator == Integrator::abm4 ? step_abm4(system, state, system.history, h)
                                                         : step_rosenbrock(system, state, h);
  system.advance_inputs(system.start);
  return status;
}

Status accelerations_in_motion(GenericSystem& system, const GenericState& state, double h,
                               GenericDerivative& derivative) {
  system.start = state.t;
  const Status status = rates_in_motion(system, state, h, derivative);
  system.advance_inputs(system.start);
  return without_notice(status);
}

void set_inputs(GenericSystem& system, const std::vector<double>& inputs) {
  system.inputs = inputs;
  system.solver.set_inputs(inputs);
  system.history = {};
}

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

std::string name_of(const GenericAlgebra& algebra) {
  if (algebra.factorisation == Factorisation::qr) return "eigen qr";
  switch (algebra.library) {
    case LinearAlgebra::entries:
      return "entries";
    case LinearAlgebra::eigen:
      return "eigen";
    case LinearAlgebra::blas:
      return "blas";
    case LinearAlgebra::sparse:
      return "sparse";
  }
  return {};
}

std::array<double, kSteps> step_shares(const GenericSolver& solver, const std::vector<LoadedState>& at,
                                       int repetitions) {
  StepClock clock;
  GenericDerivative derivative;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (const LoadedState& one : at) solver.accelerations(one.state, one.tau, derivative, &clock);
  }
  const double whole = static_cast<double>(std::accumulate(std::begin(clock.ticks), std::end(clock.ticks), 0LL));
  std::array<double, kSteps> shares{};
  if (whole <= 0) return shares;
  std::transform(std::begin(clock.ticks), std::end(clock.ticks), shares.begin(),
                 [&](long long ticks) { return static_cast<double>(ticks) / whole; });
  return shares;
}

}  // namespace

Engine make_generic_engine(const Compilation& compilation, const EngineChoice& choice) {
  const auto system = std::make_shared<GenericSystem>(
      GenericSystem{GenericSolver(compilation.model, compilation.topology, compilation.analysis, choice.algebra),
                    compilation.model.inputs, compilation.topology.balls, input_values(compilation.model, {})});
  Engine engine;
  engine.name = choice.name;
  engine.balls = compilation.topology.balls;
  engine.form = "matrix";
  engine.linear_algebra = name_of(choice.algebra);
  engine.accelerations = [system](const LoadedState& at, GenericDerivative& derivative) {
    return system->solver.accelerations(at.state, at.tau, derivative);
  };
  engine.project = [system](GenericState& state) { return system->solver.project(state); };
  engine.step = [system, integrator = choice.integrator](GenericState& state, double h) {
    return step(*system, integrator, state, h);
  };
  engine.accelerations_in_motion = [system](const GenericState& state, double h, GenericDerivative& derivative) {
    return accelerations_in_motion(*system, state, h, derivative);
  };
  if (!compilation.model.sampled.empty()) {
    engine.sample = [system](GenericState& state, double h, bool& any) { return system->solver.sample(state, h, any); };
  }
  engine.multipliers = [system](const LoadedState& at, const GenericDerivative& derivative,
                                std::vector<double>& lambda) {
    lambda = system->solver.multipliers(at.state, at.tau, derivative);
    return Status{};
  };
  engine.driving_forces = [system](const LoadedState& at, const GenericDerivative& derivative,
                                   std::vector<double>& drive) {
    drive = system->solver.driving_forces(at.state, at.tau, derivative);
    return Status{};
  };
  engine.outputs = [system](const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
    values = system->solver.outputs(at.state, at.tau, derivative);
    return Status{};
  };
  if (has_inverse_dynamics(compilation.model, compilation.topology, compilation.analysis))
    engine.inverse_dynamics = [system](const LoadedState& at, GenericDerivative& derivative,
                                       std::vector<double>& force) {
      return system->solver.inverse_dynamics(at.state, at.tau, derivative, force);
    };
  engine.residuals = [system](const GenericState& state, Residuals& largest) {
    largest = {largest_absolute(system->solver.position_residuals(state)),
               largest_absolute(system->solver.velocity_residuals(state))};
    return Status{};
  };
  engine.set_inputs = [system](const std::vector<double>& inputs) { set_inputs(*system, inputs); };
  engine.time_accelerations = [system](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(system->solver, at, repetitions);
  };
  engine.step_shares = [system](const std::vector<LoadedState>& at, int repetitions) {
    return step_shares(system->solver, at, repetitions);
  };
  return engine;
}

}  // namespace mbgen
