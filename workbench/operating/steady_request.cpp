#include "workbench/operating/steady_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

/// Index of a named item of the model. Fails: UserError that names the nearest.
template <class Item>
int place_of(const std::vector<Item>& items, std::string_view name, const char* option, const char* kind) {
  const auto found = std::ranges::find(items, name, &Item::name);
  if (found != items.end()) return static_cast<int>(found - items.begin());
  std::vector<std::string_view> names;
  for (const Item& item : items) names.push_back(item.name);
  const std::string near = did_you_mean(std::string(name), names);
  throw UserError(
      fmt::format("{}: the model has no {} \"{}\"{}{}\n", option, kind, name, near.empty() ? "" : "; ", near));
}

/// coordinate or coordinate=rate.
std::pair<int, std::optional<double>> held_rate(const Compilation& c, const std::vector<int>& independent,
                                                const std::string& name, const std::optional<std::string>& value) {
  const int i = find_coordinate(c.topology, name);
  if (std::ranges::find(independent, i) == independent.end()) {
    throw UserError(
        fmt::format("--hold: \"{}\" is no independent coordinate of the model; mbgen inspect lists them\n", name));
  }
  if (!value) return {i, {}};
  return {i, parse_number(*value, "--hold: " + name)};
}

/// out.NAME=value.
OutputGoal held_output(const Model& model, std::string_view name, const std::optional<std::string>& value) {
  const int output = place_of(model.outputs, name, "--hold", "output");
  if (!value) throw UserError(fmt::format("--hold: output \"{}\" needs a value: out.{}=VALUE\n", name, name));
  return {output, parse_number(*value, fmt::format("--hold: out.{}", name))};
}

}  // namespace

TypedRequest typed_request(const Compilation& compilation, const std::vector<int>& independent,
                           const SteadyRequest& request) {
  constexpr std::string_view kOutput = "out.";
  TypedRequest typed;
  typed.goals = request.goals;
  for (const std::string& assignment : request.hold) {
    const std::size_t sign = assignment.find('=');
    const std::string name = assignment.substr(0, sign);
    std::optional<std::string> value;
    if (sign != std::string::npos) value = assignment.substr(sign + 1);
    if (name.starts_with(kOutput)) {
      typed.goals.push_back(held_output(compilation.model, std::string_view(name).substr(kOutput.size()), value));
    } else {
      typed.rates.push_back(held_rate(compilation, independent, name, value));
    }
  }
  for (const std::string& name : request.solve)
    typed.inputs.push_back(place_of(compilation.model.inputs, name, "--solve", "input"));
  return typed;
}

Eigen::VectorXd goal_errors(const std::vector<OutputGoal>& goals, const GenericSolver& solver, Status status,
                            const GenericState& state, const GenericDerivative& derivative) {
  Eigen::VectorXd errors = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(goals.size()), std::nan(""));
  if (!status.ok() || goals.empty()) return errors;
  const std::vector<double> y = solver.outputs(state, std::vector<double>(state.z.size(), 0.0), derivative).y;
  for (std::size_t g = 0; g < goals.size(); ++g)
    errors[static_cast<Eigen::Index>(g)] = y[static_cast<std::size_t>(goals[g].output)] - goals[g].value;
  return errors;
}

}  // namespace mbgen
