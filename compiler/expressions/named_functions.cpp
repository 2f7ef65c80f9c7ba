#include "compiler/expressions/named_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compiler/text/diagnostic.hpp"

namespace mbgen::reading {
namespace {

constexpr NamedFunction kFunctions[] = {
    {"sqrt", Function::sqrt, 1, "x", "square root, of x at least 0"},
    {"sin", Function::sin, 1, "x", "sine, of x in rad"},
    {"cos", Function::cos, 1, "x", "cosine, of x in rad"},
    {"tan", Function::tan, 1, "x", "tangent, of x in rad; infinite at pi/2 and every pi from there"},
    {"asin", Function::asin, 1, "x", "angle of the sine x, from -pi/2 to pi/2 rad; x from -1 to 1"},
    {"acos", Function::acos, 1, "x", "angle of the cosine x, from 0 to pi rad; x from -1 to 1"},
    {"atan", Function::atan, 1, "x", "angle of the tangent x, between -pi/2 and pi/2 rad"},
    {"atan2", Function::atan2, 2, "y, x", "angle of the point (x, y) from the x axis, from -pi to pi rad"},
    {"exp", Function::exp, 1, "x", "e to the power of x"},
    {"log", Function::log, 1, "x", "natural logarithm, of x above 0"},
    {"tanh", Function::tanh, 1, "x", "hyperbolic tangent, between -1 and 1"},
    {"abs", Function::abs, 1, "x", "magnitude"},
    {"min", Function::min, 2, "a, b", "the smaller one"},
    {"max", Function::max, 2, "a, b", "the larger one"},
    {"pow", Function::power, 2, "a, b", "a to the power of b, as a^b; a above 0 unless b is a constant whole number"},
    {"sign", Function::sign, 1, "x", "-1 below 0, 0 at 0, 1 above"},
    {"step", Function::step, 1, "x", "0 below 0, 1 from 0 on"},
    {"select", Function::select, 3, "x, a, b", "a where x is at least 0, else b"},
    {"floor", Function::floor, 1, "x", "largest whole number not above x"},
};

}  // namespace

std::span<const NamedFunction> named_functions() { return kFunctions; }

const NamedFunction* find_function(std::string_view name) {
  const auto* found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                   [&](const NamedFunction& entry) { return entry.name == name; });
  return found == std::end(kFunctions) ? nullptr : found;
}

std::string signatures_of_functions() {
  std::string text;
  for (const NamedFunction& function : kFunctions)
    text += fmt::format("{}{}({})", text.empty() ? "" : ", ", function.name, function.arguments);
  return text;
}

std::string hint_of_functions(std::string_view word, std::vector<std::string_view> others) {
  std::string all = signatures_of_functions();
  for (const std::string_view other : others) all += fmt::format(", {}(...)", other);
  for (const NamedFunction& function : kFunctions) others.push_back(function.name);
  const std::string nearest = did_you_mean(word, others);
  return nearest + (nearest.empty() ? "" : " ") + "functions: " + all;
}

bool is_reserved_name(std::string_view name) {
  const bool is_newer = name == "floor";  // than models in which it may be the name of a parameter
  return name == "pi" || name == "t" || name == "z" || name == "zd" || (!is_newer && find_function(name) != nullptr);
}

}  // namespace mbgen::reading
