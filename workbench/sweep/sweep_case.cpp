#include "workbench/sweep/sweep_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/manoeuvre/manoeuvre_run.hpp"
#include "workbench/motion/motion_end.hpp"
#include "workbench/motion/motion_judge.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/simulation_text.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"
#include "workbench/start/initial_state.hpp"
#include "workbench/sweep/metric_derivatives.hpp"

namespace mbgen {
namespace {

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
  Recorder(const Study& study, const Compilation& compilation, double step, const TangentEngine& moving)
      : columns_(study.metrics.columns), moving_(moving) {
    points_.step = step;
    if (moving_.memory) slopes_.assign(static_cast<std::size_t>(moving_.memory->parameters), {step, {}});
    for (const MetricColumn& column : columns_) places_.push_back(place_of(column, compilation.topology));
  }

  void add(const Sample& sample) {
    for (std::size_t c = 0; c < columns_.size(); ++c) points_.values.push_back(value(c, sample));
    if (slopes_.empty()) return;
    const std::vector<double> derivatives = output_derivatives(moving_);
    for (std::size_t p = 0; p < slopes_.size(); ++p)
      for (std::size_t c = 0; c < columns_.size(); ++c)
        slopes_[p].values.push_back(
            columns_[c].kind == MetricColumn::Kind::output ? derivatives[places_[c] * slopes_.size() + p] : 0.0);
  }

  const MetricPoints& points() const { return points_; }
  /// Derivatives of the points by each parameter; of times and inputs zero.
  const std::vector<MetricPoints>& slopes() const { return slopes_; }

 private:
  static std::size_t place_of(const MetricColumn& column, const Topology& topology) {
    using Kind = MetricColumn::Kind;
    if (column.kind != Kind::position && column.kind != Kind::velocity) return static_cast<std::size_t>(column.index);
    const int coordinate = tree_coordinate(topology, column.coordinate);
    if (coordinate >= 0) return static_cast<std::size_t>(coordinate);
    throw UserError(fmt::format("{}: a joint that was cut has no coordinates, mark it \"cut\": false\n", "--metric"));
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
        return sample.inputs[place];
    }
    return 0;
  }

  const std::vector<MetricColumn>& columns_;
  const TangentEngine& moving_;
  std::vector<std::size_t> places_;
  MetricPoints points_;
  std::vector<MetricPoints> slopes_;
};

CaseResult failed(const Study& study, std::string status) {
  return {std::move(status), std::vector<double>(study.metrics.list.size(), std::numeric_limits<double>::quiet_NaN())};
}

/// The values of the axes in the manoeuvre.
std::vector<ManoeuvreValue> manoeuvre_values(const Study& study, const std::vector<double>& values) {
  std::vector<ManoeuvreValue> list;
  for (std::size_t a = 0; a < values.size(); ++a) {
    const SweepAxis& axis = study.grid.axes[a];
    if (axis.of == SweepAxis::Of::manoeuvre) list.push_back({axis.name.substr(kOfManoeuvre.size()), values[a]});
  }
  return list;
}

/// Parameters of a case as the command line of `simulate` gives them.
std::vector<std::string> assignments_of(const std::vector<VariedParameter>& varied) {
  std::vector<std::string> list;
  for (const VariedParameter& parameter : varied)
    if (parameter.name != kStepOfMotion) list.push_back(fmt::format("{}={}", parameter.name, *parameter.value));
  return list;
}

/// A case that is about to move.
struct CaseTask {
  const Study& study;
  const std::vector<double>& values;  ///< of the axes
  std::string kept;                   ///< file of its motion, "" for none
  const Compilation& compilation;
  TangentEngine& moving;
  const InputsOverTime& inputs;
  std::vector<std::string> set;  ///< name=value of its parameters
};

