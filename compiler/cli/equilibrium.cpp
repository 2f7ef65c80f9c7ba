// mbgen equilibrium: where a model stays at rest.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/base/assignments.hpp"
#include "compiler/base/files.hpp"
#include "compiler/base/json_text.hpp"
#include "compiler/base/user_error.hpp"
#include "compiler/cli/commands.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/describe/notes.hpp"
#include "compiler/engines/engine.hpp"
#include "compiler/study/operating_point.hpp"

namespace mbgen::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EquilibriumOptions {
  std::string model, file;
  std::vector<std::string> inputs, set;
  bool json = false;
};

/// The equilibrium, its rates and its forces.
struct Equilibrium {
  GenericState state;
  GenericDerivative rates;  ///< zero but for rounding, and for what may roll or turn freely
  GenericOutputs outputs;
};

Equilibrium find(const Compilation& compilation, const std::vector<double>& inputs) {
  Equilibrium found{equilibrium_state(compilation, inputs), {}, {}};
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const std::vector<double> no_forces(found.state.z.size(), 0.0);
  const Status status = solver.accelerations(found.state, no_forces, found.rates);
  if (!status.ok()) throw UserError(fmt::format("at the equilibrium: {}\n", describe(compilation, status)));
  found.outputs = solver.outputs(found.state, no_forces, found.rates);
  return found;
}

Json equilibrium_json(const Compilation& compilation, const Equilibrium& found) {
  Json positions = Json::object(), outputs = Json::object();
  for (std::size_t i = 0; i < found.state.z.size(); ++i) {
    positions[compilation.topology.bodies[i].coordinate] = found.state.z[i];
  }
  for (std::size_t i = 0; i < compilation.model.outputs.size(); ++i) {
    outputs[compilation.model.outputs[i].name] = found.outputs.y[i];
  }
  return {{"model", compilation.model.name},
          {"positions", positions},
          {"largest_acceleration", largest_absolute(found.rates.zdd)},
          {"outputs", outputs}};
}

std::string equilibrium_text(const Compilation& compilation, const Equilibrium& found) {
  std::string text = fmt::format("{}: static equilibrium, accelerations below {:.1e}\n\nCoordinates\n",
                                 compilation.model.name, largest_absolute(found.rates.zdd));
  for (std::size_t i = 0; i < found.state.z.size(); ++i) {
    const TreeBody& body = compilation.topology.bodies[i];
    text += fmt::format("  {:<40}{:>16.9g} {}\n", body.coordinate, found.state.z[i], unit_of(body.kind));
  }
  if (!compilation.model.outputs.empty()) text += "\nOutputs\n";
  for (std::size_t i = 0; i < compilation.model.outputs.size(); ++i) {
    const Output& output = compilation.model.outputs[i];
    text += fmt::format("  {:<40}{:>16.9g} {}\n", output.name, found.outputs.y[i], output.unit);
  }
  return text;
}

/// A file to include: a model that starts there.
void write_start(const EquilibriumOptions& options, const Compilation& compilation, const Equilibrium& found) {
  require_other_file(options.file, compilation.model.files);
  const Json positions = equilibrium_json(compilation, found)["positions"];
  write_file(options.file, json_text({{"mbgen", 1}, {"initial", {{"positions", positions}}}}));
}

int run(const EquilibriumOptions& options) {
  const Compilation compilation = expect(decide(read_set_model(options.model, options.set)));
  count_notes(compilation);
  const Equilibrium found = find(compilation, input_values(compilation.model, options.inputs));
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
