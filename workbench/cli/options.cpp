#include "workbench/cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "workbench/describe/dump.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen::cli {

void add_model_argument(NamedCommand command, std::string& path) {
  command.add_option("MODEL", path, "model file (JSON)").required();
}

void add_journal_options(NamedCommand command, int& jobs, bool& restart) {
  command.add_option("--jobs", jobs, "evaluations at a time (default: one a processor)").between(0, 1024);
  command.add_flag("--restart", restart, "forget the evaluations of a search that was killed");
}

void add_json_option(NamedCommand command, bool& json) {
  command.add_flag("--json", json, "print the result for machines");
}

void add_form_option(NamedCommand command, std::string& form) {
  command.add_option("--form", form,
                     "form of the generated equations: recursive, or matrix, the paper's steps (default: the one with "
                     "fewer operations)");
}

void add_dump_option(NamedCommand command, std::string& stage) {
  command.add_option("--dump", stage,
                     fmt::format("print the result of a stage, and nothing else: {}", fmt::join(dump_stages(), ", ")));
}

void add_depfile_option(NamedCommand command, std::string& path) {
  command.add_option("--depfile", path,
                     "write the files that the model is read from as a rule of Make, for build tools");
}

void add_batch_option(NamedCommand command, int& lanes) {
  command
      .add_option(
          "--batch", [&lanes](const std::string& typed) { lanes = std::stoi(typed); },
          "4 or 8: solve so many independent instances in one call, in SIMD lanes")
      .one_of({"4", "8"});
}

void add_scalar_option(NamedCommand command, Scalar& scalar) {
  const auto take = [&scalar](const std::string& typed) {
    scalar = typed == name_of(Scalar::floats) ? Scalar::floats : Scalar::doubles;
  };
  command
      .add_option("--scalar", take,
                  "float: single precision, for processors without double (docs/use/targets.md) (default double)")
      .one_of({"double", "float"});
}

void add_engine_options(NamedCommand command, EngineArguments& arguments) {
  command.add_option("--engine", arguments.choice.name,
                     fmt::format("{} (default {}; the others need no compiler)", fmt::join(engine_names(), ", "),
                                 arguments.choice.name));
  command.add_option(
      "--linear-algebra", arguments.linear_algebra,
      "of the generic engine: entries (block by block, zeros never touched), eigen (dense, block by block),\n"
      "blas (the paper's LU on all loops at once) or sparse (KLU) (default entries)");
  command.add_option("--factorisation", arguments.factorisation,
                     "of the generic engine's loops: lu, or qr with eigen only (default lu)");
  command.add_option(
      "--stabilisation", arguments.stabilisation,
      "projection or baumgarte: method that keeps the joints of a Cartesian engine together (default projection)");
  add_run_options(command, arguments);
}

void add_input_option(NamedCommand command, std::vector<std::string>& inputs) {
  command.add_option("--input", inputs, "name=value of a model input; may be repeated").one_value_at_a_time();
}

void add_run_options(NamedCommand command, EngineArguments& arguments) {
  add_input_option(command, arguments.inputs);
  command.add_flag(
      "--no-cache", [&arguments] { arguments.choice.use_cache = false; },
      "compile anew and keep nothing (default: keep solvers under ~/.cache/mbgen)");
}

Option add_set_option(NamedCommand command, std::vector<std::string>& assignments) {
  return command
      .add_option("--set", assignments,
                  "name=value of a model parameter, tunable or not, in place of the file's; may be repeated")
      .one_value_at_a_time();
}

void add_simulation_options(NamedCommand command, SimulationArguments& arguments) {
  command.add_option("--duration", arguments.duration, "s (default: the model's)");
  command.add_option("--step", arguments.step, "s, shortened to divide the duration (default: the model's)");
  command.add_option(
      "--integrator", arguments.integrator,
      "rk4, abm4, rosenbrock, or for simulate auto, which asks the modes of the start (default: the model's; Cartesian "
      "engines: rk4 only)");
  command.add_option(
      "--input-table", arguments.input_table,
      "inputs over time (CSV): columns t and names of inputs, held before the first row and after the last");
  command.add_option("--interpolation", arguments.interpolation,
                     "between the rows of the input table: pchip (default: cubic that stays within them), linear, "
                     "spline, hold");
}

void add_state_options(NamedCommand command, StateArguments& arguments) {
  arguments.at = "initial";
  arguments.index = 1;
  arguments.row = 1;
  const Option at = command.add_option("--at", arguments.at,
                                       "initial: the state that the model starts from (default), equilibrium: the "
                                       "static equilibrium near it, or steady: a motion near it with constant rates");
  at.one_of({"initial", "equilibrium", "steady"});
  command
      .add_option(
          "--hold", arguments.steady.hold,
          "of steady: coordinate=rate that is given (default: with --solve the first translation that moves at the "
          "start, else none)")
      .one_value_at_a_time();
  command.add_option("--solve", arguments.steady.solve, "of steady: an input to be found, a drive or a steering angle")
      .one_value_at_a_time();
  const Option states =
      command.add_option("--states", arguments.states, "a state of this file, as evaluate reads it, made consistent")
          .excludes(at);
  command.add_option("--index", arguments.index, "which state of the file, counted from 1 (default 1)");
  const Option result = command.add_option("--result", arguments.result, "a row of this file, which simulate wrote")
                            .excludes(at)
                            .excludes(states);
  const Option row = command.add_option("--row", arguments.row, "which row of the result, counted from 1 (default 1)");
  row.needs(result);
  command.add_option("--time", arguments.time, "the row of the result at this time, s").needs(result).excludes(row);
  add_input_option(command, arguments.inputs);
}

}  // namespace mbgen::cli
