#pragma once
// A model with free parameters: one analysis and one compiled solver, whose tunable parameters are set at load.

#include <memory>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/reader/varied.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/search/unknowns.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"

namespace mbgen {

/// Model and engine as typed.
struct ModelArguments {
  std::string path;
  std::vector<std::string> set;
  SimulationArguments simulation;
  EngineArguments engine;
  bool has_engine = false;  ///< the engine was typed, not taken by default
};

struct FreeModel {
  ModelArguments arguments;
  Model model = {};                       ///< with `set`; free parameters are tunable where `is_tuned`
  std::vector<VariedParameter> set = {};  ///< values for all evaluations
  EngineChoice choice = {};
  bool is_tuned = true;            ///< one solver serves all values; else the model is analysed anew for each
  std::string why_not_tuned = {};  ///< the first place that asks for a constant
  Compilation compilation = {};
  std::shared_ptr<const SolverTable> table = nullptr;  ///< null for engines made of the model of each evaluation
  /// The solver with derivatives by the free parameters; null where differences stand in for them.
  std::shared_ptr<const TangentTable> tangents = nullptr;
  std::string why_differences = {};  ///< the reason for that, of a start without derivatives
};

/// Reads the model. Fails: UserError.
FreeModel read_free_model(const ModelArguments& arguments);

/// Uses of a model with free parameters.
struct Uses {
  bool motions = false, modes = false;
};

/// Makes the free parameters tunable and analyses; compiles for motions, and adds programs for modes. Fails: UserError.
void prepare(FreeModel& model, const std::vector<Unknown>& unknowns, const Uses& uses);

/// The model at values of the unknowns. Fails: UserError.
Compilation compilation_at(const FreeModel& model, const std::vector<Unknown>& unknowns,
                           const std::vector<double>& values);

/// An engine at the parameters of a compilation; with the derivatives by the free parameters where they are asked for
/// and the model has `tangents`.
TangentEngine engine_of(const FreeModel& model, const std::vector<Unknown>& unknowns, const Compilation& compilation,
                        bool with_derivatives);

}  // namespace mbgen
