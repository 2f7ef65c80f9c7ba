// mbgen bench: the nine steps of the paper's tables and the time of one evaluation, every engine in one process.

#include <fmt/format.h>

#include <memory>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/cost/bench_measure.hpp"
#include "workbench/cost/bench_states.hpp"
#include "workbench/cost/bench_text.hpp"
#include "workbench/cost/paper_tables.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/start/states_file.hpp"

namespace mbgen::cli {
namespace {

struct BenchOptions {
  std::string model, form, states;
  std::vector<std::string> set;
  long evaluations = kPaperEvaluations;
  EngineArguments engine;
  int lanes = 0;
  bool json = false;
};

/// Every engine; on request the generated one also in lanes, the generic one with every linear algebra.
std::vector<EngineChoice> choices(const EngineChoice& common, int lanes) {
  std::vector<EngineChoice> list;
  for (const std::string& name : engine_names()) {
    EngineChoice choice = common;
    choice.name = name;
    choice.use = SolverUse::timing_steps;
    if (name != "generic") {
      list.push_back(choice);
      if (name != "generated" || lanes == 0) continue;
      choice.use = SolverUse::timing;
      choice.lanes = lanes;
      list.push_back(choice);
      continue;
    }
    for (const LinearAlgebra library :
         {LinearAlgebra::entries, LinearAlgebra::eigen, LinearAlgebra::blas, LinearAlgebra::sparse}) {
      choice.algebra = {library, Factorisation::lu};
      list.push_back(choice);
    }
    choice.algebra = {LinearAlgebra::eigen, Factorisation::qr};
    list.push_back(choice);
  }
  return list;
}

/// The generic engine on Eigen: reference of errors if the states contain no accelerations.
const Engine& reference_engine(const std::vector<Engine>& engines) {
  for (const Engine& engine : engines) {
    if (engine.name == "generic") return engine;
  }
  return engines.front();
}

int run(const BenchOptions& options) {
  if (options.evaluations < 1) {
    throw UserError(fmt::format("--evaluations: must be positive, found {}\n", options.evaluations));
  }
  const Compilation compilation =
      expect(decide_to_write(read_set_model(options.model, options.set), chosen_form(options.form)));
  const std::vector<double> inputs = input_values(compilation.model, options.engine.inputs);
  std::vector<Engine> engines;
  for (EngineChoice choice : choices(options.engine.choice, options.lanes)) {
    choice.form = chosen_form(options.form);
    engines.push_back(make_engine(compilation, choice));
    engines.back().set_inputs(inputs);
  }
  const Engine& reference = reference_engine(engines);
  std::vector<FileState> states = options.states.empty() ? random_states(compilation, reference, inputs)
                                                         : read_states(options.states, compilation, inputs).states;
  if (states.empty()) throw UserError(fmt::format("{}: has no states\n", options.states));
  complete(states, reference, compilation);
  const std::vector<LoadedState> at = timed_states(states, options.lanes);
  BenchRecord record{compilation.model.name, options.evaluations, measure(engines, at, options.evaluations)};
  for (Measurement& measurement : record.measurements) {
    measurement.largest_error = largest_error(*measurement.engine, compilation, states);
  }
  print(options.json ? bench_json(record) : bench_text(record));
  return kDone;
}

}  // namespace

void add_bench(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<BenchOptions>();
  NamedCommand command =
      application.add_command("bench", "measure the nine steps and the time of one evaluation, per engine");
  command.footer(fmt::format(
      "Example: mbgen bench models/coach.json --json\n"
      "The engines take {} turns at the same states; times are medians, the spread is the distance of the quartiles\n"
      "over the median, the error is that to the \"zdd\" of the states, or to the generic engine where there are "
      "none.\n"
      "The steps are shares by a clock read after each, of the whole as timed without it. An engine that would need\n"
      "more than {} s makes fewer evaluations, in {} turns.",
      kTurns, kLongestMeasurement, kTurnsOfSlowEngines));
  add_model_argument(command, options->model);
  command.add_option("--states", options->states, "file of states as for evaluate (default: random consistent ones)");
  command.add_option("--evaluations", options->evaluations,
                     fmt::format("of each engine (default: {}, as in the paper)", kPaperEvaluations));
  add_batch_option(command, options->lanes);
  add_set_option(command, options->set);
  add_run_options(command, options->engine);
  add_form_option(command, options->form);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
