#pragma once
// The driver of a compiled solver.

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// `<model>_driver.cpp`: the table of mbgen/driver.hpp over plain arrays, for whoever loads the compiled solver.
/// lanes: as the solver has them.
EmittedFile emit_driver(const Model& model, int lanes = 0);

/// The same with step_ticks: it holds the program of accelerations once more, cut at its steps.
/// Requires: as emit.
EmittedFile emit_clocked_driver(const Programs& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis, int lanes = 0);

}  // namespace mbgen
