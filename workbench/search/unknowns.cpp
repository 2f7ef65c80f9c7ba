#include "workbench/search/unknowns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"

namespace mbgen {
namespace {

/// Bounds without typed ones, in parts of the value.
constexpr double kLeastPart = 0.1, kMostPart = 10;
/// Scale of an unknown that starts at zero, in parts of its range.
constexpr double kPartOfRange = 0.1;

/// NAME=LOW:HIGH as typed.
struct TypedBounds {
  std::string name;
  std::optional<double> lower, start, upper;
  bool is_physical = false;
};

TypedBounds typed_bounds(const std::string& option, const std::string& text) {
  const std::size_t sign = text.find('=');
  TypedBounds typed{text.substr(0, sign), {}, {}, {}};
  if (sign == std::string::npos) return typed;
  typed.is_physical = text.substr(sign + 1) == "physical";
  if (typed.is_physical) return typed;
  const std::vector<std::string> parts = split_at(text.substr(sign + 1), ':');
  if (parts.size() != 2 && parts.size() != 3)
    throw UserError(fmt::format("{} {}: bounds are LOW:HIGH or LOW:START:HIGH, found {}\n", option, typed.name,
                                in_quotes(text.substr(sign + 1))));
  const std::string what = fmt::format("{} {}", option, typed.name);
  typed.lower = parse_number(parts.front(), what);
  typed.upper = parse_number(parts.back(), what);
  if (parts.size() == 3) typed.start = parse_number(parts[1], what);
  return typed;
}

/// Fails: UserError for a start outside of the bounds.
void check_bounds(const std::string& option, const Unknown& unknown) {
  if (!(unknown.lower < unknown.upper))
    throw UserError(fmt::format("{} {}: the lower bound {:g} must be below the upper {:g}\n", option, unknown.name,
                                unknown.lower, unknown.upper));
  if (unknown.start >= unknown.lower && unknown.start <= unknown.upper) return;
  throw UserError(
      fmt::format("{} {}: it starts at {:g}, outside of its bounds {:g} to {:g}\n  hint: write LOW:START:HIGH\n",
                  option, unknown.name, unknown.start, unknown.lower, unknown.upper));
}

void set_scale(Unknown& unknown) {
  const double range = unknown.upper - unknown.lower;
  unknown.scale = unknown.start != 0 ? std::min(std::abs(unknown.start), range) : kPartOfRange * range;
}

void refuse_twice(const std::string& option, const std::vector<Unknown>& list, const std::string& name) {
  const auto is_same = [&](const Unknown& one) { return one.name == name || one.coordinate == name; };
  if (std::any_of(list.begin(), list.end(), is_same))
    throw UserError(fmt::format("{}: \"{}\" stands twice\n", option, name));
}

const Parameter& parameter_named(const Model& model, const std::string& name) {
  const auto is_it = [&](const Parameter& parameter) { return parameter.name == name; };
  const auto found = std::find_if(model.parameters.begin(), model.parameters.end(), is_it);
  if (found != model.parameters.end()) return *found;
  std::vector<std::string> names;
  for (const Parameter& parameter : model.parameters) names.push_back(parameter.name);
  const std::string hint = nearest_hint(name, names);
  throw UserError(fmt::format("--free: the model has no parameter \"{}\"\n{}", name,
                              hint.empty() ? "  hint: give the number a name in \"parameters\" of the model\n" : hint));
}

std::string unit_of_coordinate(const Model& model, const std::string& name) {
  const bool is_velocity = name.starts_with("zd.");
  std::vector<std::string> known;
  for (const Joint& joint : model.joints)
    for (const Freedom& freedom : joint.freedoms) {
      if (name == (is_velocity ? "zd." : "z.") + freedom.name)
        return std::string(freedom.kind == FreedomKind::revolute ? "rad" : "m") + (is_velocity ? "/s" : "");
      known.push_back((is_velocity ? "zd." : "z.") + freedom.name);
    }
  throw UserError(fmt::format("--free-start: the model has no coordinate \"{}\"; write z.NAME or zd.NAME\n{}", name,
                              nearest_hint(name, known)));
}

}  // namespace

std::vector<Unknown> free_parameters(const Model& model, const std::vector<std::string>& texts) {
  std::vector<Unknown> list;
  for (const std::string& text : texts) {
    const TypedBounds typed = typed_bounds("--free", text);
    const Parameter& parameter = parameter_named(model, typed.name);
    refuse_twice("--free", list, typed.name);
    Unknown unknown{.kind = Unknown::Kind::parameter, .name = typed.name, .unit = parameter.unit};
    unknown.start = typed.start.value_or(parameter.value);
    if (typed.is_physical) {
      unknown.is_physical = true;
      unknown.upper = std::numeric_limits<double>::infinity();
      unknown.lower = -unknown.upper;
      list.push_back(std::move(unknown));
      continue;
    }
    if (!typed.lower && unknown.start == 0)
      throw UserError(fmt::format("--free {0}: it starts at 0: give its bounds, {0}=LOW:HIGH\n", typed.name));
    const double least = (unknown.start > 0 ? kLeastPart : kMostPart) * unknown.start;
    const double most = (unknown.start > 0 ? kMostPart : kLeastPart) * unknown.start;
    unknown.lower = typed.lower.value_or(least);
    unknown.upper = typed.upper.value_or(most);
    check_bounds("--free", unknown);
    set_scale(unknown);
    list.push_back(std::move(unknown));
  }
  return list;
}

std::vector<Unknown> free_starts(const Model& model, const std::vector<std::string>& texts,
                                 const std::vector<int>& runs) {
  std::vector<Unknown> list;
  for (const std::string& text : texts) {
    const TypedBounds typed = typed_bounds("--free-start", text);
    if (!typed.lower) throw UserError(fmt::format("--free-start {0}: give its bounds, {0}=LOW:HIGH\n", typed.name));
    const std::string unit = unit_of_coordinate(model, typed.name);
    refuse_twice("--free-start", list, typed.name);
    if (model.initial.equilibrium && typed.name.starts_with("z."))
      throw UserError(fmt::format(
          "--free-start {}: the model starts in equilibrium, which gives all positions: free velocities alone, "
          "zd.NAME\n",
          typed.name));
    for (const int run : runs) {
      Unknown unknown{.kind = Unknown::Kind::start,
                      .name = fmt::format("{} of run {}", typed.name, run + 1),
                      .unit = unit,
                      .start = typed.start.value_or((*typed.lower + *typed.upper) / 2),
                      .lower = *typed.lower,
                      .upper = *typed.upper,
                      .run = run,
                      .coordinate = typed.name};
      check_bounds("--free-start", unknown);
      unknown.scale = kPartOfRange * (unknown.upper - unknown.lower);
      list.push_back(std::move(unknown));
    }
  }
  return list;
}

}  // namespace mbgen
