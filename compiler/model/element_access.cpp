#include "compiler/model/element_access.hpp"

namespace mbgen {

int round_after(const Model& model, const Expression& expression) {
  int round = 0;
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind != ExpressionNode::Kind::observed) continue;
    const int known = model.observed[static_cast<std::size_t>(node.index)].round;
    round = std::max(round, known == kAfterForces ? known : known + 1);
  }
  return round;
}

int last_round(const Model& model) {
  int last = 0;
  if (model.observed.empty()) return last;
  each_element(model, [&](const auto& element) { last = std::max(last, round_of(model, element)); });
  return last;
}

ElementQuantity quantity_of(const ElementOutput& output) {
  ElementQuantity quantity{"", ""};
  with_kind(output.kind, [&](auto kind) {
    if constexpr (kind.quantities.size() > 0) quantity = kind.quantities[static_cast<std::size_t>(output.quantity)];
  });
  return quantity;
}

const std::string& element_name(const Model& model, const ElementOutput& output) {
  const std::string* name = nullptr;
  with_kind(output.kind, [&](auto kind) { name = &kind.list(model)[static_cast<std::size_t>(output.element)].name; });
  return *name;
}

bool is_stored_energy(const ElementOutput& output) {
  return quantity_of(output).name == std::string_view(kPotentialEnergy);
}

bool acts_on_turn(const Model& model, const Connection& connection) {
  const OnCoordinate* coordinate = std::get_if<OnCoordinate>(&connection);
  return coordinate && coordinate->joint.joint >= 0 &&
         freedom_of(model, coordinate->joint).kind == FreedomKind::revolute;
}

std::string unit_of(const Model& model, const ElementOutput& output) {
  if (output.element < 0) return "";
  const ElementQuantity quantity = quantity_of(output);
  bool turns = false;
  with_kind(output.kind, [&](auto kind) {
    turns = acts_on_turn(model, kind.connection(kind.list(model)[static_cast<std::size_t>(output.element)]));
  });
  return turns ? quantity.unit_of_turn : quantity.unit;
}

}  // namespace mbgen
