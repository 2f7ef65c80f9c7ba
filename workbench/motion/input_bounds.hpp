#pragma once
// Inputs of a run beyond what the model allows.

#include "compiler/model/model.hpp"
#include "workbench/motion/inputs_over_time.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// A warning of the first instant, t = 0 and the rows of a table, at which an input is below its least value or above
/// its largest one, or at which inputs make a number that the reader refuses. Cost: linear in rows.
void judge_inputs(const Model& model, const InputsOverTime& inputs, StepVerdict& verdict);

}  // namespace mbgen
