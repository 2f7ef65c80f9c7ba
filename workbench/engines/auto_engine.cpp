#include "workbench/engines/auto_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/analysis/analysis.hpp"
#include "compiler/analysis/implicit_operations.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/compile_solver.hpp"

namespace mbgen {
namespace {

// Measured on two cores of an EPYC, g++ 12, from four_bar to truck, over the operations of least_operations: coach 2.9
// s and 0.50 ms a step, truck 5.4 s and 1.3 ms.
constexpr double kSecondsToCompile = 1.2, kSecondsToCompileAnOperation = 0.7e-3;
constexpr double kSecondsOfAStep = 1e-5, kSecondsOfAStepPerOperation = 2.2e-7;  // of the generic engine
// Of the equations of implicit steps, over implicit_operations: the truck on a bending frame (models/beams).
constexpr double kSecondsToCompileAnImplicitOne = 3.5e-4, kSecondsOfAStepPerImplicitOne = 1.2e-8;

}  // namespace

AutoEngine auto_engine(const Compilation& decided, const EngineChoice& choice, long steps) {
  if (!too_large(decided, choice.form).empty()) return {"generic", "the solver is too large to be written"};
  try {
    if (auto kept = kept_solver(decided, choice)) return {"generated", "its solver is kept", std::move(kept)};
  } catch (const UserError&) {
    return {"generic", "there is no C++ compiler"};
  }
  const LeastOperations least = least_operations(decided.topology, decided.analysis);
  const double operations = std::min(least.matrix, least.recursive);
  const double implicit = implicit_operations(decided.model, decided.topology, decided.analysis, kMostOperations);
  const double compiling =
      kSecondsToCompile + kSecondsToCompileAnOperation * operations + kSecondsToCompileAnImplicitOne * implicit;
  const double generic = static_cast<double>(steps) * (kSecondsOfAStep + kSecondsOfAStepPerOperation * operations +
                                                       kSecondsOfAStepPerImplicitOne * implicit);
  const bool is_generic = generic < compiling;
  return {is_generic ? "generic" : "generated",
          fmt::format("{} steps take the generic engine about {:.2g} s, compiling a solver takes about {:.2g} s", steps,
                      generic, compiling)};
}

}  // namespace mbgen
