#pragma once
// Names in expressions: what they mean, and hints where one is unknown or forbidden. A part of parse_expression.

#include <string>
#include <string_view>

#include "compiler/expressions/expression_scope.hpp"

namespace mbgen::reading {

/// An element with a length, of length.NAME and rate.NAME.
struct FoundLength {
  int index = -1;            ///< of elements with a length, kind by kind, then rods; -1: none
  std::string problem = {};  ///< "" where there is none
  std::string hint = {};
};

FoundLength find_length(const ExpressionScope& scope, std::string_view name);

/// The reduction of this name, nullptr for none.
const ReductionName* find_reduction(const ExpressionScope& scope, std::string_view name);

/// "may depend on parameters only", for less than Depends::all.
const char* limit_of(Depends depends);

/// Hint at the operator that is missing before a word that follows a value.
std::string hint_after_value(std::string_view word);

/// Replacement for zdd.NAME.
std::string hint_of_acceleration(std::string_view name);

/// Likely meaning of a name that is no parameter, input, variable or state.
std::string hint_of_unknown_name(const ExpressionScope& scope, std::string_view name);

}  // namespace mbgen::reading
