#pragma once
// Settings of a motion, as typed.

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

/// The same with a table of inputs that was read. Fails: UserError.
InputsOverTime inputs_of(const Model& model, const std::vector<std::string>& assignments, const InputTable& table,
                         const std::string& interpolation);

/// The duration in equal steps, none longer than requested. Fails: UserError for impossible values.
SimulationSettings settings_of(const SimulationArguments& arguments, const SolverSettings& by_default);

/// Sets loads of frictions without a given period to the step of the motion, and lags without a given time to a longer
/// one than the model's. set: values with which the model was read;
/// it receives the step if it matters.
void follow_step(const SimulationSettings& settings, std::vector<VariedParameter>& set, Model& model);

/// Fails: UserError if the period of a sampled value is not a multiple of the step.
void require_whole_periods(const SimulationSettings& settings, const Model& model);

/// The integrator of this name, else the model's if the engine has it. Fails: UserError for an unknown one, or one that
/// the engine does not have.
SolverSettings::Integrator integrator_of(const std::string& name, SolverSettings::Integrator of_model,
                                         const std::string& engine);

}  // namespace mbgen
