#pragma once
// How the inputs of a solver go on during a step.

#include <string>
#include <vector>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/names.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// Each input dt seconds after `inputs`: `member`, `value`. scalar: type of the inputs.
FrameRows later_inputs(const Model& model, const SolverNames& names, const std::string& scalar);

/// The items of kInputRows; empty where no rates can be made.
std::string input_rows_text(const Model& model, const SolverNames& names);

}  // namespace mbgen
