#include "compiler/cli/operating_point.hpp"

#include <fmt/format.h>

#include "compiler/cli/engine.hpp"
#include "compiler/cli/equilibrium_trouble.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/states_file.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

/// A state of a file, made consistent.
GenericState state_of_file(const Compilation& compilation, const StateArguments& arguments,
                           std::vector<double>& inputs) {
  const StatesFile file = read_states(arguments.states, compilation, inputs);
  const int count = static_cast<int>(file.states.size());
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

}  // namespace

void add_state_options(CLI::App& command, StateArguments& arguments) {
  arguments.at = "initial";
  arguments.index = 1;
  CLI::Option* at = command.add_option("--at", arguments.at,
                                       "initial: the state that the model starts from (default), or equilibrium: the "
                                       "static equilibrium near it");
  at->check(CLI::IsMember({"initial", "equilibrium"}));
  command.add_option("--states", arguments.states, "a state of this file, as evaluate reads it, made consistent")
      ->excludes(at);
  command.add_option("--index", arguments.index, "which state of the file, counted from 1 (default 1)");
  add_input_option(command, arguments.inputs);
}

GenericState equilibrium_state(const Compilation& compilation, const std::vector<double>& inputs) {
  GenericState state = noted_initial_state(compilation, inputs);
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const GenericState start = state;
  const Status status = solver.equilibrium(state);
  if (!status.ok()) fail_equilibrium(compilation, inputs, start, state, status);
  return state;
}

OperatingPoint operating_point(const Compilation& compilation, const StateArguments& arguments) {
  std::vector<double> inputs = input_values(compilation.model, arguments.inputs);
  GenericState state = !arguments.states.empty()       ? state_of_file(compilation, arguments, inputs)
                       : arguments.at == "equilibrium" ? equilibrium_state(compilation, inputs)
                                                       : noted_initial_state(compilation, inputs);
  return {std::move(state.z), std::move(state.zd), std::move(state.x), state.t, std::move(inputs)};
}

}  // namespace mbgen::cli
