#pragma once
// The model of a fit: one analysis and one compiled solver, whose tunable parameters are set at load.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/reader/varied.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/fit/fit_data.hpp"
#include "workbench/fit/series.hpp"
#include "workbench/fit/unknowns.hpp"
#include "workbench/motion/simulation_arguments.hpp"

namespace mbgen::fit {

/// Model and engine of a fit as typed.
struct ModelArguments {
  std::string path;
  std::vector<std::string> set;
  SimulationArguments simulation;
  EngineArguments engine;
  bool has_engine = false;  ///< the engine was typed, not taken by default
};

struct FitModel {
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
FitModel read_fit_model(const ModelArguments& arguments);

/// Makes the free parameters tunable and analyses; compiles for runs, and adds programs for modes. Fails: UserError.
void prepare(FitModel& model, const std::vector<Unknown>& unknowns, const std::vector<MeasuredFile>& files,
             const std::vector<Channel>& channels);

/// The model at values of the unknowns. Fails: UserError.
Compilation compilation_at(const FitModel& model, const std::vector<Unknown>& unknowns,
                           const std::vector<double>& values);

/// Series of the quantities of a source, or the reason why there are none.
struct Outcome {
  std::string failure;
  std::vector<Series> series;         ///< one for each channel of the file
  std::vector<std::string> warnings;  ///< of a judged motion
  /// Of an exact evaluation: derivatives of the series by each free parameter, in the order of the unknowns.
  std::vector<std::vector<Series>> derivatives = {};
};

/// How a motion is computed.
enum class Care {
  quick,  ///< for the search
  exact,  ///< likewise, with derivatives where the model has `tangents`
  judged  ///< with all watchers, whose doubts are warnings
};

/// The motion of a run at values of the unknowns; run: its number among all files. is_stopped: asked after every step.
Outcome motion_of(const FitModel& model, const MeasuredFile& file, int run, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values, Care care,
                  const std::function<bool()>& is_stopped);

}  // namespace mbgen::fit
