// mbgen simulate: a motion, as a table in a file and a summary.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/inverse_path.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/engines/auto_engine.hpp"
#include "workbench/engines/compile_solver.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/engines/kept_decisions.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/manoeuvre/manoeuvre_run.hpp"
#include "workbench/motion/controlled_engine.hpp"
#include "workbench/motion/motion_end.hpp"
#include "workbench/motion/motion_judge.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/motion/simulation_text.hpp"
#include "workbench/sensitivity/jump_watch.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {
namespace {

struct SimulateOptions {
  std::string model, form, file, format, manoeuvre, path;
  bool inverse = false;
  std::vector<std::string> set, sensitivities;
  SimulationArguments simulation;
  std::optional<double> tolerance;  ///< of error control
  long every = 1;
  EngineArguments engine;
  bool json = false;
};

/// A motion and the facts around it.
struct Run {
  JudgedMotion motion;
  std::vector<MovedValue> moved;  ///< of the start
  int signal = 0;                 ///< that stopped it
};

Run compute(const Compilation& compilation, const EngineChoice& choice, TangentEngine& moving,
            const InputsOverTime& inputs, SimulationSettings settings, const std::optional<ErrorControl>& control,
            MotionTable& table, ManoeuvreRun* manoeuvre, JumpWatch* jumps) {
  const Engine& engine = moving.engine;
  Start start = initial_start(compilation, inputs.at(0));
  start.state = initial_state(start, engine);
  start_motion(compilation, start.state, moving);
  print_notes(start_notes(compilation, start));
  if (manoeuvre) manoeuvre->look_at_steering(compilation, start.state, inputs.at(0));
  Progress progress("simulate");
  BlockedSignals signals;
  settings.is_stopped = [&] { return signals.taken() != 0; };
  const MotionTask task{.compilation = compilation,
                        .engine = engine,
                        .integrator = choice.integrator,
                        .settings = settings,
                        .start = start.state,
                        .inputs = inputs,
                        .error_control = control,
                        .control = manoeuvre ? manoeuvre->control(settings.step) : InputControl()};
  Run run{judged_motion(task,
                        [&](const Sample& sample) {
                          table.add(sample, output_derivatives(moving));
                          if (jumps) jumps->add(sample);
                          progress.show(sample.step, settings.steps);
                        }),
          start.moved};
  if (run.motion.summary.is_stopped) run.signal = signals.taken();
  progress.clear();
  if (manoeuvre) manoeuvre->judge(run.motion.verdict);
  return run;
}

/// Warnings, and why there is no good result, on standard error.
int print_outcome(const Compilation& compilation, const JudgedMotion& motion, const std::string& file) {
  const StepVerdict& verdict = motion.verdict;
  for (const std::string& warning : verdict.warnings) print_message("simulate: warning: {}\n", warning);
  if (motion.summary.status.ok() && verdict.failure.empty()) return kDone;
  if (motion.summary.status.ok()) {
    print_message("simulate: {}; {} holds the motion\n", verdict.failure, shown_name(file));
    return kUserFault;
  }
  print_message("simulate: {}; {} holds the motion up to there\n", end_text(compilation, motion), shown_name(file));
  for (const std::string& hint : hints_of_end(compilation, motion)) print_message("  hint: {}\n", hint);
  return kUserFault;
}

/// The integrator that suits the modes of the start; standard error says which and why.
SolverSettings::Integrator chosen_integrator(const Model& model, const SimulateOptions& options,
                                             const SimulationSettings& settings, const std::string& engine) {
  if (is_cartesian(engine)) return SolverSettings::Integrator::rk4;
  const Compilation decided = expect(decide(Model(model)));
  const auto inputs = inputs_of(decided.model, options.engine.inputs, options.simulation).at(0);
  const auto modes = modes_near(decided, initial_start(decided, inputs).state, inputs);
  const IntegratorChoice chosen = choose_integrator(decided, settings, modes);
  print_message("simulate: integrator {}: {}\n", name_of(chosen.integrator), chosen.reason);
  return chosen.integrator;
}

/// Forces along a path in place of a motion. Fails: UserError for options of a motion.
int run_inverse(const SimulateOptions& options) {
  const std::pair<const char*, bool> others[] = {{"--manoeuvre", !options.manoeuvre.empty()},
                                                 {"--tolerance", options.tolerance.has_value()},
                                                 {"--integrator", !options.simulation.integrator.empty()}};
  for (const auto& [name, is_given] : others)
    if (is_given) throw UserError(fmt::format("simulate --inverse: {} is of a motion: leave it out\n", name));
  return run_inverse_path({options.model, options.path, options.form, options.file, options.format, options.set,
                           options.engine, options.simulation, options.every, options.json});
}

/// Warns of derivatives past a singular position, which are those of the branch that the step found, and past a jump.
void doubt_derivatives(const JumpWatch& jumps, JudgedMotion& motion) {
  std::optional<double> first;
  for (const BlockEvents& block : motion.summary.blocks)
    if (block.singular_met > 0)
      first = std::min(first.value_or(block.singular_times.front()), block.singular_times.front());
  if (first)
    motion.verdict.warnings.push_back(fmt::format(
        "derivatives after t = {:.6g} s are not exact: the motion passed a singular position there", *first));
  if (!jumps.warning().empty()) motion.verdict.warnings.push_back(jumps.warning());
}

/// Fails: UserError for options whose motion has no derivatives.
void require_derivatives(const SimulateOptions& options, const std::string& engine,
                         const std::optional<ErrorControl>& control) {
  if (options.sensitivities.empty()) return;
  if (!options.manoeuvre.empty())
    throw UserError("simulate: --sensitivities needs inputs that no driver moves: leave out --manoeuvre\n");
  if (control) throw UserError("simulate: --sensitivities needs a fixed step: rk4, abm4 or rosenbrock\n");
  if (engine != "generated" && engine != kAutoEngine)
    throw UserError(fmt::format("simulate: --sensitivities is of the generated solver, not of --engine {}\n", engine));
}

TangentEngine engine_of(const Compilation& compilation, const EngineChoice& choice,
                        const std::shared_ptr<const SolverTable>& kept, const std::vector<std::string>& sensitivities) {
  if (!sensitivities.empty()) return make_tangent_engine(compilation, choice, sensitivities);
  return make_moving_engine({kept, nullptr}, compilation, choice, sensitivities);
}

/// Replaces --engine auto by the engine that suits the motion, which standard error names. Result: its solver, if it is
/// kept.
std::shared_ptr<const SolverTable> settle_engine(const Compilation& compilation, long steps, EngineChoice& choice) {
  if (choice.name != kAutoEngine) return nullptr;
  AutoEngine chosen = auto_engine(compilation, choice, steps);
  print_message("simulate: engine {}: {}\n", chosen.name, chosen.reason);
  choice.name = chosen.name;
  return std::move(chosen.kept);
}

int run(SimulateOptions options) {
  if (options.inverse) return run_inverse(options);
  if (!options.path.empty()) throw UserError("simulate: --path is of --inverse\n");
  EngineChoice choice = chosen_engine(options.engine);
  choice.form = chosen_form(options.form);
  Model model = read_set_model(options.model, options.set, options.sensitivities, "--sensitivities");
  const auto manoeuvre = prepare_manoeuvre(options.manoeuvre, options.model, options.set, model, options.simulation);
  if (manoeuvre) require_others_inputs(model, "--input", options.engine.inputs);
  const SimulationSettings settings = settings_of(options.simulation, model.solver);
  std::vector<VariedParameter> set = set_parameters(model, options.set, options.sensitivities, "--sensitivities");
  follow_step(settings, set, model);
  const std::optional<ErrorControl> control = error_control_of(options.simulation.integrator, options.tolerance, model);
  choice.integrator = model.solver.integrator =
      options.simulation.integrator == "auto"
          ? chosen_integrator(model, options, settings, choice.name)
          : integrator_of(control ? "" : options.simulation.integrator, model.solver.integrator, choice.name);
  require_derivatives(options, choice.name, control);
  if (!options.sensitivities.empty()) choice.name = "generated";
  const Compilation compilation = expect(decide_for(std::move(model), choice));
  const auto kept = settle_engine(compilation, settings.steps, choice);
  if (options.every < 1) throw UserError(fmt::format("--every: must be positive, found {}\n", options.every));
  count_notes(compilation);
  require_whole_periods(settings, compilation.model);
  const InputsOverTime inputs = inputs_of(compilation.model, options.engine.inputs, options.simulation);
  for (const std::string& warning : inputs.warnings) print_message("{}", warning);
  std::vector<std::string> read = compilation.model.files;
  read.insert(read.end(), {options.simulation.input_table, options.manoeuvre});
  MotionTable table(options.file, table_format(options.format, options.file), compilation, settings.step, options.every,
                    std::move(read), derivative_headings(compilation.model, options.sensitivities));
  TangentEngine engine = engine_of(compilation, choice, kept, options.sensitivities);
  std::optional<JumpWatch> jumps;
  if (!options.sensitivities.empty()) jumps.emplace(compilation, options.sensitivities);
  Run run = compute(compilation, choice, engine, inputs, settings, control, table, manoeuvre.get(),
                    jumps ? &*jumps : nullptr);
  if (jumps) doubt_derivatives(*jumps, run.motion);
  const JudgedMotion& motion = run.motion;
  const SimulationRecord record{compilation,
                                choice,
                                settings,
                                motion.summary,
                                options.file,
                                table.finish(),
                                options.every,
                                motion.verdict,
                                run.moved,
                                options.set,
                                inputs.is_constant && !manoeuvre,
                                motion.control,
                                manoeuvre ? manoeuvre->words() : ManoeuvreWords()};
  table.commit(run_json(record));
  print_beside(options.file, options.json ? summary_json(record) : summary_text(record));
  const int exit_code = print_outcome(compilation, motion, options.file);
  if (run.signal == 0) return exit_code;
  print_message(
      "simulate: interrupted at t = {:.10g} s; {} holds the motion up to there, run the same command again for "
      "all of it\n",
      motion.summary.end_time, shown_name(options.file));
  throw Interrupted{run.signal};
}

}  // namespace

