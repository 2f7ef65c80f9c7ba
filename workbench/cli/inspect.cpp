// mbgen inspect: analysis of a model before code generation.

#include <fmt/format.h>

#include <memory>

#include "compiler/compile.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/dump.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/describe/report.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {
namespace {

/// From this size on, the repeated tracing without each treatment takes over a second.
constexpr int kMostBodiesCounted = 200;

struct InspectOptions {
  std::string model, form, dump, svg;
  std::vector<std::string> set;
  bool json = false;
};

/// Adds the programs and counts their operations per pass.
Counts add_counted_programs(Compilation& compilation, std::optional<Form> form, bool with_savings) {
  Counts counts;
  std::vector<Saving> of_passes;
  long before = 0;
  const auto count = [&](std::string_view pass, long after) {
    if (before > after) of_passes.push_back({fmt::format("pass {}", pass), before, after});
    before = after;
  };
  add_programs(compilation, {form, [&](const Stage& stage) {
                               // Of one spelling: the text has another one.
                               const Program& plain = stage.so_far.whole.programs.accelerations;
                               count(stage.name, count_operations(plain).total());
                               return true;
                             }});
  const long with = count_operations(counted_programs(compilation).accelerations).total();
  count("derived-constants", with);
  const Model& model = compilation.model;
  const Topology& topology = compilation.topology;
  const Analysis& analysis = compilation.analysis;
  for (const Form f : {Form::matrix, Form::recursive})
    counts.operations_of_form[static_cast<int>(f)] =
        f == compilation.form() ? with : count_operations_of(model, topology, analysis, f);
  if (!with_savings || counts.operations_of_form[0] == 0 || counts.operations_of_form[1] == 0) return counts;
  if (compilation.form() == Form::recursive) counts.savings = count_savings(model, topology, analysis, with);
  counts.savings.insert(counts.savings.end(), of_passes.begin(), of_passes.end());
  return counts;
}

int run(const InspectOptions& options) {
  const std::optional<Form> form = chosen_form(options.form);
  if (!options.dump.empty()) {
    print(dump_stage(read_set_model(options.model, options.set), options.dump, known_start, form));
    return kDone;
  }
  Compilation compilation = expect(decide(read_set_model(options.model, options.set)));
  if (!options.svg.empty()) {
    const std::string drawing = topology_svg(compilation.model, compilation.topology, compilation.analysis);
    write_file(options.svg, drawing, compilation.model.files);
    return kDone;
  }
  const Diagnostics problems = too_large(compilation, form);
  print_notes(problems);
  Counts counts;
  const bool with_savings = compilation.topology.size() <= kMostBodiesCounted;
  if (problems.empty()) counts = add_counted_programs(compilation, form, with_savings);
  const nlohmann::ordered_json report = make_report(compilation, counts);
  print(options.json ? json_text(report) : report_text(report));
  return kDone;
}

}  // namespace

void add_inspect(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<InspectOptions>();
  NamedCommand command = application.add_command(
      "inspect", "show tree, loops, redundant equations, coordinates and operations of a model");
  command.footer(
      "Example: mbgen inspect models/coach_mechanism.json --json\n"
      "         mbgen inspect models/coach.json --svg coach.svg");
  add_model_argument(command, options->model);
  add_set_option(command, options->set);
  add_form_option(command, options->form);
  add_json_option(command, options->json);
  command.add_option("--svg", options->svg, "draw the topology into this file; - for standard output");
  add_dump_option(command, options->dump);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
