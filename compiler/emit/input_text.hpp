#pragma once
// How the inputs of a solver go on during a step.

#include <string>
#include <vector>

#include "compiler/emit/names.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// Inputs with their derivatives, each row from an input that is no derivative to the last one; those that share a
/// derivative are left out, as no rate can follow several values.
std::vector<std::vector<int>> input_rows(const std::vector<Input>& inputs);

/// Statements that set the members of `later` to the inputs dt seconds after `inputs`; empty where no input has a
/// derivative. scalar: type of the inputs.
std::string advanced_inputs(const Model& model, const SolverNames& names, const std::string& scalar,
                            const std::string& margin);

/// The items of kInputRows; empty where no rates can be made.
std::string input_rows_text(const Model& model, const SolverNames& names);

}  // namespace mbgen
