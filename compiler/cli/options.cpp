#include "compiler/cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "compiler/cli/dump.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {

void add_model_argument(CLI::App& command, std::string& path) {
  command.add_option("MODEL", path, "model file (JSON)")->required();
}

void add_json_option(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print the result for machines");
}

void add_dump_option(CLI::App& command, std::string& stage) {
  command.add_option("--dump", stage,
                     fmt::format("print what a stage made, and nothing else: {}", fmt::join(dump_stages(), ", ")));
}

void add_engine_options(CLI::App& command, EngineArguments& arguments) {
  command.add_option("--engine", arguments.choice.name,
                     fmt::format("{} (default {}; the others need no compiler)", fmt::join(engine_names(), ", "),
                                 arguments.choice.name));
  command.add_option(
      "--stabilisation", arguments.stabilisation,
      "projection or baumgarte: what keeps the joints of a Cartesian engine together (default projection)");
  add_run_options(command, arguments);
}

EngineChoice chosen_engine(const EngineArguments& arguments) {
  EngineChoice choice = arguments.choice;
  const std::string& name = arguments.stabilisation;
  if (name.empty()) return choice;
  const std::vector<std::string>& relative = relative_engine_names();
  if (std::find(relative.begin(), relative.end(), choice.name) != relative.end()) {
    std::vector<std::string> cartesian;
    std::copy_if(engine_names().begin(), engine_names().end(), std::back_inserter(cartesian), is_cartesian);
    throw UserError(fmt::format("--stabilisation: engine \"{}\" has none to choose; those that have: {}\n", choice.name,
                                fmt::join(cartesian, ", ")));
  }
  if (name != "projection" && name != "baumgarte") {
    throw UserError(fmt::format("--stabilisation: no stabilisation \"{}\"; there are: projection, baumgarte\n", name));
  }
  choice.stabilisation = name == "baumgarte" ? Stabilisation::baumgarte : Stabilisation::projection;
  return choice;
}

void add_run_options(CLI::App& command, EngineArguments& arguments) {
  command.add_option("--input", arguments.inputs, "name=value of a model input; may be repeated")
      ->allow_extra_args(false);
  command.add_flag_callback(
      "--no-cache", [&arguments] { arguments.choice.use_cache = false; },
      "compile anew and keep nothing (default: keep solvers under ~/.cache/mbgen)");
}

double parse_number(const std::string& text, const std::string& what) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw UserError(fmt::format("{}: \"{}\" is not a finite number\n", what, text));
  }
  return value;
}

std::vector<double> input_values(const Model& model, const std::vector<std::string>& assignments) {
  std::vector<double> values;
  std::vector<std::string> names;
  for (const Input& input : model.inputs) {
    values.push_back(input.default_value);
    names.push_back(input.name);
  }
  for (const std::string& assignment : assignments) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string::npos) {
      throw UserError(fmt::format("--input: \"{}\" is not of the form name=value\n", assignment));
    }
    const std::string name = assignment.substr(0, sign);
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) {
      throw UserError(fmt::format("--input: the model has no input \"{}\"; its inputs: {}\n", name,
                                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    }
    values[static_cast<std::size_t>(place - names.begin())] =
        parse_number(assignment.substr(sign + 1), "--input " + name);
  }
  return values;
}

}  // namespace mbgen::cli
