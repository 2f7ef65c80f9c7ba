// mbgen simulate: a motion, as a table in a file and a summary.

#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/motion_table.hpp"
#include "compiler/cli/notes.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/progress.hpp"
#include "compiler/cli/simulation.hpp"
#include "compiler/cli/simulation_options.hpp"
#include "compiler/cli/simulation_text.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

/// Rows that a table has at most unless --every is given: enough for every plot.
constexpr long kRows = 10000;

struct SimulateOptions {
  std::string model, form, file, format;
  SimulationArguments simulation;
  long every = 0;
  EngineArguments engine;
  bool json = false;
};

/// Rows between two written ones: first, last and every n-th point are written.
long decimation(const SimulateOptions& options, long steps) {
  if (options.every < 0) throw UserError(fmt::format("--every: must be positive, found {}\n", options.every));
  return options.every > 0 ? options.every : (steps + kRows - 3) / (kRows - 2);
}

int run(const SimulateOptions& options) {
  EngineChoice choice = chosen_engine(options.engine);
  const std::optional<Form> form = chosen_form(options.form);
  const Compilation compilation =
      expect(choice.name == "generated" ? compile(options.model, form) : decide(options.model));
  require_other_file(options.file, compilation.model.files);
  require_other_file(options.file, {options.simulation.input_table});
  const SimulationSettings settings = settings_of(options.simulation, compilation.model.solver);
  const InputsOverTime inputs =
      inputs_over_time(compilation.model, options.engine.inputs, options.simulation.input_table);
  choice.integrator = integrator_of(options.simulation.integrator, compilation.model.solver.integrator, choice.name);
  MotionTable table(options.file, table_format(options.format, options.file), compilation,
                    decimation(options, settings.steps));
  const Engine engine = make_engine(compilation, choice);
  const Start start = initial_start(compilation, inputs.at(0));
  print_notes(moved_notes(compilation, start.moved));

  Progress progress(settings.steps);
  const SimulationSummary summary = simulate(engine, start.state, inputs, settings, [&](const Sample& sample) {
    table.add(sample);
    progress.show(sample.step);
  });
  progress.clear();
  const SimulationRecord record{compilation, choice, settings, summary, options.file, table.finish(), start.moved};
  table.commit(run_json(record));
  print(options.json ? summary_json(record) : summary_text(record));
  if (summary.status.ok()) return kDone;
  fmt::print(stderr, "simulate: stopped after t = {} s: {}; {} holds the motion up to there\n", summary.end_time,
             describe(compilation, summary.status), options.file);
  return kUserFault;
}

}  // namespace

void add_simulate(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = application.add_subcommand("simulate", "compute a motion, write it as a table (CSV or MAT)");
  command->footer(
      "Example: mbgen simulate models/coach.json --duration 5 --step 1e-3 --out coach.csv\n"
      "Prints a summary; the file appears when it is complete. When the motion cannot go on, the file holds\n"
      "what there is, standard error says why, and the exit code is 1.\n"
      "Beside a CSV file FILE.run.json says which run it is of, for mbgen report; a MAT file holds that itself.\n"
      "Inputs keep their values (--input), or follow a table (--input-table steer.csv), whose header names them:\n"
      "  t [s],steer [rad],torque [N m]\n"
      "An input with a derivative among the inputs continues with it; where the table has no column for the\n"
      "derivative, a cubic spline through the input's column gives both.");
  add_model_argument(*command, options->model);
  add_simulation_options(*command, options->simulation);
  command->add_option("-o,--out", options->file, "table of the motion")->required();
  command->add_option("--format", options->format, "csv or mat (level 4) (default: by the ending of --out)");
  command->add_option("--every", options->every,
                      fmt::format("write every n-th step (default: at most {} rows)", kRows));
  add_form_option(*command, options->form);
  add_engine_options(*command, options->engine);
  add_json_option(*command, options->json);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
