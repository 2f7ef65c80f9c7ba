#pragma once
// Characteristics of force elements at a state.

#include <optional>

#include "runtime/judges/values.hpp"

namespace mbgen::cartesian {

/// y of a table, computed independently of the formulation's pieces.
double value_of(const Table& table, double argument);

/// Factor times argument, or a table over it; zero without a law.
double law(const std::optional<Law>& law, const Values& value, double argument);

/// An expression over two local variables; zero without one.
double with_locals(const std::optional<int>& expression, Values value, double first, double second);

}  // namespace mbgen::cartesian
