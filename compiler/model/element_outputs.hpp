#pragma once
// Outputs of elements by the tables of their kinds.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// An output of an element. Requires: its kind shows the quantity.
template <class Element>
ElementOutput output_of(std::string_view quantity, std::size_t element, int axis = 0) {
  return {kKindIndex<Element>, static_cast<int>(element), quantity_index(KindOf<Element>{}, quantity), axis};
}

/// The row of its kind's table.
ElementQuantity quantity_of(const ElementOutput& output);

/// Name of the element.
const std::string& element_name(const Model& model, const ElementOutput& output);

/// Whether the output is the energy that the element holds.
bool is_stored_energy(const ElementOutput& output);

/// Whether an element acts on a coordinate that turns.
bool acts_on_turn(const Model& model, const Connection& connection);

/// Unit of the quantity of an element; "" of one that could not be read.
std::string unit_of(const Model& model, const ElementOutput& output);

}  // namespace mbgen
