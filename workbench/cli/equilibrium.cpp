// mbgen equilibrium: state of rest of a model.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/operating/equilibrium_text.hpp"

namespace mbgen::cli {
namespace {

struct EquilibriumOptions {
  std::string model, file;
  std::vector<std::string> inputs, set;
  bool json = false;
};

/// Writes a file to include: a model that starts in the equilibrium.
void write_start(const EquilibriumOptions& options, const Compilation& compilation, const Equilibrium& found) {
  const nlohmann::ordered_json positions = equilibrium_json(compilation, found)["positions"];
  write_file(options.file, json_text({{"mbgen", 1}, {"initial", {{"positions", positions}}}}), compilation.model.files);
}

int run(const EquilibriumOptions& options) {
  const Compilation compilation = expect(decide(read_set_model(options.model, options.set)));
  count_notes(compilation);
  const Equilibrium found = equilibrium(compilation, input_values(compilation.model, options.inputs));
  if (!options.file.empty()) write_start(options, compilation, found);
  print_beside(options.file,
               options.json ? json_text(equilibrium_json(compilation, found)) : equilibrium_text(compilation, found));
  return kDone;
}

}  // namespace

void add_equilibrium(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<EquilibriumOptions>();
  NamedCommand command = application.add_command("equilibrium", "find where a model stays at rest");
  command.footer(
      "Example: mbgen equilibrium models/coach.json\n"
      "Starts from the model's initial state. Driven coordinates stay at their motions, loops closed.");
  add_model_argument(command, options->model);
  add_input_option(command, options->inputs);
  add_set_option(command, options->set);
  command.add_option("-o,--out", options->file, "write the positions as a file that a model may include: its start");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
