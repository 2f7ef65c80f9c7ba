#pragma once
// The programs that take given accelerations: constraint forces and outputs, in the frames and by the sweeps of a form.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Multipliers and driving forces in the frozen order (theory.md section 4). Same slots as Programs::multipliers.
Program trace_multipliers(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// Outputs of the model and its energies. Multipliers come from outside, so that they are right where the frozen
/// partition is not; without loops there are none, and the driving forces are what is missing. Same slots as
/// Programs::outputs.
Program trace_outputs(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

}  // namespace mbgen
