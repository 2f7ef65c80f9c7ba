#include "compiler/model/named_functions.hpp"

#include <algorithm>
#include <iterator>

namespace mbgen::reading {
namespace {

constexpr NamedFunction kFunctions[] = {
    {"sqrt", Function::sqrt, 1}, {"sin", Function::sin, 1},     {"cos", Function::cos, 1},
    {"tan", Function::tan, 1},   {"asin", Function::asin, 1},   {"acos", Function::acos, 1},
    {"atan", Function::atan, 1}, {"atan2", Function::atan2, 2}, {"exp", Function::exp, 1},
    {"log", Function::log, 1},   {"tanh", Function::tanh, 1},   {"abs", Function::abs, 1},
    {"min", Function::min, 2},   {"max", Function::max, 2},     {"pow", Function::power, 2},
    {"sign", Function::sign, 1}, {"step", Function::step, 1},   {"select", Function::select, 3},
};

}  // namespace

std::span<const NamedFunction> named_functions() { return kFunctions; }

const NamedFunction* find_function(std::string_view name) {
  const auto* found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                   [&](const NamedFunction& entry) { return entry.name == name; });
  return found == std::end(kFunctions) ? nullptr : found;
}

bool is_reserved_name(std::string_view name) {
  return name == "pi" || name == "t" || name == "z" || name == "zd" || find_function(name) != nullptr;
}

}  // namespace mbgen::reading
