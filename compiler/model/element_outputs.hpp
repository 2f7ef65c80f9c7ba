#pragma once
// Outputs of elements from the tables of their kinds.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

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
