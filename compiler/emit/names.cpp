#include "compiler/emit/names.hpp"

#include <fmt/format.h>

#include <iterator>

#include "compiler/emit/mapped.hpp"

namespace mbgen {
namespace {

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// Letters, digits and single underscores, starting with a letter.
std::string sanitised(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      // Two successive underscores are reserved to the compiler, and so is one at the start.
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty()) return "unnamed";
  if (result.front() >= '0' && result.front() <= '9') result = "n_" + result;
  return result;
}

std::vector<std::string> identifiers(const std::vector<std::string>& names,
                                     const std::vector<std::string>& taken = {}) {
  UniqueNames unique;
  for (const std::string& name : taken) unique.reserve(name);
  return mapped(names, [&](const std::string& name) { return unique.identifier(name); });
}

}  // namespace

std::vector<Parameter> tunable_parameters(const Model& model) {
  std::vector<Parameter> parameters = model.parameters;
  std::erase_if(parameters, [](const Parameter& parameter) { return !parameter.tunable; });
  return parameters;
}

std::string identifier_base(const std::string& name) {
  std::string base = sanitised(name);
  if (is_reserved(base)) base += '_';
  return base;
}

std::string UniqueNames::unique(const std::string& base) {
  std::string candidate = base;
  for (int& number = next_number_.try_emplace(base, 2).first->second; !taken_.insert(candidate).second; ++number) {
    candidate = fmt::format("{}{}{}", base, base.back() == '_' ? "" : "_", number);
  }
  return candidate;
}

std::string solver_name(const Model& model) {
  std::string name = identifier_base(model.name);
  if (is_reserved_for_solvers(name)) name += '_';
  return name;
}

SolverNames model_names(const Model& model) {
  SolverNames names;
  names.solver = solver_name(model);
  names.bodies = identifiers(names_of(model.bodies));
  names.inputs = identifiers(names_of(model.inputs));
  names.parameters = identifiers(names_of(tunable_parameters(model)), {"derived"});
  names.actuators = identifiers(names_of(model.actuators));
  names.outputs = identifiers(names_of(model.outputs), {std::begin(kEnergyMembers), std::end(kEnergyMembers)});
  return names;
}

SolverNames solver_names(const Model& model, const Topology& topology) {
  SolverNames names = model_names(model);
  const auto first_loop = [&](const LoopBlock& block) { return topology.loops[block.loops.front()].name; };
  names.coordinates = identifiers(mapped(topology.bodies, &TreeBody::coordinate));
  names.loop_blocks = identifiers(mapped(topology.blocks, first_loop));
  return names;
}

}  // namespace mbgen
