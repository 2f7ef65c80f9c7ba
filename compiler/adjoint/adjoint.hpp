#pragma once
// The door of the adjoint room: WrittenPrograms -> the solver's steps backwards in C++, for derivatives of one number
// by many. The same input gives the same bytes on any machine.

#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// <model>_adjoint.hpp and <model>_adjoint.cpp, beside the solver and the solver with derivatives of the same programs.
/// Requires: as emit, with options.tangents.
std::vector<EmittedFile> emit_adjoint(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                                      const Analysis& analysis, const EmitOptions& options);

}  // namespace mbgen
