#pragma once
// From emitted code to a loaded solver, by the C++ compiler of the machine.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "mbgen/driver.hpp"
#include "mbgen/tangents.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/process.hpp"

namespace mbgen {

/// Writes the solver of a decided model (by its programs, where it has them) and its driver, compiles them with $CXX
/// (or c++) for this processor and loads the result. choice: its use, form and lanes, and use_cache: look for the
/// object under
/// ${XDG_CACHE_HOME:-~/.cache}/mbgen first, and keep it there. Its name is a hash of the code without comments and
/// default values, the compiler's version, the flags and the processor: models of equal equations share one solver. A
/// request that was met before finds its object without translating. Any number of mbgen may run at the same time.
/// Requires: not too_large. Fails: UserError when there is no compiler (the text names --engine generic),
/// std::runtime_error with the end of the compiler's messages when it rejects the code.
std::shared_ptr<const SolverTable> load_solver(const Compilation& decided, const EngineChoice& choice);

/// The same solver, or, while the cache does not hold it, one of regular positions alone, which compiles in half the
/// time: a call at another position fails with kNotRegular (mbgen/solver/regular.hpp) and leaves its results untouched.
/// The same call by load_solver goes on from there.
std::shared_ptr<const SolverTable> load_regular_solver(const Compilation& decided, EngineChoice choice);

/// The table of a solver with derivatives.
using TangentNumber = Tangents<kDirections>;
using TangentTable = SolverTableOf<TangentNumber>;

/// The solver with derivatives, compiled and kept as load_solver does it. Fails: as load_solver.
std::shared_ptr<const TangentTable> load_tangents(const Compilation& decided, EngineChoice choice);

/// The solver of this request as the cache holds it, whole or of regular positions alone, null where that has none.
/// Fails: UserError when there is no compiler.
std::shared_ptr<const SolverTable> kept_solver(const Compilation& decided, EngineChoice choice);

/// An engine of its own behind a solver that others may use at the same time. compilation: of the solver, or one
/// whose model has other values of the tunable parameters; engines run at those.
Engine make_generated_engine(const std::shared_ptr<const SolverTable>& solver, const Compilation& compilation,
                             const EngineChoice& choice);

}  // namespace mbgen
