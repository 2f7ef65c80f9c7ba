#pragma once
// Names of the quantities in programs for reading: the words for the first part of each, which the legend lists.

#include <span>
#include <string_view>

namespace mbgen {

/// A kind of quantity: `prefix` is the name up to its first underscore.
struct QuantityName {
  std::string_view prefix, words, unit;
};

/// In the order of the steps.
std::span<const QuantityName> quantity_names();

/// The kind of a quantity by its name, "" prefix for a name of no kind.
QuantityName quantity_of(std::string_view name);

}  // namespace mbgen
