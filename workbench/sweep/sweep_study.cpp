#include "workbench/sweep/sweep_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_end.hpp"
#include "workbench/motion/motion_judge.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/motion/simulation_text.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr const char* kMetricOption = "--metric";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The parameters that a case reads otherwise than they are written. values: of all axes, or empty for those of the
/// file.
std::vector<VariedParameter> varied_parameters(const Study& study, const std::vector<double>& values, bool tunable) {
  const SweepGrid& grid = study.grid;
  std::vector<VariedParameter> varied = study.set;
  for (std::size_t a = 0; a < grid.axes.size(); ++a) {
    if (grid.axes[a].is_input) continue;
    VariedParameter parameter{grid.axes[a].name, std::nullopt, tunable};
    if (!values.empty()) parameter.value = values[a];
    varied.push_back(std::move(parameter));
  }
  return varied;
}

/// Lets the varied parameters be tunable, or finds out why they cannot.
void choose_tuning(Study& study) {
  const std::vector<VariedParameter> varied = varied_parameters(study, {}, true);
  if (varied.size() == study.set.size()) return;
  Result<Model> model = read_varied_model(study.arguments.model, varied);
  if (model) {
    study.model = std::move(*model);
    study.model.solver.integrator = study.choice.integrator;
    return;
  }
  study.is_tuned = false;
  const Diagnostic& first = model.problems().front();
  study.why_not_tuned =
      fmt::format("{}:{}:{}: {}", first.where.file, first.where.line, first.where.column, first.message);
  if (study.choice.name != "generated") return;
  if (study.arguments.has_engine) {
    throw UserError(
        fmt::format("--engine generated: one solver cannot serve all cases: {}\n  hint: leave out --engine, cases are "
                    "then analysed "
                    "one by one and run on the generic engine\n",
                    study.why_not_tuned));
  }
  study.choice.name = "generic";
}

/// Fails: UserError for a name that is both varied and given.
void check_given_once(const Study& study) {
  for (const SweepAxis& axis : study.grid.axes) {
    for (const VariedParameter& parameter : study.set) {
      if (!axis.is_input && parameter.name == axis.name) {
        throw UserError(fmt::format("--set {0}: --vary gives \"{0}\" its values\n", axis.name));
      }
    }
    for (const std::string& assignment : study.arguments.engine.inputs) {
      if (axis.is_input && assignment.substr(0, assignment.find('=')) == axis.name) {
        throw UserError(fmt::format("--input {0}: --vary gives \"{0}\" its values\n", axis.name));
      }
    }
  }
}

/// The inputs of a case. Fails: UserError.
InputsOverTime inputs_of(const Study& study, const Model& model, const std::vector<double>& values) {
  std::vector<std::string> assignments = study.arguments.engine.inputs;
  for (std::size_t a = 0; a < values.size(); ++a) {
    const SweepAxis& axis = study.grid.axes[a];
    if (axis.is_input) assignments.push_back(fmt::format("{}={}", axis.name, values[a]));
  }
  return mbgen::inputs_of(model, assignments, study.arguments.simulation);
}

/// Fails: UserError when the model has changed since the study was read, or cannot be read any more.
void require_unchanged(const Study& study, const Result<Model>& of_case) {
  const std::string& hash = study.model.hash;
  if (of_case && of_case->hash == hash) return;
  const Result<Model> again = read_model_file(study.arguments.model);  // the values of a case can spoil a good model
  if (again && again->hash == hash && !of_case) return;
  throw UserError(
      fmt::format("{}: was changed while its cases were computed, run again with --restart\n", study.arguments.model));
}

/// The system of one case. Fails: UserError.
Compilation compilation_of_case(const Study& study, const StudySolver& solver, Model model) {
  if (!study.is_tuned) return expect(decide(std::move(model)));
  return {std::move(model), solver.compilation.topology, solver.compilation.analysis, {}};
}

/// The columns that the metrics need, point by point.
class Recorder {
 public:
  Recorder(const Study& study, const Compilation& compilation, const InputsOverTime& inputs)
      : columns_(study.metrics.columns), inputs_(inputs) {
    points_.step = study.settings.step;
    for (const MetricColumn& column : columns_) places_.push_back(place_of(column, compilation.topology));
  }

  void add(const Sample& sample) {
    for (std::size_t c = 0; c < columns_.size(); ++c) points_.values.push_back(value(c, sample));
  }

  const MetricPoints& points() const { return points_; }

 private:
  static std::size_t place_of(const MetricColumn& column, const Topology& topology) {
    using Kind = MetricColumn::Kind;
    if (column.kind != Kind::position && column.kind != Kind::velocity) return static_cast<std::size_t>(column.index);
    const int coordinate = tree_coordinate(topology, column.coordinate);
    if (coordinate >= 0) return static_cast<std::size_t>(coordinate);
    throw UserError(
        fmt::format("{}: a joint that was cut has no coordinates, mark it \"cut\": false\n", kMetricOption));
  }

  double value(std::size_t c, const Sample& sample) const {
    const std::size_t place = places_[c];
    switch (columns_[c].kind) {
      case MetricColumn::Kind::time:
        return sample.state.t;
      case MetricColumn::Kind::output:
        return sample.outputs.y[place];
      case MetricColumn::Kind::position:
        return sample.state.z[place];
      case MetricColumn::Kind::velocity:
        return sample.state.zd[place];
      case MetricColumn::Kind::input:
        return inputs_.courses[place].at(sample.state.t);
    }
    return 0;
  }

  const std::vector<MetricColumn>& columns_;
  std::vector<std::size_t> places_;
  const InputsOverTime& inputs_;
  MetricPoints points_;
};

CaseResult failed(const Study& study, std::string status) {
  return {std::move(status), std::vector<double>(study.metrics.list.size(), std::numeric_limits<double>::quiet_NaN())};
}

