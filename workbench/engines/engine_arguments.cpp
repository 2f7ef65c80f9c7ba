#include "workbench/engines/engine_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// An option whose value is one of a few words.
template <class Value, std::size_t count>
struct WordOption {
  const char *name, *noun;
  std::array<std::pair<const char*, Value>, count> words;
};

constexpr WordOption<LinearAlgebra, 4> kLinearAlgebra{"--linear-algebra",
                                                      "linear algebra",
                                                      {{{"eigen", LinearAlgebra::eigen},
                                                        {"blas", LinearAlgebra::blas},
                                                        {"sparse", LinearAlgebra::sparse},
                                                        {"entries", LinearAlgebra::entries}}}};
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

std::optional<Form> chosen_form(const std::string& typed) {
  return typed.empty() ? std::nullopt : std::optional<Form>(meaning(kForm, typed));
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
      throw UserError(fmt::format("{}: engine \"{}\" has no such option; engines that have it: {}\n", option.name,
                                  choice.name, fmt::join(engines, ", ")));
    }
    value = meaning(option, typed);
  };
  if (choice.lanes > 0 && choice.name != "generated") {
    throw UserError(
        fmt::format("--batch: engine \"{}\" has no such option; engines that have it: generated\n", choice.name));
  }
  choose(kLinearAlgebra, arguments.linear_algebra, generic, choice.algebra.library);
  choose(kFactorisation, arguments.factorisation, generic, choice.algebra.factorisation);
  choose(kStabilisation, arguments.stabilisation, cartesian, choice.stabilisation);
  if (choice.algebra.factorisation == Factorisation::qr && choice.algebra.library != LinearAlgebra::eigen &&
      !arguments.linear_algebra.empty()) {
    throw UserError(
        fmt::format("--factorisation: qr goes with --linear-algebra eigen only, found {}\n", arguments.linear_algebra));
  }
  return choice;
}

}  // namespace mbgen
