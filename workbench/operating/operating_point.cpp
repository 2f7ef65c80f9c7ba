#include "workbench/operating/operating_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/linearisation/bristles.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/result_file.hpp"
#include "workbench/start/equilibrium_trouble.hpp"
#include "workbench/start/initial_state.hpp"
#include "workbench/start/states_file.hpp"

namespace mbgen {
namespace {

/// The initial state in the angles of the model.
GenericState users_initial_state(const Compilation& compilation, const std::vector<double>& inputs) {
  return in_users_angles(compilation.topology.balls, noted_initial_state(compilation, inputs));
}

/// A state of a file, made consistent.
GenericState state_of_file(const Compilation& compilation, const StateArguments& arguments,
                           std::vector<double>& inputs) {
  const StatesFile file = read_states(arguments.states, compilation, inputs);
  const int count = static_cast<int>(file.states.size());
  if (count == 0) throw UserError(fmt::format("{}: /states: has no states\n", arguments.states));
  if (arguments.index < 1 || arguments.index > count) {
    throw UserError(
        fmt::format("--index: {} has states 1 to {}, found {}\n", arguments.states, count, arguments.index));
  }
  const FileState& asked = file.states[static_cast<std::size_t>(arguments.index) - 1];
  inputs = asked.inputs;
  GenericState state = asked.at.state;
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const Status status = solver.project(state);
  if (status.ok()) return state;
  throw UserError(fmt::format("{}: state {} cannot be made consistent: {}\n", arguments.states, arguments.index,
                              describe(compilation, status)));
}

/// Requested row of a result, from 0.
std::size_t chosen_row(const Results& results, const StateArguments& arguments) {
  const std::vector<double>& time = results.columns.front().values;
  if (!arguments.time) {
    if (arguments.row >= 1 && static_cast<std::size_t>(arguments.row) <= time.size()) return arguments.row - 1;
    throw UserError(
        fmt::format("--row: {} has rows 1 to {}, found {}\n", arguments.result, time.size(), arguments.row));
  }
  constexpr double kSameTime = 1e-3;  // of the distance of rows
  const double slack =
      time.size() > 1 ? kSameTime * (time.back() - time.front()) / static_cast<double>(time.size() - 1) : 0;
  const auto nearest = std::min_element(time.begin(), time.end(), [&](double a, double b) {
    return std::abs(a - *arguments.time) < std::abs(b - *arguments.time);
  });
  if (std::abs(*nearest - *arguments.time) <= slack) return static_cast<std::size_t>(nearest - time.begin());
  throw UserError(fmt::format("--time: {} has times from {:g} to {:g} s, the nearest to {:g} s is {:g} s\n",
                              arguments.result, time.front(), time.back(), *arguments.time, *nearest));
}

/// Notes when the result's run had other parameters, or the model has changed since.
void note_other_model(const Compilation& compilation, const Results& results, const std::string& file) {
  const nlohmann::json run = nlohmann::json::parse(results.run, nullptr, false);
  if (!run.is_object() || run.value("model_hash", nlohmann::json()) == compilation.model.hash) return;
  const nlohmann::json set = run.value("set", nlohmann::json::array());
  std::string words;
  for (const nlohmann::json& one : set) words += one.is_string() ? " --set " + one.get<std::string>() : std::string();
  print_message("{}: note: is of another model, or of other values of its parameters, than {} is now{}\n", file,
                compilation.model.file, words.empty() ? "" : fmt::format("; it was simulated with{}", words));
}

/// Takes the auxiliary states at a row, if the result has all of them.
bool take_auxiliary(const Compilation& compilation, const Results& results, std::size_t row, std::vector<double>& x) {
  std::vector<double> found;
  for (const std::string& name : auxiliary_state_names(compilation.model)) {
    const int column = find_column(results, "x." + name);
    if (column < 0) return false;
    found.push_back(results.columns[static_cast<std::size_t>(column)].values[row]);
  }
  x = std::move(found);
  return true;
}

/// A row of a result, made consistent; notes name the values missing in the result.
OperatingPoint point_of_result(const Compilation& compilation, const StateArguments& arguments,
                               const std::vector<double>& inputs) {
  const Results results = read_result_file(arguments.result);
  const std::size_t row = chosen_row(results, arguments);
  note_other_model(compilation, results, arguments.result);
  GenericState state = reference_state(compilation);
  state.t = results.columns.front().values[row];
  const auto value = [&](const std::string& name) {
    const int column = find_column(results, name);
    if (column >= 0) return results.columns[static_cast<std::size_t>(column)].values[row];
    throw UserError(
        fmt::format("{}: no column \"{}\"; it is no result of {}\n", arguments.result, name, compilation.model.file));
  };
  for (std::size_t i = 0; i < state.z.size(); ++i) {
    state.z[i] = value("z." + compilation.topology.bodies[i].coordinate);
    state.zd[i] = value("zd." + compilation.topology.bodies[i].coordinate);
  }
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  if (const Status status = solver.project(state); !status.ok()) {
    throw UserError(fmt::format("{}: row {} cannot be made consistent: {}\n", arguments.result, row + 1,
                                describe(compilation, status)));
  }
  OperatingPoint point{state.z, state.zd, state.x, state.t, inputs};
  if (!take_auxiliary(compilation, results, row, point.x)) {
    set_steady_states(compilation, point);
    print_message("{}: note: has not all auxiliary states, columns x.*: they are taken as settled\n", arguments.result);
  }
  if (!inputs.empty() && arguments.inputs.empty()) {
    print_message("{}: note: a result does not hold the inputs: they have their defaults; --input sets them\n",
                  arguments.result);
  }
  return point;
}

}  // namespace

std::vector<double> outputs_at(const Compilation& c, const OperatingPoint& point, const std::string& where) {
  GenericSolver solver(c.model, c.topology, c.analysis);
  solver.set_inputs(point.inputs);
  const GenericState state{point.z, point.zd, point.x, point.t};
  const std::vector<double> tau(point.z.size(), 0.0);
  GenericDerivative derivative;
  if (const Status status = solver.accelerations(state, tau, derivative); !status.ok())
    throw UserError(fmt::format("{}: {}\n", where, describe(c, status)));
  return solver.outputs(state, tau, derivative).y;
}

GenericState equilibrium_state(const Compilation& compilation, const std::vector<double>& inputs) {
  GenericState state = users_initial_state(compilation, inputs);
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const GenericState start = state;
  const Status status = solver.equilibrium(state);
  if (!status.ok()) fail_equilibrium(compilation, inputs, start, state, status);
  return state;
}

std::vector<std::string> files_read(const Model& model, const StateArguments& arguments) {
  std::vector<std::string> files = model.files;
  files.push_back(arguments.states);
  if (!arguments.result.empty()) files.insert(files.end(), {arguments.result, run_file(arguments.result)});
  return files;
}

ChosenPoint operating_point(const Compilation& compilation, const StateArguments& arguments) {
  std::vector<double> inputs = input_values(compilation.model, arguments.inputs);
  const bool is_steady = arguments.at == "steady";
  if (!is_steady && !(arguments.steady.hold.empty() && arguments.steady.solve.empty())) {
    throw UserError("--hold, --solve: these belong to --at steady\n");
  }
  if (!arguments.result.empty()) return {point_of_result(compilation, arguments, inputs), {}};
  GenericState state = !arguments.states.empty()       ? state_of_file(compilation, arguments, inputs)
                       : arguments.at == "equilibrium" ? equilibrium_state(compilation, inputs)
                                                       : users_initial_state(compilation, inputs);
  OperatingPoint point{std::move(state.z), std::move(state.zd), std::move(state.x), state.t, std::move(inputs)};
  if (arguments.states.empty()) set_steady_bristles(compilation.model, compilation.topology, point);
  if (!is_steady) return {std::move(point), {}};
  SteadyMotion steady = steady_motion(compilation, point, arguments.steady);
  print_message("{}", free_directions_note(compilation, steady));
  return {steady.point, steady};
}

}  // namespace mbgen
