#include "compiler/topology/coordinate_uses.hpp"

namespace mbgen {
namespace {

template <class Elements>
void add_elements(std::vector<CoordinateUse>& uses, const std::string& kind, const Elements& elements) {
  for (const auto& element : elements) uses.push_back({element.joint, kind + " " + element.name});
}

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
  add_elements(uses, "motion", model.motions);
  add_elements(uses, "joint spring", model.joint_springs);
  for (const JointSpring& spring : model.joint_springs) {
    if (spring.relative_to) uses.push_back({*spring.relative_to, "joint spring " + spring.name});
  }
  add_elements(uses, "friction", model.frictions);
  add_elements(uses, "joint force", model.joint_forces);
  for (const BumpStop& stop : model.bump_stops)
    if (stop.is_on_joint()) uses.push_back({stop.joint, "bump stop " + stop.name});
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
