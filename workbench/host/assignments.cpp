#include "workbench/host/assignments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

[[noreturn]] void fail_unknown(const Model& model, const std::string& name, const std::string& option) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : model.parameters) names.push_back(parameter.name);
  const bool is_input =
      std::any_of(model.inputs.begin(), model.inputs.end(), [&](const Input& input) { return input.name == name; });
  const std::string hint = is_input ? fmt::format("it is an input: --input {}=VALUE", name) : did_you_mean(name, names);
  throw UserError(
      fmt::format("{}: the model has no parameter \"{}\"{}{}\n", option, name, hint.empty() ? "" : "; ", hint));
}

const Parameter& parameter_of(const Model& model, const std::string& name, const std::string& option) {
  const auto found = std::find_if(model.parameters.begin(), model.parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  if (found == model.parameters.end()) fail_unknown(model, name, option);
  return *found;
}

/// A parameter given on the command line; it keeps its tunability.
VariedParameter parameter_from(const Model& model, const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) {
    throw UserError(fmt::format("--set: \"{}\" is not of the form name=value\n", assignment));
  }
  const std::string name = assignment.substr(0, sign);
  const bool is_tunable = parameter_of(model, name, "--set").tunable;
  return {name, parse_number(assignment.substr(sign + 1), "--set " + name), is_tunable};
}

}  // namespace

std::string nearest_hint(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string hint = did_you_mean(word, {candidates.begin(), candidates.end()});
  return hint.starts_with("did") ? fmt::format("  hint: {}\n", hint) : std::string();
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
      const bool is_parameter = std::any_of(model.parameters.begin(), model.parameters.end(),
                                            [&](const Parameter& parameter) { return parameter.name == name; });
      throw UserError(fmt::format(
          "--input: the model has no input \"{}\"; its inputs: {}\n{}", name,
          names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
          is_parameter ? fmt::format("  hint: it is a parameter: --set {}=VALUE\n", name) : nearest_hint(name, names)));
    }
    values[static_cast<std::size_t>(place - names.begin())] =
        parse_number(assignment.substr(sign + 1), "--input " + name);
  }
  return values;
}

std::vector<VariedParameter> set_parameters(const Model& model, const std::vector<std::string>& assignments,
                                            const std::vector<std::string>& tuned, const std::string& option) {
  std::vector<VariedParameter> set;
  const auto place_of = [&](const std::string& name) { return std::ranges::find(set, name, &VariedParameter::name); };
  for (const std::string& assignment : assignments) {
    const VariedParameter parameter = parameter_from(model, assignment);
    if (place_of(parameter.name) != set.end())
      throw UserError(fmt::format("--set: \"{}\" stands twice\n", parameter.name));
    set.push_back(parameter);
  }
  for (const std::string& name : tuned) {
    if (parameter_of(model, name, option).tunable) continue;
    if (place_of(name) == set.end()) set.push_back({name, {}, true});
    place_of(name)->tunable = true;
  }
  std::ranges::sort(set, {}, &VariedParameter::name);
  return set;
}

std::string hash_of_set(const std::string& hash, const std::vector<VariedParameter>& set) {
  if (set.empty()) return hash;
  Hash of_all;
  of_all.add(hash);
  for (const VariedParameter& parameter : set) {
    if (parameter.value)
      of_all.add(fmt::format("{}={};", parameter.name, *parameter.value));
    else
      of_all.add(fmt::format("{} tuned;", parameter.name));
  }
  return of_all.text();
}

Model read_set_model(const std::string& path, const std::vector<std::string>& assignments,
                     const std::vector<std::string>& tuned, const std::string& option) {
  Model model = expect(read_model_file(path));
  const std::vector<VariedParameter> set = set_parameters(model, assignments, tuned, option);
  if (set.empty()) return model;
  std::string hash = hash_of_set(model.hash, set);
  model = expect(read_varied_model(path, set));
  model.hash = std::move(hash);
  return model;
}

}  // namespace mbgen
