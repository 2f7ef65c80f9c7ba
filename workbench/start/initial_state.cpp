#include "workbench/start/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/start/equilibrium_trouble.hpp"
#include "workbench/start/open_loops.hpp"
#include "workbench/start/turning_start.hpp"

namespace mbgen {
namespace {

/// A value counts as kept if the closures moved it by less than this (rad, m or per second, relative above 1).
constexpr double kKept = 1e-9;
/// Largest deviation of a motion from a value that the model gives with a few digits.
constexpr double kRounding = 1e-3;

/// Largest ratio of velocities to the largest requested one: no gear or lever multiplies by so much.
constexpr double kMostMultiplied = 1e6;

/// A requested value of a coordinate.
struct Target {
  int coordinate = -1;
  double value = 0;
  Where where;
  double weight = 1;
  bool locked = false;
};

std::vector<Target> targets_of(const Compilation& compilation, const std::vector<InitialValue>& values) {
  std::vector<Target> targets;
  for (const InitialValue& value : values) {
    const int coordinate = tree_coordinate(compilation.topology, value.coordinate);
    if (coordinate < 0) {
      throw UserError(
          Diagnostics{{value.where, "initial value of a joint that was cut", "mark it \"cut\": false", ""}});
    }
    targets.push_back({coordinate, value.value, value.where, value.weight, value.locked});
  }
  return targets;
}

bool keeps(const Target& target, const std::vector<double>& values, double tolerance) {
  return std::abs(values[target.coordinate] - target.value) <= tolerance * std::max(1.0, std::abs(target.value));
}

bool keeps_all(const std::vector<Target>& targets, const std::vector<double>& values) {
  return std::all_of(targets.begin(), targets.end(),
                     [&](const Target& target) { return keeps(target, values, kKept); });
}

void require(Status status, const Compilation& compilation, const char* action) {
  if (!status.ok()) {
    throw UserError(Diagnostics{{{compilation.model.file, 0, 0, ""},
                                 fmt::format("initial state: cannot {}: {}", action, describe(compilation, status)),
                                 "",
                                 ""}});
  }
}

/// A driven coordinate is at its motion. Fails: UserError if a request contradicts this.
void require_motions(const Compilation& compilation, const std::vector<Target>& targets,
                     const std::vector<double>& values, const char* what) {
  for (const Target& target : targets) {
    if (!compilation.analysis.driven[target.coordinate] || keeps(target, values, kRounding)) continue;
    throw UserError(Diagnostics{{target.where,
                                 fmt::format("initial {} of {} contradicts its motion, {} asked, the motion gives {}",
                                             what, compilation.topology.bodies[target.coordinate].coordinate,
                                             target.value, values[target.coordinate]),
                                 "remove it: a driven coordinate starts where its motion is", ""}});
  }
}

/// The requests in the solver's form.
std::vector<CoordinateTarget> of_solver(const std::vector<Target>& targets) {
  std::vector<CoordinateTarget> result;
  for (const Target& target : targets)
    result.push_back({target.coordinate, target.value, target.weight, target.locked});
  return result;
}

/// Closed positions nearest to the requests.
GenericState assemble(const Compilation& compilation, const GenericSolver& solver, const std::vector<Target>& targets,
                      bool only_a_guess) {
  GenericState simple = reference_state(compilation);
  for (const Target& target : targets) simple.z[target.coordinate] = target.value;
  if (solver.project(simple).ok() && (only_a_guess || keeps_all(targets, simple.z))) return simple;

  GenericState state = reference_state(compilation);
  const Status status = solver.assemble(state, of_solver(targets));
  if (status.code == Code::loop_not_closed) refuse_open_positions(compilation, solver, state);
  require(status, compilation, "move the joints to the asked positions");
  require(solver.project(state), compilation, "close the loops");
  require_motions(compilation, targets, state.z, "position");
  return state;
}

/// Consistent velocities nearest to the requests, at the positions of `state`.
void set_velocities(const Compilation& compilation, const GenericSolver& solver, const std::vector<Target>& targets,
                    GenericState& state) {
  GenericState simple = state;
  for (const Target& target : targets) simple.zd[target.coordinate] = target.value;
  require(solver.project(simple), compilation, "close the loops");
  if (!keeps_all(targets, simple.zd)) {
    const Status status = solver.assemble_velocities(simple, of_solver(targets));
    if (status.code == Code::loop_not_closed) refuse_open_velocities(compilation);
    require(status, compilation, "give the joints the asked velocities");
    require(solver.project(simple), compilation, "close the loops");
    require_motions(compilation, targets, simple.zd, "velocity");
  }
  state = simple;
}

/// The fastest coordinate, -1 if all are at rest.
int fastest(const std::vector<double>& zd) {
  int result = -1;
  for (std::size_t i = 0; i < zd.size(); ++i)
    if (std::abs(zd[i]) > (result < 0 ? 0 : std::abs(zd[static_cast<std::size_t>(result)])))
      result = static_cast<int>(i);
  return result;
}

/// Next to a singular position a loop turns a requested velocity into any other one. Fails: UserError.
void require_reason(const Compilation& compilation, const std::vector<Target>& targets, const GenericState& state) {
  const int runs = fastest(state.zd);
  if (runs < 0) return;
  double largest = 1;
  const Target* asked = nullptr;
  for (const Target& target : targets) {
    if (asked == nullptr || std::abs(target.value) > std::abs(asked->value)) asked = &target;
    largest = std::max(largest, std::abs(target.value));
  }
  for (std::size_t i = 0; i < state.zd.size(); ++i)
    if (compilation.analysis.driven[i]) largest = std::max(largest, std::abs(state.zd[i]));
  const double speed = state.zd[static_cast<std::size_t>(runs)];
  if (asked == nullptr || std::abs(speed) <= kMostMultiplied * largest) return;
  const std::vector<TreeBody>& bodies = compilation.topology.bodies;
  const auto text = [&](int i, double value) {
    const auto& body = bodies[static_cast<std::size_t>(i)];
    return fmt::format("{:.4g} {}/s", value, unit_of(body.kind));
  };
  const std::string &of_asked = bodies[static_cast<std::size_t>(asked->coordinate)].coordinate,
                    &of_fastest = bodies[static_cast<std::size_t>(runs)].coordinate;
  throw UserError(Diagnostics{
      {asked->where,
       fmt::format("initial velocity of {} cannot be met: with {} the loops would move {} at {}", of_asked,
                   text(asked->coordinate, asked->value), of_fastest, text(runs, speed)),
       fmt::format("the start is next to a singular position, where {} can hardly move: start elsewhere, or "
                   "give the velocity of {}",
                   of_asked, of_fastest),
       ""}});
}

/// Adds the values that were not kept.
void add_moved(const std::vector<Target>& targets, const std::vector<double>& values, bool velocity,
               std::vector<MovedValue>& moved) {
  for (const Target& target : targets) {
    if (!keeps(target, values, kKept))
      moved.push_back({target.where, target.coordinate, velocity, target.value, values[target.coordinate]});
  }
}

}  // namespace

Start initial_start(const Compilation& compilation, const std::vector<double>& inputs) {
  const Initial& initial = compilation.model.initial;
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const std::vector<Target> positions = targets_of(compilation, initial.positions);
  std::vector<Target> velocities = targets_of(compilation, initial.velocities);
  Start start;
  start.state = assemble(compilation, solver, positions, initial.equilibrium);
  if (initial.equilibrium) {
    const GenericState guess = start.state;
    const Status status = solver.equilibrium(start.state);
    if (!status.ok()) fail_equilibrium(compilation, inputs, guess, start.state, status);
  } else {
    add_moved(positions, start.state.z, false, start.moved);
  }
  for (const TurningRate& one : turning_rates(compilation, start.state))
    velocities.push_back({one.coordinate, one.rate, one.asked->where});
  set_velocities(compilation, solver, velocities, start.state);
  require_reason(compilation, velocities, start.state);
  add_moved(velocities, start.state.zd, true, start.moved);
  start.unloaded = start.state.x;
  solver.set_friction_loads(start.state);  // where it fails, as at a singular position, loads start from zero
  return start;
}

GenericState initial_state(const Compilation& compilation, const std::vector<double>& inputs) {
  return initial_start(compilation, inputs).state;
}

GenericState initial_state(const Start& start, const Engine& engine) {
  GenericState state = start.state;
  if (!engine.set_friction_loads) return state;
  state.x = start.unloaded;
  engine.set_friction_loads(state);
  return state;
}

namespace {

/// Parameters at their values, except one changed.
struct MovedParameter {
  const Model& model;
  int moved = -1;
  double by = 0;
  double parameter(int index) const {
    return model.parameters[static_cast<std::size_t>(index)].value + (index == moved ? by : 0);
  }
  double input(int) const { return 0; }
  double time() const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

/// Change of the initial velocities with a parameter that affects them.
std::vector<double> change_of_start(const Compilation& compilation, const GenericSolver& solver,
                                    const GenericState& start, int parameter, double by) {
  const std::vector<InitialValue>& values = compilation.model.initial.velocities;
  std::vector<Target> targets = targets_of(compilation, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].expression < 0) continue;
    const Expression& expression = compilation.model.expressions[static_cast<std::size_t>(values[i].expression)];
    targets[i].value = evaluate<double>(expression, MovedParameter{compilation.model, parameter, by});
  }
  GenericState state = start;
  set_velocities(compilation, solver, targets, state);
  for (std::size_t i = 0; i < state.zd.size(); ++i) state.zd[i] -= start.zd[i];
  return state.zd;
}

std::vector<StartParameter> start_parameters(const Compilation& compilation, const GenericState& start) {
  std::vector<StartParameter> result;
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(input_values(compilation.model, {}));
  for (std::size_t i = 0; i < compilation.model.parameters.size(); ++i) {
    const Parameter& parameter = compilation.model.parameters[i];
    if (!parameter.at_start) continue;
    const int index = static_cast<int>(i);
    StartParameter one{index, change_of_start(compilation, solver, start, index, 1)};
    const std::vector<double> twice = change_of_start(compilation, solver, start, index, 2);
    for (std::size_t c = 0; c < twice.size(); ++c) {
      if (std::abs(twice[c] - 2 * one.zd[c]) <= kKept * std::max(1.0, std::abs(one.zd[c]))) continue;
      throw UserError(
          Diagnostics{{parameter.where,
                       fmt::format("parameter \"{}\" does not act linearly on the velocity of {} at the start",
                                   parameter.name, compilation.topology.bodies[c].coordinate),
                       "ask for velocities that fit together, or leave out its \"at_start\"", ""}});
    }
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace

InitialState default_initial_state(const Compilation& compilation) {
  GenericState state = noted_initial_state(compilation, input_values(compilation.model, {}));
  std::vector<StartParameter> parameters = start_parameters(compilation, state);
  return {std::move(state.z), std::move(state.zd), std::move(state.x), std::move(parameters), std::move(state.charts)};
}

std::optional<InitialState> known_start(const Compilation& compilation) {
  try {
    return default_initial_state(compilation);
  } catch (const UserError& error) {
    print_message("{}{}: note: the solver is written without initial_state(): start from a state of your own\n",
                  error.text(Style::plain), compilation.model.file);
    return {};
  }
}

}  // namespace mbgen
