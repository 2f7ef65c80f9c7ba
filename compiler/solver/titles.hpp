#pragma once
// Titles of steps and of parts of a mechanism, for headings of emitted code, dumps and tables.

#include "compiler/model/model.hpp"
#include "compiler/program/program.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Titles of the sections of a form and of the parts of this model. Requires: model and topology live as long.
Titles titles_of(Form form, const Model& model, const Topology& topology);

}  // namespace mbgen
