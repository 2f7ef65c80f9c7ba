#pragma once
// A parameter study: its grid, the metrics of each motion or manoeuvre, and the computation of one case.

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
  std::string model, manoeuvre;
  std::vector<std::string> vary, metrics, set;
  std::string vary_option = "--vary", metric_option = "--metric";  ///< for messages
  std::string keep;  ///< directory for the motions of the cases, "" for none
  long every = 1;    ///< steps from one row of a kept motion to the next
  SimulationArguments simulation;
  EngineArguments engine;
  bool has_engine = false;  ///< the engine was typed, not taken by default
};

/// A study that was read and checked.
struct Study {
  StudyArguments arguments;
  Model model;  ///< with `set`, and the outputs of a vehicle; the varied parameters are tunable where `is_tuned`
  std::vector<VariedParameter> set;  ///< parameters that all cases have at other values than the file
  SweepGrid grid;
  Metrics metrics;
  std::string manoeuvre;        ///< text of its file, "" for none
  std::string start_speed;      ///< parameter that has the speed of the manoeuvre in each case, "" for none
  SimulationSettings settings;  ///< with a manoeuvre those of the manoeuvre as written; all cases have this step
  EngineChoice choice;
  bool is_tuned = true;       ///< one analysis and one solver serve all cases; else each case is analysed anew
  std::string why_not_tuned;  ///< the first place that asks for a constant
  std::vector<std::string> warnings = {};  ///< of its inputs, complete lines for standard error
  Diagnostics notes = {};                  ///< on the manoeuvre
};

/// A number of a manoeuvre: a metric of its standard, or the deviation from its course or speed.
struct ManoeuvreResult {
  std::string name, unit;
  double value = 0;  ///< SI
};

/// Result of one case.
struct CaseResult {
  /// One line: "ok" or "warning: " and the reason for doubt, then the singular positions that were passed; or the
  /// reason why there are no values
  std::string status;
  std::vector<double> metrics;  ///< of all metrics; NaN where there are none
  double energy_error = 0;      ///< of the motion, relative
  std::vector<ManoeuvreResult> of_manoeuvre = {};
  std::vector<std::vector<double>> derivatives = {};  ///< of the metrics by each axis, where they were asked for
  bool is_warned() const { return status.starts_with("warning: "); }
  bool has_values() const { return status == "ok" || status.starts_with("ok, ") || is_warned(); }
};

using CaseResults = std::map<long, CaseResult>;

/// Reads the model and the settings of the study. Varied parameters become tunable; if one stands for a number that
/// must be constant, and no engine was named, the generic engine is used. Fails: UserError.
Study read_study(const StudyArguments& arguments);

/// Whether a path is a motion of --keep, or of the description beside it.
bool is_kept_motion(const Study& study, const std::string& path);

/// File of the motion of a case in the directory of kept ones: "case_007.csv", as many digits as the last case has.
std::string kept_file(const Study& study, long index);

/// All inputs of a study's result, as one line of JSON: two studies with the same line have the same results. Fails:
/// UserError for an input table that cannot be read.
std::string description(const Study& study);

/// The parameters that a case reads otherwise than they are written. values: of all axes, or empty for those of the
/// file.
std::vector<VariedParameter> varied_parameters(const Study& study, const std::vector<double>& values, bool tunable);

/// The model of the study with these parameters, with the outputs of its vehicle for a manoeuvre. Fails: with the
/// problems of the model; UserError, as prepare_model.
Result<Model> model_with(const Study& study, const std::vector<VariedParameter>& varied);

/// The inputs of a case, at the start of a manoeuvre. Fails: UserError.
InputsOverTime inputs_of(const Study& study, const Model& model, const std::vector<double>& values);

/// Data that all cases and threads share: analysis, compiled solver.
struct StudySolver {
  Compilation compilation;
  std::shared_ptr<const SolverTable> table;                ///< null for engines that are made of the model of each case
  std::shared_ptr<const TangentTable> tangents = nullptr;  ///< null without derivatives
};

/// Analyses, generates and compiles. Fails: UserError.
StudySolver prepare(const Study& study);

/// Adds exact derivatives of the metrics by the axes to a solver. Result: the reason why they have none, "" where they
/// do. Fails: UserError.
std::string add_derivatives(const Study& study, StudySolver& solver);

}  // namespace mbgen