/// Keeps the motion of a case as `simulate` writes it.
class KeptMotion {
 public:
  KeptMotion(const CaseTask& task, const SimulationSettings& settings) : task_(task), settings_(settings) {
    const StudyArguments& arguments = task.study.arguments;
    if (task.kept.empty()) return;
    std::vector<std::string> read = task.compilation.model.files;
    read.insert(read.end(), {arguments.simulation.input_table, arguments.manoeuvre});
    table_.emplace(task.kept, TableFormat::csv, task.compilation, settings.step, arguments.every, std::move(read));
  }
  void add(const Sample& sample) {
    if (table_) table_->add(sample);
  }
  void commit(const JudgedMotion& motion, const std::vector<MovedValue>& moved, const ManoeuvreRun* manoeuvre) {
    if (!table_) return;
    const SimulationRecord record{task_.compilation,
                                  task_.study.choice,
                                  settings_,
                                  motion.summary,
                                  task_.kept,
                                  table_->finish(),
                                  task_.study.arguments.every,
                                  motion.verdict,
                                  moved,
                                  task_.set,
                                  task_.inputs.is_constant && !manoeuvre,
                                  motion.control,
                                  words_of(manoeuvre)};
    table_->commit(run_json(record));
  }

 private:
  /// The manoeuvre's, and the varied values.
  ManoeuvreWords words_of(const ManoeuvreRun* manoeuvre) const {
    ManoeuvreWords words = manoeuvre ? manoeuvre->words() : ManoeuvreWords();
    nlohmann::ordered_json members =
        manoeuvre ? nlohmann::ordered_json::parse(words.members) : nlohmann::ordered_json::object();
    for (std::size_t a = 0; a < task_.values.size(); ++a)
      members["case"][task_.study.grid.axes[a].name] = task_.values[a];
    words.members = members.dump();
    return words;
  }
  const CaseTask& task_;
  const SimulationSettings& settings_;
  std::optional<MotionTable> table_;
};

/// Metrics and status of a motion that came to its end.
CaseResult result_of(const CaseTask& task, const JudgedMotion& motion, const Recorder& recorder,
                     const ManoeuvreRun* manoeuvre) {
  const auto& [summary, verdict, control] = motion;
  const Study& study = task.study;
  const std::string passed = passages_text(task.compilation.topology, summary);
  if (const std::optional<double> instant = instant_outside(study.metrics, summary.end_time); manoeuvre && instant)
    return failed(study,
                  fmt::format("at({}, ...) is not in the motion, which ends at {:.6g} s", *instant, summary.end_time));
  CaseResult result{"ok" + passed, evaluate(study.metrics, task.compilation.model.parameters, recorder.points()),
                    summary.energy.relative_error()};
  if (!verdict.warnings.empty())
    result.status = fmt::format("warning: {}{}", fmt::join(verdict.warnings, "; "), passed);
  for (std::size_t m = 0; m < result.metrics.size(); ++m) {
    if (std::isfinite(result.metrics[m])) continue;
    return failed(study, fmt::format("metric {} is {}", study.metrics.list[m].name, result.metrics[m]));
  }
  for (std::size_t p = 0; p < recorder.slopes().size(); ++p)
    result.derivatives.push_back(derivatives_by(study.metrics, study.grid.axes[p].name,
                                                task.compilation.model.parameters, recorder.points(),
                                                recorder.slopes()[p]));
  if (!manoeuvre) return result;
  for (const VehicleMetric& number : manoeuvre->numbers())
    result.of_manoeuvre.push_back({number.name, number.unit, number.value});
  return result;
}

