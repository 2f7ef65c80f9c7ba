#pragma once
// A parameter study: its grid, the metrics of each motion, and the computation of one case.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/reader/varied.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/sweep/metric.hpp"
#include "workbench/sweep/sweep_grid.hpp"

namespace mbgen {

/// A study as typed.
struct StudyArguments {
  std::string model;
  std::vector<std::string> vary, metrics, set;
  SimulationArguments simulation;
  EngineArguments engine;
  bool has_engine = false;  ///< the engine was typed, not taken by default
};

/// A study that was read and checked.
struct Study {
  StudyArguments arguments;
  Model model;                       ///< with `set`; the varied parameters are tunable where `is_tuned`
  std::vector<VariedParameter> set;  ///< parameters that all cases have at other values than the file
  SweepGrid grid;
  Metrics metrics;
  SimulationSettings settings;
  EngineChoice choice;
  bool is_tuned = true;       ///< one analysis and one solver serve all cases; else each case is analysed anew
  std::string why_not_tuned;  ///< the first place that asks for a constant
  std::vector<std::string> warnings = {};  ///< of its inputs, complete lines for standard error
};

/// Result of one case.
struct CaseResult {
  /// One line: "ok" or "warning: " and the reason for doubt, then the singular positions that were passed; or the
  /// reason why there are no values
  std::string status;
  std::vector<double> metrics;  ///< of all metrics; NaN where there are none
  double energy_error = 0;      ///< of the motion, relative
  bool is_warned() const { return status.starts_with("warning: "); }
  bool has_values() const { return status == "ok" || status.starts_with("ok, ") || is_warned(); }
};

using CaseResults = std::map<long, CaseResult>;

/// Reads the model and the settings of the study. Varied parameters become tunable; if one stands for a number that
/// must be constant, and no engine was named, the generic engine is used. Fails: UserError.
Study read_study(const StudyArguments& arguments);

/// All inputs of a study's result, as one line of JSON: two studies with the same line have the same results. Fails:
/// UserError for an input table that cannot be read.
std::string description(const Study& study);

/// Data that all cases and threads share: analysis, compiled solver.
struct StudySolver {
  Compilation compilation;
  std::shared_ptr<const SolverTable> table;  ///< null for engines that are made of the model of each case
};

/// Analyses, generates and compiles. Fails: UserError.
StudySolver prepare(const Study& study);

/// Simulates one case and computes its metrics. An error of a case is its status. is_stopped: called after every step;
/// a case that it stops has no result. Fails: std::exception where mbgen is at fault, UserError when the model was
/// changed meanwhile.
std::optional<CaseResult> run_case(const Study& study, const StudySolver& solver, long index,
                                   const std::function<bool()>& is_stopped = {});

}  // namespace mbgen
