#pragma once
// `mbgen simulate --inverse`: forces of the actuators along a path.

#include <optional>
#include <string>
#include <vector>

#include "workbench/engines/engine_arguments.hpp"
#include "workbench/motion/simulation_arguments.hpp"

namespace mbgen::cli {

struct InversePathOptions {
  std::string model, path, form, out, format;
  std::vector<std::string> set;
  EngineArguments engine;
  SimulationArguments simulation;
  long every = 1;
  bool json = false;
};

/// Fails: UserError for a model without inverse dynamics.
void require_inverse_dynamics(const Compilation& compilation, const char* command);

/// Writes the table of the forces and prints a summary. Result: the exit code. Fails: UserError.
int run_inverse_path(const InversePathOptions& options);

}  // namespace mbgen::cli
