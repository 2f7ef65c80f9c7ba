#include "workbench/sensitivity/tangent_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbgen {
namespace {

using Memory = TangentEngine::Memory;
using Numbers = std::vector<TangentNumber>;

/// Sets the values from `place` on and keeps the derivatives.
void set_values(const std::vector<double>& values, Numbers& numbers, std::size_t& place) {
  for (const double value : values) numbers[place++].value = value;
}

/// Whether the values from `place` on are these.
bool has_values(const std::vector<double>& values, const Numbers& numbers, std::size_t& place) {
  const bool are_same = std::equal(values.begin(), values.end(), numbers.begin() + static_cast<std::ptrdiff_t>(place),
                                   [](double value, const TangentNumber& number) { return value == number.value; });
  place += values.size();
  return are_same;
}

/// Charts of a state, one for each of `count` balls.
std::vector<double> charts_of(const GenericState& state, std::size_t count) {
  std::vector<double> charts = state.charts;
  charts.resize(count);
  return charts;
}

void set_state(const GenericState& state, Numbers& numbers) {
  std::size_t place = 0;
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x}) set_values(*part, numbers, place);
  numbers[place++].value = state.t;
  set_values(charts_of(state, numbers.size() - place), numbers, place);
}

/// Whether numbers are those of this state, but for the time, which a caller keeps as a multiple of its step.
bool has_state(const GenericState& state, const Numbers& numbers) {
  std::size_t place = 0;
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x})
    if (!has_values(*part, numbers, place)) return false;
  ++place;
  return has_values(charts_of(state, numbers.size() - place), numbers, place);
}

void set_all(const std::vector<double>& values, Numbers& numbers) {
  std::size_t place = 0;
  set_values(values, numbers, place);
}

/// Copies the values from `place` on.
void take_values(const Numbers& numbers, std::size_t& place, std::vector<double>& values) {
  for (double& value : values) value = numbers[place++].value;
}

void take_all(const Numbers& numbers, std::vector<double>& values) {
  std::size_t place = 0;
  take_values(numbers, place, values);
}

void set_rates(const GenericDerivative& derivative, Numbers& numbers) {
  std::size_t place = 0;
  for (const std::vector<double>* part : {&derivative.zdd, &derivative.xd}) set_values(*part, numbers, place);
}

void take_state(const Numbers& numbers, GenericState& state) {
  std::size_t place = 0;
  for (std::vector<double>* part : {&state.z, &state.zd, &state.x}) take_values(numbers, place, *part);
  state.t = numbers[place++].value;
  state.charts.resize(numbers.size() - place);
  take_values(numbers, place, state.charts);
}

void forget_derivatives(Numbers& numbers) {
  for (TangentNumber& number : numbers)
    for (int k = 0; k < kDirections; ++k) number.tangent[k] = std::numeric_limits<double>::quiet_NaN();
}

/// Puts the numbers of this state into `scratch`: those of the motion, or without derivatives beside it. Result:
/// whether they are of the motion.
bool find_state(const GenericState& state, TangentPass& pass) {
  const bool is_after = has_state(state, pass.after), is_of_motion = is_after || has_state(state, pass.before);
  if (is_of_motion) {
    pass.scratch = is_after ? pass.after : pass.before;
  } else {
    pass.scratch.assign(pass.scratch.size(), 0.0);
  }
  set_state(state, pass.scratch);
  return is_of_motion;
}

/// Keeps what a step or projection left in `scratch`; a state beside the motion is forgotten.
void keep_state(bool is_of_motion, TangentPass& pass) {
  if (!is_of_motion) return;
  pass.before.swap(pass.after);
  pass.after = pass.scratch;
}

/// Calls of(pass) for every pass. Result: the first status that is not ok, of the first pass otherwise.
template <class Of>
Status each_pass(Memory& memory, const Of& of) {
  Status first;
  for (std::size_t p = 0; p < memory.passes.size(); ++p) {
    const Status status = of(memory.passes[p]);
    if (!status.ok()) return status;
    if (p == 0) first = status;
  }
  return first;
}

