#include "workbench/sweep/sweep_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/manoeuvre/manoeuvre_run.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/sweep/metric_derivatives.hpp"

namespace mbgen {
namespace {

/// Lets the varied parameters be tunable, or finds out why they cannot.
void choose_tuning(Study& study) {
  const std::vector<VariedParameter> varied = varied_parameters(study, {}, true);
  if (varied.size() == study.set.size()) return;
  Result<Model> model = model_with(study, varied);
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
      if (axis.of == SweepAxis::Of::parameter && parameter.name == axis.name) {
        throw UserError(
            fmt::format("--set {0}: {1} gives \"{0}\" its values\n", axis.name, study.arguments.vary_option));
      }
    }
    for (const std::string& assignment : study.arguments.engine.inputs) {
      if (axis.of == SweepAxis::Of::input && assignment.substr(0, assignment.find('=')) == axis.name) {
        throw UserError(
            fmt::format("--input {0}: {1} gives \"{0}\" its values\n", axis.name, study.arguments.vary_option));
      }
    }
  }
}

void require_others_inputs(const Study& study) {
  mbgen::require_others_inputs(study.model, "--input", study.arguments.engine.inputs);
  for (const SweepAxis& axis : study.grid.axes)
    if (axis.of == SweepAxis::Of::input) mbgen::require_others_inputs(study.model, "--vary", {axis.name});
}

/// Lets the vehicle start at the speed of the manoeuvre, in all cases or in each at its own.
void set_start_speed(Study& study, const Manoeuvre& manoeuvre, std::vector<std::string>& set) {
  const std::optional<VariedParameter> speed = start_speed(manoeuvre, study.model);
  if (!speed) return;
  const auto is_varied = [&](const std::string& name) {
    const auto is_it = [&](const SweepAxis& axis) { return axis.name == name; };
    return std::any_of(study.grid.axes.begin(), study.grid.axes.end(), is_it);
  };
  const std::string name = std::string(kOfManoeuvre) + "speed";
  if (is_varied(speed->name))
    throw UserError(fmt::format("{} {}: the manoeuvre says at which speed it starts; vary {}\n",
                                study.arguments.vary_option, speed->name, name));
  if (is_varied(name)) {
    study.start_speed = speed->name;
    const std::string given = speed->name + "=";
    if (std::any_of(set.begin(), set.end(), [&](const std::string& text) { return text.starts_with(given); }))
      throw UserError(fmt::format("--set {}: the manoeuvre says at which speed it starts\n", speed->name));
  } else {
    set.push_back(fmt::format("{}={}", speed->name, *speed->value));
  }
}

/// The model of the study, its grid, and its manoeuvre. Fails: UserError.
void read_files(Study& study) {
  const StudyArguments& arguments = study.arguments;
  study.model = expect(read_model_file(arguments.model));
  study.set = set_parameters(study.model, arguments.set);
  if (!arguments.manoeuvre.empty()) study.manoeuvre = read_text(arguments.manoeuvre);
  std::vector<std::string> set = arguments.set;
  std::optional<Manoeuvre> manoeuvre;
  if (!study.manoeuvre.empty()) {
    manoeuvre = expect(read_manoeuvre(study.manoeuvre, arguments.manoeuvre));
    study.notes = base_of(*manoeuvre).notes;
  }
  study.grid = read_grid(arguments.vary, study.model, study.manoeuvre);
  if (manoeuvre) set_start_speed(study, *manoeuvre, set);
  study.set = set_parameters(study.model, set);
  study.model = expect(model_with(study, study.set));
  SimulationArguments simulation = arguments.simulation;
  if (manoeuvre) run_of(*manoeuvre, arguments.manoeuvre, study.model, simulation);
  study.settings = settings_of(simulation, study.model.solver);
}

}  // namespace

std::vector<VariedParameter> varied_parameters(const Study& study, const std::vector<double>& values, bool tunable) {
  const std::string speed = std::string(kOfManoeuvre) + "speed";
  std::vector<VariedParameter> varied = study.set;
  for (std::size_t a = 0; a < study.grid.axes.size(); ++a) {
    const SweepAxis& axis = study.grid.axes[a];
    const bool is_speed = axis.name == speed && !study.start_speed.empty();
    if (axis.of != SweepAxis::Of::parameter && !is_speed) continue;
    VariedParameter parameter{is_speed ? study.start_speed : axis.name, std::nullopt, tunable};
    if (!values.empty()) parameter.value = values[a];
    varied.push_back(std::move(parameter));
  }
  return varied;
}

Result<Model> model_with(const Study& study, const std::vector<VariedParameter>& varied) {
  Result<Model> model = read_varied_model(study.arguments.model, varied);
  if (model && !study.manoeuvre.empty())
    prepare_model(*model, expect(read_manoeuvre(study.manoeuvre, study.arguments.manoeuvre)));
  return model;
}

