#include "compiler/cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "compiler/cli/dump.hpp"
#include "compiler/cli/number.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

/// An option whose value is one of a few words.
template <class Value, std::size_t count>
struct WordOption {
  const char *name, *noun;
  std::array<std::pair<const char*, Value>, count> words;
};

constexpr WordOption<LinearAlgebra, 3> kLinearAlgebra{
    "--linear-algebra",
    "linear algebra",
    {{{"eigen", LinearAlgebra::eigen}, {"blas", LinearAlgebra::blas}, {"sparse", LinearAlgebra::sparse}}}};
constexpr WordOption<Factorisation, 2> kFactorisation{
    "--factorisation", "factorisation", {{{"lu", Factorisation::lu}, {"qr", Factorisation::qr}}}};
constexpr WordOption<Form, 2> kForm{"--form", "form", {{{"recursive", Form::recursive}, {"matrix", Form::matrix}}}};
constexpr WordOption<Stabilisation, 2> kStabilisation{
    "--stabilisation",
    "stabilisation",
    {{{"projection", Stabilisation::projection}, {"baumgarte", Stabilisation::baumgarte}}}};

/// Fails: UserError for a word that is none of the option's.
template <class Value, std::size_t count>
Value meaning(const WordOption<Value, count>& option, const std::string& typed) {
  std::vector<std::string> known;
  for (const auto& [word, value] : option.words) {
    if (typed == word) return value;
    known.push_back(word);
  }
  throw UserError(
      fmt::format("{}: no {} \"{}\"; there are: {}\n", option.name, option.noun, typed, fmt::join(known, ", ")));
}

}  // namespace

void add_model_argument(NamedCommand command, std::string& path) {
  command.add_option("MODEL", path, "model file (JSON)").required();
}

void add_json_option(NamedCommand command, bool& json) {
  command.add_flag("--json", json, "print the result for machines");
}

void add_form_option(NamedCommand command, std::string& form) {
  command.add_option("--form", form,
                     "form of the generated equations: recursive, or matrix, the paper's steps (default: the one with "
                     "fewer operations)");
}

std::optional<Form> chosen_form(const std::string& typed) {
  return typed.empty() ? std::nullopt : std::optional<Form>(meaning(kForm, typed));
}

void add_dump_option(NamedCommand command, std::string& stage) {
  command.add_option("--dump", stage,
                     fmt::format("print what a stage made, and nothing else: {}", fmt::join(dump_stages(), ", ")));
}

void add_batch_option(NamedCommand command, int& lanes) {
  command
      .add_option(
          "--batch", [&lanes](const std::string& typed) { lanes = std::stoi(typed); },
          "4 or 8: solve so many independent instances in one call, in SIMD lanes")
      .one_of({"4", "8"});
}

void add_scalar_option(NamedCommand command, std::string& scalar) {
  command
      .add_option("--scalar", scalar,
                  "float: single precision, for processors without double (docs/targets.md) (default double)")
      .one_of({"double", "float"});
}

void add_engine_options(NamedCommand command, EngineArguments& arguments) {
  command.add_option("--engine", arguments.choice.name,
                     fmt::format("{} (default {}; the others need no compiler)", fmt::join(engine_names(), ", "),
                                 arguments.choice.name));
  command.add_option(
      "--linear-algebra", arguments.linear_algebra,
      "of the generic engine: eigen (dense, block by block), blas (the paper's LU on all loops at once)\n"
      "or sparse (KLU) (default eigen)");
  command.add_option("--factorisation", arguments.factorisation,
                     "of the generic engine's loops: lu, or qr with eigen only (default lu)");
  command.add_option(
      "--stabilisation", arguments.stabilisation,
      "projection or baumgarte: what keeps the joints of a Cartesian engine together (default projection)");
  add_run_options(command, arguments);
}

EngineChoice chosen_engine(const EngineArguments& arguments) {
  EngineChoice choice = arguments.choice;
  const std::vector<std::string> generic{"generic"};
  std::vector<std::string> cartesian;
  std::copy_if(engine_names().begin(), engine_names().end(), std::back_inserter(cartesian), is_cartesian);
  const auto choose = [&](const auto& option, const std::string& typed, const std::vector<std::string>& engines,
                          auto& value) {
    if (typed.empty()) return;
    if (std::find(engines.begin(), engines.end(), choice.name) == engines.end()) {
      throw UserError(fmt::format("{}: engine \"{}\" has none to choose; those that have: {}\n", option.name,
                                  choice.name, fmt::join(engines, ", ")));
    }
    value = meaning(option, typed);
  };
  if (choice.lanes > 0 && choice.name != "generated") {
    throw UserError(
        fmt::format("--batch: engine \"{}\" has none to choose; those that have: generated\n", choice.name));
  }
  choose(kLinearAlgebra, arguments.linear_algebra, generic, choice.algebra.library);
  choose(kFactorisation, arguments.factorisation, generic, choice.algebra.factorisation);
  choose(kStabilisation, arguments.stabilisation, cartesian, choice.stabilisation);
  if (choice.algebra.factorisation == Factorisation::qr && choice.algebra.library != LinearAlgebra::eigen) {
    throw UserError(
        fmt::format("--factorisation: qr goes with --linear-algebra eigen only, found {}\n", arguments.linear_algebra));
  }
  return choice;
}

std::string nearest_hint(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string hint = did_you_mean(word, {candidates.begin(), candidates.end()});
  return hint.starts_with("did") ? fmt::format("  hint: {}\n", hint) : std::string();
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
      throw UserError(fmt::format("--input: the model has no input \"{}\"; its inputs: {}\n{}", name,
                                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                                  nearest_hint(name, names)));
    }
    values[static_cast<std::size_t>(place - names.begin())] =
        parse_number(assignment.substr(sign + 1), "--input " + name);
  }
  return values;
}

}  // namespace mbgen::cli
