#pragma once
// Functions that expressions call by name.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/expression.hpp"

namespace mbgen::reading {

/// A row of the table that the parser, its messages, the schema and the model reference have in common.
struct NamedFunction {
  std::string_view name;
  Function function;
  int arity;
  std::string_view arguments;  ///< as people write them: "y, x"
  std::string_view meaning;    ///< with units and the arguments that it takes
};

std::span<const NamedFunction> named_functions();

/// "sqrt(x), sin(x), ...".
std::string signatures_of_functions();

/// The function that was probably meant, and all there are. others: names of functions that are known here beside them.
std::string hint_of_functions(std::string_view word, std::vector<std::string_view> others);

/// Null when there is none of this name.
const NamedFunction* find_function(std::string_view name);

/// True for names that expressions give a meaning of their own: pi, t, z, zd and the functions.
bool is_reserved_name(std::string_view name);

}  // namespace mbgen::reading
