// The specialised solver behind the table of mbgen/driver.hpp.

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "mbgen/solver/regular.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

/// A loaded solver with its parameters and the memory that its calls work on.
struct LoadedSolver {
  std::shared_ptr<const SolverTable> table;
  std::function<std::shared_ptr<const SolverTable>()> whole;  ///< loads the one for all positions
  double loading_seconds = 0;
  std::vector<double> parameters, inputs;
  std::vector<double> state, derivative;
  std::vector<double> history;  ///< of the multistep method, in doubles for their alignment
};

/// The status of a call of the table's functions. Where the solver is one of regular positions alone and fails for
/// that, the whole one takes its place: sizes and memory are the same.
template <class Call>
Status called(LoadedSolver& solver, const Call& call) {
  const Status status = call(*solver.table);
  if (status.code != kNotRegular) return status;
  const auto before = std::chrono::steady_clock::now();
  solver.table = solver.whole();
  solver.loading_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  return call(*solver.table);
}

void flatten(const GenericState& state, std::vector<double>& flat) {
  double* place = flat.data();
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x}) {
    place = std::copy(part->begin(), part->end(), place);
  }
  *place++ = state.t;
  std::fill(std::copy(state.charts.begin(), state.charts.end(), place), flat.data() + flat.size(), 0.0);
}

void flatten(const GenericDerivative& derivative, std::vector<double>& flat) {
  std::copy(derivative.xd.begin(), derivative.xd.end(),
            std::copy(derivative.zdd.begin(), derivative.zdd.end(), flat.begin()));
}

void unflatten(const std::vector<double>& flat, GenericState& state) {
  const double* place = flat.data();
  for (std::vector<double>* part : {&state.z, &state.zd, &state.x}) {
    std::copy_n(place, part->size(), part->begin());
    place += part->size();
  }
  state.t = *place++;
  state.charts.assign(place, flat.data() + flat.size());
}

void unflatten(const LoadedSolver& solver, GenericDerivative& derivative) {
  const auto middle = solver.derivative.begin() + solver.table->coordinates;
  derivative.zdd.assign(solver.derivative.begin(), middle);
  derivative.xd.assign(middle, solver.derivative.end());
}

Status accelerations(LoadedSolver& solver, const LoadedState& at, GenericDerivative& derivative) {
  flatten(at.state, solver.state);
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.accelerations(solver.parameters.data(), solver.inputs.data(), solver.state.data(), at.tau.data(),
                               solver.derivative.data());
  });
  if (status.ok()) unflatten(solver, derivative);
  return status;
}

void flatten(const std::vector<LoadedState>& at, LoadedSolver& solver, std::vector<double>& states,
             std::vector<double>& taus) {
  for (const LoadedState& one : at) {
    flatten(one.state, solver.state);
    states.insert(states.end(), solver.state.begin(), solver.state.end());
    taus.insert(taus.end(), one.tau.begin(), one.tau.end());
  }
}

/// The same as one lane of a batch whose other lanes are the same state.
Status accelerations_in_lanes(LoadedSolver& solver, const LoadedState& at, GenericDerivative& derivative) {
  const SolverTable& table = *solver.table;
  const auto lanes = static_cast<std::size_t>(table.lanes);
  std::vector<double> states, taus, derivatives(lanes * solver.derivative.size());
  flatten(std::vector<LoadedState>(lanes, at), solver, states, taus);
  std::vector<Status> statuses(lanes);
  table.batch_accelerations(solver.parameters.data(), solver.inputs.data(), states.data(), taus.data(),
                            derivatives.data(), statuses.data());
  if (!statuses.back().ok()) return statuses.back();
  std::copy(derivatives.end() - static_cast<std::ptrdiff_t>(solver.derivative.size()), derivatives.end(),
            solver.derivative.begin());
  unflatten(solver, derivative);
  return statuses.back();
}

Status accelerations_in_motion(LoadedSolver& solver, const GenericState& state, double h,
                               GenericDerivative& derivative) {
  flatten(state, solver.state);
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.accelerations_in_motion(solver.parameters.data(), solver.inputs.data(), solver.state.data(), h,
                                         solver.derivative.data());
  });
  if (status.ok()) unflatten(solver, derivative);
  return status;
}

Status project(LoadedSolver& solver, GenericState& state) {
  flatten(state, solver.state);
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.project(solver.parameters.data(), solver.inputs.data(), solver.state.data());
  });
  if (status.ok()) unflatten(solver.state, state);
  return status;
}

Status step(LoadedSolver& solver, SolverSettings::Integrator integrator, GenericState& state, double h) {
  flatten(state, solver.state);
  using Integrator = SolverSettings::Integrator;
  const Status status = called(solver, [&](const SolverTable& table) {
    const auto one_step = integrator == Integrator::rk4 ? table.step_rk4 : table.step_rosenbrock;
    return integrator == Integrator::abm4
               ? table.step_abm4(solver.parameters.data(), solver.inputs.data(), solver.state.data(),
                                 solver.history.data(), h)
               : one_step(solver.parameters.data(), solver.inputs.data(), solver.state.data(), h);
  });
  if (status.ok()) unflatten(solver.state, state);
  return status;
}

