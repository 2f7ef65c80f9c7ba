#pragma once
// Operating point of an analysis: initial state, equilibrium, or a state from a file.

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
  SteadyRequest steady;
  std::vector<std::string> inputs;  ///< name=value
};

/// A state, its inputs and the origin of both.
struct ChosenPoint {
  OperatingPoint point;
  std::optional<SteadyMotion> steady;  ///< of --at steady
};

/// The state and inputs selected by the arguments, with closed loops. Fails: UserError.
ChosenPoint operating_point(const Compilation& compilation, const StateArguments& arguments);

/// Files read by a command with these arguments, including `run_file` of a result.
std::vector<std::string> files_read(const Model& model, const StateArguments& arguments);

/// All outputs at a point, by the generic engine. where: in front of the reason. Fails: UserError where the point has
/// no accelerations.
std::vector<double> outputs_at(const Compilation& compilation, const OperatingPoint& point, const std::string& where);

/// The static equilibrium near the model's initial state, at these inputs. Fails: UserError if there is none.
GenericState equilibrium_state(const Compilation& compilation, const std::vector<double>& inputs);

}  // namespace mbgen
