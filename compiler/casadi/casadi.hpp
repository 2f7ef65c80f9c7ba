#pragma once
// The door of the CasADi room: Programs -> the motion as functions in C that CasADi's `external` finds by name, and an
// acados model of them. The same input gives the same bytes on any machine. Source: CasADi 3.6, core/external.cpp.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Why a model is no explicit differential equation of its independent coordinates; "" where it is one.
std::string no_explicit_motion(const Model& model, const Topology& topology, const Analysis& analysis);

/// <model>_casadi.h, <model>_casadi.c with further parts, <model>_casadi.cmake, <model>_acados.py. programs: after the
/// passes; for_slopes: the same as they are differentiated; emitted: as they are emitted. initial: the state from which
/// loops are closed. Requires: no_explicit_motion is empty.
std::vector<EmittedFile> emit_casadi(const Programs& programs, const Programs& for_slopes,
                                     const WrittenPrograms& emitted, const Model& model, const Topology& topology,
                                     const Analysis& analysis, const InitialState& initial);

}  // namespace mbgen
