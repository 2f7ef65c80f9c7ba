#pragma once
// Characteristics of elements.

#include <variant>

#include "compiler/expressions/table.hpp"

namespace mbgen {

/// A characteristic: factor times argument, or a table over the argument.
using Law = std::variant<Quantity, Table>;

}  // namespace mbgen
