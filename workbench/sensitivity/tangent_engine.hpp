#pragma once
// An engine that carries along its motion the exact derivatives by parameters of the model.

#include <memory>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {

/// The numbers of a motion and their derivatives by at most kDirections parameters.
struct TangentPass {
  std::vector<TangentNumber> parameters, inputs;
  std::vector<TangentNumber> before, after;  ///< states that the last step left and found
  std::vector<TangentNumber> scratch, derivative, tau, y;
  std::vector<TangentNumber> history;  ///< memory of the multistep method, in numbers for their alignment
};

/// An Engine over the solver with derivatives, and the memory of these, to which `engine` refers; or any other engine,
/// which has no memory and no derivatives.
struct TangentEngine {
  struct Memory {
    std::shared_ptr<const TangentTable> table;
    std::vector<TangentPass> passes;
    int parameters = 0;  ///< whose derivatives are carried
  };
  std::shared_ptr<Memory> memory;
  Engine engine;
};

/// The engine of a compiled solver for the derivatives by these tunable parameters. Compiles the solver where it is not
/// kept. Fails: as load_tangents.
TangentEngine make_tangent_engine(const Compilation& compilation, const EngineChoice& choice,
                                  const std::vector<std::string>& parameters);

/// The same of a solver that is loaded.
TangentEngine make_tangent_engine(const std::shared_ptr<const TangentTable>& table, const Compilation& compilation,
                                  const EngineChoice& choice, const std::vector<std::string>& parameters);

/// Solvers that were loaded before: null for one made of the compilation, null for no derivatives.
struct LoadedTables {
  std::shared_ptr<const SolverTable> plain;
  std::shared_ptr<const TangentTable> tangents;
};

/// The engine with derivatives where `tangents` is there, else one without.
TangentEngine make_moving_engine(const LoadedTables& tables, const Compilation& compilation, const EngineChoice& choice,
                                 const std::vector<std::string>& parameters);

/// Headings of the derivatives, in the order of output_derivatives: "d(OUTPUT)/d(PARAMETER)".
std::vector<Heading> derivative_headings(const Model& model, const std::vector<std::string>& parameters);

/// Derivatives of the outputs that the engine gave last: outputs x parameters, row by row; none of an engine without
/// memory. NaN where the state was none of the motion.
std::vector<double> output_derivatives(const TangentEngine& engine);

/// Starts the motion at this state, which initial_start found, with the derivatives that the model's `initial` gives
/// it: coordinates that it names are held and the others follow, or a static equilibrium moves with the parameters.
/// An engine without memory stays as it is. Fails: UserError where `initial` names more coordinates than the loops
/// leave free and locks none, and where the equilibrium is not determined.
void start_motion(const Compilation& compilation, const GenericState& start, TangentEngine& engine);

}  // namespace mbgen