/// Moves the state by move(pass), which works on `scratch`. The first pass decides on the values.
template <class Move>
Status moved(Memory& memory, GenericState& state, const Move& move) {
  std::vector<bool> of_motion;
  const Status status = each_pass(memory, [&](TangentPass& pass) {
    of_motion.push_back(find_state(state, pass));
    return move(pass);
  });
  if (!status.ok()) return status;
  take_state(memory.passes[0].scratch, state);
  for (std::size_t p = 0; p < memory.passes.size(); ++p) {
    set_state(state, memory.passes[p].scratch);
    keep_state(of_motion[p], memory.passes[p]);
  }
  return status;
}

Status step(Memory& memory, SolverSettings::Integrator integrator, GenericState& state, double h) {
  const TangentTable& table = *memory.table;
  using Integrator = SolverSettings::Integrator;
  const auto one_step = integrator == Integrator::rk4 ? table.step_rk4 : table.step_rosenbrock;
  return moved(memory, state, [&](TangentPass& pass) {
    return integrator == Integrator::abm4
               ? table.step_abm4(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(), pass.history.data(),
                                 h)
               : one_step(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(), h);
  });
}

/// Accelerations by find(pass), with their derivatives where the state is of the motion.
template <class Find>
Status rates(Memory& memory, const GenericState& state, GenericDerivative& derivative, const Find& find) {
  const Status status = each_pass(memory, [&](TangentPass& pass) {
    const bool is_of_motion = find_state(state, pass);
    const Status found = find(pass);
    if (found.ok() && !is_of_motion) forget_derivatives(pass.derivative);
    return found;
  });
  if (!status.ok()) return status;
  std::size_t place = 0;
  derivative.zdd.resize(static_cast<std::size_t>(memory.table->coordinates));
  derivative.xd.resize(static_cast<std::size_t>(memory.table->auxiliary_states));
  for (std::vector<double>* part : {&derivative.zdd, &derivative.xd})
    take_values(memory.passes[0].derivative, place, *part);
  return status;
}

Status outputs(Memory& memory, const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
  TangentNumber energy[3];
  const Status status = each_pass(memory, [&](TangentPass& pass) {
    const bool is_of_motion = find_state(at.state, pass);
    std::size_t place = 0;
    const bool are_last =
        has_values(derivative.zdd, pass.derivative, place) && has_values(derivative.xd, pass.derivative, place);
    set_rates(derivative, pass.derivative);
    set_all(at.tau, pass.tau);
    const Status found = memory.table->output_values(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(),
                                                     pass.tau.data(), pass.derivative.data(), pass.y.data(), energy);
    if (found.ok() && !(is_of_motion && are_last)) forget_derivatives(pass.y);
    return found;
  });
  if (!status.ok()) return status;
  values.y.resize(static_cast<std::size_t>(memory.table->outputs));
  take_all(memory.passes[0].y, values.y);
  values.kinetic_energy = energy[0].value;
  values.potential_energy = energy[1].value;
  values.applied_power = energy[2].value;
  return status;
}

/// Multipliers and driving forces, without derivatives.
Status constraint_forces(Memory& memory, const LoadedState& at, const GenericDerivative& derivative,
                         std::vector<double>& lambda, std::vector<double>& drive) {
  TangentPass& pass = memory.passes[0];
  find_state(at.state, pass);
  Numbers rates = pass.derivative;
  set_rates(derivative, rates);
  set_all(at.tau, pass.tau);
  Numbers of_equations(static_cast<std::size_t>(memory.table->multipliers) + 1);
  Numbers of_drives(static_cast<std::size_t>(memory.table->drives) + 1);
  const Status status =
      memory.table->multiplier_values(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(), pass.tau.data(),
                                      rates.data(), of_equations.data(), of_drives.data());
  if (!status.ok()) return status;
  lambda.resize(of_equations.size() - 1);
  drive.resize(of_drives.size() - 1);
  take_all(of_equations, lambda);
  take_all(of_drives, drive);
  return status;
}