Status sample(LoadedSolver& solver, GenericState& state, double h, bool& any) {
  flatten(state, solver.state);
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.sample(solver.parameters.data(), solver.inputs.data(), solver.state.data(), h, &any);
  });
  if (status.ok()) unflatten(solver.state, state);
  return status;
}

Status constraint_forces(LoadedSolver& solver, const LoadedState& at, const GenericDerivative& derivative,
                         std::vector<double>& lambda, std::vector<double>& drive) {
  flatten(at.state, solver.state);
  flatten(derivative, solver.derivative);
  drive.resize(static_cast<std::size_t>(solver.table->drives));
  lambda.resize(static_cast<std::size_t>(solver.table->multipliers));
  return called(solver, [&](const SolverTable& table) {
    return table.multiplier_values(solver.parameters.data(), solver.inputs.data(), solver.state.data(), at.tau.data(),
                                   solver.derivative.data(), lambda.data(), drive.data());
  });
}

Status outputs(LoadedSolver& solver, const LoadedState& at, const GenericDerivative& derivative,
               GenericOutputs& values) {
  flatten(at.state, solver.state);
  flatten(derivative, solver.derivative);
  double energy[3] = {};
  values.y.resize(static_cast<std::size_t>(solver.table->outputs));
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.output_values(solver.parameters.data(), solver.inputs.data(), solver.state.data(), at.tau.data(),
                               solver.derivative.data(), values.y.data(), energy);
  });
  values.kinetic_energy = energy[0];
  values.potential_energy = energy[1];
  values.applied_power = energy[2];
  return status;
}

Status actuator_forces(LoadedSolver& solver, const LoadedState& at, GenericDerivative& derivative,
                       std::vector<double>& force) {
  flatten(at.state, solver.state);
  flatten(derivative, solver.derivative);
  std::vector<double> values(static_cast<std::size_t>(solver.table->actuators));
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.actuator_forces(solver.parameters.data(), solver.inputs.data(), solver.state.data(), at.tau.data(),
                                 solver.derivative.data(), values.data());
  });
  if (!status.ok()) return status;
  unflatten(solver, derivative);
  force = std::move(values);
  return status;
}

/// The same as one lane of a batch whose other lanes are the same state.
Status actuator_forces_in_lanes(LoadedSolver& solver, const LoadedState& at, GenericDerivative& derivative,
                                std::vector<double>& force) {
  const SolverTable& table = *solver.table;
  const auto lanes = static_cast<std::size_t>(table.lanes), actuators = static_cast<std::size_t>(table.actuators);
  std::vector<double> states, taus, derivatives, values(lanes * actuators);
  flatten(std::vector<LoadedState>(lanes, at), solver, states, taus);
  flatten(derivative, solver.derivative);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    derivatives.insert(derivatives.end(), solver.derivative.begin(), solver.derivative.end());
  std::vector<Status> statuses(lanes);
  table.batch_actuator_forces(solver.parameters.data(), solver.inputs.data(), states.data(), taus.data(),
                              derivatives.data(), values.data(), statuses.data());
  if (!statuses.back().ok()) return statuses.back();
  std::copy(derivatives.end() - static_cast<std::ptrdiff_t>(solver.derivative.size()), derivatives.end(),
            solver.derivative.begin());
  unflatten(solver, derivative);
  force.assign(values.end() - static_cast<std::ptrdiff_t>(actuators), values.end());
  return statuses.back();
}

Status residuals(LoadedSolver& solver, const GenericState& state, Residuals& largest) {
  flatten(state, solver.state);
  std::vector<double> position(static_cast<std::size_t>(solver.table->closure_equations));
  std::vector<double> velocity(position.size());
  const Status status = called(solver, [&](const SolverTable& table) {
    return table.residuals(solver.parameters.data(), solver.inputs.data(), solver.state.data(), position.data(),
                           velocity.data());
  });
  if (status.ok()) largest = {largest_absolute(position), largest_absolute(velocity)};
  return status;
}

/// State after state, tau after tau.
long long time_accelerations(LoadedSolver& solver, const std::vector<LoadedState>& at, int repetitions) {
  std::vector<double> states, taus;
  flatten(at, solver, states, taus);
  const auto time = solver.table->lanes > 0 ? solver.table->time_batch_accelerations : solver.table->time_accelerations;
  return time(solver.parameters.data(), solver.inputs.data(), states.data(), taus.data(), static_cast<int>(at.size()),
              repetitions);
}

