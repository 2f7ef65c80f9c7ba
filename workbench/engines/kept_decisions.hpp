#pragma once
// Decisions about a model that are kept for the next run, as its solver is.

#include "compiler/compile.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {

/// The decisions for an engine: of a solver that is to be compiled and kept those of an earlier run of this mbgen on
/// the same model, where the cache has them. Fails: as decide, and for the generated engine as decide_to_write.
Result<Compilation> decide_for(Model model, const EngineChoice& choice);

}  // namespace mbgen
