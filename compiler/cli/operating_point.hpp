#pragma once
// The state at which a model is looked at: its initial one, its equilibrium, or one of a file.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::cli {

/// A state as typed.
struct StateArguments {
  std::string at, states;
  int index = 0;
  std::vector<std::string> inputs;  ///< name=value
};

/// --at, --states, --index, --input
void add_state_options(CLI::App& command, StateArguments& arguments);

/// The state that the arguments name, its loops closed, and the inputs. Fails: UserError.
OperatingPoint operating_point(const Compilation& compilation, const StateArguments& arguments);

/// The static equilibrium near the model's initial state, at these inputs. Fails: UserError when there is none.
GenericState equilibrium_state(const Compilation& compilation, const std::vector<double>& inputs);

}  // namespace mbgen::cli
