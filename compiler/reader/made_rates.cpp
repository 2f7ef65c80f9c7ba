// Second rates of inputs for motions, added if the model has only the first.

#include <fmt/format.h>

#include <set>

#include "compiler/model/inputs.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Inputs used by motions.
std::set<int> inputs_of_motions(const Model& model) {
  std::set<int> inputs;
  for (const Motion& motion : model.motions) {
    if (motion.position.expression < 0) continue;
    for (const ExpressionNode& node : model.expressions[static_cast<std::size_t>(motion.position.expression)].nodes)
      if (node.kind == ExpressionNode::Kind::input) inputs.insert(node.index);
  }
  return inputs;
}

std::string free_name(const Reader& reader, std::string name) {
  const auto is_taken = [&](const std::string& n) {
    return reader.names.inputs.count(n) > 0 || reader.names.parameters.count(n) > 0 || reader.names.values.count(n) > 0;
  };
  while (is_taken(name)) name += '_';
  return name;
}

}  // namespace

void make_second_rates(Reader& reader) {
  std::vector<Input>& inputs = reader.model.inputs;
  for (const int input : inputs_of_motions(reader.model)) {
    const int rate = inputs[static_cast<std::size_t>(input)].derivative;
    if (rate < 0 || inputs[static_cast<std::size_t>(rate)].derivative >= 0) continue;
    const Input& first = inputs[static_cast<std::size_t>(rate)];
    Input second{free_name(reader, first.name + "_rate"), first.where,
                 first.unit.ends_with("/s") ? first.unit + "^2" : ""};
    second.shown.description = "made from " + first.name;
    reader.model.notes.push_back(
        {first.where,
         fmt::format(
             "input \"{0}\" moves a joint and has no derivative: its rate \"{1}\" is added, so that bodies feel "
             "their inertia; --input-table and steps of C and FMU without values for \"{1}\" make it from "
             "\"{0}\"",
             first.name, second.name),
         "give it a \"derivative\" of your own where you know the acceleration",
         {}});
    reader.names.inputs.emplace(second.name, static_cast<int>(inputs.size()));
    inputs[static_cast<std::size_t>(rate)].derivative = static_cast<int>(inputs.size());
    inputs.push_back(std::move(second));
  }
}

}  // namespace mbgen::reading
