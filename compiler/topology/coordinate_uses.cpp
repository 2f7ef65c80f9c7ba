#include "compiler/topology/coordinate_uses.hpp"

#include <fmt/format.h>

namespace mbgen {
namespace {

void add_expressions(std::vector<CoordinateUse>& uses, const Model& model) {
  using Kind = ExpressionNode::Kind;
  for (const Expression& expression : model.expressions) {
    for (const ExpressionNode& node : expression.nodes) {
      if (node.kind != Kind::position && node.kind != Kind::velocity) continue;
      uses.push_back({node.coordinate, "expression \"" + expression.text + "\""});
    }
  }
}

void add_elements_of_laws(std::vector<CoordinateUse>& uses, const Model& model) {
  for (const Motion& motion : model.motions) uses.push_back({motion.joint, "motion " + motion.name});
  each_element(model, [&](const auto& element) {
    const Connection connection = connection_of(element);
    const OnCoordinate* on = std::get_if<OnCoordinate>(&connection);
    if (!on) return;
    const std::string name = fmt::format("{} {}", KindOf<std::decay_t<decltype(element)>>::words, element.name);
    uses.push_back({on->joint, name});
    if (on->relative_to) uses.push_back({*on->relative_to, name});
  });
}

}  // namespace

std::vector<CoordinateUse> coordinates_of_laws(const Model& model) {
  std::vector<CoordinateUse> uses;
  add_elements_of_laws(uses, model);
  for (const Coupling& coupling : model.couplings)
    for (const CoordinateReference& coordinate : coupling.coordinates)
      uses.push_back({coordinate, "coupling " + coupling.name});
  return uses;
}

std::vector<CoordinateUse> coordinate_uses(const Model& model) {
  std::vector<CoordinateUse> uses;
  add_elements_of_laws(uses, model);
  add_expressions(uses, model);
  for (const Coupling& coupling : model.couplings)
    for (const CoordinateReference& coordinate : coupling.coordinates)
      if (coupling.curve) uses.push_back({coordinate, "coupling " + coupling.name});
  for (const InitialValue& value : model.initial.positions) uses.push_back({value.coordinate, "an initial position"});
  for (const InitialValue& value : model.initial.velocities) uses.push_back({value.coordinate, "an initial velocity"});
  for (const Output& output : model.outputs) {
    const auto* source = std::get_if<CoordinateOutput>(&output.source);
    if (source) uses.push_back({source->coordinate, "output " + output.name});
  }
  return uses;
}

}  // namespace mbgen
