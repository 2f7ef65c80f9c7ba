#pragma once
// Fields, expressions and outputs of elements, whatever their kind.

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "compiler/model/model.hpp"

namespace mbgen {

// Calls use(index into Model::expressions) for every expression in a field.
template <class Use>
void each_expression_in(const Quantity& field, const Use& use) {
  if (field.expression >= 0) use(field.expression);
}
template <class Use>
void each_expression_in(int field, const Use& use) {
  use(field);
}
template <class Use>
void each_expression_in(const Table&, const Use&) {}
template <class Use>
void each_expression_in(double, const Use&) {}
template <class Use>
void each_expression_in(const char*, const Use&) {}
template <std::size_t size, class Use>
void each_expression_in(const std::array<double, size>&, const Use&) {}
template <class Use>
void each_expression_in(const Law& field, const Use& use) {
  if (const Quantity* factor = std::get_if<Quantity>(&field)) each_expression_in(*factor, use);
}
template <std::size_t size, class Use>
void each_expression_in(const std::array<Quantity, size>& field, const Use& use) {
  for (const Quantity& component : field) each_expression_in(component, use);
}
template <class Field, class Use>
void each_expression_in(const std::optional<Field>& field, const Use& use) {
  if (field) each_expression_in(*field, use);
}

/// Calls use(index into Model::expressions) for every expression of an element.
template <class Element, class Use>
void each_expression(const Element& element, const Use& use) {
  KindOf<Element>::fields(element, [&](const std::string&, const auto& field) { each_expression_in(field, use); });
}

/// Whether an expression (index into Model::expressions, or -1) has a node of one of these kinds.
inline bool mentions(const Model& model, int expression, std::initializer_list<ExpressionNode::Kind> kinds) {
  if (expression < 0) return false;
  const std::vector<ExpressionNode>& nodes = model.expressions[static_cast<std::size_t>(expression)].nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const ExpressionNode& node) {
    return std::find(kinds.begin(), kinds.end(), node.kind) != kinds.end();
  });
}

/// Name of the spring that an element acts along.
inline const std::string& name_of(const Model& model, const AlongSpring& at) {
  return model.springs[static_cast<std::size_t>(at.spring)].name;
}

/// The round after the outputs that an expression looks at: 0 without any, at most kAfterForces.
int round_after(const Model& model, const Expression& expression);

/// The round of an element: after the outputs that its law, or the spring that presses or carries it, looks at. after:
/// round_after of an expression.
template <class Element, class After>
int round_of(const Model& model, const Element& element, const After& after) {
  int round = 0;
  each_expression(element,
                  [&](int e) { round = std::max(round, after(model.expressions[static_cast<std::size_t>(e)])); });
  const auto wait_for_spring = [&](int spring) {
    if (spring >= 0) round = std::max(round, round_of(model, model.springs[static_cast<std::size_t>(spring)], after));
  };
  if constexpr (std::is_base_of_v<FrictionLaw, Element>) wait_for_spring(element.normal);
  const Connection connection = connection_of(element);
  if (const auto* along = std::get_if<AlongSpring>(&connection)) wait_for_spring(along->spring);
  return round;
}
template <class Element>
int round_of(const Model& model, const Element& element) {
  if (model.observed.empty()) return 0;
  return round_of(model, element, [&](const Expression& expression) { return round_after(model, expression); });
}

/// The last round of elements.
int last_round(const Model& model);

/// Calls use(friction) for frictions on coordinates, then along springs, then in rod ends.
template <class Use>
void each_friction(const Model& model, const Use& use) {
  each_element(model, [&](const auto& element) {
    if constexpr (std::is_base_of_v<FrictionLaw, std::decay_t<decltype(element)>>) use(element);
  });
}

/// An output of an element. Requires: the quantity is in the table of its kind.
template <class Element>
ElementOutput output_of(std::string_view quantity, std::size_t element, int axis = 0) {
  return {kKindIndex<Element>, static_cast<int>(element), quantity_index(KindOf<Element>{}, quantity), axis};
}

/// The quantity's row in the table of its kind.
ElementQuantity quantity_of(const ElementOutput& output);

/// Name of the element.
const std::string& element_name(const Model& model, const ElementOutput& output);

/// Whether the output is the potential energy of the element.
bool is_stored_energy(const ElementOutput& output);

/// Whether an element acts on a rotational coordinate.
bool acts_on_turn(const Model& model, const Connection& connection);

/// Unit of an element's quantity; "" for an unreadable one.
std::string unit_of(const Model& model, const ElementOutput& output);

}  // namespace mbgen
