// mbgen fit: parameters of a model from measurements.

#include <fmt/format.h>

#include <memory>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/fit/fit.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/search/found_model.hpp"
#include "workbench/sweep/sweep_parts.hpp"

namespace mbgen::cli {
namespace {

struct FitOptions {
  fit::FitArguments fit;
  std::string out, page;
  int jobs = 0;  ///< 0: one per processor
  bool json = false;
};

int run_fit(FitOptions options) {
  options.fit.jobs = options.jobs > 0 ? options.jobs : processors();
  if (is_special(options.out) && !options.out.empty())
    throw UserError(
        fmt::format("{}: cannot write: a fit keeps a journal beside its result, name a file\n", options.out));
  std::vector<std::string> read{options.fit.model.path};
  for (const std::vector<std::string>* files : {&options.fit.data, &options.fit.held_out})
    read.insert(read.end(), files->begin(), files->end());
  if (!options.out.empty()) require_other_file(options.out, read);
  if (!options.page.empty()) require_other_file(options.page, read);
  require_written_apart(
      {{"--out", options.out}, {"--report", options.page}, {"the journal beside --out", journal_beside(options.out)}});
  if (!options.out.empty()) {
    std::vector<std::string> names;
    for (const std::vector<std::string>* texts : {&options.fit.free, &options.fit.model.set})
      for (const std::string& text : *texts) names.push_back(text.substr(0, text.find('=')));
    require_places(options.fit.model.path, names, options.out);
  }
  options.fit.journal = journal_beside(options.out);
  try {
    const fit::FitResult result = fit::fit_model_to_data(options.fit);
    if (!options.out.empty()) write_file(options.out, fit::fitted_model(result, options.out), result.files);
    if (!options.page.empty()) write_file(options.page, fit::fit_page(result), result.files);
    print(options.json ? fit::fit_json(result) : fit::fit_text(result));
  } catch (const Interrupted&) {
    if (!options.out.empty())
      print_message("fit: interrupted; {} keeps its evaluations: run the same command again to go on\n",
                    options.fit.journal);
    throw;
  }
  return kDone;
}

void add_search_options(NamedCommand command, FitOptions& options) {
  fit::FitArguments& fit = options.fit;
  command
      .add_option("--free-start", fit.free_start,
                  "z.NAME=LOW:HIGH or zd.NAME=LOW:HIGH: a coordinate or velocity at the start, found for each run; "
                  "separated by commas")
      .separated_by(',');
  command
      .add_option("--nuisance", fit.nuisance,
                  "OUTPUT:gain:bias:delay: faults of a channel that are found beside the parameters, any of the three; "
                  "* for all channels; separated by commas")
      .separated_by(',');
  command.add_option("--loss", fit.loss,
                     "squares (default), huber:LIMIT or cauchy:LIMIT: less weight for outliers "
                     "beyond so many standard deviations");
  command.add_option("--iterations", fit.most_iterations, "at most").with_shown_default().between(1, 100000);
  add_journal_options(command, options.jobs, fit.restart);
}

}  // namespace

void add_fit(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<FitOptions>();
  NamedCommand command = application.add_command("fit", "find parameters of a model from measurements");
  command.footer(
      "Example: mbgen fit models/fit/quarter_vehicle.json --data run1.csv,run2.csv \\\n"
      "             --match body_acceleration:0.08,spring_length:2e-4 --free k=2e4:5e4,c,kt -o fitted.json\n"
      "FILE.journal beside --out keeps the evaluations: a fit that was killed goes on from there. See "
      "docs/use/fit.md.");
  fit::FitArguments& fit = options->fit;
  add_model_argument(command, fit.model.path);
  command
      .add_option("--data", fit.data,
                  "measured runs (CSV or MAT, first column t), or points of a rig's curve, separated by commas")
      .separated_by(',');
  command
      .add_option("--match", fit.match,
                  "OUTPUT[=COLUMN][:SIGMA] or kc:AXLE:COLUMN[=COLUMN][:SIGMA]: measured outputs, the column that holds "
                  "each, the standard deviation of its noise; separated by commas")
      .separated_by(',');
  command
      .add_option(
          "--target", fit.targets,
          "MEASURE=VALUE:SIGMA: single numbers, as start:OUTPUT, mode:K:frequency, mode:K:damping, kc:AXLE:FIGURE, a "
          "metric as in sweep, or a number of the manoeuvre; separated by commas")
      .one_value_at_a_time();
  command.add_option("--manoeuvre", fit.manoeuvres, "manoeuvre file, whose numbers are targets; may be repeated")
      .one_value_at_a_time();
  command
      .add_option("--free", fit.free,
                  "NAME, NAME=LOW:HIGH, NAME=LOW:START:HIGH or (entries of an inertia) NAME=physical: parameters that "
                  "are found; "
                  "separated by commas")
      .required()
      .separated_by(',');
  command.add_option("--hold-out", fit.held_out, "measured runs that only test the result; separated by commas")
      .separated_by(',');
  command.add_option("-o,--out", options->out, "model with the found values, which includes MODEL (JSON)");
  command.add_option("--report", options->page, "page with the result and pictures of data and model (HTML)");
  add_search_options(command, *options);
  add_set_option(command, fit.model.set);
  command.add_option("--step", fit.model.simulation.step, "s, of the motion (default: of the model)");
  command.add_option("--integrator", fit.model.simulation.integrator,
                     "rk4, abm4 or rosenbrock (default: of the model)");
  command.add_option("--interpolation", fit.model.simulation.interpolation,
                     "of the inputs in the data between rows: pchip (default), linear, spline, hold");
  add_engine_options(command, fit.model.engine);
  add_json_option(command, options->json);
  command.callback([options, command, &exit_code] {
    options->fit.model.has_engine = command.is_given("--engine");
    exit_code = run_fit(*options);
  });
}

}  // namespace mbgen::cli
