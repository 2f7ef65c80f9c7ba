#pragma once
// The programs of the loop closures over joint rates, in the frames and by the rows of a form.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Newton correction of positions and consistent velocities by the frozen factors (60), (61). Same slots as
/// Programs::closure.
Program trace_closure(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// Residuals, Jacobian and acceleration right-hand side of every block. Same slots as Programs::closure_terms.
Program trace_closure_terms(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

}  // namespace mbgen
