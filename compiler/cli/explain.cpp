// mbgen explain: the decisions about a model, in words.

#include <memory>

#include "compiler/base/assignments.hpp"
#include "compiler/base/files.hpp"
#include "compiler/base/user_error.hpp"
#include "compiler/cli/commands.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/describe/explanation.hpp"
#include "compiler/engines/engine_arguments.hpp"

namespace mbgen::cli {
namespace {

struct ExplainOptions {
  std::string model, form;
  std::vector<std::string> set;
};

int run(const ExplainOptions& options) {
  print(explanation_text(expect(compile(read_set_model(options.model, options.set), {chosen_form(options.form)}))));
  return kDone;
}

}  // namespace

void add_explain(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<ExplainOptions>();
  NamedCommand command =
      application.add_command("explain", "explain the decisions about a model in words, each with its reason");
  command.footer(
      "Example: mbgen explain models/four_bar.json\n"
      "The same facts as tables and as JSON: mbgen inspect.");
  add_model_argument(command, options->model);
  add_set_option(command, options->set);
  add_form_option(command, options->form);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