InputsOverTime inputs_of(const Study& study, const Model& model, const std::vector<double>& values) {
  std::vector<std::string> assignments = study.arguments.engine.inputs;
  for (std::size_t a = 0; a < values.size(); ++a) {
    const SweepAxis& axis = study.grid.axes[a];
    if (axis.of == SweepAxis::Of::input) assignments.push_back(fmt::format("{}={}", axis.name, values[a]));
  }
  return mbgen::inputs_of(model, assignments, study.arguments.simulation);
}

namespace {

/// Fails: UserError for a metric with the name of another column of the table.
void require_own_columns(const Study& study) {
  for (const Metric& metric : study.metrics.list) {
    const auto is_its_name = [&](const SweepAxis& axis) { return axis.name == metric.name; };
    const bool is_varied = std::ranges::any_of(study.grid.axes, is_its_name);
    if (is_varied || metric.name == "case" || metric.name == "status")
      throw UserError(
          fmt::format("{}: the table has another column \"{}\"{}\n  hint: give the metric another name, "
                      "NAME=EXPRESSION\n",
                      study.arguments.metric_option, metric.name, is_varied ? ", which is varied" : ""));
  }
}

}  // namespace

Study read_study(const StudyArguments& arguments) {
  Study study;
  study.arguments = arguments;
  read_files(study);
  study.metrics = expect(read_metrics(arguments.metrics, study.model, arguments.metric_option));
  follow_step(study.settings, study.set, study.model);
  require_whole_periods(study.settings, study.model);
  const double end = static_cast<double>(study.settings.steps) * study.settings.step;
  const std::optional<double> instant = instant_outside(study.metrics, end);
  if (instant && study.manoeuvre.empty()) {  // each case has its own duration
    throw UserError(fmt::format("{}: at({}, ...) is not in the motion, which lasts {} s\n", arguments.metric_option,
                                *instant, end));
  }
  study.choice = chosen_engine(arguments.engine);
  require_engine(study.choice.name);
  study.choice.integrator = study.model.solver.integrator =
      integrator_of(arguments.simulation.integrator, study.model.solver.integrator, study.choice.name);
  check_given_once(study);
  require_own_columns(study);
  if (!study.manoeuvre.empty()) require_others_inputs(study);
  study.warnings = inputs_of(study, study.model, study.grid.values_of(0)).warnings;
  choose_tuning(study);
  return study;
}

bool is_kept_motion(const Study& study, const std::string& path) {
  if (study.arguments.keep.empty()) return false;
  const std::string name = std::filesystem::path(path).filename().string();
  const std::size_t first = name.find_first_of("123456789");
  long number = 0;
  if (first == std::string::npos) return false;
  std::from_chars(name.data() + first, name.data() + name.size(), number);
  if (number < 1 || number > study.grid.size()) return false;
  const std::string kept = kept_file(study, number - 1);
  return is_same_file(path, kept) || is_same_file(path, run_file(kept));
}

std::string kept_file(const Study& study, long index) {
  const std::size_t digits = fmt::format("{}", study.grid.size()).size();
  return (std::filesystem::path(study.arguments.keep) / fmt::format("case_{:0{}}.csv", index + 1, digits)).string();
}

std::string description(const Study& study) {
  using Json = nlohmann::ordered_json;
  const StudyArguments& arguments = study.arguments;
  Json vary = Json::object(), set = Json::object();
  for (const SweepAxis& axis : study.grid.axes) vary[axis.name] = axis.values;
  for (const VariedParameter& parameter : study.set) set[parameter.name] = *parameter.value;
  Hash table;
  if (!arguments.simulation.input_table.empty()) table.add(read_text(arguments.simulation.input_table));
  Json words = {{"mbgen", kMbgenVersion},
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
  if (!study.manoeuvre.empty()) {
    Hash manoeuvre;
    manoeuvre.add(study.manoeuvre);
    words["manoeuvre"] = manoeuvre.text();
  }
  if (!arguments.keep.empty()) words["keep"] = {arguments.keep, arguments.every};
  return words.dump(-1, ' ', false, Json::error_handler_t::replace);
}

StudySolver prepare(const Study& study) {
  if (!study.is_tuned) return {};
  if (study.choice.name != "generated") return {expect(decide(study.model)), nullptr};
  StudySolver solver{expect(decide_to_write(study.model)), nullptr};
  solver.table = load_solver(solver.compilation, study.choice);
  return solver;
}

std::string add_derivatives(const Study& study, StudySolver& solver) {
  if (!solver.table) return "no generated solver";
  if (!study.manoeuvre.empty()) return "a manoeuvre is driven";
  for (const SweepAxis& axis : study.grid.axes) {
    if (axis.of != SweepAxis::Of::parameter) return fmt::format("\"{}\" is no parameter", axis.name);
  }
  std::string reason = why_no_derivatives(study.metrics, study.model.parameters);
  if (!reason.empty()) return reason;
  solver.tangents = load_tangents(solver.compilation, study.choice);
  return "";
}

}  // namespace mbgen
