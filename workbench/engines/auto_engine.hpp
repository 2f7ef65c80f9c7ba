#pragma once
// `--engine auto`: the engine that has the motion first.

#include <memory>
#include <string>

#include "compiler/compile.hpp"
#include "mbgen/driver.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {

constexpr const char* kAutoEngine = "auto";

/// An engine with the reason why it was taken, for people.
struct AutoEngine {
  std::string name;
  std::string reason;
  std::shared_ptr<const SolverTable> kept = {};  ///< the solver of a generated engine that needs no compilation
};

/// generated where its solver is kept already, or where compiling it takes less time than so many steps of the generic
/// engine; else generic. Times are estimated from operations, so that the same command takes the same engine
/// everywhere.
AutoEngine auto_engine(const Compilation& decided, const EngineChoice& choice, long steps);

}  // namespace mbgen