/// The motion of a case and its metrics; none where it is stopped.
std::optional<CaseResult> measured(const Study& study, const Compilation& compilation, const Engine& engine,
                                   const InputsOverTime& inputs, const std::function<bool()>& is_stopped) {
  const GenericState start = initial_state(initial_start(compilation, inputs.at(0)), engine);
  Recorder recorder(study, compilation, inputs);
  SimulationSettings settings = study.settings;
  settings.is_stopped = is_stopped;
  const MotionTask task{.compilation = compilation,
                        .engine = engine,
                        .integrator = study.choice.integrator,
                        .settings = settings,
                        .start = start,
                        .inputs = inputs};
  const JudgedMotion motion = judged_motion(task, [&](const Sample& sample) { recorder.add(sample); });
  const auto& [summary, verdict, control] = motion;
  if (summary.is_stopped) return {};
  if (!summary.status.ok()) {
    std::vector<std::string> words = hints_of_end(compilation, motion);
    words.insert(words.begin(), end_text(compilation, motion));
    return failed(study, fmt::format("{}", fmt::join(words, "; ")));
  }
  if (!verdict.failure.empty()) return failed(study, verdict.failure);
  CaseResult result{"ok" + passages_text(compilation.topology, summary),
                    evaluate(study.metrics, compilation.model.parameters, recorder.points()),
                    summary.energy.relative_error()};
  if (!verdict.warnings.empty())
    result.status =
        fmt::format("warning: {}{}", fmt::join(verdict.warnings, "; "), passages_text(compilation.topology, summary));
  for (std::size_t m = 0; m < result.metrics.size(); ++m) {
    if (std::isfinite(result.metrics[m])) continue;
    return failed(study, fmt::format("metric {} is {}", study.metrics.list[m].name, result.metrics[m]));
  }
  return result;
}

}  // namespace

Study read_study(const StudyArguments& arguments) {
  Study study;
  study.arguments = arguments;
  study.model = expect(read_model_file(arguments.model));
  study.set = set_parameters(study.model, arguments.set);
  if (!study.set.empty()) study.model = expect(read_varied_model(arguments.model, study.set));
  study.grid = read_grid(arguments.vary, study.model);
  study.metrics = expect(read_metrics(arguments.metrics, study.model, kMetricOption));
  study.settings = settings_of(arguments.simulation, study.model.solver);
  follow_step(study.settings, study.set, study.model);
  require_whole_periods(study.settings, study.model);
  const double end = static_cast<double>(study.settings.steps) * study.settings.step;
  if (const std::optional<double> instant = instant_outside(study.metrics, end)) {
    throw UserError(
        fmt::format("{}: at({}, ...) is not in the motion, which lasts {} s\n", kMetricOption, *instant, end));
  }
  study.choice = chosen_engine(arguments.engine);
  const auto& engines = engine_names();
  if (std::find(engines.begin(), engines.end(), study.choice.name) == engines.end()) {
    make_engine({}, study.choice);  // whose refusal lists the engines
  }
  study.choice.integrator = study.model.solver.integrator =
      integrator_of(arguments.simulation.integrator, study.model.solver.integrator, study.choice.name);
  check_given_once(study);
  study.warnings = inputs_of(study, study.model, study.grid.values_of(0)).warnings;
  choose_tuning(study);
  return study;
}

std::string description(const Study& study) {
  using Json = nlohmann::ordered_json;
  const StudyArguments& arguments = study.arguments;
  Json vary = Json::object(), set = Json::object();
  for (const SweepAxis& axis : study.grid.axes) vary[axis.name] = axis.values;
  for (const VariedParameter& parameter : study.set) set[parameter.name] = *parameter.value;
  Hash table;
  if (!arguments.simulation.input_table.empty()) table.add(read_text(arguments.simulation.input_table));
  const Json words = {{"mbgen", kMbgenVersion},
                      {"model", study.model.hash},
                      {"set", set},
                      {"vary", vary},
                      {"metric", arguments.metrics},
                      {"steps", study.settings.steps},
                      {"step", study.settings.step},
                      {"integrator", name_of(study.choice.integrator)},
                      {"engine", study.choice.name},
                      {"linear-algebra", arguments.engine.linear_algebra},
                      {"factorisation", arguments.engine.factorisation},
                      {"stabilisation", arguments.engine.stabilisation},
                      {"input", arguments.engine.inputs},
                      {"input-table", table.text()},
                      {"interpolation", arguments.simulation.interpolation}};
  return words.dump(-1, ' ', false, Json::error_handler_t::replace);
}

StudySolver prepare(const Study& study) {
  if (!study.is_tuned) return {};
  if (study.choice.name != "generated") return {expect(decide(study.model)), nullptr};
  StudySolver solver{expect(decide_to_write(study.model)), nullptr};
  solver.table = load_solver(solver.compilation, study.choice);
  return solver;
}

std::optional<CaseResult> run_case(const Study& study, const StudySolver& solver, long index,
                                   const std::function<bool()>& is_stopped) {
  const std::vector<double> values = study.grid.values_of(index);
  Result<Model> model = read_varied_model(study.arguments.model, varied_parameters(study, values, study.is_tuned));
  require_unchanged(study, model);
  if (model) model->solver.integrator = study.choice.integrator;
  try {
    const Compilation compilation = compilation_of_case(study, solver, expect(std::move(model)));
    const Engine engine = solver.table ? make_generated_engine(solver.table, compilation, study.choice)
                                       : make_engine(compilation, study.choice);
    return measured(study, compilation, engine, inputs_of(study, compilation.model, values), is_stopped);
  } catch (const UserError& error) {
    return failed(study, first_line(error.what()));
  }
}

}  // namespace mbgen