Status residuals(Memory& memory, const GenericState& state, Residuals& largest) {
  TangentPass& pass = memory.passes[0];
  find_state(state, pass);
  const auto equations = static_cast<std::size_t>(memory.table->closure_equations);
  Numbers position(equations + 1), velocity(equations + 1);
  const Status status = memory.table->residuals(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(),
                                                position.data(), velocity.data());
  if (!status.ok()) return status;
  std::vector<double> positions(equations), velocities(equations);
  take_all(position, positions);
  take_all(velocity, velocities);
  largest = {largest_absolute(positions), largest_absolute(velocities)};
  return status;
}

/// The numbers of one pass, with derivatives of 1 for its parameters from `first` on.
TangentPass prepared(const TangentTable& table, const Model& model, const std::vector<int>& parameters,
                     std::size_t first) {
  TangentPass pass;
  for (const Parameter& parameter : model.parameters)
    if (parameter.tunable) pass.parameters.emplace_back(parameter.value);
  for (std::size_t k = first; k < parameters.size() && k < first + kDirections; ++k)
    pass.parameters[static_cast<std::size_t>(parameters[k])].tangent[k - first] = 1;
  for (const Input& input : model.inputs) pass.inputs.emplace_back(input.default_value);
  pass.before.assign(static_cast<std::size_t>(table.state_size), 0.0);
  pass.after = pass.scratch = pass.before;
  pass.derivative.assign(static_cast<std::size_t>(table.derivative_size), 0.0);
  pass.tau.assign(static_cast<std::size_t>(table.coordinates), 0.0);
  pass.y.assign(static_cast<std::size_t>(table.outputs), 0.0);
  pass.history.resize(static_cast<std::size_t>(table.history_bytes) / sizeof(TangentNumber) + 1);
  table.start_abm4(pass.history.data());
  return pass;
}

/// Places of parameters among the tunable ones.
std::vector<int> tunable_places(const Model& model, const std::vector<std::string>& names) {
  std::vector<int> places;
  const std::vector<Parameter> tunable = tunable_parameters(model);
  for (const std::string& name : names)
    places.push_back(static_cast<int>(std::ranges::find(tunable, name, &Parameter::name) - tunable.begin()));
  return places;
}

/// The functions that move states or ask for rates.
void add_motion(const std::shared_ptr<Memory>& memory, SolverSettings::Integrator integrator, Engine& engine) {
  engine.accelerations = [memory](const LoadedState& at, GenericDerivative& derivative) {
    return rates(*memory, at.state, derivative, [&](TangentPass& pass) {
      set_all(at.tau, pass.tau);
      return memory->table->accelerations(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(),
                                          pass.tau.data(), pass.derivative.data());
    });
  };
  engine.accelerations_in_motion = [memory](const GenericState& state, double h, GenericDerivative& derivative) {
    return rates(*memory, state, derivative, [&](TangentPass& pass) {
      return memory->table->accelerations_in_motion(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(), h,
                                                    pass.derivative.data());
    });
  };
  engine.project = [memory](GenericState& state) {
    return moved(*memory, state, [&](TangentPass& pass) {
      return memory->table->project(pass.parameters.data(), pass.inputs.data(), pass.scratch.data());
    });
  };
  engine.step = [memory, integrator](GenericState& state, double h) { return step(*memory, integrator, state, h); };
  if (memory->table->sample != nullptr) {
    engine.sample = [memory](GenericState& state, double h, bool& any) {
      return moved(*memory, state, [&](TangentPass& pass) {
        return memory->table->sample(pass.parameters.data(), pass.inputs.data(), pass.scratch.data(), h, &any);
      });
    };
  }
}