void add_simulate(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<SimulateOptions>();
  NamedCommand command = application.add_command("simulate", "compute a motion, write it as a table (CSV or MAT)");
  command.footer(
      "Example: mbgen simulate models/coach.json --duration 5 --step 1e-3 --out coach.csv\n"
      "Prints a summary; the file appears when it is complete. With --out - the table goes to standard output and the\n"
      "summary to standard error. When the motion cannot go on, the file holds\n"
      "the rows up to there, standard error says why, and the exit code is 1.\n"
      "Beside a CSV file FILE.run.json says which run it is of, for mbgen report; a MAT file holds that itself.\n"
      "Inputs keep their values (--input), or follow a table (--input-table steer.csv), whose header names them:\n"
      "  t [s],steer [rad],torque [N m]\n"
      "An input with a derivative among the inputs continues with it; where the table has no column for the\n"
      "derivative, it is the derivative of the curve through the rows.\n"
      "--integrator cvode (stiff models) or cvode-adams steps with error control (SUNDIALS); --step is then the\n"
      "interval of the table's rows alone.\n"
      "--engine auto takes the generic engine where its motion is over before a solver would be compiled.\n"
      "Where the step is too long for the model (its fastest mode, or an energy balance off by 0.1 %), standard error\n"
      "says so and names one that would do; values that blow up and an energy balance off by 10 % are an error.");
  add_model_argument(command, options->model);
  add_simulation_options(command, options->simulation);
  command.add_option("--manoeuvre", options->manoeuvre,
                     "file of a manoeuvre that moves the inputs (docs/use/manoeuvres.md)");
  command.add_option("--tolerance", options->tolerance,
                     "of cvode and cvode-adams: error of a step, relative, and absolute in SI units (default 1e-6)");
  command.add_flag("--inverse", options->inverse,
                   "the forces of the actuators along --path, in place of a motion (docs/use/actuators.md)");
  command.add_option(
      "--path", options->path,
      "of --inverse: table (CSV) of coordinates over time, splined; columns t and names of coordinates; not "
      "needed where motions determine all");
  command
      .add_option("--sensitivities", options->sensitivities,
                  "parameters, separated by commas: columns with the exact derivatives of all outputs by them "
                  "(docs/use/sensitivities.md)")
      .one_value_at_a_time()
      .separated_by(',');
  command.add_option("-o,--out", options->file, "table of the motion; - for standard output").required();
  command.add_option("--format", options->format, "csv or mat (level 4) (default: by the ending of --out)");
  command.add_option("--every", options->every, "write every n-th step, and the last (default 1)");
  add_set_option(command, options->set);
  add_form_option(command, options->form);
  add_engine_options(command, options->engine);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
