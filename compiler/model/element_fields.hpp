#pragma once
// Numbers and references that the fields of elements hold.

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "compiler/model/element_kinds.hpp"

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

}  // namespace mbgen
