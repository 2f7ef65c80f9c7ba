#pragma once
// How a motion is computed, as typed.

#include <optional>
#include <string>
#include <vector>

#include "compiler/reader/varied.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen {

struct SimulationArguments {
  std::optional<double> duration, step;                ///< s
  std::string integrator, input_table, interpolation;  ///< "" for the default, for none
};

/// The inputs of a run. assignments: --input. Fails: UserError, see inputs_over_time.
InputsOverTime inputs_of(const Model& model, const std::vector<std::string>& assignments,
                         const SimulationArguments& arguments);

/// The duration in whole equal steps, none longer than the one asked for. Fails: UserError for values that make none.
SimulationSettings settings_of(const SimulationArguments& arguments, const SolverSettings& by_default);

/// Lets loads of frictions whose period is not given follow the step of the motion. set: with which the model was read;
/// it gets the step where that matters.
void follow_step(const SimulationSettings& settings, std::vector<VariedParameter>& set, Model& model);

/// Fails: UserError where the period of a sampled value is no multiple of the step.
void require_whole_periods(const SimulationSettings& settings, const Model& model);

/// The integrator asked for by name, else the model's where the engine has it. Fails: UserError for an unknown one, or
/// one that the engine does not have.
SolverSettings::Integrator integrator_of(const std::string& name, SolverSettings::Integrator of_model,
                                         const std::string& engine);

}  // namespace mbgen