/// The motion of a case and its metrics; none where it is stopped.
std::optional<CaseResult> measured(const CaseTask& task, const SimulationSettings& settings, ManoeuvreRun* manoeuvre) {
  Start start = initial_start(task.compilation, task.inputs.at(0));
  start.state = initial_state(start, task.moving.engine);
  start_motion(task.compilation, start.state, task.moving);
  if (manoeuvre) manoeuvre->look_at_steering(task.compilation, start.state, task.inputs.at(0));
  Recorder recorder(task.study, task.compilation, settings.step, task.moving);
  KeptMotion kept(task, settings);
  const MotionTask motion_task{.compilation = task.compilation,
                               .engine = task.moving.engine,
                               .integrator = task.study.choice.integrator,
                               .settings = settings,
                               .start = start.state,
                               .inputs = task.inputs,
                               .control = manoeuvre ? manoeuvre->control(settings.step) : InputControl()};
  JudgedMotion motion = judged_motion(motion_task, [&](const Sample& sample) {
    recorder.add(sample);
    kept.add(sample);
  });
  if (motion.summary.is_stopped) return {};
  if (manoeuvre) manoeuvre->judge(motion.verdict);
  kept.commit(motion, start.moved, manoeuvre);
  if (!motion.summary.status.ok()) {
    std::vector<std::string> words = hints_of_end(task.compilation, motion);
    words.insert(words.begin(), end_text(task.compilation, motion));
    return failed(task.study, fmt::format("{}", fmt::join(words, "; ")));
  }
  if (!motion.verdict.failure.empty()) return failed(task.study, motion.verdict.failure);
  return result_of(task, motion, recorder, manoeuvre);
}

/// Drives the manoeuvre of a case, or lets it move by itself.
std::optional<CaseResult> driven(const CaseTask& task, const std::function<bool()>& is_stopped) {
  const Study& study = task.study;
  SimulationSettings settings = study.settings;
  std::shared_ptr<ManoeuvreRun> run;
  if (!study.manoeuvre.empty()) {
    const std::string& file = study.arguments.manoeuvre;
    const std::vector<ManoeuvreValue> values = manoeuvre_values(study, task.values);
    SimulationArguments arguments = study.arguments.simulation;
    run = run_of(expect(read_manoeuvre(study.manoeuvre, file, values)), file, task.compilation.model, arguments);
    settings = settings_of(arguments, task.compilation.model.solver);
  }
  settings.is_stopped = is_stopped;
  return measured(task, settings, run.get());
}

/// The engine of a case, with derivatives by the axes where they are asked for.
TangentEngine engine_of_case(const Study& study, const StudySolver& solver, const Compilation& compilation,
                             bool with_derivatives) {
  std::vector<std::string> names;
  for (const SweepAxis& axis : study.grid.axes) names.push_back(axis.name);
  return make_moving_engine({solver.table, with_derivatives ? solver.tangents : nullptr}, compilation, study.choice,
                            names);
}

}  // namespace

std::optional<CaseResult> run_at(const Study& study, const StudySolver& solver, const CaseAt& at,
                                 const std::function<bool()>& is_stopped) {
  const std::vector<VariedParameter> varied = varied_parameters(study, at.values, study.is_tuned);
  Result<Model> model = model_with(study, varied);
  require_unchanged(study, model);
  try {
    if (!model) expect(std::move(model));
    model->solver.integrator = study.choice.integrator;
    std::vector<std::string> set = assignments_of(varied);
    if (!at.kept.empty()) model->hash = hash_of_set(model->hash, set_parameters(*model, set));
    const Compilation compilation = compilation_of_case(study, solver, expect(std::move(model)));
    TangentEngine moving = engine_of_case(study, solver, compilation, at.with_derivatives);
    const InputsOverTime inputs = inputs_of(study, compilation.model, at.values);
    return driven({study, at.values, at.kept, compilation, moving, inputs, std::move(set)}, is_stopped);
  } catch (const UserError& error) {
    return failed(study, first_line(error.what()));
  }
}

std::optional<CaseResult> run_case(const Study& study, const StudySolver& solver, long index,
                                   const std::function<bool()>& is_stopped) {
  const std::string kept = study.arguments.keep.empty() ? "" : kept_file(study, index);
  return run_at(study, solver, {study.grid.values_of(index), kept}, is_stopped);
}

}  // namespace mbgen