/// The functions of one state.
void add_results(const std::shared_ptr<Memory>& memory, Engine& engine) {
  engine.outputs = [memory](const LoadedState& at, const GenericDerivative& derivative, GenericOutputs& values) {
    return outputs(*memory, at, derivative, values);
  };
  engine.multipliers = [memory](const LoadedState& at, const GenericDerivative& derivative,
                                std::vector<double>& lambda) {
    std::vector<double> drive;
    return constraint_forces(*memory, at, derivative, lambda, drive);
  };
  engine.driving_forces = [memory](const LoadedState& at, const GenericDerivative& derivative,
                                   std::vector<double>& drive) {
    std::vector<double> lambda;
    return constraint_forces(*memory, at, derivative, lambda, drive);
  };
  engine.residuals = [memory](const GenericState& state, Residuals& largest) {
    return residuals(*memory, state, largest);
  };
  engine.set_inputs = [memory](const std::vector<double>& inputs) {
    for (TangentPass& pass : memory->passes) {
      set_all(inputs, pass.inputs);
      memory->table->start_abm4(pass.history.data());
    }
  };
}

}  // namespace

TangentEngine make_tangent_engine(const Compilation& compilation, const EngineChoice& choice,
                                  const std::vector<std::string>& names) {
  return make_tangent_engine(load_tangents(compilation, choice), compilation, choice, names);
}

TangentEngine make_tangent_engine(const std::shared_ptr<const TangentTable>& table, const Compilation& compilation,
                                  const EngineChoice& choice, const std::vector<std::string>& names) {
  const std::vector<int> parameters = tunable_places(compilation.model, names);
  const auto memory = std::make_shared<Memory>();
  memory->table = table;
  memory->parameters = static_cast<int>(parameters.size());
  for (std::size_t first = 0; first == 0 || first < parameters.size(); first += kDirections)
    memory->passes.push_back(prepared(*memory->table, compilation.model, parameters, first));
  TangentEngine result{memory, {}};
  Engine& engine = result.engine;
  engine.name = "generated";
  engine.follows_motion = true;
  engine.form = name_of(written_form(compilation, choice.form));
  engine.balls = compilation.topology.balls;
  add_motion(memory, choice.integrator, engine);
  add_results(memory, engine);
  return result;
}

TangentEngine make_moving_engine(const LoadedTables& tables, const Compilation& compilation, const EngineChoice& choice,
                                 const std::vector<std::string>& parameters) {
  if (tables.tangents) return make_tangent_engine(tables.tangents, compilation, choice, parameters);
  return {nullptr,
          tables.plain ? make_generated_engine(tables.plain, compilation, choice) : make_engine(compilation, choice)};
}

std::vector<double> output_derivatives(const TangentEngine& engine) {
  if (!engine.memory) return {};
  const Memory& memory = *engine.memory;
  std::vector<double> derivatives;
  for (int output = 0; output < memory.table->outputs; ++output)
    for (int k = 0; k < memory.parameters; ++k)
      derivatives.push_back(memory.passes[static_cast<std::size_t>(k / kDirections)]
                                .y[static_cast<std::size_t>(output)]
                                .tangent[k % kDirections]);
  return derivatives;
}

std::vector<Heading> derivative_headings(const Model& model, const std::vector<std::string>& parameters) {
  std::vector<Heading> headings;
  for (const Output& output : model.outputs) {
    for (const std::string& name : parameters) {
      const Parameter& by = *std::ranges::find(model.parameters, name, &Parameter::name);
      const std::string of = output.unit.empty() ? "1" : output.unit;
      headings.push_back({fmt::format("d({})/d({})", output.name, name),
                          by.unit.empty() || by.unit == "1" ? of : fmt::format("{}/({})", of, by.unit)});
    }
  }
  return headings;
}

}  // namespace mbgen
