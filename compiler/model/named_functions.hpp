#pragma once
// Functions that expressions call by name.

#include <span>
#include <string_view>

#include "compiler/model/expression.hpp"

namespace mbgen::reading {

struct NamedFunction {
  std::string_view name;
  Function function;
  int arity;
};

std::span<const NamedFunction> named_functions();

/// Null when there is none of this name.
const NamedFunction* find_function(std::string_view name);

/// True for names that expressions give a meaning of their own: pi, t, z, zd and the functions.
bool is_reserved_name(std::string_view name);

}  // namespace mbgen::reading
