#include "workbench/cli/inverse_path.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/engines/auto_engine.hpp"
#include "workbench/engines/kept_decisions.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/motion/motion_table.hpp"
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

namespace {

/// The path of a table, or of the motions of a model that determine all coordinates.
PathOfCoordinates path_of(const InversePathOptions& options, const Compilation& compilation) {
  const std::optional<double>& duration = options.simulation.duration;
  if (!options.path.empty()) {
    if (duration) throw UserError("simulate --inverse: --path has a duration of its own: leave out --duration\n");
    return read_path(options.path, compilation);
  }
  if (!free_coordinates(compilation.topology, compilation.analysis).empty())
    throw UserError(
        "simulate --inverse: --path TABLE is required\n"
        "  hint: a path is a table: t [s],coordinate [unit]. Motions that determine all coordinates are a path too\n");
  PathOfCoordinates path;
  const SimulationSettings settings = settings_of(options.simulation, compilation.model.solver);
  path.end = static_cast<double>(settings.steps) * settings.step;
  return path;
}

nlohmann::ordered_json forces_json(const Compilation& compilation, const InversePathOptions& options,
                                   const std::string& engine, const PathOfCoordinates& path, const Results& table) {
  nlohmann::ordered_json result = {{"model", compilation.model.name},
                                   {"path", options.path},
                                   {"engine", engine},
                                   {"rows", table.rows()},
                                   {"start", path.start},
                                   {"end", path.end}};
  for (const ColumnOfActuators& column : columns_of_actuators(table))
    result["actuators"][column.heading.name] = {{"unit", column.heading.unit},
                                                {"smallest", column.smallest},
                                                {"largest", column.largest},
                                                {"rms", column.root_mean_square}};
  return result;
}

}  // namespace

int run_inverse_path(const InversePathOptions& options) {
  if (options.every < 1) throw UserError(fmt::format("--every: must be positive, found {}\n", options.every));
  table_format(options.format, options.out);  // fails before the work
  EngineChoice choice = chosen_engine(options.engine);
  if (choice.name == kAutoEngine) choice.name = "generic";
  choice.form = chosen_form(options.form);
  Model model = read_set_model(options.model, options.set);
  const double step = options.simulation.step.value_or(model.solver.step);
  if (!(step > 0)) throw UserError(fmt::format("--step: must be positive, found {}\n", step));
  add_actuator_outputs(model);
  const Compilation compilation = expect(decide_for(std::move(model), choice));
  require_inverse_dynamics(compilation, "simulate");
  const PathOfCoordinates path = path_of(options, compilation);
  const InputsOverTime inputs = inputs_of(compilation.model, options.engine.inputs, options.simulation);
  const Engine engine = make_engine(compilation, choice);
  const Results table = forces_along(path, engine, compilation, inputs,
                                     initial_state(compilation, inputs.at(path.start)), {step, options.every});
  std::vector<std::string> read = compilation.model.files;
  read.insert(read.end(), {options.path, options.simulation.input_table});
  const bool is_mat = table_format(options.format, options.out) == TableFormat::mat;
  write_file(options.out, is_mat ? mat_text(table) : csv_text(table.columns), read);
  print_beside(options.out,
               options.json ? forces_json(compilation, options, choice.name, path, table).dump() + "\n"
                            : fmt::format("{}: forces along {}, {} rows from {:g} s to {:g} s, engine {}\n{}",
                                          compilation.model.name, options.path.empty() ? "its motions" : options.path,
                                          table.rows(), path.start, path.end, choice.name, forces_text(table)));
  for (const std::string& line : limits_passed(compilation.model, table))
    print_message("simulate: warning: {}\n", line);
  return kDone;
}

}  // namespace mbgen::cli
