// mbgen explain: the decisions about a model, in words.

#include <memory>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/explanation.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/operating/tyre_law_text.hpp"

namespace mbgen::cli {
namespace {

struct ExplainOptions {
  std::string model, form, tyre;
  std::vector<std::string> set;
};

int run(const ExplainOptions& options) {
  const Model model = read_set_model(options.model, options.set);
  print(options.tyre.empty() ? explanation_text(compiled(model, chosen_form(options.form)))
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
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
