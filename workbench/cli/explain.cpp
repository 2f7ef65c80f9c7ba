// mbgen explain: the decisions about a model, in words.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "compiler/compile.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/equation.hpp"
#include "workbench/describe/equation_words.hpp"
#include "workbench/describe/explanation.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/operating/tyre_law_text.hpp"

namespace mbgen::cli {
namespace {

struct ExplainOptions {
  std::string model, form, tyre, equation;
  std::vector<std::string> set;
};

/// The lines of a quantity in the reading copy.
std::string equation_of(const ExplainOptions& options, Model model) {
  const Compilation compilation =
      compiled(std::move(model), {.form = chosen_form(options.form), .spelling = Spelling::reading});
  const std::string file = solver_name(compilation.model) + ".cpp";
  for (const EmittedFile& emitted : emit(compilation, {.runtime_headers = false}))
    if (emitted.path == file)
      return equation_text(file, emitted.text, options.equation, part_words(compilation.model, compilation.topology));
  throw std::logic_error("a solver without " + file);
}

int run(const ExplainOptions& options) {
  if (!options.tyre.empty() && !options.equation.empty())
    throw UserError("explain: one of --tyre and --equation at a time\n");
  const Model model = read_set_model(options.model, options.set);
  if (!options.equation.empty()) {
    print(equation_of(options, model));
    return kDone;
  }
  print(options.tyre.empty() ? explanation_text(compiled(model, {.form = chosen_form(options.form)}))
                             : tyre_law_text(expect(decide(model)), options.tyre));
  return kDone;
}

}  // namespace

void add_explain(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<ExplainOptions>();
  NamedCommand command =
      application.add_command("explain", "explain the decisions about a model in words, each with its reason");
  command.footer("Example: mbgen explain models/four_bar.json\nThe same facts as tables and as JSON: mbgen inspect.");
  add_model_argument(command, options->model);
  add_set_option(command, options->set);
  add_form_option(command, options->form);
  command.add_option("--tyre", options->tyre, "print the law of this tyre instead: coefficients, stiffnesses, forces");
  command.add_option(
      "--equation", options->equation,
      "print instead where the reading copy (generate --reading) computes this quantity, or all "
      "quantities of this body, coordinate, loop or element, or the quantities that fit words: \"roll bar moment\"");
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
