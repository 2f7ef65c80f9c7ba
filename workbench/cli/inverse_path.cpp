#include "workbench/cli/inverse_path.hpp"

#include <fmt/format.h>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/engines/auto_engine.hpp"
#include "workbench/engines/kept_decisions.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/path_forces.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {

void require_inverse_dynamics(const Compilation& compilation, const char* command) {
  if (compilation.model.actuators.empty())
    throw UserError(
        fmt::format("{}: {} --inverse: the model has no actuators\n"
                    "  hint: \"actuators\": {{ \"motor\": {{ \"joint\": \"...\" }} }}\n",
                    compilation.model.file, command));
  Diagnostics problems = unactuated_directions(compilation.model, compilation.topology, compilation.analysis);
  if (!problems.empty()) expect(Result<int>(std::move(problems)));
}

int run_inverse_path(const InversePathOptions& options) {
  if (options.path.empty()) throw UserError("simulate --inverse: --path TABLE is required\n");
  EngineChoice choice = chosen_engine(options.engine);
  if (choice.name == kAutoEngine) choice.name = "generic";
  choice.form = chosen_form(options.form);
  Model model = read_set_model(options.model, options.set);
  const double step = options.simulation.step.value_or(model.solver.step);
  if (!(step > 0)) throw UserError(fmt::format("--step: must be positive, found {}\n", step));
  add_actuator_outputs(model);
  const Compilation compilation = expect(decide_for(std::move(model), choice));
  require_inverse_dynamics(compilation, "simulate");
  const PathOfCoordinates path = read_path(options.path, compilation);
  const InputsOverTime inputs = inputs_of(compilation.model, options.engine.inputs, options.simulation);
  const Engine engine = make_engine(compilation, choice);
  const Results table =
      forces_along(path, engine, compilation, inputs, initial_state(compilation, inputs.at(path.start)), step);
  std::vector<std::string> read = compilation.model.files;
  read.push_back(options.path);
  write_file(options.out, csv_text(table.columns), read);
  print_beside(options.out,
               fmt::format("{}: forces along {}, {} rows from {:g} s to {:g} s, engine {}\n{}", compilation.model.name,
                           options.path, table.rows(), path.start, path.end, choice.name, forces_text(table)));
  return kDone;
}

}  // namespace mbgen::cli
