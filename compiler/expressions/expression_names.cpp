#include "compiler/expressions/expression_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {

FoundLength find_length(const ExpressionScope& scope, std::string_view name) {
  const Names& names = scope.names;
  FoundLength found;
  std::string kind;
  int first = 0;
  NameMap<int> known;
  const auto look_in = [&](const NameMap<int>& list, const std::string& kind_of_list) {
    const auto element = find_visible(list, name, scope.visible);
    if (element != list.end() && !kind.empty()) {
      found.problem = fmt::format("{} is {} and {}", in_quotes(name), kind, kind_of_list);
      found.hint = "rename one of them";
    } else if (element != list.end()) {
      found.index = first + element->second;
      kind = kind_of_list;
    }
    first += static_cast<int>(list.size());
    known.insert(list.begin(), list.end());
  };
  for (const LengthNames& list : names.lengths) look_in(list.names, list.kind);
  look_in(names.rods, "a rod");
  if (!kind.empty()) return found;
  return {-1, "unknown spring or rod " + in_quotes(name),
          scope.suggest ? did_you_mean(name, known, scope.visible) : ""};
}

const ReductionName* find_reduction(const ExpressionScope& scope, std::string_view name) {
  const auto found = std::find_if(scope.reductions.begin(), scope.reductions.end(),
                                  [&](const ReductionName& one) { return one.name == name; });
  return found == scope.reductions.end() ? nullptr : &*found;
}

const char* limit_of(Depends depends) {
  static constexpr const char* kLimits[] = {"must be constant", "may depend on parameters only",
                                            "may depend on positions of coordinates and on parameters only",
                                            "may depend on t, parameters and inputs only"};  // in the order of Depends
  return kLimits[static_cast<std::size_t>(depends)];
}

std::string hint_after_value(std::string_view word) {
  const char* factors = "write * between factors";
  const bool may_be_unit = word != "t" && unit_exponents(word);
  return may_be_unit ? fmt::format("{}; values are in SI units and stand without them", factors) : factors;
}

std::string hint_of_acceleration(std::string_view name) {
  return fmt::format(
      "a state \"v\" with the derivative \"(zd.{} - v)/0.01\" follows the velocity: (zd.{} - v)/0.01 is the "
      "acceleration, filtered",
      name, name);
}

std::string hint_of_unknown_name(const ExpressionScope& scope, std::string_view name) {
  const NameMap<int>& later = scope.names.later_parameters;
  if (find_visible(later, name, scope.visible) != later.end())
    return "parameter " + in_quotes(name) + " must be defined above its use";
  if (find_function(name) || find_reduction(scope, name))
    return fmt::format("{} is a function, write {}(...)", name, name);
  if (find_coordinate(scope.names, name, scope.visible))
    return fmt::format("coordinates are written z.{} and zd.{}", name, name);
  const auto has_it = [&](const LengthNames& list) {
    return find_visible(list.names, name, scope.visible) != list.names.end();
  };
  if (std::any_of(scope.names.lengths.begin(), scope.names.lengths.end(), has_it))
    return fmt::format("lengths of springs and their rates are written length.{} and rate.{}", name, name);
  if (find_visible(scope.names.outputs, name, scope.visible) != scope.names.outputs.end())
    return fmt::format("values of outputs are written out.{}", name);
  if (name == "z" || name == "zd") return fmt::format("coordinates are written {}.NAME", name);
  if (!scope.suggest) return {};
  std::vector<std::string_view> known(scope.locals.begin(), scope.locals.end());
  for (const auto& [parameter, index] : scope.names.parameters)
    known.push_back(name_from_inside(parameter, scope.visible));
  for (const auto& [input, index] : scope.names.inputs) known.push_back(name_from_inside(input, scope.visible));
  for (const auto& [value, index] : scope.names.values) known.push_back(name_from_inside(value, scope.visible));
  for (const auto& [value, index] : scope.names.named_values) known.push_back(name_from_inside(value, scope.visible));
  known.insert(known.end(), {"pi", "t"});
  return did_you_mean(name, known);
}

}  // namespace mbgen::reading