std::array<double, kSteps> step_shares(LoadedSolver& solver, const std::vector<LoadedState>& at, int repetitions) {
  std::vector<double> states, taus;
  flatten(at, solver, states, taus);
  long long ticks[kSteps] = {};
  solver.table->step_ticks(solver.parameters.data(), solver.inputs.data(), states.data(), taus.data(),
                           static_cast<int>(at.size()), repetitions, ticks);
  const double total = static_cast<double>(std::accumulate(std::begin(ticks), std::end(ticks), 0LL));
  std::array<double, kSteps> shares{};
  for (int s = 0; s < kSteps; ++s) shares[s] = total > 0 ? static_cast<double>(ticks[s]) / total : 0.0;
  return shares;
}

/// The memory of one engine, parameters and inputs at the model's values.
std::shared_ptr<LoadedSolver> prepared(std::shared_ptr<const SolverTable> shared, const Compilation& compilation,
                                       const EngineChoice& choice) {
  const Model& model = compilation.model;
  auto solver = std::make_shared<LoadedSolver>();
  solver->table = std::move(shared);
  if (solver->table->regular_only)
    solver->whole = [decided = std::make_shared<const Compilation>(compilation), choice] {
      return load_solver(*decided, choice);
    };
  const SolverTable& table = *solver->table;
  for (const Parameter& parameter : model.parameters) {
    if (parameter.tunable) solver->parameters.push_back(parameter.value);
  }
  for (const Input& input : model.inputs) solver->inputs.push_back(input.default_value);
  solver->state.resize(static_cast<std::size_t>(table.state_size));
  solver->derivative.resize(static_cast<std::size_t>(table.derivative_size));
  solver->history.resize(static_cast<std::size_t>(table.history_bytes) / sizeof(double) + 1);
  table.start_abm4(solver->history.data());
  return solver;
}

}  // namespace

Engine make_generated_engine(const Compilation& compilation, const EngineChoice& choice) {
  return make_generated_engine(load_regular_solver(compilation, choice), compilation, choice);
}

Engine make_generated_engine(const std::shared_ptr<const SolverTable>& table, const Compilation& compilation,
                             const EngineChoice& choice) {
  const std::shared_ptr<LoadedSolver> solver = prepared(table, compilation, choice);
  Engine engine;
  engine.name = choice.name;
  engine.balls = compilation.topology.balls;
  engine.form = name_of(written_form(compilation, choice.form));
  engine.batch = std::max(choice.lanes, 1);
  const auto evaluate = choice.lanes > 0 ? accelerations_in_lanes : accelerations;
  engine.accelerations = [solver, evaluate](const LoadedState& at, GenericDerivative& derivative) {
    return evaluate(*solver, at, derivative);
  };
  engine.project = [solver](GenericState& state) { return project(*solver, state); };
  engine.step = [solver, integrator = choice.integrator](GenericState& state, double h) {
    return step(*solver, integrator, state, h);
  };
  engine.accelerations_in_motion = [solver](const GenericState& state, double h, GenericDerivative& derivative) {
    return accelerations_in_motion(*solver, state, h, derivative);
  };
  if (table->sample != nullptr) {
    engine.sample = [solver](GenericState& state, double h, bool& any) { return sample(*solver, state, h, any); };
  }
  engine.multipliers = [solver](const LoadedState& at, const GenericDerivative& derivative,
                                std::vector<double>& lambda) {
    std::vector<double> drive;
    return constraint_forces(*solver, at, derivative, lambda, drive);
  };
  engine.driving_forces = [solver](const LoadedState& at, const GenericDerivative& derivative,
                                   std::vector<double>& drive) {
    std::vector<double> lambda;
    return constraint_forces(*solver, at, derivative, lambda, drive);
  };
  engine.outputs = [solver](const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
    return outputs(*solver, at, derivative, values);
  };
  if (table->actuators > 0)
    engine.inverse_dynamics = [solver, find = choice.lanes > 0 ? actuator_forces_in_lanes : actuator_forces](
                                  const LoadedState& at, GenericDerivative& derivative, std::vector<double>& force) {
      return find(*solver, at, derivative, force);
    };
  engine.residuals = [solver](const GenericState& state, Residuals& largest) {
    return residuals(*solver, state, largest);
  };
  engine.set_inputs = [solver](const std::vector<double>& inputs) {
    solver->inputs = inputs;
    solver->table->start_abm4(solver->history.data());
  };
  engine.loading_seconds = [solver] { return solver->loading_seconds; };
  engine.time_accelerations = [solver](const std::vector<LoadedState>& at, int repetitions) {
    return time_accelerations(*solver, at, repetitions);
  };
  if (solver->table->step_ticks != nullptr) {
    engine.step_shares = [solver](const std::vector<LoadedState>& at, int repetitions) {
      return step_shares(*solver, at, repetitions);
    };
  }
  return engine;
}

}  // namespace mbgen
