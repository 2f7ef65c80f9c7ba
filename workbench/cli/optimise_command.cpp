// mbgen optimise: the best design of a model by goals, within bounds and constraints.

#include <fmt/format.h>

#include <memory>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/optimise/optimise.hpp"
#include "workbench/search/found_model.hpp"
#include "workbench/sweep/sweep_parts.hpp"

namespace mbgen::cli {
namespace {

struct OptimiseOptions {
  optimise::OptimiseArguments search;
  std::string out, page;
  int jobs = 0;  ///< 0: one per processor
  bool json = false;
};

/// Fails: UserError for files that cannot be written, before the work.
void check_files(const OptimiseOptions& options) {
  const optimise::OptimiseArguments& search = options.search;
  if (is_special(options.out) && !options.out.empty())
    throw UserError(
        fmt::format("{}: cannot write: an optimisation keeps a journal beside its result, name a file\n", options.out));
  std::vector<std::string> read{search.model.path};
  read.insert(read.end(), search.manoeuvres.begin(), search.manoeuvres.end());
  if (!options.out.empty()) require_other_file(options.out, read);
  if (!options.page.empty()) require_other_file(options.page, read);
  require_written_apart(
      {{"--out", options.out}, {"--report", options.page}, {"the journal beside --out", journal_beside(options.out)}});
  if (options.out.empty() || !search.trade_off.empty()) return;
  std::vector<std::string> names;
  for (const std::vector<std::string>* texts : {&search.free, &search.model.set})
    for (const std::string& text : *texts) names.push_back(text.substr(0, text.find('=')));
  require_places(search.model.path, names, options.out);
}

/// Writes the files. Result: the exit code.
int write_result(const OptimiseOptions& options, const optimise::OptimiseResult& result) {
  const bool is_design = !result.is_trade_off();
  if (!options.page.empty()) write_file(options.page, optimise::optimise_page(result), result.files);
  if (!options.out.empty() && !is_design) write_file(options.out, optimise::trade_off_csv(result), result.files);
  if (!options.out.empty() && is_design && result.best.keeps_constraints)
    write_file(options.out, optimise::optimised_model(result, options.out), result.files);
  print(options.json ? optimise::optimise_json(result) : optimise::optimise_text(result));
  if (!is_design || result.best.keeps_constraints) return kDone;
  print_message(
      "optimise: no design was found that keeps all constraints: {}\n{}  hint: other bounds or start values, "
      "--global, or a wider limit\n",
      result.best.status, options.out.empty() ? "" : fmt::format("  {} is not written\n", options.out));
  return kUserFault;
}

int run_optimise(OptimiseOptions options) {
  options.search.jobs = options.jobs > 0 ? options.jobs : processors();
  check_files(options);
  options.search.journal = journal_beside(options.out);
  try {
    return write_result(options, optimise::optimise_model(options.search));
  } catch (const Interrupted&) {
    if (!options.out.empty())
      print_message("optimise: interrupted; {} keeps its evaluations: run the same command again to go on\n",
                    options.search.journal);
    throw;
  }
}

void add_rig_options(NamedCommand command, KcSettings& rig) {
  command.add_option("--travel", rig.travel, "m, of rig curves without a table (default 0.05)");
  command.add_option("--steer", rig.steer, "rad or m, likewise");
  command.add_option("--force", rig.force, "N, likewise");
  command.add_option("--moment", rig.moment, "N m, likewise");
}

void add_method_options(NamedCommand command, OptimiseOptions& options) {
  optimise::OptimiseArguments& search = options.search;
  command
      .add_option("--method", search.method,
                  "slsqp (default), mma, or cobyla, which takes no derivatives, for goals with corners")
      .one_of({"slsqp", "mma", "cobyla"});
  command.add_option("--global", search.starts, "search from so many starts, evenly spread over the bounds")
      .between(1, 100000);
  command.add_option("--trade-off", search.trade_off, "GOAL,GOAL: the curve of designs that are best for both");
  command.add_option("--points", search.points, "of the trade-off").with_shown_default().between(2, 1000);
  command.add_option("--evaluations", search.most_evaluations, "at most, of each search")
      .with_shown_default()
      .between(1, 1000000);
  add_journal_options(command, options.jobs, search.restart);
}

}  // namespace

void add_optimise(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<OptimiseOptions>();
  NamedCommand command = application.add_command("optimise", "find the best design by goals and constraints");
  command.footer(
      "Example: mbgen optimise models/fit/quarter_vehicle.json --free k=1e4:6e4,c \\\n"
      "             --goal \"min:rms(body_acceleration)\" --constraint \"range(spring_length)<=0.04\" -o best.json\n"
      "MEASURE is start:OUTPUT, mode:K:frequency, mode:K:damping, kc:AXLE:FIGURE, kc:AXLE:CURVE:COLUMN, a metric of "
      "the\n"
      "motion as in sweep, or a number of the manoeuvre. FILE.journal beside --out keeps the evaluations. See\n"
      "docs/use/optimise.md.");
  optimise::OptimiseArguments& search = options->search;
  add_model_argument(command, search.model.path);
  command
      .add_option("--free", search.free,
                  "NAME, NAME=LOW:HIGH or NAME=LOW:START:HIGH: design variables, any parameters; separated by commas")
      .required()
      .separated_by(',');
  command
      .add_option("--goal", search.goals,
                  "[NAME=]min:MEASURE, max:MEASURE or min:MEASURE~TARGET, each with :SCALE behind; separated by commas")
      .required()
      .one_value_at_a_time();
  command
      .add_option("--constraint", search.constraints,
                  "MEASURE<=LIMIT, MEASURE>=LIMIT, MEASURE==VALUE or LOW<=MEASURE<=HIGH; separated by commas")
      .one_value_at_a_time();
  command.add_option("--manoeuvre", search.manoeuvres, "manoeuvre that is driven in place of the free motion")
      .one_value_at_a_time();
  command.add_option("-o,--out", options->out,
                     "model with the found values, which includes MODEL (JSON); of a trade-off its points (CSV)");
  command.add_option("--report", options->page, "page with tables and pictures (HTML)");
  add_method_options(command, *options);
  add_rig_options(command, search.rig);
  add_set_option(command, search.model.set);
  add_simulation_options(command, search.model.simulation);
  add_engine_options(command, search.model.engine);
  add_json_option(command, options->json);
  command.callback([options, command, &exit_code] {
    options->search.model.has_engine = command.is_given("--engine");
    exit_code = run_optimise(*options);
  });
}

}  // namespace mbgen::cli
