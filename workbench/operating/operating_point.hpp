#pragma once
// The state at which a model is looked at: its initial one, its equilibrium, or one of a file.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/operating/steady_motion.hpp"

namespace mbgen {

/// A state as typed.
struct StateArguments {
  std::string at, states, result;
  int index = 0, row = 0;
  std::optional<double> time;
  SteadyWish steady;
  std::vector<std::string> inputs;  ///< name=value
};

/// A state, its inputs and the origin of both.
struct ChosenPoint {
  OperatingPoint point;
  std::optional<SteadyMotion> steady;  ///< of --at steady
};

/// The state that the arguments name, its loops closed, and the inputs. Fails: UserError.
ChosenPoint operating_point(const Compilation& compilation, const StateArguments& arguments);

/// The files that a command with these arguments reads, `run_file` of a result among them.
std::vector<std::string> files_read(const Model& model, const StateArguments& arguments);

/// The static equilibrium near the model's initial state, at these inputs. Fails: UserError when there is none.
GenericState equilibrium_state(const Compilation& compilation, const std::vector<double>& inputs);

}  // namespace mbgen
